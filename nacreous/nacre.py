"""What a pearl is made of: a stack of layers, given one by one or grown day by day."""

from __future__ import annotations

import copy
import datetime as dt
from collections.abc import Sequence
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.medium import Medium, is_function, medium_of, sampled
from nacreous.number import alone, number_of, row_of, said, within
from nacreous.problem import InputError
from nacreous.thinness import thin_layers
from nacreous.unchanging import keep
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.spec import Growth, Layers, Pearl

__all__ = ["Diary", "LayerStack", "columns_of", "diary", "grow", "stack_of"]


@value_class
class LayerStack:
    """Aragonite layers, surface first, each followed by a protein layer, then the substrate.

    thickness_nm: aragonite layers in nm, from the surface inward; 1 to 5000 values, each above 0,
    up to 1e6; one of them at least 1, for a stack of sheets all thinner than two cells of aragonite
    is one in micrometres.
    protein_nm: thickness of every protein layer, 0 to 1e6 nm, or one for each; however thin, for a
    series of stacks may lead to none.
    aragonite, protein, ambient, substrate: media of layers, surroundings and core. Each is an
    index n or complex n + ik (0 < n <= 100, 0 <= k <= 100, k > 0 absorbs); a pair (n_o, n_e) of
    them for a uniaxial medium with its axis along the normal; an `IndexTable`; a function that
    takes wavelengths in nm, a float64 array, and returns an index, one for each, or such a pair;
    or a name that `nc.medium.NAMES` lists, such as "aragonite".
    cover: layers upon the nacre, outermost first, each (medium, thickness in nm, up to 1e6): water,
    lacquer, an oxide; where there are any, one is at least 1. They are coherent, as all layers; a
    mm of water is rather the ambient.

    A stack never changes: assigning to a field is refused, and `dataclasses.replace` makes another.
    It compares, hashes, copies and pickles as its numbers; a medium that is a function must pickle
    itself, as one of a module does and a lambda does not.

    Defaults are the paper's (section 3.2). Raises `InputError` that names the bad quantity.

    >>> stack = LayerStack([410.0, 395.0])
    >>> stack
    LayerStack(2 layers, 0.845 um)
    >>> LayerStack([410.0, -1.0])
    Traceback (most recent call last):
    nacreous.problem.InputError: thickness_nm[1] is -1; allowed: above 0, up to 1000000 nm
    """

    thickness_nm: NDArray[np.float64]
    protein_nm: float | NDArray[np.float64]
    aragonite: Medium
    protein: Medium
    ambient: Medium
    substrate: Medium
    cover: tuple[tuple[Medium, float], ...]
    if TYPE_CHECKING:  # no field, so that `dataclasses.asdict` gives what a stack is made from
        _compiled: _core.Stack = field(init=False, compare=False, repr=False)

    def __init__(
        self,
        thickness_nm: ArrayLike,
        protein_nm: ArrayLike = 20.0,
        aragonite: Medium = 1.53,
        protein: Medium = 1.43,
        ambient: Medium = 1.0,
        substrate: Medium = 1.53,
        cover: Sequence[tuple[Medium, float]] = (),
    ) -> None:
        media = map(alone, (aragonite, protein, ambient, substrate))
        given: dict[str, Medium] = dict(zip(_MEDIA, media, strict=True))
        layers = row_of("thickness_nm", thickness_nm)
        nm = _protein(protein_nm)
        # All layers are checked with one thickness of protein: a wrong one if there is any.
        each = np.atleast_1d(nm)
        wrong = each[~((each >= 0.0) & (each <= 1e6))]
        one = float(wrong[0]) if wrong.size else float(np.max(each, initial=0.0))
        core = _core.Stack(layers, one, *(medium_of(name, given[name]) for name in _MEDIA))
        if np.size(nm) != 1 and np.size(nm) != layers.size:
            raise InputError(
                f"protein_nm has {np.size(nm)} values; allowed: one, or {layers.size}, one a layer"
            )
        if (verdict := thin_layers(layers.tolist())) is not None:
            raise InputError(f"thickness_nm {verdict}")
        # Copied only now that it is known to be short enough.
        plain = {name: _plain(medium) for name, medium in given.items()}
        keep(self, thickness_nm=layers, protein_nm=nm, **plain, cover=_cover(cover), _compiled=core)

    def __deepcopy__(self, _: object) -> LayerStack:
        """With the same media, for a copy of a function need not equal it."""
        return copy.copy(self)

    def __repr__(self) -> str:
        """Layers and thickness, not every layer."""
        return f"LayerStack({len(self)} layers, {self.total_um:.3f} um)"

    def __len__(self) -> int:
        """How many aragonite layers."""
        return len(self.thickness_nm)

    @property
    def is_plain(self) -> bool:
        """Whether all protein layers are alike and nothing covers the nacre."""
        return not self.cover and isinstance(self.protein_nm, float)

    def at(self, wavelength_nm: NDArray[np.float64]) -> _core.Stack:
        """The compiled stack, with the media that are functions known at these wavelengths."""
        if not self.is_plain:
            what = "cover" if self.cover else "protein_nm"
            raise InputError(
                f"the stack has {what} layer by layer; allowed here: one protein_nm and no cover"
            )
        media = [getattr(self, name) for name in _MEDIA]
        if wavelength_nm.size == 0 or not any(map(is_function, media)):
            return self._compiled
        known = (sampled(name, getattr(self, name), wavelength_nm) for name in _MEDIA)
        return _core.Stack(self.thickness_nm, float(self.protein_nm), *known)

    def film(self, wavelength_nm: NDArray[np.float64]) -> _core.Film:
        """All layers one by one, cover included, with their media at these wavelengths."""
        names = [
            "ambient",
            *(f"cover[{i}]" for i in range(len(self.cover))),
            *_MEDIA[:2],
            "substrate",
        ]
        covers = [medium for medium, _ in self.cover]
        given = [self.ambient, *covers, self.aragonite, self.protein, self.substrate]
        known = [
            (name, sampled(name, n, wavelength_nm)) for name, n in zip(names, given, strict=True)
        ]
        covering = len(covers)
        bilayers = np.column_stack([self.thickness_nm, np.broadcast_to(self.protein_nm, len(self))])
        places = [*range(1, covering + 1), *[covering + 1, covering + 2] * len(self)]
        thickness_nm = [*(nm for _, nm in self.cover), *bilayers.ravel().tolist()]
        return _core.Film(known, places, thickness_nm)

    @property
    def total_um(self) -> float:
        """Thickness of the whole nacre in um, protein included, without cover."""
        if isinstance(self.protein_nm, float):
            return self._compiled.total_um()
        return float(self.thickness_nm.sum() + self.protein_nm.sum()) / 1e3

    def outer(self, depth_um: float) -> tuple[int, float, float]:
        """Count, mean and spread (standard deviation, nm) of the layers within `depth_um`.

        Counted are the aragonite layers that begin within that depth (0 or more um) below the
        surface, at least one. The trade's reports give these numbers for the outer 10 and 50 um.

        >>> LayerStack([300.0, 500.0, 700.0]).outer(0.4)
        (2, 400.0, 100.0)
        """
        depth = number_of("depth_um", depth_um)
        if not depth >= 0:
            raise InputError(f"depth_um is {depth:g}; allowed: 0 or more um")
        if isinstance(self.protein_nm, float):
            return self._compiled.outer(depth)
        begins_nm = np.cumsum(self.thickness_nm + self.protein_nm)[:-1]
        counted = self.thickness_nm[: 1 + int(np.count_nonzero(begins_nm <= 1e3 * depth))]
        return counted.size, float(counted.mean()), float(counted.std())


def _plain(medium: Medium) -> Medium:
    """A medium whose equal indices are one number, so that equal stacks pickle alike."""
    medium = alone(medium)
    if isinstance(medium, (tuple, list)):
        return tuple(map(_plain, medium))  # type: ignore[return-value]
    if isinstance(medium, bool) or not isinstance(medium, (int, float, complex, np.number)):
        return medium
    try:
        index = complex(medium)
    except OverflowError:
        return medium
    return index if index.imag else index.real


def _protein(protein_nm: ArrayLike) -> float | NDArray[np.float64]:
    """One thickness, or one for each layer."""
    if np.ndim(protein_nm) == 0:
        return number_of("protein_nm", protein_nm) + 0.0  # -0.0 is 0.0
    row = row_of("protein_nm", protein_nm) + 0.0
    for layer, nm in enumerate(row):
        within(f"protein_nm[{layer}]", float(nm), 0, 1e6)
    return float(row[0]) if row.size == 1 else row


def _cover(cover: Sequence[tuple[Medium, float]]) -> tuple[tuple[Medium, float], ...]:
    """Covers as they are kept, each of them checked; an array [layer, 2] has them as rows."""
    if isinstance(cover, np.ndarray):
        cover = cover.tolist()
    if not isinstance(cover, (list, tuple)) or len(cover) > 100:
        raise InputError(
            f"cover is {said(cover)}; allowed: up to 100 pairs (medium, thickness in nm)"
        )
    kept = []
    for place, layer in enumerate(cover):
        if not isinstance(layer, (list, tuple)) or len(layer) != 2:
            raise InputError(f"cover[{place}] is {said(layer)}; allowed: (medium, thickness in nm)")
        medium, nm = layer
        medium_of(f"cover[{place}]", medium)
        kept.append((_plain(medium), 0.0 + within(f"cover[{place}] thickness", nm, 0, 1e6)))
    if (verdict := thin_layers(nm for _, nm in kept)) is not None:
        raise InputError(f"cover's thickness {verdict}")
    known = [
        (f"cover[{place}]", medium_of("cover", medium)) for place, (medium, _) in enumerate(kept)
    ]
    around = [("ambient", 1.0), *known, ("substrate", 1.0)]
    _core.Film(around, list(range(1, len(kept) + 1)), [nm for _, nm in kept])  # knows every name
    return tuple(kept)


_MEDIA = ("aragonite", "protein", "ambient", "substrate")


@value_class
class Diary:
    """What grew on which day, in the order of growth: from the nucleus outward.

    date: one calendar day for each layer; thickness_nm: float64, aragonite.
    """

    date: tuple[dt.date, ...]
    thickness_nm: NDArray[np.float64]


def diary(growth: Growth) -> Diary:
    """Grow nacre day by day and keep the days (paper, section 3.2.1). Same growth, same layers.

    >>> from nacreous.spec import Growth
    >>> days = diary(Growth(seed=7))
    >>> days.date[-1] < Growth().harvest_date
    True
    """
    from nacreous.spec import Growth

    if not isinstance(growth, Growth):
        raise InputError(f"growth is {said(growth)}; allowed: a nacreous.spec.Growth")
    day, thickness_nm = _core.grow(growth.model_dump_json())
    seeding = growth.seeding_date
    return Diary(tuple(seeding + dt.timedelta(days=int(days)) for days in day), thickness_nm)


def grow(growth: str | Growth = "paper", **parameters: Any) -> LayerStack:
    """Grow a pearl from seeding to harvest and return its layers, surface first.

    growth: the name of a nacre preset (`nacreous presets nacre` lists them) or a `Growth`.
    parameters: any key of the `[nacre]` section of a pearl file, such as seed, harvest="12-15" or
    thickness_summer_nm; they go over the preset's. Raises `InputError` for what cannot be.

    Same seed, same stack, on every platform.

    >>> stack = grow("akoya-rg", seed=7, harvest="12-15")
    >>> stack == grow("akoya-rg", seed=7, harvest="12-15")
    True
    >>> stack == grow("akoya-rg", seed=8, harvest="12-15")
    False
    """
    from nacreous.spec import Growth
    from nacreous.spec.growth import Grown
    from nacreous.spec.specfile import checked

    if not isinstance(growth, str | Growth):
        raise InputError(f"growth is {said(growth)}; allowed: a nacre preset's name or a Growth")
    given = {"preset": growth} if isinstance(growth, str) else growth.model_dump()
    return _stack(checked(Grown, {"nacre": {**given, **parameters}}, "grow", Path()).nacre)


def stack_of(pearl: Pearl) -> LayerStack:
    """The layers of a pearl file: those it lists, or those that grow by its season.

    >>> from nacreous.spec import Pearl
    >>> stack_of(Pearl.load("paper", [("nacre.harvest", "08-15")])).outer(10)[1] > 600
    True
    """
    return _stack(pearl.nacre)


def columns_of(pearl: Pearl, outer_um: float | None = None) -> list[LayerStack]:
    """The columns of tablets of a transport pearl's film, the outer `outer_um` of each.

    outer_um: depth, 1 to 500 um; left out, the pearl's own. Grown nacre: each column grows by the
    same season with a seed of its own, the first with the pearl's. Listed layers are the same in
    all. Both are spread by film.column_spread_nm, layer by layer. Same pearl, same columns. Raises
    `InputError` for a pearl of the other model.

    >>> from nacreous.spec import Pearl
    >>> columns = columns_of(Pearl(), 10.0)
    >>> len(columns), len(columns[0])
    (64, 24)
    """
    if outer_um is not None:
        outer_um = within("outer_um", outer_um, 1, 500)
    columns = _core.film_columns(pearl.model_dump_json(), outer_um)
    stack = stack_of(pearl)
    media = (stack.protein_nm, *(getattr(stack, name) for name in _MEDIA))
    return [LayerStack(thickness_nm, *media) for thickness_nm in columns]


def _stack(nacre: Growth | Layers) -> LayerStack:
    """Grown or listed layers on their core."""
    stack, on_crystal = _core.stack_of_nacre(nacre.model_dump_json())
    aragonite, protein = nacre.aragonite_medium, nacre.protein_medium
    bare = LayerStack(stack.thickness_nm(), nacre.protein_nm, aragonite, protein)
    return replace(bare, substrate=aragonite) if on_crystal else bare


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

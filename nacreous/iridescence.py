"""Tables for pictures: the colours of a stack by angle, straight from layers to XYZ."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core, colour
from nacreous.deprecation import keep_former_names
from nacreous.medium import sampled
from nacreous.nacre import LayerStack
from nacreous.number import array_of, number_of, said
from nacreous.problem import InputError
from nacreous.value import value_class

__all__ = ["ByAngle", "exact", "illuminant_model"]


@value_class
class ByAngle:
    """Colours by angle, on a grid so fine that straight lines between its nodes will do.

    xyz: float64 [cosine, 3], relative to white with Y = 1, for cosines of the angle spaced evenly
    from 0 (grazing, the rim of a ball) to 1 (the normal, its middle).
    """

    xyz: NDArray[np.float64]

    @property
    def angle_rad(self) -> NDArray[np.float64]:
        """The angle of each row, from pi/2 down to 0."""
        return np.arccos(np.linspace(0.0, 1.0, len(self.xyz)))

    def at(self, angle_rad: ArrayLike) -> NDArray[np.float64]:
        """XYZ [..., 3] at any angles from 0 to pi/2, by straight lines in the cosine."""
        angle = array_of("angle_rad", angle_rad)
        if not np.all((angle >= 0) & (angle <= np.pi / 2)):
            raise InputError(f"angle_rad is {said(angle_rad)}; allowed: 0 to pi/2")
        place = np.cos(angle).clip(0.0, 1.0) * (len(self.xyz) - 1)
        low = np.minimum(place.astype(np.intp), len(self.xyz) - 2)
        share = (place - low)[..., None]
        found: NDArray[np.float64] = self.xyz[low] * (1 - share) + self.xyz[low + 1] * share
        return found


def exact(
    stack: LayerStack,
    light: str | ArrayLike = "D65",
    observer: colour.Observer = "1931-2",
    polarisation: str = "unpolarised",
) -> tuple[ByAngle, ByAngle]:
    """The colours that a stack reflects and lets through, by the angle of incidence.

    light: a name for `nc.colour.illuminant` or a spectrum [401]. Exact R and T, in steps of 1 nm or
    less: thick stacks have fringes finer than that, which would beat with the steps in colours that
    are not there. Where light resonates between two mirrors, as it does near grazing in a flake
    with the same medium on either side, steps are finer than the lines in which it does; beyond
    89.88 degrees, where lines narrow without end, colours follow a parabola to what is known at
    grazing: everything comes back. The grid of angles is halved until straight lines between its
    nodes stay within CIEDE2000 0.2, from 129 angles to 4097; with narrow lines it has 4097.
    Ctrl-C interrupts.

    Lines narrower than the steps are worked out as far as 1e10 layers (and 50 more) times
    wavelengths times angles go, ten to twenty seconds on one core, in pieces of some 100 MB. Light
    that is caught between gaps in a dense medium, or good mirrors far apart, may ask for more.

    Raises `InputError` for what is out of range, for a stack that 4097 angles do not show to
    CIEDE2000 0.2, and, before it begins with them, for lines that would take more.

    >>> nacre = LayerStack([380.0] * 50, 20.0, "aragonite", "chitin", 1.0, "aragonite")
    >>> reflected, transmitted = exact(nacre)
    >>> white = colour.white_xyz("D65")
    >>> bool(abs(reflected.xyz + transmitted.xyz - white).max() < 1e-4)
    True
    """
    known, spectrum = _checked(stack, light)
    found = _core.iridescence(known, spectrum, str(observer), str(polarisation))
    fine = _Fine(stack, spectrum, str(observer), str(polarisation))
    reflected, transmitted = (ByAngle(table) for table in fine.resolved(found))
    if len(found[0]) == _MOST_ROWS:
        fine.check(reflected, transmitted)
    return reflected, transmitted


def illuminant_model(
    stack: LayerStack,
    light: str | ArrayLike = "D65",
    observer: colour.Observer = "1931-2",
    coherence_nm: float = 5000.0,
    threshold: float = 0.05,
    diffuse_loss: float = 0.0,
) -> ByAngle:
    """The colours of nacre lit from within by `light`, by the view angle (paper, section 3).

    As `nc.optics.illuminant`, which has no scale of its own: here the brightest angle has Y = 1.
    Its colours jump where one layer more begins to interfere, by about CIEDE2000 0.5 in grown
    nacre and by 5 where all layers are equal; between jumps straight lines stay within 0.2.

    >>> rings = illuminant_model(LayerStack([420.0] * 100))
    >>> float(rings.xyz[:, 1].max())
    1.0
    """
    known, spectrum = _checked(stack, light)
    numbers = (
        number_of("coherence_nm", coherence_nm),
        number_of("threshold", threshold),
        number_of("diffuse_loss", diffuse_loss),
    )
    return ByAngle(_core.interference_iridescence(known, spectrum, str(observer), *numbers))


#: Of the grid of angles that `_core.iridescence` refines.
_MOST_ROWS = 4097
#: The largest CIEDE2000 that straight lines may make.
_TOLERANCE = 0.2
#: Cosine below which colours go to grazing by a parabola through two nodes beyond.
_GRAZING = 1 / 512
#: Cosines that are nodes where lines matter, whatever the grid.
_NEAR_GRAZING = np.arange(1, 17) / 512
#: Cosines at which lines are looked for.
_PROBES = np.geomspace(_GRAZING, 1.0, 16)
#: Steps between wavenumbers at which lines are looked for, in stacks thinner than their light.
_FEWEST_PLACES = 64
#: What lines narrower than a step may hold, beside the lesser of R and T.
_UNRESOLVED = 0.02
#: What they may hold in any case, of white: in the darkest colour CIEDE2000 0.1.
_UNSEEN = 1e-5
#: Wavelengths times angles times layers that narrow lines may take, some ten to twenty seconds.
_MOST_WORK = 1e10
#: Layers in whose time a wavelength is begun.
_LAYERS_TO_BEGIN = 50
#: Steps to half the width of a line; the rule of equal steps then misses 1e-4 of it.
_STEPS_TO_HALF_WIDTH = 1.5
#: Where what the eye sees of fringes begins.
_FIRST_NM = 400.0
#: Values of a table that is worked out in one piece.
_AT_ONCE = 1 << 20


class _Fine:
    """Colours of a stack by steps in wavelength finer than its lines."""

    def __init__(
        self, stack: LayerStack, light: NDArray[np.float64], observer: str, polarisation: str
    ) -> None:
        self.stack, self.polarisation = stack, polarisation
        each_nm = np.eye(len(colour.WAVELENGTH_NM))
        self.weights = _core.xyz_from_spectrum(each_nm, light, observer)

    def resolved(self, found: tuple[NDArray[np.float64], ...]) -> list[NDArray[np.float64]]:
        """Tables of R and T, rows where lines are narrower than the steps worked out again."""
        cosine = np.linspace(0.0, 1.0, len(found[0]))
        white_y = self.weights[:, 1].sum()
        least = np.min([np.interp(_PROBES, cosine, table[:, 1]) for table in found], axis=0)
        logs = [self._log_per_nm(*probe) for probe in zip(_PROBES, least / white_y, strict=True)]
        known = np.union1d(cosine, _NEAR_GRAZING)
        per_nm = np.exp2(np.interp(known, _PROBES, logs))
        again = (per_nm > self.sampled_per_nm) & (known >= _GRAZING)
        if not again[np.isin(known, cosine)].any():
            return [table.copy() for table in found]
        self._require_work(per_nm[again])
        tables = [_between(cosine, table, known) for table in found]
        for row in np.flatnonzero(again):
            for table, xyz in zip(tables, self.at(float(known[row]), per_nm[row]), strict=True):
                table[row] = xyz
        return [_to_grazing(known, table) for table in tables]

    @property
    def sampled_per_nm(self) -> float:
        """What the compiled room takes: 5 samples a fringe of the whole stack at 400 nm."""
        return max(1.0, 5 * 2 * 1.6e3 * self.stack.total_um / _FIRST_NM**2)

    def at(self, cosine: float, per_nm: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """XYZ of R and T with so many samples a nm."""
        nm = colour.WAVELENGTH_NM
        steps = math.ceil(per_nm * (nm.size - 1))
        sums, total = np.zeros((2, 3)), np.zeros(3)
        for start in range(0, steps + 1, _AT_ONCE):
            places = np.arange(start, min(start + _AT_ONCE, steps + 1))
            fine_nm = nm[0] + np.ptp(nm) * (places / steps)
            weights = [np.interp(fine_nm, nm, column) for column in self.weights.T]
            stack, angle = self.stack.at(fine_nm), np.array([np.arccos(cosine)])
            shares = _core.energies(stack, angle, fine_nm, self.polarisation, "double")
            sums += shares[:2, 0] @ np.stack(weights, axis=1)
            total += np.sum(weights, axis=1)
        sums *= self.weights.sum(axis=0) / total
        return sums[0], sums[1]

    def _require_work(self, per_nm: NDArray[np.float64]) -> None:
        """Refuses angles with so many samples a nm where that is more than some seconds."""
        layers = len(self.stack) + _LAYERS_TO_BEGIN
        work = float(per_nm.sum() * np.ptp(colour.WAVELENGTH_NM)) * layers
        if work > _MOST_WORK:
            raise InputError(
                f"stack catches light in lines so narrow that its colours would take {work:.2g} "
                "layers (and 50 more) times wavelengths times angles; allowed: up to "
                f"{_MOST_WORK:.2g}. Thinner gaps or fewer layers make wider lines; "
                "nc.optics.energies answers at single angles"
            )

    def check(self, *tables: ByAngle) -> None:
        """The finest grid is fine enough half-way between some of its nodes."""
        white = self.weights.sum(axis=0)
        for cosine in (np.linspace(0.02, 0.99, 24) * (_MOST_ROWS - 1)).round() + 0.5:
            place = float(cosine / (_MOST_ROWS - 1))
            per_nm = max(32.0, 2.0 ** self._log_per_nm(place, 1.0))
            self._require_work(np.array([24 * per_nm]))
            for table, xyz in zip(tables, self.at(place, per_nm), strict=True):
                seen = table.at(np.arccos(place))
                labs = (colour.lab_from_xyz(each.clip(0), white) for each in (seen, xyz))
                if float(colour.delta_e_2000(*labs)) > _TOLERANCE:
                    raise InputError(
                        f"stack has {len(self.stack)} layers whose colours change too fast with "
                        f"the angle; allowed: what {_MOST_ROWS} angles show to CIEDE2000 0.2"
                    )

    def _places(self) -> int:
        """Wavenumbers at which lines are looked for: at most a quarter of a fringe apart."""
        fringes = 2e3 * self.stack.total_um * 8 * (1 / _FIRST_NM - 1 / colour.WAVELENGTH_NM[-1])
        steps = math.ceil(float(fringes) * max(1.0, _densest(self.stack) / 2))
        return max(_FEWEST_PLACES, steps) + 1

    def _log_per_nm(self, cosine: float, least: float) -> float:
        """Samples a nm that resolve the lines at an angle, as a power of 2; 0 where none matter.

        least: the lesser of R and T there.
        """
        nm = colour.WAVELENGTH_NM
        wavenumber = np.linspace(1 / nm[-1], 1 / _FIRST_NM, self._places())
        at_nm = 1 / wavenumber
        stack, angle = self.stack.at(at_nm), np.array([np.arccos(cosine)])
        _, _, width, height = _core.resonances(stack, angle, at_nm, self.polarisation)
        held = np.pi * width * height / np.ptp(wavenumber)
        order = np.argsort(width)
        counts = np.cumsum(held[order]) > max(_UNRESOLVED * least, _UNSEEN)
        if not counts.any():
            return 0.0
        narrowest = float(width[order[counts.argmax()]])
        return max(0.0, math.log2(_STEPS_TO_HALF_WIDTH / (narrowest * _FIRST_NM**2)))


def _densest(stack: LayerStack) -> float:
    """The largest index of a layer that is given by numbers; those with names are all below 2."""
    media = (stack.aragonite, stack.protein)
    known = [sampled("layer", medium, colour.WAVELENGTH_NM) for medium in media]
    numbers = [n for n in known if not isinstance(n, str)]
    parts = [part for n in numbers for part in (n[-2:] if isinstance(n, tuple) else (n,))]
    return max((float(np.asarray(part).real.max()) for part in parts), default=0.0)


def _between(
    cosine: NDArray[np.float64], table: NDArray[np.float64], at: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Columns of a table at other cosines, by straight lines."""
    return np.stack([np.interp(at, cosine, column) for column in table.T], axis=1)


def _to_grazing(cosine: NDArray[np.float64], table: NDArray[np.float64]) -> NDArray[np.float64]:
    """A table on the finest grid, by a parabola from the first node that is known to grazing."""
    fine = np.linspace(0.0, 1.0, _MOST_ROWS)
    smooth = _between(cosine, table, fine)
    first = int(np.searchsorted(cosine, _GRAZING))
    one, two = cosine[first], cosine[2 * first]
    near = fine[fine < one]
    rise, next_rise = ((table[at] - table[0]) / cosine[at] for at in (first, 2 * first))
    bend = (next_rise - rise) / (two - one)
    smooth[: near.size] = table[0] + near[:, None] * (rise + bend * (near[:, None] - one))
    return smooth


def _checked(stack: LayerStack, light: str | ArrayLike) -> tuple[_core.Stack, NDArray[np.float64]]:
    if not isinstance(stack, LayerStack):
        raise InputError(f"stack is {said(stack)}; allowed: a LayerStack")
    spectrum = colour.illuminant(light) if isinstance(light, str) else array_of("light", light)
    if spectrum.shape != (401,):
        raise InputError(f"light has shape {list(spectrum.shape)}; allowed: [401]")
    return stack.at(colour.WAVELENGTH_NM), spectrum


keep_former_names(__name__, {"illuminant": "illuminant_model"})


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

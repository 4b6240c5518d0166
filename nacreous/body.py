"""Body colour: nacre that scatters and absorbs, over the nucleus."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core, colour
from nacreous.deprecation import keep_former_names
from nacreous.number import row_of, said, within
from nacreous.problem import InputError

if TYPE_CHECKING:
    from nacreous.spec import Pearl

__all__ = ["PIGMENTS", "absorption", "reflectance", "reflectance_of_body"]

Array = NDArray[np.float64]

#: The pigments that are known by name; their sources stand in data/pigments.csv.
PIGMENTS: tuple[str, ...] = tuple(_core.pigments())


def absorption(name: str) -> Array:
    """Absorption coefficient K per mm, [401] at 380 to 780 nm by 1 nm, of a pigment at strength 1.

    name: one of `PIGMENTS`; "none" is 0 everywhere. Raises `InputError` for another.

    >>> absorption("gold")[[20, 220]].round(2).tolist()  # at 400 and 600 nm
    [1.55, 0.1]
    """
    if not isinstance(name, str):
        raise InputError(f"pigment is {said(name)}; allowed: {', '.join(PIGMENTS)}")
    return _core.pigment_absorption(name)


def reflectance(
    pigment: str = "white",
    nacre_mm: float = 0.5,
    strength: float = 1.0,
    scattering_per_mm: float = 3.0,
    nucleus: str | ArrayLike = "#fcfcfa",
) -> Array:
    """Diffuse reflectance, [401] at 380 to 780 nm by 1 nm, of nacre over a nucleus.

    By Kubelka and Munk (1931), for light that is already inside the pearl: what the surface and the
    film reflect, outside and inside, comes on top of it. Scattering is taken as the same at all
    wavelengths **(ours)**.

    pigment: one of `PIGMENTS`. nacre_mm: thickness of the nacre, 0 to 15. strength: factor on the
    pigment's absorption, 0 to 10. scattering_per_mm: S, 0 to 1000. nucleus: its colour without its
    surface, "#rrggbb", which stands for a smooth reflectance of that colour under D65, or a
    reflectance [401], 0 to 1. Raises `InputError` for what cannot be.

    >>> white = reflectance("none", nucleus="#ffffff")
    >>> white.shape, float(white.min()), float(white.max())
    ((401,), 1.0, 1.0)
    """
    absorbed = within("strength", strength, 0, 10) * absorption(pigment)
    return _core.kubelka_munk(
        within("scattering_per_mm", scattering_per_mm, 0, 1000),
        absorbed,
        within("nacre_mm", nacre_mm, 0, 15),
        _nucleus(nucleus),
    )


def _nucleus(given: str | ArrayLike) -> Array:
    """The nucleus as a reflectance [401]."""
    if isinstance(given, str):
        return _core.smooth_reflectance(colour.linear_from_hex(given))
    row = row_of("nucleus", given)
    if row.shape != colour.WAVELENGTH_NM.shape:
        raise InputError(f"nucleus has shape {list(row.shape)}; allowed: [401]")
    outside = np.flatnonzero(~((row >= 0) & (row <= 1)))
    if outside.size:
        at = int(outside[0])
        raise InputError(f"nucleus[{at}] is {row[at]:g}; allowed: 0 to 1")
    return np.ascontiguousarray(row)


def reflectance_of_body(pearl: Pearl, nacre_mm_of_stack: float) -> Array:
    """Reflectance [401] of a pearl's body, as its file says.

    nacre_mm_of_stack: thickness of its layers in mm, 0 or more, for a file that leaves
    body.nacre_mm out; more than the pearl's radius counts as the radius. Raises `InputError`.

    >>> from nacreous.spec import Pearl
    >>> gold = Pearl(body={"pigment": "gold"})
    >>> thin, thick = (reflectance_of_body(gold, nacre_mm) for nacre_mm in (0.1, 0.5))
    >>> bool(thin[60] > thick[60])  # at 440 nm
    True
    """
    of_layers_mm = within("nacre_mm_of_stack", nacre_mm_of_stack, 0, 1e6)
    return _core.body_reflectance(pearl.model_dump_json(), of_layers_mm)


keep_former_names(__name__, {"of_pearl": "reflectance_of_body"})


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

"""Numbers as this room takes them, and the wavelengths of its spectra."""

from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.problem import InputError
from nacreous.unchanging import settled

Array = NDArray[np.float64]

#: No light of a surface, and no code value but of light 160 times as bright as white, is larger;
#: 8-bit codes and percentages are.
_MOST_RELATIVE = 10.0
#: L* of that.
_MOST_LIGHTNESS = 116 * _MOST_RELATIVE ** (1 / 3) - 16
#: Nothing but the darkest colours in percent, and every colour where 1 is white, is below.
_DARK = 0.012

WAVELENGTH_NM: Array = settled(_core.spectrum_wavelength_nm())
"""Wavelength of each sample of a spectrum: 380, 381 ... 780 nm."""


def array_of(quantity: str, values: ArrayLike) -> Array:
    """Numbers as the bindings take them: float64, in one block of memory."""
    try:
        array = np.asarray(values)
    except ValueError:  # rows of unequal length
        raise InputError(f"{quantity} is ragged; allowed: an array of numbers") from None
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise InputError(
            f"{quantity} has masked values; allowed: numbers, such as values.filled(0)"
        )
    if array.dtype.kind not in "iuf":
        raise InputError(f"{quantity} has type {array.dtype}; allowed: an array of real numbers")
    if array.dtype == np.uint8:
        raise InputError(
            f"{quantity} has type uint8, the codes 0 to 255 of a picture; "
            "allowed: numbers where 1 is white, as in decode(codes / 255)"
        )
    return np.asarray(array, dtype=np.float64, order="C")


def light_of(quantity: str, values: ArrayLike, white: float = 1.0) -> Array:
    """Linear light, where `white` is white's largest component; not codes, and not percentages.

    Lamps and what mirrors them are hundreds of times as bright as white, so no number is too large
    for light. But nobody counts light in whole numbers: those are codes, or XYZ in percent.
    """
    array = array_of(quantity, values)
    if np.asarray(values).dtype.kind not in "iu":
        return array
    beyond = np.argwhere(np.abs(array) > _MOST_RELATIVE * max(white, 1.0))
    if len(beyond):
        place = tuple(beyond[0].tolist())
        raise InputError(
            f"{_at(quantity, place)} is {array[place]:.0f}, of type {np.asarray(values).dtype}; "
            "allowed: floating-point numbers where 1 is white, as decode(codes / 255) gives, "
            "and percentages / 100"
        )
    return array


def surface_of(quantity: str, values: ArrayLike, white: float) -> Array:
    """XYZ of surfaces, on the scale of a white of this largest component."""
    array = light_of(quantity, values, white)
    beyond = np.argwhere(np.isfinite(array) & (np.abs(array) > _MOST_RELATIVE * white))
    if len(beyond):
        place = tuple(beyond[0].tolist())
        raise InputError(
            f"{_at(quantity, place)} is {array[place]:g} beside a white of {white:g}; allowed: "
            f"up to {_MOST_RELATIVE:g} times it (percentages / 100, or with a white in percent)"
        )
    most = float(np.abs(array).max(initial=0.0))
    if white > _MOST_RELATIVE and 0 < most <= _DARK * white:
        warnings.warn(
            f"{quantity} is at most {most:g} beside a white of {white:g}, darker than L* 11; "
            "if 1 is white in it, divide the white by 100",
            stacklevel=3,
        )
    return array


def lab_of(quantity: str, values: ArrayLike) -> Array:
    """L*, a*, b* of surfaces: L* up to that of 10 times white, as `surface_of` takes XYZ."""
    array = array_of(quantity, values)
    if array.shape[-1:] != (3,):
        return array  # told where it is used
    lightness = array[..., 0]
    beyond = np.argwhere(np.isfinite(lightness) & (lightness > _MOST_LIGHTNESS))
    if len(beyond):
        place = (*beyond[0].tolist(), 0)
        raise InputError(
            f"{_at(quantity, place)} is {array[place]:g}; allowed: L* up to {_MOST_LIGHTNESS:.0f}, "
            "of which 100 is white (not codes 0 to 255)"
        )
    return array


def relative_of(quantity: str, values: ArrayLike) -> Array:
    """Numbers of which 1 is white, not 255 and not 100."""
    return bounded_of(quantity, values, _MOST_RELATIVE, "1 is white, and no surface reaches 10")


def bounded_of(quantity: str, values: ArrayLike, most: float, why: str) -> Array:
    """Numbers within a bound of zero; what is not finite is told where it is used."""
    array = array_of(quantity, values)
    beyond = np.argwhere(np.isfinite(array) & (np.abs(array) > most))
    if len(beyond):
        place = tuple(beyond[0].tolist())
        raise InputError(
            f"{_at(quantity, place)} is {array[place]:g}; allowed: {-most:g} to {most:g} ({why})"
        )
    return array


def _at(quantity: str, place: tuple[int, ...]) -> str:
    return quantity + "".join(f"[{index}]" for index in place)


def white_of(quantity: str, values: ArrayLike) -> tuple[float, float, float]:
    """The three components of a white."""
    array = array_of(quantity, values)
    if array.shape != (3,):
        raise InputError(f"{quantity} has shape {list(array.shape)}; allowed: [3]")
    x, y, z = array.tolist()
    return x, y, z

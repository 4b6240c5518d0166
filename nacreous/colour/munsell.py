"""Munsell hue, value and chroma."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.colour.samples import Array, array_of, bounded_of, relative_of
from nacreous.problem import InputError

#: Light ten times as bright as white, the most that `hvc_from_rgb` takes, has 23.4.
_MOST_VALUE = 25.0


def hvc_from_rgb(rgb: ArrayLike) -> Array:
    """Munsell hue, value and chroma `[..., 3]` of linear sRGB, adapted from D65 to C by Bradford.

    The Mathematical Transform to Munsell (Miyahara and Yoshida 1988). Hue is an angle in rad, -pi
    to pi, that runs R, RP, P, PB, B, BG, G, GY, Y, YR, against Munsell's order; value is 0 black
    to 10 white; chroma is 0 for grey, where hue means nothing. Against the real renotation colours
    of value 2 and more: value within 0.105, chroma 0.76 rms, hue 8 degrees rms.

    Raises `InputError` for components beyond 10: those are codes or percentages.

    >>> hue_rad, value, chroma = hvc_from_rgb([0.80, 0.72, 0.70])
    >>> [round(float(number), 2) for number in (hue_rad, value, chroma)]
    [-0.53, 8.87, 0.76]
    """
    return _core.hvc_from_rgb(relative_of("rgb", rgb))


def rgb_from_hvc(hvc: ArrayLike) -> Array:
    """Linear sRGB `[..., 3]` of hue (rad), value and chroma; leaves 0..1 where sRGB ends.

    Undoes `hvc_from_rgb` to rounding, by Newton's method. Chroma is not negative, or `InputError`
    is raised.

    >>> rgb_from_hvc(hvc_from_rgb([0.80, 0.72, 0.70])).round(9).tolist()
    [0.8, 0.72, 0.7]
    """
    return _core.rgb_from_hvc(_hvc_of(hvc))


def hvc_from_xyz(xyz: ArrayLike) -> Array:
    """Munsell hue (rad), value and chroma `[..., 3]` of XYZ under illuminant C, 2-degree observer.

    >>> hvc_from_xyz([0.3, 0.3, 0.3])[1].round(3).tolist()
    6.165
    """
    return _core.hvc_from_xyz(relative_of("xyz", xyz))


def xyz_from_hvc(hvc: ArrayLike) -> Array:
    """XYZ `[..., 3]` under illuminant C of hue (rad), value and chroma; undoes `hvc_from_xyz`.

    >>> xyz_from_hvc([0, 10, 0]).round(4).tolist()
    [0.9807, 1.0, 1.1822]
    """
    return _core.xyz_from_hvc(_hvc_of(hvc))


def munsell_notation(hvc: ArrayLike) -> NDArray[np.str_]:
    """Munsell notation `[...]`, to one decimal, of hue (rad), value and chroma `[..., 3]`.

    >>> munsell_notation([[0.1, 6, 8], [0, 5.2, 0]]).tolist()
    ['7.5RP 6/8', 'N 5.2/']
    """
    array = _hvc_of(hvc)
    return np.array(_core.munsell_notation(array), dtype=np.str_).reshape(array.shape[:-1])


def _hvc_of(hvc: ArrayLike) -> Array:
    """Hue, value and chroma, of which no hue is in degrees and no value in percent."""
    array = array_of("hvc", hvc)
    if array.shape[-1:] == (3,):
        bounded_of("hue of hvc", array[..., 0], 4 * np.pi, "hue is in rad")
        highest = np.max(array[..., 1], initial=0.0)
        if _MOST_VALUE < highest < np.inf:
            raise InputError(
                f"value of hvc is {highest:g}; allowed: up to {_MOST_VALUE:g} (10 is white)"
            )
    return array

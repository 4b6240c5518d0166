"""Colours from spectra, and from one space into another."""

from __future__ import annotations

import re
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from nacreous import _core
from nacreous.colour.samples import (
    WAVELENGTH_NM,
    Array,
    array_of,
    lab_of,
    light_of,
    relative_of,
    surface_of,
    white_of,
)
from nacreous.number import said
from nacreous.problem import InputError

Observer = Literal["1931-2", "1964-10"]
Space = Literal["srgb", "display-p3"]


def linear_from_hex(code: str) -> tuple[float, float, float]:
    """Linear sRGB of a colour written as "#rrggbb" in sRGB codes.

    >>> linear_from_hex("#ff0000")
    (1.0, 0.0, 0.0)
    """
    if not isinstance(code, str):
        raise InputError(f'colour is {said(code)}; allowed: "#rrggbb" with hexadecimal digits')
    if not re.fullmatch("#[0-9a-fA-F]{6}", code):
        raise InputError(f'colour is "{code}"; allowed: "#rrggbb" with hexadecimal digits')
    codes = [int(code[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    red, green, blue = decode(codes).tolist()
    return red, green, blue


def xyz_from_spectrum(
    spectra: ArrayLike,
    illuminant: str | ArrayLike = "E",
    observer: Observer = "1931-2",
) -> Array:
    """XYZ `[..., 3]` of reflectances or other relative spectra `[..., 401]` under a light.

    The sum over 380 to 780 nm by 1 nm of spectrum x light x colour-matching functions (CIE 015),
    scaled so that 1 at every wavelength has Y = 1. The light is a name for `illuminant` or a
    spectrum `[401]`, such as one from `spectrum_from_csv`. The observer is CIE 1931 (2 degrees)
    or CIE 1964 (10 degrees).

    Raises `InputError` for negative values, other shapes, unknown names and a light without
    luminance.

    >>> xyz_from_spectrum(np.full(401, 0.18), illuminant="D50").round(3).tolist()
    [0.174, 0.18, 0.149]
    """
    light = (
        _core.illuminant_spectrum(illuminant)
        if isinstance(illuminant, str)
        else array_of("illuminant", illuminant)
    )
    if light.ndim != 1:
        raise InputError(f"illuminant has shape {list(light.shape)}; allowed: [401]")
    return _core.xyz_from_spectrum(array_of("spectra", spectra), light, str(observer))


def white_xyz(illuminant: str | ArrayLike = "D65", observer: Observer = "1931-2") -> Array:
    """XYZ `[3]` of the perfect reflecting diffuser under a light: Y is 1.

    >>> white_xyz("E").round(3).tolist()
    [1.0, 1.0, 1.0]
    """
    return xyz_from_spectrum(np.ones(len(WAVELENGTH_NM)), illuminant, observer)


def lab_from_xyz(xyz: ArrayLike, white: ArrayLike | None = None) -> Array:
    """CIE L*, a*, b* `[..., 3]` of XYZ, relative to the XYZ of white `[3]` (CIE 015, 8.2.1).

    White is D65's for the 2-degree observer unless given; of XYZ from RGB it is better
    `xyz_from_rgb([1, 1, 1])`, whose chromaticity the standard of sRGB rounds (0.03 in b*).

    XYZ and white are on one scale: where white is not given, Y of white is 1, and XYZ in percent
    are to be divided by 100. Lab is of surfaces: XYZ beyond 10 times white's largest component, L*
    234, raise `InputError`, as XYZ in percent do that are not very dark; light is to be cut before.
    XYZ all below 1.2 % of a white in percent give a warning: is 1 white in them? XYZ may be
    negative (colours outside any gamut); the straight line near 0 goes on. The components of white
    are positive, or `InputError` is raised.

    >>> lab_from_xyz([0.18, 0.18, 0.18], white=[1, 1, 1]).round(2).tolist()
    [49.5, 0.0, 0.0]
    >>> lab_from_xyz(white_xyz("D65")).tolist()
    [100.0, 0.0, 0.0]
    """
    reference = _white_or_d65(white)
    return _core.lab_from_xyz(surface_of("xyz", xyz, max(reference)), reference)


def xyz_from_lab(lab: ArrayLike, white: ArrayLike | None = None) -> Array:
    """XYZ `[..., 3]` of L*, a*, b*, relative to the XYZ of white `[3]`; D65 unless given.

    L* is 0 black to 100 white, not 0 to 1, which cannot be told from dark colours, and not 0 to
    255: L* above 234, that of 10 times white, raises `InputError`, as `lab_from_xyz` gives none.

    >>> xyz_from_lab([100, 0, 0], white=[1, 1, 1]).tolist()
    [1.0, 1.0, 1.0]
    """
    return _core.xyz_from_lab(lab_of("lab", lab), _white_or_d65(white))


def _white_or_d65(white: ArrayLike | None) -> tuple[float, float, float]:
    """The white that was given; D65 otherwise, as most who work with screens mean."""
    return white_of("white", white_xyz("D65") if white is None else white)


def delta_e_2000(first: ArrayLike, second: ArrayLike) -> Array:
    """CIEDE2000 colour difference `[...]` of L*, a*, b* `[..., 3]`; about 1 is just visible.

    All parametric factors are 1 (ISO/CIE 11664-6; Sharma, Wu and Dalal 2005). L* is 0 to 100, as
    `lab_from_xyz` gives it; above 234 it raises `InputError`, as in `xyz_from_lab`. The arrays are
    broadcast against each other.

    >>> float(delta_e_2000([50, 2.6772, -79.7751], [50, 0, -82.7485]).round(4))
    2.0425
    """
    arrays = lab_of("first", first), lab_of("second", second)
    try:
        one, other = np.broadcast_arrays(*arrays)
    except ValueError:
        shapes = [list(array.shape) for array in arrays]
        raise InputError(
            f"first and second have shapes {shapes[0]} and {shapes[1]}; allowed: equal shapes"
        ) from None
    return _core.delta_e_2000(np.array(one, order="C"), np.array(other, order="C"))


def rgb_from_xyz(xyz: ArrayLike, space: Space = "srgb") -> Array:
    """Linear RGB `[..., 3]` of XYZ relative to D65, in sRGB (IEC 61966-2-1) or Display P3.

    Y of white is 1, in XYZ and in RGB: XYZ in percent are to be divided by 100. Nothing tells them
    from light brighter than white, so they pass where they are floating-point numbers; whole
    numbers above 10 are refused.
    Components leave 0..1 where the space cannot show the colour; see `map_to_gamut`. XYZ seen under
    another white goes through `adapt` first.

    >>> rgb_from_xyz(xyz_from_rgb([0.2, 0.5, 0.8])).round(9).tolist()
    [0.2, 0.5, 0.8]
    """
    return _core.rgb_from_xyz(light_of("xyz", xyz), str(space))


def xyz_from_rgb(rgb: ArrayLike, space: Space = "srgb") -> Array:
    """XYZ `[..., 3]` relative to D65 of linear RGB, of which 1 is white; codes go through `decode`.

    Floating-point numbers above 1 are light brighter than white, as a renderer's highlights are;
    whole numbers above 10 are refused, for they are codes. All functions of linear RGB do so.

    >>> xyz_from_rgb([1, 1, 1]).round(4).tolist()
    [0.9505, 1.0, 1.0891]
    """
    return _core.xyz_from_rgb(light_of("rgb", rgb), str(space))


def p3_from_srgb(rgb: ArrayLike) -> Array:
    """Linear Display P3 `[..., 3]` of linear sRGB.

    >>> p3_from_srgb([1, 0, 0]).round(4).tolist()
    [0.8225, 0.0332, 0.0171]
    """
    return rgb_from_xyz(xyz_from_rgb(rgb, "srgb"), "display-p3")


def srgb_from_p3(rgb: ArrayLike) -> Array:
    """Linear sRGB `[..., 3]` of linear Display P3; leaves 0..1 for its strong colours.

    >>> srgb_from_p3([1, 0, 0]).round(4).tolist()
    [1.2249, -0.0421, -0.0196]
    """
    return rgb_from_xyz(xyz_from_rgb(rgb, "display-p3"), "srgb")


def encode(rgb: ArrayLike) -> Array:
    """Code values `[..., 3]` of linear RGB by the sRGB transfer function, the same for Display P3.

    Code values of linear components within 0..1 lie within 0..1; the function is odd about 0. Light
    brighter than white has codes above 1. Whole numbers above 10 are codes already, and refused.

    >>> encode([0.0, 0.5, 1.0]).round(4).tolist()
    [0.0, 0.7354, 1.0]
    """
    return _core.encode_rgb(light_of("rgb", rgb))


def decode(encoded: ArrayLike) -> Array:
    """Linear RGB `[..., 3]` of code values, of which 1 is white; undoes `encode`.

    Raises `InputError` for values beyond 10: those are codes 0 to 255, to be divided by 255.

    >>> decode([0.0, 0.7354, 1.0]).round(3).tolist()
    [0.0, 0.5, 1.0]
    """
    return _core.decode_rgb(relative_of("encoded", encoded))


def adapt(xyz: ArrayLike, from_white: ArrayLike, to_white: ArrayLike) -> Array:
    """XYZ `[..., 3]` that look under `to_white` as `xyz` do under `from_white`: linear Bradford.

    Whites are XYZ `[3]` that all three cones see, or `InputError` is raised. `xyz` are on the scale
    of `from_white`, the result on that of `to_white`.

    >>> white_of_screen = xyz_from_rgb([1, 1, 1])
    >>> paper = adapt(white_xyz("A"), from_white=white_xyz("A"), to_white=white_of_screen)
    >>> rgb_from_xyz(paper).round(9).tolist()
    [1.0, 1.0, 1.0]
    """
    seen, wanted = white_of("from_white", from_white), white_of("to_white", to_white)
    return _core.adapt_xyz(light_of("xyz", xyz, max(seen)), seen, wanted)


def map_to_gamut(
    rgb: ArrayLike, method: Literal["clip", "soft"] = "clip", space: Space = "srgb"
) -> Array:
    """Linear RGB `[..., 3]` within 0..1.

    `clip` cuts each channel. `soft` **(ours)** bends luminance above 0.8 smoothly towards white,
    then draws strong colours towards the grey of their luminance along the same knee, so that hue
    direction is kept; it changes nothing within 0.8 of the way from grey to the limit.

    >>> map_to_gamut([-0.2, 0.7, 1.4]).tolist()
    [0.0, 0.7, 1.0]
    >>> map_to_gamut([-0.2, 0.7, 0.1], "soft").round(3).tolist()
    [0.022, 0.622, 0.222]
    """
    return _core.map_to_gamut(light_of("rgb", rgb), str(method), str(space))


def out_of_gamut_share(rgb: ArrayLike) -> float:
    """Share, 0 to 1, of linear colours `[..., 3]` that leave 0..1, by more than 1e-6.

    A linear colour of 1 is white; whole numbers above 10 are codes, and refused.

    >>> out_of_gamut_share([[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]])
    0.5
    """
    return _core.out_of_gamut_share(light_of("rgb", rgb))

"""From spectra to colour: XYZ, Lab, RGB and Munsell hue, value, chroma.

Spectra are float64 arrays `[..., 401]`, 380 to 780 nm by 1 nm (`WAVELENGTH_NM`); colours are
float64 arrays `[..., 3]`. Conversions are named output first. XYZ is relative: Y = 1 is the
perfect reflecting diffuser. RGB is linear light, relative to white D65, until `encode`.

Numbers must be finite and within 1e12 of zero; whatever is not raises `InputError` with one line
that names the quantity, its place and what is allowed.

>>> coral = np.where(WAVELENGTH_NM < 600, 0.1, 0.6)
>>> rgb = rgb_from_xyz(xyz_from_spectrum(coral, illuminant="D65"))
>>> encode(rgb).round(2).tolist()
[0.75, 0.32, 0.34]
"""

from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.problem import InputError

Array = NDArray[np.float64]
Observer = Literal["1931-2", "1964-10"]
Space = Literal["srgb", "display-p3"]

WAVELENGTH_NM: Array = _core.spectrum_wavelength_nm()
"""Wavelength of each sample of a spectrum: 380, 381 ... 780 nm."""
WAVELENGTH_NM.flags.writeable = False

_LARGEST_TABLE_BYTES = 1_000_000


def illuminant(name: str) -> Array:
    """Relative spectrum of a light, float64 `[401]`, 1 at 560 nm.

    `name` is `A` (tungsten), `D50`, `D65` (daylight), `E` (equal energy) or a colour temperature
    from `1000K` to `25000K`: CIE daylight from 4000 K up, Planck's law below (CIE 015).

    Raises `InputError` for any other name.

    >>> lamp = illuminant("2700K")
    >>> bool(lamp[WAVELENGTH_NM == 650] > lamp[WAVELENGTH_NM == 450])
    True
    """
    return _core.illuminant_spectrum(str(name))


def spectrum_from_csv(path: str | Path) -> Array:
    r"""Spectrum in a file, float64 `[401]`, interpolated linearly.

    The file has two columns, `wavelength_nm,value`; a header row is optional, `#` begins a
    comment. Wavelengths increase and cover 380 to 780 nm, values are not negative, and the file
    has at most 1 MB.

    Raises `InputError` naming the file, and the line where one is at fault.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder) / "lamp.csv"
    ...     _ = file.write_text("wavelength_nm,value\n380,0\n780,4\n")
    ...     float(spectrum_from_csv(file)[100])
    1.0
    """
    try:
        with Path(path).open("rb") as file:
            content = file.read(_LARGEST_TABLE_BYTES + 1)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    if len(content) > _LARGEST_TABLE_BYTES:
        raise InputError(f"{path}: a spectrum of more than 1 MB; allowed: up to 1 MB")
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        raise InputError(f"{path}: not text; allowed: a table in UTF-8") from None
    return _core.spectrum_from_csv(text, str(path))


def light(name_or_path: str) -> Array:
    """Relative spectrum of a light given as files of scenes give it: a name, or a table's path.

    >>> bool(np.array_equal(light("D65"), illuminant("D65")))
    True
    """
    if name_or_path.lower().endswith(".csv"):
        return spectrum_from_csv(name_or_path)
    return illuminant(name_or_path)


def linear_from_hex(code: str) -> tuple[float, float, float]:
    """Linear sRGB of a colour written as "#rrggbb" in sRGB codes.

    >>> linear_from_hex("#ff0000")
    (1.0, 0.0, 0.0)
    """
    try:
        codes = [int(code[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    except ValueError:
        codes = []
    if len(code) != 7 or code[0] != "#" or not codes:
        raise InputError(f'colour is "{code}"; allowed: "#rrggbb" with hexadecimal digits')
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
        else _array("illuminant", illuminant)
    )
    if light.ndim != 1:
        raise InputError(f"illuminant has shape {list(light.shape)}; allowed: [401]")
    return _core.xyz_from_spectrum(_array("spectra", spectra), light, str(observer))


def white_xyz(illuminant: str | ArrayLike = "D65", observer: Observer = "1931-2") -> Array:
    """XYZ `[3]` of the perfect reflecting diffuser under a light: Y is 1.

    >>> white_xyz("E").round(3).tolist()
    [1.0, 1.0, 1.0]
    """
    return xyz_from_spectrum(np.ones(len(WAVELENGTH_NM)), illuminant, observer)


def lab_from_xyz(xyz: ArrayLike, white: ArrayLike) -> Array:
    """CIE L*, a*, b* `[..., 3]` of XYZ, relative to the XYZ of white `[3]` (CIE 015, 8.2.1).

    XYZ may be negative (colours outside any gamut); the straight line near 0 goes on. The
    components of white are positive, or `InputError` is raised.

    >>> lab_from_xyz([0.18, 0.18, 0.18], white=[1, 1, 1]).round(2).tolist()
    [49.5, 0.0, 0.0]
    """
    return _core.lab_from_xyz(_array("xyz", xyz), _white("white", white))


def xyz_from_lab(lab: ArrayLike, white: ArrayLike) -> Array:
    """XYZ `[..., 3]` of L*, a*, b*, relative to the XYZ of white `[3]`.

    >>> xyz_from_lab([100, 0, 0], white=[1, 1, 1]).tolist()
    [1.0, 1.0, 1.0]
    """
    return _core.xyz_from_lab(_array("lab", lab), _white("white", white))


def delta_e_2000(first: ArrayLike, second: ArrayLike) -> Array:
    """CIEDE2000 colour difference `[...]` of L*, a*, b* `[..., 3]`; about 1 is just visible.

    All parametric factors are 1 (ISO/CIE 11664-6; Sharma, Wu and Dalal 2005). The arrays are
    broadcast against each other.

    >>> float(delta_e_2000([50, 2.6772, -79.7751], [50, 0, -82.7485]).round(4))
    2.0425
    """
    arrays = _array("first", first), _array("second", second)
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

    Components leave 0..1 where the space cannot show the colour; see `map_to_gamut`. XYZ seen under
    another white goes through `adapt` first.

    >>> rgb_from_xyz(xyz_from_rgb([0.2, 0.5, 0.8])).round(9).tolist()
    [0.2, 0.5, 0.8]
    """
    return _core.rgb_from_xyz(_array("xyz", xyz), str(space))


def xyz_from_rgb(rgb: ArrayLike, space: Space = "srgb") -> Array:
    """XYZ `[..., 3]` relative to D65 of linear RGB.

    >>> xyz_from_rgb([1, 1, 1]).round(4).tolist()
    [0.9505, 1.0, 1.0891]
    """
    return _core.xyz_from_rgb(_array("rgb", rgb), str(space))


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

    Code values of linear components within 0..1 lie within 0..1; the function is odd about 0.

    >>> encode([0.0, 0.5, 1.0]).round(4).tolist()
    [0.0, 0.7354, 1.0]
    """
    return _core.encode_rgb(_array("rgb", rgb))


def decode(encoded: ArrayLike) -> Array:
    """Linear RGB `[..., 3]` of code values; undoes `encode`.

    >>> decode([0.0, 0.7354, 1.0]).round(3).tolist()
    [0.0, 0.5, 1.0]
    """
    return _core.decode_rgb(_array("encoded", encoded))


def adapt(xyz: ArrayLike, from_white: ArrayLike, to_white: ArrayLike) -> Array:
    """XYZ `[..., 3]` that look under `to_white` as `xyz` do under `from_white`: linear Bradford.

    Whites are XYZ `[3]` that all three cones see, or `InputError` is raised.

    >>> white_of_screen = xyz_from_rgb([1, 1, 1])
    >>> paper = adapt(white_xyz("A"), from_white=white_xyz("A"), to_white=white_of_screen)
    >>> rgb_from_xyz(paper).round(9).tolist()
    [1.0, 1.0, 1.0]
    """
    return _core.adapt_xyz(
        _array("xyz", xyz), _white("from_white", from_white), _white("to_white", to_white)
    )


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
    return _core.map_to_gamut(_array("rgb", rgb), str(method), str(space))


def out_of_gamut_share(rgb: ArrayLike) -> float:
    """Share, 0 to 1, of linear colours `[..., 3]` that leave 0..1, by more than 1e-6.

    >>> out_of_gamut_share([[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]])
    0.5
    """
    return _core.out_of_gamut_share(_array("rgb", rgb))


def hvc_from_rgb(rgb: ArrayLike) -> Array:
    """Munsell hue, value and chroma `[..., 3]` of linear sRGB, adapted from D65 to C by Bradford.

    The Mathematical Transform to Munsell (Miyahara and Yoshida 1988). Hue is an angle in rad, -pi
    to pi, that runs R, RP, P, PB, B, BG, G, GY, Y, YR, against Munsell's order; value is 0 black
    to 10 white; chroma is 0 for grey, where hue means nothing. Against the real renotation colours
    of value 2 and more: value within 0.105, chroma 0.76 rms, hue 8 degrees rms.

    >>> hue_rad, value, chroma = hvc_from_rgb([0.80, 0.72, 0.70])
    >>> [round(float(number), 2) for number in (hue_rad, value, chroma)]
    [-0.53, 8.87, 0.76]
    """
    return _core.hvc_from_rgb(_array("rgb", rgb))


def rgb_from_hvc(hvc: ArrayLike) -> Array:
    """Linear sRGB `[..., 3]` of hue (rad), value and chroma; leaves 0..1 where sRGB ends.

    Undoes `hvc_from_rgb` to rounding, by Newton's method. Chroma is not negative, or `InputError`
    is raised.

    >>> rgb_from_hvc(hvc_from_rgb([0.80, 0.72, 0.70])).round(9).tolist()
    [0.8, 0.72, 0.7]
    """
    return _core.rgb_from_hvc(_array("hvc", hvc))


def hvc_from_xyz(xyz: ArrayLike) -> Array:
    """Munsell hue (rad), value and chroma `[..., 3]` of XYZ under illuminant C, 2-degree observer.

    >>> hvc_from_xyz([0.3, 0.3, 0.3])[1].round(3).tolist()
    6.165
    """
    return _core.hvc_from_xyz(_array("xyz", xyz))


def xyz_from_hvc(hvc: ArrayLike) -> Array:
    """XYZ `[..., 3]` under illuminant C of hue (rad), value and chroma; undoes `hvc_from_xyz`.

    >>> xyz_from_hvc([0, 10, 0]).round(4).tolist()
    [0.9807, 1.0, 1.1822]
    """
    return _core.xyz_from_hvc(_array("hvc", hvc))


def munsell_notation(hvc: ArrayLike) -> NDArray[np.str_]:
    """Munsell notation `[...]`, to one decimal, of hue (rad), value and chroma `[..., 3]`.

    >>> munsell_notation([[0.1, 6, 8], [0, 5.2, 0]]).tolist()
    ['7.5RP 6/8', 'N 5.2/']
    """
    array = _array("hvc", hvc)
    return np.array(_core.munsell_notation(array), dtype=np.str_).reshape(array.shape[:-1])


def _array(quantity: str, values: ArrayLike) -> Array:
    """Numbers as the bindings take them: float64, in one block of memory."""
    try:
        array = np.asarray(values)
    except ValueError:  # rows of unequal length
        raise InputError(f"{quantity} is ragged; allowed: an array of numbers") from None
    if array.dtype.kind not in "iuf":
        raise InputError(f"{quantity} has type {array.dtype}; allowed: an array of real numbers")
    return np.asarray(array, dtype=np.float64, order="C")


def _white(quantity: str, values: ArrayLike) -> tuple[float, float, float]:
    array = _array(quantity, values)
    if array.shape != (3,):
        raise InputError(f"{quantity} has shape {list(array.shape)}; allowed: [3]")
    x, y, z = array.tolist()
    return x, y, z

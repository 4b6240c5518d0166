"""From spectra to colour: XYZ, Lab, RGB and Munsell hue, value, chroma.

Spectra are float64 arrays `[..., 401]`, 380 to 780 nm by 1 nm (`WAVELENGTH_NM`); colours are
float64 arrays `[..., 3]`. Conversions are named output first. XYZ is relative: Y = 1 is the
perfect reflecting diffuser. RGB is linear light, relative to white D65, until `encode`.

Numbers must be finite and within 1e12 of zero; whatever is not raises `InputError` with one line
that names the quantity, its place and what is allowed.

>>> import numpy as np
>>> coral = np.where(WAVELENGTH_NM < 600, 0.1, 0.6)
>>> rgb = rgb_from_xyz(xyz_from_spectrum(coral, illuminant="D65"))
>>> encode(rgb).round(2).tolist()
[0.75, 0.32, 0.34]
"""

from nacreous.colour.conversion import (
    Observer,
    Space,
    adapt,
    decode,
    delta_e_2000,
    encode,
    lab_from_xyz,
    linear_from_hex,
    map_to_gamut,
    out_of_gamut_share,
    p3_from_srgb,
    rgb_from_xyz,
    srgb_from_p3,
    white_xyz,
    xyz_from_lab,
    xyz_from_rgb,
    xyz_from_spectrum,
)
from nacreous.colour.light import (
    illuminant,
    light,
    spectrum_from_csv,
)
from nacreous.colour.munsell import (
    hvc_from_rgb,
    hvc_from_xyz,
    munsell_notation,
    rgb_from_hvc,
    xyz_from_hvc,
)
from nacreous.colour.samples import (
    WAVELENGTH_NM,
    Array,
)

__all__ = [
    "WAVELENGTH_NM",
    "Array",
    "Observer",
    "Space",
    "adapt",
    "decode",
    "delta_e_2000",
    "encode",
    "hvc_from_rgb",
    "hvc_from_xyz",
    "illuminant",
    "lab_from_xyz",
    "light",
    "linear_from_hex",
    "map_to_gamut",
    "munsell_notation",
    "out_of_gamut_share",
    "p3_from_srgb",
    "rgb_from_hvc",
    "rgb_from_xyz",
    "spectrum_from_csv",
    "srgb_from_p3",
    "white_xyz",
    "xyz_from_hvc",
    "xyz_from_lab",
    "xyz_from_rgb",
    "xyz_from_spectrum",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

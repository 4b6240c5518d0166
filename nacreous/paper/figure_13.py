"""Figure 13: the grain's texture in lightness (V)."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import _core, colour
from nacreous.image import Image
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import PATCH_MM, PATCH_PX, Pictures
from nacreous.texture import GrainSpectrum

__all__ = ["FILES", "band_share", "exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-13.png", "figure-13-pearl.png")
#: The third of HVC textures, in the renderer's order hue, value, chroma.
_VALUE = 1
#: Standard deviations between middle grey and black or white.
_RANGE = 3.0


def measure(
    patch: Array, over_pearl: Array, width_mm: float, band_per_mm: tuple[float, float]
) -> list[Measurement]:
    """What the paper's sentences ask of a square patch of V texture, `width_mm` wide.

    over_pearl: the texture at all pixels of the pearl, [n]. band_per_mm: limits of the band-pass
    filter in cycles per mm.
    """
    spread = float(over_pearl.std())
    mean = abs(float(over_pearl.mean())) / spread if spread > 0 else float("nan")
    share = band_share(patch, width_mm, band_per_mm)
    low, high = band_per_mm
    return [
        Measurement("mean over the pearl, over the standard deviation", mean, most=0.1),
        Measurement(
            "standard deviation in the patch, of lightness", float(patch.std()), least=1e-3
        ),
        Measurement(f"share of power from {low:g} to {high:g} cycles a mm", share, least=0.9),
    ]


def band_share(patch: Array, width_mm: float, band_per_mm: tuple[float, float]) -> float:
    """Share of the power of a square patch that lies in a band, under a Hanning window (4.3).

    The window smears each frequency over two cycles a patch, by which the band is widened.
    """
    side = len(patch)
    hanning = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(side) / side)
    window = np.outer(hanning, hanning)
    mean = (patch * window).sum() / window.sum()
    power = np.abs(np.fft.fft2((patch - mean) * window)) ** 2
    cycles_per_mm = np.fft.fftfreq(side, width_mm / side)
    frequency = np.hypot(cycles_per_mm[:, None], cycles_per_mm)
    low, high = band_per_mm[0] - 2 / width_mm, band_per_mm[1] + 2 / width_mm
    inside = (low <= frequency) & (frequency <= high)
    total = float(power.sum())
    return float(power[inside].sum() / total) if total > 0 else float("nan")


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the texture of a patch and of the pearl in `folder`, and measure it."""
    patch_path, pearl_path = (folder / name for name in FILES)
    patch = pictures.patch.layers["texture"][..., _VALUE].astype(np.float64)
    value = pictures.grained.layers["texture"][..., _VALUE].astype(np.float64)
    whole = pictures.grained.layers["coverage"][..., 0] == 1
    white = _RANGE * float(patch.std())
    _grey(pictures.patch, patch, white).save(patch_path)
    _grey(pictures.grained, np.where(whole, value, 0.0), white).save(pearl_path)
    # The preset has no photograph; what stands in for one is known by its spectrum.
    spectrum = GrainSpectrum.procedural()
    band = (float(spectrum.cycles_per_mm[0]), float(spectrum.cycles_per_mm[-1]))
    seed = _core.texture_seed(pictures.pearl.model_dump_json())
    return Exhibit(
        "13",
        [
            Plate(patch_path, f"{PATCH_PX} × {PATCH_PX} pixels, {PATCH_MM:g} mm", small=True),
            Plate(pearl_path, "over the pearl"),
        ],
        measure(patch, value[whole], PATCH_MM, band),
        "nacreous render paper -o layers.exr (layer texture, second channel)",
        [
            f"Source of the texture: {spectrum.source}, a stand-in chosen by eye and not measured "
            f"on a pearl (ours). Seed {seed}.",
            f"Middle grey is 0; black and white are −{white:.2g} and {white:.2g} of lightness, "
            f"{_RANGE:g} standard deviations.",
        ],
    )


def _grey(picture: Image, value: Array, white: float) -> Image:
    """Texture as codes evenly from black at -white to white."""
    codes = np.clip(0.5 + 0.5 * value / (white or 1.0), 0.0, 1.0)
    linear = colour.decode(np.repeat(codes[..., None], 3, axis=-1)).astype(np.float32)
    note = json.dumps({"part": "texture, value", "white": white})
    return Image(linear, {}, {**picture.recipe, "component": note})

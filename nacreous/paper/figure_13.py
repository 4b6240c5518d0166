"""Figure 13: the grain's texture in lightness (V)."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.image import Image
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import PATCH_MM, PATCH_PX, Pictures

__all__ = ["exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-13.png", "figure-13-pearl.png")
#: The band that counts as grain, in cycles per mm **(ours)**: that of the procedural stand-in.
BAND_PER_MM = (1.0, 12.0)
#: How many standard deviations lie between middle grey and black, and white.
_RANGE = 3.0


def measure(value: Array, over_pearl: Array, width_mm: float) -> list[Measurement]:
    """What the paper's sentences ask of a square patch of V texture, `width_mm` wide.

    over_pearl: the texture at all pixels of the pearl, [n].
    """
    spread = float(value.std())
    sky = float(over_pearl.std()) if over_pearl.size else 0.0
    mean = abs(float(over_pearl.mean())) / sky if sky > 0 else float("nan")
    return [
        Measurement("mean over the visible half, over its standard deviation", mean, "", None, 0.1),
        Measurement(
            "standard deviation of V in the patch, relative to lightness", spread, "", 1e-3
        ),
        Measurement(
            f"share of the patch's power from {BAND_PER_MM[0]:g} to {BAND_PER_MM[1]:g} cycles per mm",
            band_share(value, width_mm),
            "",
            0.9,
        ),
    ]


def band_share(value: Array, width_mm: float) -> float:
    """Share of the power of a square patch that lies in the band, under a Hanning window (4.3).

    The window smears each frequency over two cycles per patch, by which the band is widened.
    """
    side = value.shape[0]
    hanning = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(side) / side)
    window = np.outer(hanning, hanning)
    mean = (value * window).sum() / window.sum()
    power = np.abs(np.fft.fft2((value - mean) * window)) ** 2
    cycles = np.fft.fftfreq(side, width_mm / side)
    frequency = np.hypot(cycles[:, None], cycles)
    low, high = BAND_PER_MM[0] - 2 / width_mm, BAND_PER_MM[1] + 2 / width_mm
    total = float(power.sum())
    inside = (low <= frequency) & (frequency <= high) & (frequency > 0)
    return float(power[inside].sum() / total) if total > 0 else float("nan")


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the texture of a patch and of the pearl in `folder`, and measure it."""
    patch_path, pearl_path = (folder / name for name in FILES)
    patch = pictures.patch.layers["texture"][..., 1].astype(np.float64)
    value = pictures.grained.layers["texture"][..., 1].astype(np.float64)
    whole = pictures.grained.layers["coverage"][..., 0] == 1
    scale = float(patch.std()) or 1.0
    _grey(pictures.patch, patch, scale).save(patch_path)
    _grey(pictures.grained, np.where(whole, value, 0.0), scale).save(pearl_path)
    over_pearl = value[whole]
    source = pictures.pearl.texture.source
    made = "a procedural stand-in, not measured on a pearl" if source == "procedural" else source
    return Exhibit(
        "13",
        "テクスチャ成分 (明度)",
        "Texture(V).",
        [
            Quotation(
                "実物の真珠の写真から2次元FFT/逆FFTにより抽出した高周波成分を真珠表面にマッピングした。",
                "The high-frequency component, extracted from photographs of real pearls by the "
                "two-dimensional FFT and its inverse, was mapped onto the surface of the pearl.",
                "4.3",
            ),
            Quotation(
                "図13に明度(V)テクスチャの例（濃度スケールを拡大したもの）を示す。",
                "Figure 13 shows an example of a lightness (V) texture, with its grey scale widened.",
                "4.3",
            ),
        ],
        [
            Plate(
                patch_path,
                "A square of irregular light and dark stripes on middle grey.",
                f"{PATCH_PX} × {PATCH_PX} pixels",
                small=True,
            ),
            Plate(pearl_path, "The same texture over the whole pearl.", "over the pearl"),
        ],
        measure(patch, over_pearl, PATCH_MM),
        "nacreous render paper -o layers.exr, layer texture, second channel",
        [
            f"Source of the texture: {made}. Seed {pictures.pearl.texture_seed}.",
            f"The patch is {PATCH_MM:g} mm wide, in the middle of the pearl. Black to white is "
            f"±{_RANGE:g} standard deviations, which is ±{_RANGE * scale:.1%} of lightness.",
        ],
    )


def _grey(picture: Image, value: Array, scale: float) -> Image:
    """Texture as grey codes evenly from black to white."""
    codes = np.clip(0.5 + 0.5 * value / (_RANGE * scale), 0.0, 1.0)
    note = json.dumps({"part": "texture, value", "white": _RANGE * scale})
    linear = colour.decode(np.repeat(codes[..., None], 3, axis=-1)).astype(np.float32)
    return Image(linear, {}, {**picture.recipe, "component": note})

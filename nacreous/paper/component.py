"""One part of a picture shown by itself, exposed so that it can be seen."""

from __future__ import annotations

import json
import math

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.image import Image

__all__ = ["alone", "beside", "chroma", "lab", "seen"]

Array = NDArray[np.float64]


def alone(picture: Image, part: str, share: float = 0.995) -> tuple[Image, float]:
    """A part, such as "interference", as a picture of its own, and the factor on its light.

    The factor, of two digits, brings the strongest channel of the given share of the pearl's pixels
    under 0.9 of white. The recipe says what was done.
    """
    light = picture.layers[part]
    strongest = light.max(axis=-1)[picture.layers["coverage"][..., 0] == 1]
    level = float(np.quantile(strongest, share)) if strongest.size else 0.0
    gain = _two_digits(0.9 / level) if level > 0 else 1.0
    note = json.dumps({"part": part, "gain": gain})
    return Image(light * np.float32(gain), {}, {**picture.recipe, "component": note}), gain


def beside(pictures: list[Image], name: str, steps: tuple[float, ...]) -> Image:
    """Pictures of one size in a row; the recipe is the first one's, with what changes."""
    row = np.concatenate([picture.linear for picture in pictures], axis=1)
    note = json.dumps({"changes": name, "steps": steps})
    return Image(row, {}, {**pictures[0].recipe, "strip": note})


def seen(picture: Image) -> Array:
    """Linear sRGB [row, column, 3] as the screen shows it, after the soft gamut."""
    codes, _ = picture.develop(bits=16)
    return colour.decode(codes / 65535.0)


def lab(picture: Image) -> Array:
    """CIE L*, a*, b* [row, column, 3] of what the screen shows."""
    return colour.lab_from_xyz(colour.xyz_from_rgb(seen(picture)), colour.xyz_from_rgb([1.0] * 3))


def chroma(picture: Image) -> Array:
    """Munsell chroma [row, column] of what the screen shows."""
    return colour.hvc_from_rgb(seen(picture))[..., 2]


def _two_digits(number: float) -> float:
    scale = 10.0 ** (math.floor(math.log10(number)) - 1)
    return round(round(number / scale) * scale, 9)

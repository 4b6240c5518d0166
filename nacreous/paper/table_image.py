"""The checkered table mirrored in a pearl: how its contrast fades with distance."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from nacreous.linear_light import luminance
from nacreous.paper.sight import Sight

__all__ = ["REACHES_MM", "contrast", "fading"]

Array = NDArray[np.float64]

#: Bounds of the distances from the pearl's surface to the table that are told apart **(ours)**.
REACHES_MM = (0.0, 4.0, 8.0, 16.0, 32.0, 64.0)
#: The part of a square, across each side, that is safely inside it.
_INNER = 0.7
#: Order of the polynomial that takes up shading, and the pixels that a fit must have at least.
_ORDER = 4
_LEAST_PX = 60


def contrast(
    linear: NDArray[np.floating], sight: Sight, check_mm: float, near_mm: float, far_mm: float
) -> float:
    """Contrast (light - dark) / (light + dark) of the mirrored squares in a range of distances.

    linear: RGB [row, column, 3], the mirrored component or the whole picture. Counted are pixels
    whose mirrored line of sight meets the inner part of a square `near_mm` to `far_mm` away; the
    pearl stands on a corner, and squares whose two numbers add up to an even one are light.

    The logarithm of luminance is fitted, by least squares, with a step between light and dark
    squares on top of a smooth polynomial over the pearl, which takes up shading and the lamp's
    shadow. NaN where too few pixels see the table.
    """
    distance_mm, x_mm, z_mm = sight.on_table()
    inner = _within(x_mm / check_mm) & _within(z_mm / check_mm)
    # The last degrees before the rim squeeze the whole far table into a pixel.
    chosen = inner & (near_mm <= distance_mm) & (distance_mm < far_mm) & (sight.view_deg < 80)
    if chosen.sum() < _LEAST_PX:
        return float("nan")
    even = (np.floor(x_mm / check_mm) + np.floor(z_mm / check_mm))[chosen] % 2 == 0
    right, up, _ = sight.normal[chosen].T
    smooth = [right**i * up**k for i in range(_ORDER + 1) for k in range(_ORDER + 1 - i)]
    terms = np.stack([np.where(even, 1.0, -1.0), *smooth], axis=1)
    light = np.log(np.maximum(luminance(linear)[chosen], 1e-9))
    step = np.linalg.lstsq(terms, light, rcond=None)[0][0]
    return float(np.tanh(step))


def fading(linear: NDArray[np.floating], sight: Sight, check_mm: float) -> tuple[Array, Array]:
    """Mean distance in mm and contrast for each range of `REACHES_MM`."""
    distance_mm, _, _ = sight.on_table()
    middles, contrasts = [], []
    for near_mm, far_mm in pairwise(REACHES_MM):
        within = (near_mm <= distance_mm) & (distance_mm < far_mm) & (sight.view_deg < 80)
        middles.append(float(distance_mm[within].mean()) if within.any() else float("nan"))
        contrasts.append(contrast(linear, sight, check_mm, near_mm, far_mm))
    return np.array(middles), np.array(contrasts)


def _within(place: Array) -> NDArray[np.bool_]:
    """Whether a place, in squares, lies in the inner part of its square."""
    return np.asarray(np.abs(place - np.floor(place) - 0.5) < 0.5 * _INNER)

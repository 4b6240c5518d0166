"""Rings of a pearl in a picture: their hue and chroma in the upper and in the lower half."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nacreous as nc

Array = NDArray[np.float64]

#: Pixels this far from straight up or down belong to neither half: the picture changes there from
#: light let through to light reflected.
WEDGE_DEG = 60.0


def rings(image: Any, count: int = 6) -> tuple[Array, Array]:
    """Upper and lower half of a pearl, each [ring, (hue in degrees, chroma, luminance)].

    image: linear [row, column, rgb] and layers["coverage"], as `nc.render` gives; one pearl, seen
    from far away, so that a ring from r1 to r2 of the radius shows angles asin(r1) to asin(r2).
    Rings are of equal width, the centre first. Hue and chroma are CIE Lab's of the ring's mean
    light brought to Y = 1, under the picture's white D65; of a black ring both are 0.
    """
    radius, azimuth_deg, whole = _polar(image)
    ring = np.where(whole, (radius * count).astype(int), count)
    halves = (np.abs(azimuth_deg) <= WEDGE_DEG, np.abs(azimuth_deg) >= 180.0 - WEDGE_DEG)
    upper, lower = (
        np.stack([_colour(image.linear[half & (ring == each)]) for each in range(count)])
        for half in halves
    )
    return upper, lower


def fan(image: Any, count: int = 6, parts: int = 5) -> Array:
    """The upper half's rings cut like a fan: [ring, part, (hue, chroma, luminance)], as `rings`."""
    radius, azimuth_deg, whole = _polar(image)
    ring = np.where(whole, (radius * count).astype(int), count)
    part = np.floor((azimuth_deg + WEDGE_DEG) / (2 * WEDGE_DEG) * parts)
    return np.array(
        [
            [_colour(image.linear[(ring == i) & (part == j)]) for j in range(parts)]
            for i in range(count)
        ]
    )


def _polar(image: Any) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Of pixels, the distance from the pearl's middle in radii, the angle from straight up in
    degrees, clockwise, and whether the pearl fills them."""
    coverage = np.asarray(image.layers["coverage"], dtype=float)
    coverage = coverage.reshape(coverage.shape[0], coverage.shape[1])
    row, column = np.indices(coverage.shape)
    down = row - np.average(row, weights=coverage)
    right = column - np.average(column, weights=coverage)
    radius = np.hypot(down, right) / np.sqrt(coverage.sum() / np.pi)
    return radius, np.degrees(np.arctan2(right, -down)), coverage > 0.999


def _colour(pixels: Array) -> Array:
    """Hue, chroma and luminance of the mean of linear pixels [pixel, rgb]."""
    xyz = nc.colour.xyz_from_rgb(np.asarray(pixels, dtype=float).mean(axis=0))
    if xyz[1] <= 1e-6:
        return np.array([0.0, 0.0, max(xyz[1], 0.0)])
    _, a, b = nc.colour.lab_from_xyz(xyz / xyz[1], nc.colour.white_xyz("D65"))
    return np.array([np.degrees(np.arctan2(b, a)) % 360, np.hypot(a, b), xyz[1]])

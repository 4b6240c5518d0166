"""Estimating where the outline of a pearl lies in a picture that does not say so."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nacreous.paper.circle import Circle
from nacreous.problem import InputError

__all__ = ["estimate", "reduced"]

Array = NDArray[np.float64]

#: Longest side, in pixels, of the picture in which circles are first tried, and its shortest.
_COARSE_PX, _LEAST_PX = 96, 8
_DIRECTIONS = 72
#: An outline is believed when it is found in this share of the directions **(ours)**.
_LEAST_FOUND = 0.6
#: How far a point of the outline may lie from a true circle, in radii; a pixel is always allowed.
_ROUND = 0.02
#: How far about the last circle the outline is looked for, in radii, time after time.
_REACHES = (0.10, 0.04, 0.04)
#: The least step of shade (1 is white) that counts as an edge, and the edges that make a circle.
_LEAST_RISE, _LEAST_SEEN = 0.02, 8


def estimate(picture: NDArray[np.floating]) -> tuple[Circle, float]:
    """The outline of one round pearl in linear RGB [row, column, 3], and how sure it is.

    An estimate **(ours)**: of all circles that lie within the picture and have a radius of at
    least an eighth of its shorter side, the one along which colour changes most steadily from
    inside to outside; then a circle fitted to the steepest places near it. The share, 0 to 1, says
    in how many directions an edge was found within 2 % of the circle. Raises `InputError` under
    0.6: then the picture shows no pearl, or several, or one that is cut off.
    """
    factor = max(1, math.ceil(max(picture.shape[:2]) / _COARSE_PX))
    small = reduced(picture, factor)
    share = 0.0
    if min(small.shape[:2]) >= _LEAST_PX:
        coarse = _best_circle(_steepness(_shade(small)))
        found = Circle(coarse.x_px * factor, coarse.y_px * factor, coarse.radius_px * factor)
        for reach in _REACHES:
            x, y, seen = _edge(picture, found, reach)
            if seen.sum() >= _LEAST_SEEN:
                found = _through(x[seen], y[seen], found)
        share = _share_on(picture, found)
    if not share >= _LEAST_FOUND:
        raise InputError(
            f"no round outline of one pearl stands out (found in {share:.0%} of all directions, "
            f"wanted: {_LEAST_FOUND:.0%}); give it with --centre X Y --radius R"
        )
    return found, share


def reduced(picture: NDArray[np.floating], factor: int) -> Array:
    """Means over blocks of factor x factor pixels [row, column, rgb]; a rest is left out."""
    rows, columns = (side // factor for side in picture.shape[:2])
    # Row by row of blocks, as the picture may fill half of the memory.
    bands = (picture[factor * row : factor * (row + 1), : factor * columns] for row in range(rows))
    means = [band.reshape(factor, columns, factor, 3).mean((0, 2), np.float64) for band in bands]
    return np.array(means).reshape(rows, columns, 3)


def _shade(linear: NDArray[np.floating]) -> Array:
    """Light on a scale of about equal visibility."""
    return np.asarray(np.sqrt(np.maximum(linear, 0.0), dtype=np.float64))


def _steepness(shade: Array) -> Array:
    """How steeply colour changes along each direction, [direction, row, column], 1 at the most."""
    padded = np.pad(shade, ((1, 1), (1, 1), (0, 0)), mode="edge")
    across = padded[1:-1, 2:] - padded[1:-1, :-2]
    down = padded[2:, 1:-1] - padded[:-2, 1:-1]
    turn = 2 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    along = np.cos(turn)[:, None, None, None] * across + np.sin(turn)[:, None, None, None] * down
    steep = np.linalg.norm(along, axis=-1)
    # The root, so that all of a faint outline counts for more than a part of a strong one.
    return np.asarray(np.sqrt(np.minimum(1.0, steep / max(float(np.quantile(steep, 0.99)), 1e-6))))


def _best_circle(steepness: Array) -> Circle:
    """The circle with the greatest mean steepness, by trying all of them."""
    rows, columns = steepness.shape[1:]
    turn = 2 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    shorter = min(rows, columns)
    best, found = -1.0, Circle(0.5 * columns, 0.5 * rows, 0.25 * shorter)
    for radius in range(max(3, shorter // 8), shorter // 2):
        # Centres from which the whole circle lies within the picture.
        height, width = rows - 2 * radius, columns - 2 * radius
        total = np.zeros((height, width))
        for direction, (right, below) in enumerate(
            zip(np.rint(radius * np.cos(turn)), np.rint(radius * np.sin(turn)), strict=True)
        ):
            top, left = radius + int(below), radius + int(right)
            total += steepness[direction, top : top + height, left : left + width]
        row, column = (int(at) for at in np.unravel_index(total.argmax(), total.shape))
        if total[row, column] > best:
            best = float(total[row, column])
            found = Circle(column + radius + 0.5, row + radius + 0.5, radius + 0.5)
    return found


def _edge(
    picture: NDArray[np.floating], circle: Circle, reach: float
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """The steepest place near a circle in each direction: x, y, and whether there is one.

    Near is within `reach`, in radii, inside and outside.
    """
    turn = 2 * np.pi * np.arange(4 * _DIRECTIONS) / (4 * _DIRECTIONS)
    steps = max(9, 2 * math.ceil(2 * reach * circle.radius_px) + 1)
    radius = circle.radius_px * np.linspace(1 - reach, 1 + reach, steps)
    x = circle.x_px + np.cos(turn)[:, None] * radius
    y = circle.y_px + np.sin(turn)[:, None] * radius
    height, width = picture.shape[:2]
    # Beyond the border the picture goes on as it ends, without an edge.
    rows = np.clip(np.floor(y).astype(int), 0, height - 1)
    columns = np.clip(np.floor(x).astype(int), 0, width - 1)
    line = _shade(picture[rows, columns])
    half = max(1, steps // 16)
    rise = np.linalg.norm(line[:, 2 * half :] - line[:, : -2 * half], axis=-1)
    # A sharp edge is as steep all along the span of the difference: take its middle.
    first = rise.argmax(axis=1)[:, None]
    top = (rise >= 0.9 * rise.max(axis=1, keepdims=True)) & (
        np.abs(np.arange(rise.shape[1]) - first) <= 2 * half
    )
    at = (top * radius[half:-half]).sum(axis=1) / top.sum(axis=1)
    edge_x, edge_y = circle.x_px + np.cos(turn) * at, circle.y_px + np.sin(turn) * at
    within = (edge_x >= 0) & (edge_x < width) & (edge_y >= 0) & (edge_y < height)
    return edge_x, edge_y, within & (rise.max(axis=1) > _LEAST_RISE)


def _share_on(picture: NDArray[np.floating], circle: Circle) -> float:
    """Share of all directions in which the steepest place near a circle lies on it."""
    # Far enough that noise has somewhere else to be steep.
    x, y, seen = _edge(picture, circle, max(_REACHES[0], 6.0 / circle.radius_px))
    off_px = np.abs(np.hypot(x - circle.x_px, y - circle.y_px) - circle.radius_px)
    return float(np.mean(seen & (off_px < max(1.0, _ROUND * circle.radius_px))))


def _through(x: Array, y: Array, first: Circle) -> Circle:
    """The circle of least squared distance to the points, outliers left out (Gauss-Newton)."""
    circle = first
    for _ in range(12):
        right, below = x - circle.x_px, y - circle.y_px
        away = np.hypot(right, below)
        residual = away - circle.radius_px
        kept = np.abs(residual) <= 2.5 * np.median(np.abs(residual)) + 1e-9
        slope = np.stack([right / away, below / away, np.ones_like(away)], axis=1)[kept]
        step = np.linalg.lstsq(slope, residual[kept], rcond=None)[0]
        circle = Circle(
            circle.x_px + float(step[0]),
            circle.y_px + float(step[1]),
            circle.radius_px + float(step[2]),
        )
    return circle

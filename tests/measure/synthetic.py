"""Pictures whose measures are known beforehand."""

import math

import numpy as np
from numpy.typing import NDArray

Light = NDArray[np.float32]
MIDDLE, RADIUS = (104.3, 99.6), 60.0
SIDE = 200


def places(side: int = SIDE, over: int = 3) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where samples lie, `over` a pixel along a side: x, y."""
    at = (np.arange(side * over) + 0.5) / over
    return np.meshgrid(at, at)


def binned(fine: NDArray[np.float64], over: int = 3) -> Light:
    """Means over a pixel's samples."""
    side = len(fine) // over
    return fine.reshape(side, over, side, over, 3).mean((1, 3)).astype(np.float32)


def ellipse(
    long: float = RADIUS, short: float = RADIUS, turn_deg: float = 30.0, ground: float = 0.05
) -> Light:
    """A disc of one colour, its half axes in pixels, on a ground."""
    x, y = places()
    x, y = x - MIDDLE[0], y - MIDDLE[1]
    turn = math.radians(turn_deg)
    along, across = x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn)
    inside = (along / long) ** 2 + (across / short) ** 2 < 1
    return binned(np.where(inside[..., None], [0.5, 0.45, 0.42], [ground] * 3))


def ball(sigma_deg: float, peak: float = 2.0, body: float = 0.4) -> Light:
    """A ball with a lamp's image that falls as a Gaussian of the normal's angle from its middle."""
    x, y = places()
    right, down = (x - MIDDLE[0]) / RADIUS, (y - MIDDLE[1]) / RADIUS
    depth = 1 - right**2 - down**2
    inside = depth > 0
    normal = np.stack([right, down, np.sqrt(np.maximum(depth, 0))], axis=-1)
    lamp = np.array([-0.35, -0.3, math.sqrt(1 - 0.35**2 - 0.3**2)])
    away = np.degrees(np.arccos(np.clip(normal @ lamp, -1, 1)))
    light = body + (peak - body) * np.exp(-0.5 * (away / sigma_deg) ** 2)
    colour = np.array([1.0, 0.97, 0.94])
    return binned(np.where(inside[..., None], light[..., None] * colour, 0.03))


def spotted(radius_rad: float, count: int, darker: float = 0.3, half: float = 100.0) -> Light:
    """A ball under a lamp, with round spots in a ring around its middle, darker by a share."""
    side, over = int(2.5 * half), 2
    x, y = places(side, over)
    right, down = (x - side / 2) / half, (y - side / 2) / half
    depth = 1 - right**2 - down**2
    normal = np.stack([right, down, np.sqrt(np.maximum(depth, 0))], axis=-1)
    lit = np.clip(normal @ [-0.35, -0.35, 0.87], 0, 1)
    shade = 0.35 + 0.39 * normal[..., 2] + 0.26 * lit
    light = shade[..., None] * [0.55, 0.52, 0.48]
    for turn in 2 * np.pi * (np.arange(count) + 0.5) / count:
        middle = [math.sin(0.55) * math.cos(turn), math.sin(0.55) * math.sin(turn), math.cos(0.55)]
        light[normal @ middle > math.cos(radius_rad)] *= 1 - darker
    return binned(np.where(depth[..., None] > 0, light, 0.04), over)

"""A made-up world in high range for benchmarks: sky, sun, windows, ground.

Rows run from the zenith down, columns clockwise as seen from above: from the viewer's side by the
left to what lies behind the pearl, the middle column, as in a scene's `sky.path`. Nothing is
random: same size, same pixels.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

HEIGHT_PX = 512

#: (azimuth, elevation, half width, half height) in degrees, and linear RGB. Two windows of a room
#: seen from the pearl, one warm lamp; the radii are those of things, not of their glow.
WINDOWS = (
    ((-50.0, 35.0, 12.0, 16.0), (9.0, 9.6, 10.5)),
    ((75.0, 25.0, 7.0, 18.0), (6.0, 6.2, 6.4)),
)
#: (azimuth, elevation, radius) in degrees, and linear RGB.
SUN = ((20.0, 52.0, 2.5), (120.0, 108.0, 90.0))


def pixels(height_px: int = HEIGHT_PX) -> NDArray[np.float32]:
    """Linear RGB, float32 [row, column, rgb], twice as wide as high."""
    elevation_deg = 90 - (np.arange(height_px) + 0.5) * 180 / height_px
    azimuth_deg = _turn(-(np.arange(2 * height_px) + 0.5) * 180 / height_px)
    azimuth, elevation = np.meshgrid(azimuth_deg, elevation_deg)
    world = np.where((elevation > 0)[..., None], _sky(elevation), _ground(azimuth, elevation))
    for (azimuth_of, elevation_of, half_width, half_height), rgb in WINDOWS:
        inside = np.abs(_turn(azimuth - azimuth_of)) < half_width
        inside &= np.abs(elevation - elevation_of) < half_height
        bars = (np.abs(_turn(azimuth - azimuth_of)) < 0.8) | (
            np.abs(elevation - elevation_of) < 0.8
        )
        world[inside & ~bars] = rgb
    (azimuth_of, elevation_of, radius), rgb = SUN
    world[_apart_deg(azimuth, elevation, azimuth_of, elevation_of) < radius] = rgb
    return world.astype(np.float32)


def write(path: Path, grey: bool = False) -> None:
    """An OpenEXR file of it, or of its luminance alone."""
    import nacreous as nc

    light = pixels()
    if grey:
        light = np.repeat(light @ np.float32([[0.2126], [0.7152], [0.0722]]), 3, axis=-1)
    nc.Image(light, {}).save(path)


def _sky(elevation: NDArray[np.float64]) -> NDArray[np.float64]:
    """From a pale horizon to a bluer zenith."""
    share = np.sin(np.radians(elevation.clip(0)))[..., None] ** 0.5
    return (1 - share) * np.array([0.90, 0.88, 0.84]) + share * np.array([0.35, 0.45, 0.65])


def _ground(azimuth: NDArray[np.float64], elevation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Squares of two browns a hand wide, seen from a hand above, greyer far away."""
    far = 1 / np.tan(np.radians(np.maximum(-elevation, 0.5)))
    x, z = far * np.sin(np.radians(azimuth)), far * np.cos(np.radians(azimuth))
    odd = (np.floor(x) + np.floor(z)) % 2
    near = np.exp(-far / 6)[..., None]
    squares = np.where(odd[..., None] > 0, (0.30, 0.22, 0.16), (0.10, 0.09, 0.08))
    return near * squares + (1 - near) * np.array([0.20, 0.17, 0.14])


def _turn(angle_deg: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same angle within -180..180."""
    return (angle_deg + 180) % 360 - 180


def _apart_deg(
    azimuth: NDArray[np.float64],
    elevation: NDArray[np.float64],
    azimuth_of: float,
    elevation_of: float,
) -> NDArray[np.float64]:
    """Angle between directions."""
    a, e, e_of = np.radians(azimuth - azimuth_of), np.radians(elevation), np.radians(elevation_of)
    cosine = np.sin(e) * np.sin(e_of) + np.cos(e) * np.cos(e_of) * np.cos(a)
    return np.degrees(np.arccos(cosine.clip(-1, 1)))

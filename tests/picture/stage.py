"""A pearl, lamps and what to look at, for the tests of the picture."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous.spec import (
    Camera,
    Lamp,
    Layers,
    Pearl,
    Sky,
    Table,
)

Array = NDArray[np.float64]

#: Few layers, quick to sum up; uneven enough to have colours.
THIN = Layers(thickness_nm=[380.0 + 9.0 * (layer % 7) for layer in range(24)])
LEFT = Lamp(azimuth_deg=-49.5, elevation_deg=45, angular_radius_deg=6, spectrum="E")
NO_TABLE = Table(kind="none")
BLACK = Sky(intensity=0.0)
SUM = ("interference", "diffuse", "mirror", "surroundings")


def pearl(**keys: Any) -> Pearl:
    return Pearl(**{"model": "illuminant", "nacre": THIN, "grain": 0.0, **keys})


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    return message


def luminance(rgb: NDArray[np.float32]) -> Array:
    return nc.colour.xyz_from_rgb(rgb)[..., 1]


def covered(image: nc.Image) -> NDArray[np.bool_]:
    return image.layers["coverage"][..., 0] == 1


#: From the silhouette; nearer pixels are worked out along lines, however few their samples are.
RIM_PX = 4.0


def away_from_rim(image: nc.Image) -> NDArray[np.bool_]:
    """Where the one pearl in the middle shows what lies behind the pixel's middle alone."""
    coverage = image.layers["coverage"][..., 0]
    side = coverage.shape[0]
    step = np.arange(side) + 0.5 - side / 2
    radius_px = np.sqrt(coverage.sum() / np.pi)
    return np.hypot(*np.meshgrid(step, step)) < radius_px - RIM_PX


def normals(size: int, field_mm: float, radius_mm: float, camera: Camera) -> tuple[Array, ...]:
    """Normals of a ball under each pixel's middle, NaN beside it, and the direction to the eye."""
    azimuth, elevation = math.radians(camera.azimuth_deg), math.radians(camera.elevation_deg)
    flat = math.cos(elevation)
    view = np.array([math.sin(azimuth) * flat, math.sin(elevation), math.cos(azimuth) * flat])
    right = np.array([math.cos(azimuth), 0.0, -math.sin(azimuth)])
    up = np.cross(view, right)
    step = (np.arange(size) + 0.5) / size - 0.5
    x, y = np.meshgrid(step, -step) * np.array(field_mm / radius_mm)
    with np.errstate(invalid="ignore"):
        z = np.sqrt(1 - x**2 - y**2)
    return x[..., None] * right + y[..., None] * up + z[..., None] * view, view

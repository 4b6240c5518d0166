"""Where each pixel of a rendered picture looks: view angles, normals, mirrored rays."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from nacreous.image import field_mm
from nacreous.paper.circle import Circle
from nacreous.spec import Camera, Lamp, Pearl, Scene

__all__ = ["Sight", "direction_of"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Sight:
    """The geometry behind the pixels' middles, written down a second time, apart from the renderer.

    The frame is the scene's: the pearl's centre the origin, y up. Where a pixel misses the pearl,
    arrays hold NaN.
    """

    radius_mm: float
    circle: Circle
    cos_view: Array
    """Cosine of the view angle theta_0, [row, column]."""
    normal: Array
    """Outward, [row, column, xyz]."""
    toward_eye: Array
    """Unit vectors, [row, column, xyz]."""

    @classmethod
    def of(cls, pearl: Pearl, scene: Scene, size_px: int) -> Self:
        """The geometry of a picture of this size."""
        eye_mm, along = _rays(scene.camera, field_mm(pearl, scene), size_px)
        radius_mm = 0.5 * pearl.diameter_mm
        closest = eye_mm - along * np.sum(eye_mm * along, axis=-1, keepdims=True)
        sine = np.linalg.norm(closest, axis=-1) / radius_mm
        cosine = np.sqrt(np.where(sine < 1, 1 - sine**2, np.nan))
        normal = closest / radius_mm - along * cosine[..., None]
        circle = Circle.of_view(pearl, scene, size_px)
        return cls(radius_mm, circle, cosine, normal, -along)

    @property
    def view_deg(self) -> Array:
        """View angle theta_0 in degrees, [row, column]."""
        return np.degrees(np.arccos(self.cos_view))

    @property
    def mirrored(self) -> Array:
        """Direction of the line of sight after reflection, [row, column, xyz]."""
        return 2 * self.cos_view[..., None] * self.normal - self.toward_eye

    def on_table(self) -> tuple[Array, Array, Array]:
        """Where mirrored lines of sight meet the table the pearl lies on: distance, x and z in mm.

        NaN where they go up.
        """
        point, along = self.normal * self.radius_mm, self.mirrored
        with np.errstate(divide="ignore", invalid="ignore"):
            distance_mm = (-self.radius_mm - point[..., 1]) / along[..., 1]
        distance_mm = np.where(along[..., 1] < 0, distance_mm, np.nan)
        met = point + along * distance_mm[..., None]
        return distance_mm, met[..., 0], met[..., 2]


def direction_of(camera_or_lamp: Camera | Lamp) -> Array:
    """Unit vector [xyz] from the pearl towards a camera or a lamp.

    >>> from nacreous.spec import Camera
    >>> direction_of(Camera(elevation_deg=0.0)).round(3).tolist()
    [0.0, 0.0, 1.0]
    """
    if isinstance(camera_or_lamp, Lamp) and camera_or_lamp.position_mm is not None:
        position = np.asarray(camera_or_lamp.position_mm)
        return np.asarray(position / np.linalg.norm(position))
    azimuth = math.radians(camera_or_lamp.azimuth_deg or 0.0)
    elevation = math.radians(camera_or_lamp.elevation_deg or 0.0)
    flat = math.cos(elevation)
    return np.array([math.sin(azimuth) * flat, math.sin(elevation), math.cos(azimuth) * flat])


def _rays(camera: Camera, width_mm: float, size_px: int) -> tuple[Array, Array]:
    """Where the pixels' lines of sight start, and their unit directions, [row, column, xyz]."""
    back = direction_of(camera)
    azimuth = math.radians(camera.azimuth_deg)
    right = np.array([math.cos(azimuth), 0.0, -math.sin(azimuth)])
    up = np.cross(back, right)
    step = (2 * np.arange(size_px) + 1 - size_px) / size_px
    target = 0.5 * width_mm * (step[None, :, None] * right - step[:, None, None] * up)
    if camera.projection == "orthographic":
        return target + back * (10 * width_mm), np.broadcast_to(-back, target.shape)
    eye = back * camera.distance_mm
    along = target - eye
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    return np.broadcast_to(eye, target.shape), along

"""A pearl's outline in a picture."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from nacreous.image import field_mm
from nacreous.spec import Pearl, Scene

__all__ = ["Circle"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Circle:
    """A pearl's outline in pixels; (0, 0) is the outer corner of the first pixel, y runs down."""

    x_px: float
    y_px: float
    radius_px: float

    @classmethod
    def of_view(cls, pearl: Pearl, scene: Scene, size_px: int) -> Self:
        """The outline of a lone pearl in a rendered picture, by geometry.

        An eye nearby sees less than half of the ball, and its outline larger by a little.

        >>> from nacreous.spec import Camera
        >>> Circle.of_view(Pearl(), Scene(camera=Camera(field_mm=16.0)), size_px=100)
        Circle(x_px=50.0, y_px=50.0, radius_px=25.0)
        """
        radius_mm = 0.5 * pearl.diameter_mm
        if scene.camera.projection == "perspective":
            radius_mm /= math.sqrt(1 - (radius_mm / scene.camera.distance_mm) ** 2)
        radius_px = size_px * radius_mm / field_mm(pearl, scene)
        return cls(0.5 * size_px, 0.5 * size_px, radius_px)

    def distance(self, shape: tuple[int, ...]) -> Array:
        """Distance of each pixel's middle from the centre, in radii, [row, column]."""
        rows, columns = np.ogrid[: shape[0], : shape[1]]
        away_px = np.hypot(columns + 0.5 - self.x_px, rows + 0.5 - self.y_px)
        return np.asarray(away_px / self.radius_px)

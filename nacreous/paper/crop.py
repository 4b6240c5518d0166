"""The seven crops of figure 2, numbered from the centre outward."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.linear_light import luminance
from nacreous.paper.circle import Circle
from nacreous.paper.outline import reduced
from nacreous.problem import InputError

__all__ = ["COUNT", "Crop", "cut", "seven"]

COUNT = 7
#: Side of a crop in radii **(ours)**: 64 pixels, as the paper's patches (4.3), where the preset
#: `paper` is rendered 512 pixels wide.
_SIDE = 0.36
_LEAST_SIDE_PX = 8
#: Crops 3 to 7 **(ours)**: distance from the centre in radii, and turn against the clock, in
#: degrees, from the direction of the lamp's image. 3 and 4 are clear of lamp and outline.
_PLACES = {3: (0.68, -100.0), 4: (0.72, -50.0), 5: (0.88, -140.0), 6: (0.97, 51.0), 7: (1.06, 90.0)}
#: Radius in pixels at which the lamp's image is looked for; more would not place it better.
_ENOUGH_PX = 300
#: Crop 1 lies on the lamp's image. Crop 2 lies so much further out, in sides, that its border
#: passes near the middle of that image: it holds half of it, and the interference colours beyond.
#: Lamps near the rim count as nearer, or crop 2 would lie beyond crops 3 and 4.
_BESIDE_LAMP, _FARTHEST_LAMP = 0.45, 0.42


@dataclass(frozen=True)
class Crop:
    """A square of a picture, in pixels from its upper left corner."""

    number: int
    left_px: int
    top_px: int
    side_px: int

    def of(self, pixels: NDArray[Any]) -> NDArray[Any]:
        """Its part of a picture [row, column, ...]."""
        rows = slice(self.top_px, self.top_px + self.side_px)
        return pixels[rows, self.left_px : self.left_px + self.side_px]

    def distance(self, circle: Circle) -> float:
        """Distance of its middle from that of the pearl, in radii."""
        half = 0.5 * self.side_px
        right, below = self.left_px + half - circle.x_px, self.top_px + half - circle.y_px
        return math.hypot(right, below) / circle.radius_px

    def record(self) -> dict[str, int]:
        """The crop for machines."""
        return asdict(self)


def seven(picture: NDArray[np.floating], circle: Circle) -> list[Crop]:
    """Where the seven crops lie in linear RGB [row, column, 3] with a pearl's outline.

    Figure 2 itself is not at hand; these places are **(ours)**, after what section 2.2 says of
    each crop: 1 the lamp's image, 2 the lamp's image and interference colours, 3 and 4 interference
    colours only, 5 to 7 more and more of the outline. Raises `InputError` where they do not fit.
    """
    side_px = round(_SIDE * circle.radius_px)
    if side_px < _LEAST_SIDE_PX:
        raise InputError(
            f"radius is {circle.radius_px:.1f} pixels; allowed: at least "
            f"{_LEAST_SIDE_PX / _SIDE:.1f}, so that a crop has {_LEAST_SIDE_PX} pixels a side"
        )
    away, turn_rad = _lamp(picture, circle)
    nearest = min(away, _FARTHEST_LAMP)
    # Squares reach further along their diagonals.
    beside = _BESIDE_LAMP * _SIDE / max(abs(math.cos(turn_rad)), abs(math.sin(turn_rad)))
    places = {1: (nearest, 0.0), 2: (nearest + beside, 0.0), **_PLACES}
    crops = []
    for number, (distance, turn_deg) in places.items():
        angle = turn_rad + math.radians(turn_deg)
        x_px = circle.x_px + circle.radius_px * distance * math.cos(angle)
        y_px = circle.y_px - circle.radius_px * distance * math.sin(angle)
        left, top = round(x_px - 0.5 * side_px), round(y_px - 0.5 * side_px)
        crops.append(_checked(Crop(number, left, top, side_px), picture.shape))
    return crops


def cut(codes: NDArray[Any], crops: list[Crop]) -> list[NDArray[Any]]:
    """The crops of a picture [row, column, rgb]."""
    return [np.ascontiguousarray(crop.of(codes)) for crop in crops]


def _checked(crop: Crop, shape: tuple[int, ...]) -> Crop:
    rows, columns = shape[:2]
    across = 0 <= crop.left_px <= columns - crop.side_px
    if across and 0 <= crop.top_px <= rows - crop.side_px:
        return crop
    raise InputError(
        f"crop {crop.number} would leave the picture: it begins at ({crop.left_px}, {crop.top_px}) "
        f"and has {crop.side_px} pixels a side, the picture has {columns} x {rows}; wanted: a "
        "third of the pearl's radius around it"
    )


def _lamp(picture: NDArray[np.floating], circle: Circle) -> tuple[float, float]:
    """Where the lamp's image lies: distance from the centre in radii, angle against the clock.

    It is the brightest place on the pearl once fine detail is blurred away, which keeps glitter and
    noise from being taken for it. Straight up where it lies in the middle.
    """
    around, within = _pearl_alone(picture, circle)
    light = np.minimum(luminance(around), 1.0)
    reach_px = max(1, round(0.04 * within.radius_px))
    inside = within.distance(light.shape) < 0.9
    if not inside.any():
        raise InputError("the pearl's outline lies outside the picture")
    blurred = np.where(inside, _blurred(light, reach_px), -1.0)
    row, column = (int(at) for at in np.unravel_index(blurred.argmax(), blurred.shape))
    # An image that fills the screen's range is flat on top: take the middle of what is as bright.
    near = Circle(column + 0.5, row + 0.5, within.radius_px).distance(light.shape) < 0.25
    rows, columns = np.nonzero(near & (blurred >= 0.98 * blurred[row, column]))
    right = float(columns.mean()) + 0.5 - within.x_px
    above = within.y_px - float(rows.mean()) - 0.5
    distance = math.hypot(right, above) / within.radius_px
    return distance, math.atan2(above, right) if distance > 0.02 else 0.5 * math.pi


def _pearl_alone(
    picture: NDArray[np.floating], circle: Circle
) -> tuple[NDArray[np.floating], Circle]:
    """The square around the pearl, scaled down to some 300 pixels a radius, and its outline."""
    factor = max(1, math.ceil(circle.radius_px / _ENOUGH_PX))
    left, top = (max(0, math.floor(at - circle.radius_px)) for at in (circle.x_px, circle.y_px))
    side = factor * math.ceil((2 * circle.radius_px + 2) / factor)
    around = reduced(picture[top : top + side, left : left + side], factor)
    x_px, y_px = (circle.x_px - left) / factor, (circle.y_px - top) / factor
    return around, Circle(x_px, y_px, circle.radius_px / factor)


def _blurred(light: NDArray[np.float64], reach_px: int) -> NDArray[np.float64]:
    """Means over squares of 2 reach + 1 pixels a side, by running sums."""
    width = 2 * reach_px + 1
    for axis in (0, 1):
        around = [(0, 0), (0, 0)]
        around[axis] = (reach_px + 1, reach_px)
        sums = np.cumsum(np.pad(light, around, mode="edge"), axis=axis)
        places = np.arange(light.shape[axis])
        light = (sums.take(places + width, axis) - sums.take(places, axis)) / width
    return light

"""Which pearls lie where in a scene."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import count
from typing import NamedTuple

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.spec import Pearl, Row, Scene, Window
from nacreous.spec.row import GIVEN
from nacreous.spec.window import Frame

__all__ = ["Arrangement", "Place", "arrange"]

#: Left out, pitch and row gap are this many of the largest diameters **(ours)**.
_ROOM = 1.1
#: The eye is at least this many times as far from the middle as the farthest pearl **(ours)**.
_CLEAR = 1.2

Point = tuple[float, float, float]


class Place(NamedTuple):
    """A pearl by its number among the different ones, and where its centre is."""

    pearl: int
    centre_mm: Point


class Arrangement(NamedTuple):
    """The pearls of a picture, each different one once, and their places.

    scene: the scene with "*0", "*1" and so on for the pearls, so that pearls and scene alone, with
    no preset and no other file, make the same arrangement again.
    """

    pearls: list[Pearl]
    places: list[Place]
    scene: Scene

    @property
    def largest_mm(self) -> float:
        """Diameter of the largest pearl."""
        return max(pearl.diameter_mm for pearl in self.pearls)

    def balls(self) -> Iterator[tuple[Point, float]]:
        """Centre and radius of each pearl."""
        for place in self.places:
            yield place.centre_mm, 0.5 * self.pearls[place.pearl].diameter_mm

    def frame(self, window: Window) -> Frame:
        """Where a window of the scene is."""
        return window.frame(min(centre[1] - radius for centre, radius in self.balls()))

    def field_mm(self) -> float:
        """Width of the view: the camera's own, or one that shows every pearl and some room."""
        camera = self.scene.camera
        if camera.field_mm is not None:
            return camera.field_mm
        if not self.scene.rows:
            return 1.5 * self.largest_mm
        right, up, back = _axes(camera.azimuth_deg, camera.elevation_deg)
        eye_mm = camera.distance_mm if camera.projection == "perspective" else math.inf
        reach_mm = max(
            _seen_mm(_dot(centre, axis), radius, eye_mm - _dot(centre, back), eye_mm)
            for centre, radius in self.balls()
            for axis in (right, up)
        )
        return 2.0 * reach_mm + 0.5 * self.largest_mm

    def nearest(self) -> float:
        """Distance from the eye to the nearest pearl, over that to the middle; at most 1."""
        camera = self.scene.camera
        if camera.projection != "perspective":
            return 1.0
        _, _, back = _axes(camera.azimuth_deg, camera.elevation_deg)
        ahead_mm = min(camera.distance_mm - _dot(centre, back) - r for centre, r in self.balls())
        return max(0.0, min(1.0, ahead_mm / camera.distance_mm))


def arrange(given: Sequence[Pearl], scene: Scene) -> Arrangement:
    """Put the pearls given into the scene's rows.

    Each "*" takes the next of them, beginning again after the last; "*2" takes the third. Raises
    `InputError` for pearls without a place, and for pearls that touch each other, a wall, a lamp or
    the eye.

    >>> from nacreous.spec import Row
    >>> rows = [Row(pearls=["akoya-rg", "*"]), Row(pearls=["*", "*"])]
    >>> made = arrange([Pearl(), Pearl(depth=0.1)], Scene(rows=rows))
    >>> [place.pearl for place in made.places], [row.pearls for row in made.scene.rows]
    ([0, 1, 2, 1], [('*0', '*1'), ('*2', '*1')])
    """
    if not scene.rows:
        if len(given) != 1:
            raise InputError(f"scene {scene.name}: has a place for one pearl, not {len(given)}")
        alone = Arrangement(list(given), [Place(0, (0.0, 0.0, 0.0))], scene)
        _check_windows(alone)
        return alone
    rows = _filled(given, scene)
    numbers: dict[Pearl, int] = {}
    for pearl in (pearl for row in rows for pearl in row):
        numbers.setdefault(pearl, len(numbers))
    pearls = list(numbers)
    largest_mm = max(pearl.diameter_mm for pearl in pearls)
    pitch_mm, gap_mm = (_distance(scene, key, largest_mm) for key in ("pitch_mm", "row_gap_mm"))
    places = [
        Place(
            numbers[pearl],
            (
                (column - 0.5 * (len(row) - 1)) * pitch_mm,
                0.5 * (pearl.diameter_mm - largest_mm),
                (line - 0.5 * (len(rows) - 1)) * gap_mm,
            ),
        )
        for line, row in enumerate(rows)
        for column, pearl in enumerate(row)
    ]
    named = [
        Row(pearls=tuple(f"{GIVEN}{numbers[pearl]}" for pearl in row), label=written.label)
        for row, written in zip(rows, scene.rows, strict=True)
    ]
    arrangement = Arrangement(pearls, places, scene.model_copy(update={"rows": tuple(named)}))
    _check_clearance(arrangement)
    _check_windows(arrangement)
    return arrangement


def _filled(given: Sequence[Pearl], scene: Scene) -> list[list[Pearl]]:
    """The pearls of each row."""
    names = [name for row in scene.rows for name in row.pearls]
    numbered = {int(name[1:]) for name in names if name.startswith(GIVEN) and name != GIVEN}
    if numbered and max(numbered) >= len(given):
        raise InputError(
            f'scene {scene.name}: a row has "{GIVEN}{max(numbered)}"; allowed: '
            f'"{GIVEN}0" to "{GIVEN}{len(given) - 1}", for {len(given)} given'
        )
    turns = names.count(GIVEN)
    idle = set(range(len(given))) - numbered - set(range(turns))
    if idle:
        raise InputError(
            f"scene {scene.name}: {len(given)} pearls given, {len(idle)} of them without a place; "
            f'its rows have {turns} "{GIVEN}"'
        )
    loaded: dict[str, Pearl] = {}
    turn = count()

    def pearl(name: str) -> Pearl:
        if name == GIVEN:
            return given[next(turn) % len(given)]
        if name.startswith(GIVEN):
            return given[int(name[1:])]
        if name not in loaded:
            loaded[name] = Pearl.load(name)
        return loaded[name]

    return [[pearl(name) for name in row.pearls] for row in scene.rows]


def _distance(scene: Scene, key: str, largest_mm: float) -> float:
    value: float | None = getattr(scene, key)
    if value is None:
        return _ROOM * largest_mm
    if value < largest_mm:
        raise InputError(
            f"scene {scene.name}: {key} is {said(value)}; allowed: at least {largest_mm:g} mm, "
            "the diameter of the largest pearl"
        )
    return value


def _check_clearance(arrangement: Arrangement) -> None:
    """Nothing may stand inside a pearl, nor a pearl inside a wall."""
    scene, balls = arrangement.scene, list(arrangement.balls())
    reach_mm = max(math.hypot(*centre) + radius for centre, radius in balls)
    camera, walls = scene.camera, scene.walls
    if camera.projection == "perspective" and camera.distance_mm < _CLEAR * reach_mm:
        raise InputError(
            f"scene {scene.name}: camera.distance_mm is {said(camera.distance_mm)}; allowed: at "
            f"least {_CLEAR * reach_mm:.4g} mm, clear of all rows"
        )
    side_mm = max(max(abs(centre[0]), abs(centre[2])) + radius for centre, radius in balls)
    if walls is not None and walls.half_width_mm < side_mm:
        raise InputError(
            f"scene {scene.name}: walls.half_width_mm is {said(walls.half_width_mm)}; allowed: at "
            f"least {side_mm:.4g} mm, around all rows"
        )
    for number, lamp in enumerate(scene.lamps):
        point = lamp.position_mm
        if point and any(math.dist(point, centre) <= radius for centre, radius in balls):
            raise InputError(
                f"scene {scene.name}: lamps.{number}.position_mm is {said(list(point))}; allowed: "
                "outside of every pearl of the rows"
            )


def _check_windows(arrangement: Arrangement) -> None:
    """No pearl may reach through a window."""
    for number, window in enumerate(arrangement.scene.windows):
        frame = arrangement.frame(window)
        for centre, radius in arrangement.balls():
            if frame.distance_mm(centre) < radius:
                raise InputError(
                    f"scene {arrangement.scene.name}: windows.{number} passes "
                    f"{frame.distance_mm(centre):.3g} mm from a pearl's centre; allowed: at least "
                    f"its radius of {radius:g} mm"
                )


def _axes(azimuth_deg: float, elevation_deg: float) -> tuple[Point, Point, Point]:
    """The viewer's right and up, and the direction from the middle to the eye."""
    azimuth, elevation = math.radians(azimuth_deg), math.radians(elevation_deg)
    sin_a, cos_a, sin_e, cos_e = (
        f(angle) for angle in (azimuth, elevation) for f in (math.sin, math.cos)
    )
    return (
        (cos_a, 0.0, -sin_a),
        (-sin_a * sin_e, cos_e, -cos_a * sin_e),
        (sin_a * cos_e, sin_e, cos_a * cos_e),
    )


def _dot(a: Point, b: Point) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _seen_mm(aside_mm: float, radius_mm: float, ahead_mm: float, eye_mm: float) -> float:
    """How far from the middle of the view a ball's outline reaches along one axis, there."""
    if math.isinf(eye_mm):
        return abs(aside_mm) + radius_mm
    middle = math.atan2(abs(aside_mm), ahead_mm)
    return eye_mm * math.tan(middle + math.asin(radius_mm / math.hypot(aside_mm, ahead_mm)))

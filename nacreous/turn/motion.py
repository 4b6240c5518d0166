"""What goes round: the pearl, the lights or the camera, by an angle about the upright."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import TypeVar

from nacreous import _core
from nacreous.problem import InputError
from nacreous.spec import Lamp, Pearl, Scene, Window
from nacreous.spec.complaint import shown

#: What can go round.
WHATS = ("pearl", "lamp", "camera")

_Light = TypeVar("_Light", Lamp, Window)
_Pair = tuple[Pearl, Scene]


def check(what: str, pearl: Pearl, scene: Scene) -> None:
    """Refuse what cannot go round: an unknown word, a pearl without pose, a scene without lights.

    >>> check("lamp", Pearl(), Scene())
    Traceback (most recent call last):
    nacreous.problem.InputError: scene scene has no lamp or window that could go round; ...
    """
    if what not in WHATS:
        raise InputError(f"what is {shown(what)}; allowed: {', '.join(WHATS)}")
    if what == "pearl" and pearl.model == "illuminant":
        raise InputError(
            f'pearl {pearl.name} has model = "illuminant", which knows no [pose]; allowed: a pearl '
            'of model = "transport", or what = lamp or camera'
        )
    lights: list[Lamp | Window] = [*scene.lamps, *scene.windows]
    if what == "lamp" and not any(map(_goes_round, lights)):
        which = "other than flat below or straight above it" if lights else "that could go round"
        raise InputError(
            f"scene {scene.name} has no lamp or window {which}; allowed: a scene with one, such as "
            "north-window-black, or what = pearl or camera"
        )


def turned(what: str, pearl: Pearl, scene: Scene, angle_deg: float) -> _Pair:
    """The pearl and the scene after a turn; seen from above, counterclockwise.

    >>> turned("camera", Pearl(), Scene(), 30.0)[1].camera.azimuth_deg
    30.0
    """
    return _TURNS[what](pearl, scene, angle_deg)


def alike(pearl: Pearl) -> bool:
    """Whether a pearl looks the same from all sides: no grain, no coat, no blemishes, no bands.

    >>> alike(Pearl.load("akoya-rg")), alike(Pearl.load("akoya-rg", {"grain": 0}))
    (False, True)
    """
    keys = _core.resolved_keys(pearl.model_dump_json())
    grains = [keys[f"texture.{part}_weight"] for part in ("hue", "chroma", "value")]
    grains.append(keys.get("coat.grain_relief_rad", 0.0))
    coat, marks = pearl.coat, pearl.blemishes
    varied = (coat.thickness_spread, coat.hammering_rad, coat.terrace_um)
    counts = (marks.pits, marks.bumps, marks.scratches, marks.wrinkles, marks.chalky_spots)
    return not any((*grains, *varied, *counts, pearl.body.nucleus_bands))


def _pearl(pearl: Pearl, scene: Scene, angle_deg: float) -> _Pair:
    pose = pearl.pose.replace(turn_deg=_sum(pearl.pose.turn_deg, angle_deg))
    return pearl.replace(pose=pose), scene


def _lamp(pearl: Pearl, scene: Scene, angle_deg: float) -> _Pair:
    lamps = tuple(_around(lamp, angle_deg) for lamp in scene.lamps)
    windows = tuple(_around(window, angle_deg) for window in scene.windows)
    return pearl, scene.replace(lamps=lamps, windows=windows)


def _camera(pearl: Pearl, scene: Scene, angle_deg: float) -> _Pair:
    camera = scene.camera
    azimuth_deg = _sum(camera.azimuth_deg, angle_deg)
    return pearl, scene.replace(camera=camera.replace(azimuth_deg=azimuth_deg))


_TURNS: Mapping[str, Callable[[Pearl, Scene, float], _Pair]] = {
    "pearl": _pearl,
    "lamp": _lamp,
    "camera": _camera,
}


def _around(light: _Light, angle_deg: float) -> _Light:
    """A light gone round the upright; one that lies flat below the pearl stays."""
    if light.azimuth_deg is not None:
        return light.replace(azimuth_deg=_sum(light.azimuth_deg, angle_deg))
    if light.position_mm is None:
        return light
    moved = light.replace(position_mm=_rotated(light.position_mm, angle_deg))
    if isinstance(moved, Window) and moved.facing is not None:
        return moved.replace(facing=_rotated(moved.facing, angle_deg))
    return moved


def _goes_round(light: Lamp | Window) -> bool:
    """Whether it is elsewhere, or faces elsewhere, after a turn."""
    if light.elevation_deg is not None:
        return abs(light.elevation_deg) < 90
    facing = light.facing if isinstance(light, Window) else None
    return any(at is not None and (at[0], at[2]) != (0, 0) for at in (light.position_mm, facing))


def _sum(first_deg: float, second_deg: float) -> float:
    """Both turns, whole ones left away: a full turn gives the very bytes of none."""
    return math.fmod(first_deg + second_deg, 360.0)


def _rotated(at: tuple[float, float, float], angle_deg: float) -> tuple[float, float, float]:
    """Turned from the z axis towards x, as azimuths count."""
    x, y, z = at
    angle_rad = math.radians(math.fmod(angle_deg, 360.0))
    sin, cos = math.sin(angle_rad), math.cos(angle_rad)
    return x * cos + z * sin, y, z * cos - x * sin

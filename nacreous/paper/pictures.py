"""All the pictures that the figures need, taken once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from nacreous.image import Image, render
from nacreous.paper.sight import Sight
from nacreous.spec import Pearl, Scene
from nacreous.spec.override import Override

__all__ = [
    "CLOSE_UP_MM",
    "KNOB_SHARES",
    "LAMPS_DEG",
    "PATCH_MM",
    "PATCH_PX",
    "SAMPLES",
    "WEAK",
    "Pictures",
    "take",
]

Report = Callable[[float], None]

#: Samples a pixel of the large pictures.
SAMPLES = 16
#: Where a knob stands for "weak" in figure 14 **(ours)**: the paper gives no numbers.
WEAK = 0.15
#: The steps in which each knob is shown from none to all.
KNOB_SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)
#: Azimuth and elevation of the lamp beside its own place: right, behind, and overhead **(ours)**.
LAMPS_DEG = ((60.0, 20.0), (150.0, 30.0), (0.0, 85.0))
#: Side of the paper's patches (4.3), and of what such a patch sees of our pearl **(ours)**.
PATCH_PX = 64
PATCH_MM = 1.92
#: Width of the small pictures that show the grain **(ours)**.
CLOSE_UP_MM = 4.0


@dataclass(frozen=True)
class Pictures:
    """One pearl, pictured for all figures; pearls differ from `pearl` in what the names say."""

    pearl: Pearl
    """The pearl of figure 14 (d)."""
    scene: Scene
    size_px: int
    smooth: Image
    """Figure 14 (a): without grain."""
    shallow: Image
    """Figure 14 (b): without grain, depth weak."""
    dull: Image
    """Figure 14 (c): without grain, shininess weak."""
    grained: Image
    """Figure 14 (d)."""
    lamps: list[Image]
    """Without grain, one sample in the middle of each pixel; lamp in its place, then in others."""
    knobs: dict[str, list[Image]]
    """Small ones, one for each of `KNOB_SHARES`."""
    patch: Image
    """The middle of the pearl, `PATCH_MM` wide."""

    @cached_property
    def sight(self) -> Sight:
        """The geometry behind the large pictures."""
        return Sight.of(self.pearl, self.scene, self.size_px)

    @cached_property
    def lamp_sight(self) -> Sight:
        """The geometry behind the pictures with other lamps."""
        return Sight.of(self.pearl, self.scene, len(self.lamps[0].linear))


def overrides(figure: str) -> list[Override]:
    """What sets the pearl of a part of figure 14 apart from the preset; "d" is the preset itself.

    >>> overrides("b")
    [('grain', 0), ('depth', 0.15)]
    """
    smooth: list[Override] = [("grain", 0)]
    return {
        "a": smooth,
        "b": [*smooth, ("depth", WEAK)],
        "c": [*smooth, ("shininess", WEAK)],
        "d": [],
    }[figure]


def take(size_px: int, report: Report, growth: Sequence[Override] = ()) -> Pictures:
    """Render the preset `paper` for all figures; `report` is called with the finished share.

    growth: what its nacre has instead, such as [("nacre.season_days", 60)].
    """
    scene = Scene.load("paper")
    shots = _Shots(scene, size_px, report, growth)
    smooth, shallow, dull, grained = (
        shots.take(overrides(part), size_px, SAMPLES) for part in "abcd"
    )
    lamps = [
        shots.take(overrides("a"), size_px // 2, 1, of_scene)
        for of_scene in [[], *map(_lamp_at, LAMPS_DEG)]
    ]
    # Grain is too fine for a small picture of the whole pearl.
    fields: dict[str, list[Override]] = {
        "depth": [],
        "shininess": [],
        "grain": [("camera.field_mm", CLOSE_UP_MM)],
    }
    knobs = {
        knob: [
            shots.take([*overrides("a"), (knob, share)], _thumbnail_px(size_px), 4, field)
            for share in KNOB_SHARES
        ]
        for knob, field in fields.items()
    }
    close: list[Override] = [("camera.field_mm", PATCH_MM), ("camera.projection", "orthographic")]
    return Pictures(
        pearl=Pearl.load("paper", list(growth)),
        scene=scene,
        size_px=size_px,
        smooth=smooth,
        shallow=shallow,
        dull=dull,
        grained=grained,
        lamps=lamps,
        knobs=knobs,
        patch=shots.take([], PATCH_PX, 1, close),
    )


def _thumbnail_px(size_px: int) -> int:
    return max(64, size_px // 4)


def _lamp_at(place_deg: tuple[float, float]) -> list[Override]:
    azimuth_deg, elevation_deg = place_deg
    return [("lamps.0.azimuth_deg", azimuth_deg), ("lamps.0.elevation_deg", elevation_deg)]


class _Shots:
    """Renders one after the other and knows how much is done of them all."""

    def __init__(
        self, scene: Scene, size_px: int, report: Report, growth: Sequence[Override] = ()
    ) -> None:
        self._scene = scene
        self._growth = growth
        self._report = report
        self._done = 0.0
        lamps = (1 + len(LAMPS_DEG)) * (size_px // 2) ** 2
        knobs = 3 * len(KNOB_SHARES) * 4 * _thumbnail_px(size_px) ** 2
        self._total = float(4 * SAMPLES * size_px**2 + lamps + knobs + PATCH_PX**2)

    def take(
        self,
        of_pearl: list[Override],
        size_px: int,
        samples: int,
        of_scene: list[Override] | None = None,
    ) -> Image:
        pearl = Pearl.load("paper", [*self._growth, *of_pearl])
        scene = Scene.load("paper", of_scene) if of_scene else self._scene
        rays = samples * size_px**2
        begin = self._done

        def progress(share: float) -> None:
            self._report((begin + share * rays) / self._total)

        picture = render(pearl, scene, size_px, samples, progress)
        self._done += rays
        return picture

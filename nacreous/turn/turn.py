"""Frames one after another, and where they are kept."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous import file, image
from nacreous.number import whole_of
from nacreous.turn import moving, series
from nacreous.turn.plan import MOST_FRAMES, Plan, plan

if TYPE_CHECKING:
    from nacreous.image import Image
    from nacreous.spec import Pearl, Scene

#: The most frames a second that screens show.
MOST_FPS = 60


def frames(
    pearl: str | Path | Pearl,
    scene: str | Path | Scene = "paper",
    count: int = 48,
    what: str = "pearl",
    degrees: float = 360.0,
    size: int = 512,
    samples: int = 16,
    progress: Callable[[float], None] | None = None,
) -> Iterator[Image]:
    """Render the frames of a turn, one after another, each as `nacreous.render` makes it.

    pearl, scene, size, samples: as for `nacreous.render`; in rows, every "*" is this pearl. count:
    2 to 2000 frames. what: "pearl" turns it in its place (`pose.turn_deg`), "lamp" takes lamps and
    windows round it, "camera" the camera; seen from above counterclockwise. degrees: how far, -3600
    to 3600 and not 0. Whole turns are cut into `count` steps, so that the first frame follows the
    last; of other turns the last frame shows the end. progress: called with the finished share of
    all frames.

    Raises `InputError` at once, before the first frame: for numbers out of range, a pearl of the
    illuminant model, which has no pose, and a scene whose lights cannot go round.

    >>> import nacreous as nc
    >>> first, second = nc.turn.frames("akoya-rg", "booth", 2, degrees=90, size=8, samples=1)
    >>> "turn_deg = 90.0" in second.recipe["pearl"]
    True
    """
    laid = plan(pearl, scene, count, what, degrees, size, samples)
    return (image.render_recipe(made, show) for made, show in series.shares(laid.recipes, progress))


def save(
    path: str | Path,
    pearl: str | Path | Pearl,
    scene: str | Path | Scene = "paper",
    count: int = 48,
    what: str = "pearl",
    degrees: float = 360.0,
    fps: int = 24,
    size: int = 512,
    samples: int = 16,
    progress: Callable[[float], None] | None = None,
) -> int:
    """Keep a turn at `path`, and give back how many frames had to be rendered for it.

    path: without an ending, a folder: frame-000.png and so on, each with its recipe, and turn.json.
    Frames that are there already are kept, if they are of the same turn. With an ending, a file:
    .png, .gif or .webp, which move, or .mp4 or .webm, for which PyAV must be installed; it is whole
    or not there. fps: 1 to 60 frames a second. The rest as for `frames`.

    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     how = {"count": 3, "size": 8, "samples": 1}
    ...     save(f"{folder}/out", "akoya-rg", **how), save(f"{folder}/out", "akoya-rg", **how)
    (3, 0)
    """
    place = check_place(path, size, count, fps)
    return keep(place, plan(pearl, scene, count, what, degrees, size, samples), fps, progress)


def check_place(path: str | Path, size: int, count: int, fps: int) -> Path:
    """Refuse a place, an ending, or more than fits there, before any long work."""
    count, fps = whole_of("frames", count, 2, MOST_FRAMES), whole_of("fps", fps, 1, MOST_FPS)
    size = whole_of("size", size, 1, 8192)
    place = file.named(path)
    if series.is_folder(place):
        series.check_place(place)
    else:
        moving.check_place(place, size, count, fps)
    return place


def keep(place: Path, laid: Plan, fps: int, progress: Callable[[float], None] | None = None) -> int:
    """Write a plan's frames to a place that has been checked."""
    fps = whole_of("fps", fps, 1, MOST_FPS)
    if series.is_folder(place):
        return series.keep(place, laid, fps, progress)
    return moving.keep(place, laid, fps, progress)

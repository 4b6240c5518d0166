"""A turn as a folder of pictures, which an interrupted call goes on with."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from nacreous import __version__, file, image
from nacreous.named_files import moved, relative_to
from nacreous.problem import InputError
from nacreous.recipe import PREFIX, Recipe
from nacreous.turn.plan import Plan

MAKER = "nacreous turn"
RECORD = "turn.json"

Progress = Callable[[float], None]


def is_folder(place: Path) -> bool:
    """Whether a series goes there: the place has no ending, or is a folder."""
    return place.suffix == "" or place.is_dir()


def check_place(place: Path) -> None:
    """Refuse a place where no folder can be filled."""
    if place.is_file():
        raise InputError(f"{place}: is a file; wanted: a folder, or a name with an ending")
    target = Path(os.path.realpath(place))
    # A folder to be made needs one that can be written to, as a file does.
    file.check_output((target if target.exists() else target.parent) / RECORD, (".json",))


def frame_name(number: int, count: int) -> str:
    """A frame's file: numbers of equal length, so that names sort as frames follow.

    >>> frame_name(7, 48), frame_name(7, 2000)
    ('frame-007.png', 'frame-0007.png')
    """
    return f"frame-{number:0{max(3, len(str(count - 1)))}}.png"


def finished(place: Path) -> int:
    """How many frames are in a folder."""
    return len(list(place.glob("frame-*.png")))


def shares(
    recipes: Sequence[Recipe], progress: Progress | None
) -> Iterator[tuple[Recipe, Progress | None]]:
    """Each recipe with what to call with its own share, which is told as one of the whole."""
    for number, made in enumerate(recipes):
        if progress is None:
            yield made, None
            continue

        def show(share: float, number: int = number, tell: Progress = progress) -> None:
            tell((number + share) / len(recipes))

        yield made, show


def keep(place: Path, laid: Plan, fps: int, progress: Progress | None) -> int:
    """Render what is not there yet, each frame whole or absent; how many that were.

    Raises `InputError` for a folder that holds anything but frames of this turn.
    """
    count = len(laid.recipes)
    digest = laid.digest
    _check_same(place, digest)
    names = [place / frame_name(number, count) for number in range(count)]
    lost = [number for number in range(count) if not _is_kept(names[number], laid.recipes[number])]
    missing = [laid.recipes[number] for number in lost]
    for number, (made, show) in zip(lost, shares(missing, progress), strict=True):
        picture = image.render_recipe(made, show)
        if number == lost[0]:  # what cannot be rendered leaves no folder behind
            _record(place, laid, fps, digest)
        picture.save(names[number])
    if not lost:
        _record(place, laid, fps, digest)
    return len(lost)


def _record(place: Path, laid: Plan, fps: int, digest: str) -> None:
    """Write what the folder holds, before the first frame: a frame is never without it."""
    place.mkdir(exist_ok=True)
    record = {
        "made_by": MAKER,
        "nacreous": __version__,
        "pearl": laid.pearl,
        "scene": laid.scene,
        "what": laid.what,
        "degrees": laid.degrees,
        "frames": len(laid.recipes),
        "fps": fps,
        "size": laid.size,
        "samples": laid.samples,
        "sha256": digest,
    }
    with file.atomic(place / RECORD) as temporary:
        text = json.dumps(record, ensure_ascii=False, indent=1)
        temporary.write_text(text + "\n", encoding="utf-8")


def _check_same(place: Path, digest: str) -> None:
    """Refuse frames of another turn, and files of anybody else's."""
    if not place.exists():
        return
    # What a killed run left behind is ours.
    found = sorted(one.name for one in place.iterdir() if not one.name.startswith(".nacreous-"))
    if not found:
        return
    record = _recorded(place / RECORD)
    wanted = "an empty folder, or one with frames of the same turn"
    if record is None:
        raise InputError(
            f"{place}: holds {found[0]!a} and no {RECORD} of {MAKER}; wanted: {wanted}"
        )
    if record.get("sha256") != digest:
        of = ", ".join(f"{key} {record.get(key)}" for key in ("pearl", "scene", "what", "frames"))
        raise InputError(f"{place}: holds frames of another turn ({of}); wanted: {wanted}")


def _recorded(place: Path) -> dict[str, object] | None:
    try:
        if not place.is_file():  # nobody waits for a pipe
            return None
        record = json.loads(place.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    ours = isinstance(record, dict) and record.get("made_by") == MAKER
    return record if ours else None


def _is_kept(place: Path, made: Recipe) -> bool:
    """Whether the frame is there, whole, and made from this recipe."""
    if not place.exists():
        return False
    try:
        found = file.read_png_text(place)
    except InputError:  # cut off, by whatever copied it
        return False
    texts = moved(made.texts, relative_to(place.parent))
    # Of several different pearls each has a text of its own: pearl.0, pearl.1 and so on.
    same = [name for name in texts if name.partition(".")[0] in {"pearl", "scene", "settings"}]
    return all(found.get(PREFIX + name) == texts[name] for name in same)

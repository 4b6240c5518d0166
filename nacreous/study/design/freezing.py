"""Freezing: a study file becomes a folder that never changes again."""

from __future__ import annotations

import copy
import hashlib
import json
import platform
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from nacreous import __version__, _core, folder
from nacreous.problem import InputError
from nacreous.spec import document
from nacreous.spec.specfile import find
from nacreous.study.design.design import Design
from nacreous.study.design.exported_names import check_exported_names
from nacreous.study.design.manifest import (
    MAKER,
    RECORD,
    STIMULI,
    VERSION,
    Frozen,
    hash_of,
    open_frozen,
)
from nacreous.study.design.picture import Picture, Source

__all__ = ["freeze"]


def freeze(
    study: str | Path,
    output: str | Path,
    progress: Callable[[float], None] | None = None,
) -> Frozen:
    """Render or read all stimuli of a study and write the folder `output`, all of it or nothing.

    study: a study file, or a preset's name. output: a folder that is empty or not there yet; a
    study is never frozen over another. progress: called with the finished share, 0 to 1.

    The folder holds study.json, the manifest, and stimuli/, PNG files by their own hash, without
    any text inside but their width, so that none tells a participant what is shown. Same file,
    same bytes, on the same versions. Raises `InputError` for a study or a folder that cannot be
    used.

    >>> from tempfile import TemporaryDirectory
    >>> file = '''purpose = "demo"
    ... questions = [{ id = "deeper", text = { en = "Which is deeper?", ja = "どちらが深い?" } }]
    ... stimuli = [{ label = "a", pearl = "akoya-r" }, { label = "b", pearl = "akoya-g" }]
    ... display = { size_px = 32, samples = 1 }
    ... '''
    >>> with TemporaryDirectory() as place:
    ...     _ = Path(place, "my.toml").write_text(file, encoding="utf-8")
    ...     frozen = freeze(f"{place}/my.toml", f"{place}/my-study")
    >>> [stimulus.label for stimulus in frozen.stimuli]
    ['a', 'b']
    """
    _, path, where = find(study, ("study",))
    values = document.read(path)
    # As it is written: the paths in the manifest do not depend on where the program ran.
    design = Design.check(copy.deepcopy(values), where, Path())
    check_exported_names(design, where)
    places = [f"{where}: stimuli.{place}" for place in range(len(design.stimuli))]
    sources = [
        Source.of(stimulus, path.parent, place)
        for stimulus, place in zip(design.stimuli, places, strict=True)
    ]
    if (Path(output) / RECORD).exists():
        raise InputError(
            f"{output}: holds a study that is frozen already; wanted: an empty folder, or one that "
            "is not there yet"
        )
    with folder.whole(output, (RECORD, STIMULI), RECORD, MAKER) as out:
        (out / STIMULI).mkdir()
        stimuli = [
            _written(out, picture)
            for picture in _pictures(design, sources, places, progress or (lambda _: None))
        ]
        text = json.dumps(_manifest(design, stimuli), indent=1, ensure_ascii=False)
        (out / RECORD).write_text(text + "\n", encoding="utf-8", newline="\n")
    return open_frozen(output)


def _pictures(
    design: Design, sources: list[Source], places: list[str], show: Callable[[float], None]
) -> Iterator[Picture]:
    for done, (source, place) in enumerate(zip(sources, places, strict=True)):

        def part(share: float, done: int = done) -> None:
            show((done + share) / len(sources))

        yield from source.pictures(design.display, place, part)


def _written(out: Path, picture: Picture) -> dict[str, Any]:
    """Write a picture under its hash, and give its entry in the manifest."""
    draft = out / STIMULI / "draft.png"
    # The width makes one picture in two widths two files, which people are to tell apart.
    _core.write_png(draft, picture.codes, "srgb", [("width_mm", f"{picture.width_mm!r}")])
    sha256 = hashlib.sha256(draft.read_bytes()).hexdigest()
    draft.replace(draft.with_name(f"{sha256}.png"))
    height_px, width_px = picture.codes.shape[:2]
    return {
        "label": picture.label,
        "file": f"{STIMULI}/{sha256}.png",
        "sha256": sha256,
        "width_px": width_px,
        "height_px": height_px,
        "width_mm": picture.width_mm,
        "recipe": picture.recipe,
    }


def _manifest(design: Design, stimuli: list[dict[str, Any]]) -> dict[str, Any]:
    """All that the study is; its own hash comes last."""
    written = json.loads(json.dumps(design.model_dump(exclude_none=True)))
    manifest = {
        "nacreous_study": VERSION,
        "made_by": MAKER,
        "design": written,
        "design_hash": hash_of(written),
        "stimuli": stimuli,
        "versions": {
            "nacreous": __version__,
            "python": platform.python_version(),
            "numpy": np.__version__,
        },
    }
    return {**manifest, "study_hash": hash_of(manifest)}

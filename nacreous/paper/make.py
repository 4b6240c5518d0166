"""Every figure of the paper that can be made, into one folder."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from numbers import Integral
from pathlib import Path
from typing import Any

import numpy as np

from nacreous import _core, folder
from nacreous.paper import (
    figure_2,
    figure_8,
    figure_9,
    figure_10,
    figure_11,
    figure_12,
    figure_13,
    figure_14,
    page,
    pictures,
)
from nacreous.paper.exhibit import Exhibit
from nacreous.problem import InputError
from nacreous.spec import Growth
from nacreous.spec.override import Override

__all__ = ["FILES", "MAKER", "SIZES_PX", "Paper", "make"]

MAKER = "nacreous paper"
PAGE, RECORD = "index.html", "measurements.json"
#: The sizes at which crops and rings hold enough pixels, and memory stays under 4 GB.
SIZES_PX = (64, 2048)

_FIGURES = (figure_8, figure_9, figure_10, figure_11, figure_12, figure_13, figure_14, figure_2)
#: Every file that a run makes.
FILES = (*(name for figure in _FIGURES for name in figure.FILES), PAGE, RECORD)

#: The share of the time that rendering takes.
_RENDERING = 0.8


@dataclass(frozen=True)
class Paper:
    """What a run has made."""

    exhibits: list[Exhibit]
    settings: dict[str, Any]
    """Size, samples, seeds, versions: what makes it again."""
    files: dict[str, str]
    """The pearl and scene file behind figure 14 (d)."""


def make(
    path: str | Path,
    size_px: int = 512,
    report: Callable[[float], None] | None = None,
    growth: Sequence[Override] = (),
) -> Paper:
    """Make figures 8 to 14 and the crops of figure 2, a page and a record, in the folder `path`.

    The folder is made; it may be empty or hold an earlier run. report: called with the finished
    share. growth: what the nacre has instead of the preset's, as `pictures.take` has it. All files
    are made or none. Same size, same bytes, on the same versions. Raises `InputError` for a folder
    or a size that cannot be used.
    """
    least, most = SIZES_PX
    whole = isinstance(size_px, Integral) and not isinstance(size_px, bool)
    if not whole or not least <= size_px <= most:
        raise InputError(f"size is {size_px}; allowed: {least} to {most} pixels")
    size_px = int(size_px)
    show = report or (lambda _: None)
    with folder.whole(path, FILES, RECORD, MAKER) as temporary:
        taken = pictures.take(size_px, lambda share: show(_RENDERING * share), growth)
        paper = Paper(_exhibits(temporary, taken, show), _settings(taken), _files(taken))
        (temporary / PAGE).write_text(page.html(paper), encoding="utf-8")
        record = json.dumps(_record(paper), ensure_ascii=False, indent=1)
        (temporary / RECORD).write_text(record + "\n", encoding="utf-8")
        show(1.0)
    return paper


def _exhibits(
    temporary: Path, taken: pictures.Pictures, show: Callable[[float], None]
) -> list[Exhibit]:
    """In the order of the paper; figure 2 last, as it is cut from figure 14."""
    found = [figure_8.exhibit(temporary)]
    makers = (figure_9, figure_10, figure_11, figure_12, figure_13)
    for done, figure in enumerate(makers):
        found.append(figure.exhibit(temporary, taken))
        show(_RENDERING + (1 - _RENDERING) * (done + 1) / (len(makers) + 2))
    found.extend(figure_14.exhibits(temporary, taken))
    found.append(figure_2.exhibit(temporary, taken))
    return found


def _settings(taken: pictures.Pictures) -> dict[str, Any]:
    from nacreous import __version__

    nacre = taken.pearl.nacre
    return {
        "size": taken.size_px,
        "samples": pictures.SAMPLES,
        "seed": nacre.seed if isinstance(nacre, Growth) else None,
        "texture_seed": _core.texture_seed(taken.pearl.model_dump_json()),
        "texture_source": taken.pearl.texture.source,
        "versions": {
            "nacreous": __version__,
            "python": platform.python_version(),
            "numpy": np.__version__,
        },
    }


def _files(taken: pictures.Pictures) -> dict[str, str]:
    return {"pearl": taken.pearl.to_toml(), "scene": taken.scene.to_toml()}


def _record(paper: Paper) -> dict[str, Any]:
    figures = [
        {
            "figure": shown.number,
            "files": [plate.path.name for plate in shown.plates],
            "command": shown.command,
            "measurements": [measured.record() for measured in shown.measurements],
        }
        for shown in paper.exhibits
    ]
    return {"made_by": MAKER, "settings": paper.settings, "figures": figures, **paper.files}

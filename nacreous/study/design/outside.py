"""What a study's file takes from elsewhere, which whoever freezes another's wants to know."""

from __future__ import annotations

import os
from pathlib import Path

from nacreous.spec.specfile import find
from nacreous.study.design.design import Design

__all__ = ["files_outside"]


def files_outside(study: str | Path) -> list[str]:
    """The pictures, pearl and scene files that a study names and that lie outside its folder.

    By the places to which all symbolic links lead, sorted, each once. Raises `InputError` for a
    study file that cannot be used.

    >>> files_outside("paper")
    []
    """
    _, path, _ = find(study, ("study",))
    folder = os.path.realpath(path.parent)
    named = [
        name
        for stimulus in Design.load(study).stimuli
        for name in (stimulus.picture, stimulus.pearl, stimulus.scene)
        if name is not None and (name == stimulus.picture or name.lower().endswith(".toml"))
    ]
    places = {os.path.realpath(path.parent / name) for name in named}
    return sorted(place for place in places if not Path(place).is_relative_to(folder))

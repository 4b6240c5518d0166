"""The frozen study: a manifest that says what was made, and hashes that show any change."""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nacreous import json_text
from nacreous.missing import missing
from nacreous.problem import InputError
from nacreous.scaling.data.label import label_of
from nacreous.study.design.design import Design
from nacreous.value import in_short

__all__ = [
    "MAKER",
    "RECORD",
    "STIMULI",
    "Frozen",
    "FrozenStimulus",
    "design_of",
    "hash_of",
    "open_frozen",
]

MAKER = "nacreous study new"
RECORD = "study.json"
STIMULI = "stimuli"
#: The version of the manifest.
VERSION = 1


@dataclass(frozen=True)
class FrozenStimulus:
    """One picture of a frozen study.

    file: relative to the study's folder. width_mm: on the participant's screen. recipe: everything
    that a rendered picture is made from again ("pearl" and "scene" as TOML, "settings",
    "versions"), of a crop where it was cut, and of words of the trade the keys that each has set
    ("words"); None for a picture that was brought.
    """

    label: str
    file: str
    sha256: str
    width_px: int
    height_px: int
    width_mm: float
    recipe: Mapping[str, Any] | None


@dataclass(frozen=True, repr=False)
class Frozen:
    """A frozen study, as it was made.

    study_hash: of the whole manifest, stimuli included. design_hash: of the study file alone.
    """

    __repr__ = in_short

    folder: Path
    design: Design
    design_hash: str
    study_hash: str
    stimuli: tuple[FrozenStimulus, ...]

    def path(self, label: str) -> Path:
        """Where the picture of a stimulus lies."""
        for stimulus in self.stimuli:
            if stimulus.label == label_of(label):
                return self.folder / stimulus.file
        raise InputError(f'"{label}" is no stimulus of the study; allowed: its labels')

    def manifest(self) -> dict[str, Any]:
        """The manifest, which a store keeps beside the answers."""
        return _read(self.folder)


def hash_of(values: Mapping[str, Any]) -> str:
    """SHA-256 of the values as JSON with sorted keys and no spaces, in hexadecimal.

    >>> hash_of({"b": 1, "a": 2.5}) == hash_of({"a": 2.5, "b": 1})
    True
    """
    text = json.dumps(values, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()


def open_frozen(path: str | Path) -> Frozen:
    """Open the folder of a frozen study and see that nothing in it has changed.

    Raises `InputError` for a folder that holds none, and for a manifest or a stimulus that is not
    as it was made.

    >>> open_frozen("no such study")
    Traceback (most recent call last):
    nacreous.problem.InputError: no such study: does not exist; wanted: a folder that ...
    """
    manifest = _read(Path(path))
    where = f"{Path(path) / RECORD}"
    sealed = {key: value for key, value in manifest.items() if key != "study_hash"}
    try:
        intact = manifest["study_hash"] == hash_of(sealed)
        intact = intact and manifest["design_hash"] == hash_of(manifest["design"])
        stimuli = tuple(
            FrozenStimulus(**{**stimulus, "label": label_of(stimulus["label"])})
            for stimulus in manifest["stimuli"]
        )
    except (KeyError, TypeError, ValueError, AttributeError):
        intact, stimuli = False, ()
    if not intact:
        raise InputError(f"{where}: has been changed since it was frozen; wanted: as it was made")
    for stimulus in stimuli:
        _check(Path(path), stimulus)
    design = design_of(manifest, where)
    return Frozen(
        Path(path), design, manifest["design_hash"], manifest["study_hash"], tuple(stimuli)
    )


def design_of(manifest: Mapping[str, Any], where: str) -> Design:
    """The design in a manifest, with what it was frozen under.

    One of before `adaptation_s` asked for none. where: for messages. Raises `InputError` where it
    is none.
    """
    design = manifest["design"]
    sitting = design.get("sitting", {})
    if isinstance(sitting, dict):
        design = {**design, "sitting": {"adaptation_s": 0.0, **sitting}}
    return Design.check(design, where, Path())


def _refuse_other(path: Path) -> None:
    """A frozen folder holds its files: what a link leads to could be anything, and change.

    Nor is it a pipe or a device, for which a reader would wait.
    """
    if path.exists() and not path.is_symlink() and not (path.is_file() or path.is_dir()):
        raise InputError(f"{path}: is no ordinary file; wanted: as {MAKER} made it")
    if path.is_symlink():
        raise InputError(
            f"{path}: is a link to {os.path.realpath(path)}; wanted: as {MAKER} made it"
        )


def _read(folder: Path) -> dict[str, Any]:
    _refuse_other(folder / RECORD)
    try:
        manifest = json_text.loads((folder / RECORD).read_text(encoding="utf-8"))
    except (FileNotFoundError, NotADirectoryError):
        if not folder.exists():
            raise missing(folder, f"a folder that {MAKER} made") from None
        raise InputError(
            f"{folder}: holds no {RECORD}; wanted: a folder that {MAKER} made"
        ) from None
    except OSError as problem:
        raise InputError(f"{folder / RECORD}: cannot be read ({problem.strerror})") from None
    except json_text.TwiceError as problem:
        raise InputError(f"{folder / RECORD}: {problem}") from None
    except (ValueError, RecursionError):
        manifest = None
    if not isinstance(manifest, dict) or manifest.get("made_by") != MAKER:
        raise InputError(f"{folder / RECORD}: is no manifest; wanted: one that {MAKER} made")
    if manifest.get("nacreous_study") != VERSION:
        version = json.dumps(manifest.get("nacreous_study"))[:40]
        raise InputError(f"{folder / RECORD}: nacreous_study is {version}; allowed: {VERSION}")
    return manifest


def _check(folder: Path, stimulus: FrozenStimulus) -> None:
    path = folder / STIMULI / f"{stimulus.sha256}.png"
    named = re.fullmatch("[0-9a-f]{64}", str(stimulus.sha256))
    if named is None or path != folder / str(stimulus.file):
        raise InputError(
            f'{folder / RECORD}: file of "{stimulus.label}" is {ascii(stimulus.file)[:80]}; '
            f"allowed: {STIMULI}/ and its SHA-256"
        )
    for part in (path.parent, path):
        _refuse_other(part)
    try:
        found = hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as problem:
        raise InputError(f"{path}: cannot be read ({problem.strerror})") from None
    if found != stimulus.sha256:
        raise InputError(
            f'{path}: the picture of "{stimulus.label}" has been changed since it was frozen; '
            "wanted: as it was made"
        )

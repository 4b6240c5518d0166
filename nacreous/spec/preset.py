"""Presets: the pearls, scenes and nacre that come with the package, as files like any other."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from nacreous import toml_text
from nacreous.problem import InputError

_FOLDER = Path(__file__).parent.parent / "presets"

#: What there are presets of, and the folder each kind lies in.
FOLDERS = {"pearl": "pearls", "scene": "scenes", "nacre": "nacre", "study": "studies"}


@cache
def names(kind: str) -> list[str]:
    """The names of all presets of a kind ("pearl", "scene", "nacre" or "study"), in order.

    >>> "akoya-rg" in names("nacre")
    True
    """
    return sorted(path.stem for path in (_FOLDER / FOLDERS[kind]).glob("*.toml"))


def path(kind: str, name: str) -> Path:
    """The file of a preset; an InputError names the nearest when there is none of that name."""
    if name not in names(kind):
        from nacreous.spec.complaint import nearest, shown

        near = nearest(name, names(kind))
        hint = f"did you mean {near}?" if near else f"there are: {', '.join(names(kind))}"
        raise InputError(f"{shown(name)} is not a {kind} preset; {hint}")
    return _FOLDER / FOLDERS[kind] / f"{name}.toml"


def text(kind: str, name: str) -> str:
    """The preset's file as it stands, to read or to begin one's own with."""
    return path(kind, name).read_text(encoding="utf-8")


def summary(kind: str, name: str) -> str:
    """What the preset is, in one line: the first comment of its file.

    >>> summary("pearl", "paper")
    "The pearl of 1996: bluish rainbow colours, by a growth within the paper's ranges."
    """
    return text(kind, name).partition("\n")[0].removeprefix("#").strip()


def values(kind: str, name: str) -> dict[str, Any]:
    """The keys that the preset gives."""
    return toml_text.loads(text(kind, name))

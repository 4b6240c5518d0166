"""Presets complete, as they lie in the package: ready for a renderer, with nothing to check.

`nacreous/presets/complete.json` is made of the presets' files by `./just types`, which a test holds
it to. The declarations of keys, which check people's own files, take longer to load than a picture
of a preset takes to render.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import NotRequired, TypeAlias, TypedDict

__all__ = ["FILE", "Complete", "Json", "ready"]

FILE = Path(__file__).parent / "presets" / "complete.json"

Json: TypeAlias = bool | int | float | str | list["Json"] | dict[str, "Json"] | None


class Complete(TypedDict):
    """A preset: what it is, in one line, and all its keys.

    values: of a scene, its rows name pearls by number. toml: the same as a file, but of nacre,
    which is a part of a pearl's. pearls: of a scene, the pearls of those numbers, null for the
    pearl that is shown.
    """

    summary: str
    values: Json
    toml: NotRequired[str]
    pearls: NotRequired[list[Json]]


@cache
def ready() -> dict[str, dict[str, Complete]]:
    """The presets, by kind ("pearl", "scene" or "nacre") and name.

    >>> ready()["scene"]["booth"]["values"]["camera"]["glare_deg"]
    0.5
    """
    presets: dict[str, dict[str, Complete]] = json.loads(FILE.read_text(encoding="utf-8"))
    return presets

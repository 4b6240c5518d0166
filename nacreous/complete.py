"""Presets complete, as JSON: for renderers that read no TOML, as in a browser.

Made from the files in `nacreous/presets/`, by the same declarations of keys that load them: every
key is there, with null where it is left out and the renderer finds its value.
"""

from __future__ import annotations

import json
from typing import Literal, NotRequired, TypeAlias, TypedDict

from nacreous.rows import fill
from nacreous.spec import Growth, Pearl, Scene, preset

__all__ = ["KINDS", "Complete", "Json", "Kind", "complete"]

Kind: TypeAlias = Literal["pearl", "scene", "nacre"]

#: What a picture is made from; a study is not.
KINDS: tuple[Kind, ...] = ("pearl", "scene", "nacre")

Json: TypeAlias = bool | int | float | str | list["Json"] | dict[str, "Json"] | None


class Complete(TypedDict):
    """A preset: what it is, in one line, and all its keys.

    values: of a scene, its rows name pearls by number. pearls: of a scene, the pearls of those
    numbers, null for the pearl that is shown.
    """

    summary: str
    values: Json
    pearls: NotRequired[list[Json]]


def complete(kind: Kind, name: str) -> Complete:
    """A preset with every key. Raises `InputError` where there is none of that name.

    >>> booth = complete("scene", "booth")
    >>> booth["pearls"], booth["values"]["camera"]["glare_deg"]
    ([None], 0.5)
    >>> [one and one["name"] for one in complete("scene", "two-tier")["pearls"]]
    ['akoya-rg-1.0', 'akoya-rg-0.7', 'akoya-rg-0.4', 'akoya-rg-0.0', None]
    """
    summary = preset.summary(kind, name)
    if kind == "scene":
        shown = Pearl(name=_SHOWN)
        filled = fill([shown], Scene.load(name))
        pearls = [None if pearl is shown else _json(pearl) for pearl in filled.pearls]
        return {"summary": summary, "values": _json(filled.scene), "pearls": pearls}
    made = Pearl.load(name) if kind == "pearl" else Growth(preset=name)
    return {"summary": summary, "values": _json(made)}


#: No preset has this name, so no pearl of a row equals it.
_SHOWN = "the pearl shown"


def _json(section: Pearl | Scene | Growth) -> Json:
    values: Json = json.loads(section.model_dump_json())
    return values

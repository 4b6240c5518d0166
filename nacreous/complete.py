"""Presets complete, as JSON: for renderers that read no TOML, as in a browser.

Made from the files in `nacreous/presets/`, by the same declarations of keys that load them: every
key is there, with null where it is left out and the renderer finds its value.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Literal, TypeAlias

from nacreous.ready import Complete, Json
from nacreous.rows import fill
from nacreous.spec import Growth, Pearl, Scene, preset

__all__ = ["KINDS", "Kind", "complete", "presets"]

Kind: TypeAlias = Literal["pearl", "scene", "nacre"]

#: What a picture is made from; a study is not.
KINDS: tuple[Kind, ...] = ("pearl", "scene", "nacre")


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
        made, toml = _json(filled.scene), filled.scene.to_toml()
        return {"summary": summary, "values": made, "toml": toml, "pearls": pearls}
    if kind == "pearl":
        pearl = Pearl.load(name)
        return {"summary": summary, "values": _json(pearl), "toml": pearl.to_toml()}
    return {"summary": summary, "values": _json(Growth(preset=name))}


def presets(kinds: Sequence[Kind] = KINDS) -> dict[str, dict[str, Complete]]:
    """All presets of some kinds, by kind and name.

    >>> list(presets(["scene"])["scene"])
    ['aurora', 'booth', 'north-window-black', 'north-window-white', 'paper', 'two-tier']
    """
    return {kind: {name: complete(kind, name) for name in preset.names(kind)} for kind in kinds}


#: No preset has this name, so no pearl of a row equals it.
_SHOWN = "the pearl shown"


def _json(section: Pearl | Scene | Growth) -> Json:
    values: Json = json.loads(section.model_dump_json())
    return values

"""A pearl and a scene in the fragment of the page's address, which a browser never sends.

`studio/src/viewer/specs/link.ts` reads and writes the same: `1.` and, in base64url, zlib's form of
`[pearl preset, what differs, scene preset, what differs]` as JSON.
"""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Iterator, Mapping
from typing import Any

from nacreous.ready import ready
from nacreous.spec import Pearl, Scene, preset

__all__ = ["fragment"]

_VERSION = "1."
#: Marks a table in place of another, not laid over it; and a whole number as text.
_WHOLE, _NUMBER = "=", "#"
#: The largest whole number that every number of a browser holds exactly.
_EXACT = 2**53 - 1


def fragment(pearl: Pearl, scene: Scene) -> str:
    """The fragment, without its `#`.

    >>> fragment(Pearl.load("akoya-rg"), Scene.load("booth"))[:2]
    '1.'
    """
    parts = [*_nearest(_pearls(pearl), _plain(pearl)), *_nearest(_scenes(), _plain(scene))]
    text = json.dumps(parts, ensure_ascii=False, separators=(",", ":"))
    packed = zlib.compress(text.encode(), 9)
    return _VERSION + base64.urlsafe_b64encode(packed).decode().rstrip("=")


def _plain(spec: Pearl | Scene) -> dict[str, Any]:
    values: dict[str, Any] = json.loads(spec.model_dump_json())
    return values


def _pearls(pearl: Pearl) -> Iterator[tuple[str, Any]]:
    """The presets of the pearl's own model, complete."""
    for name, one in ready()["pearl"].items():
        values = one["values"]
        if isinstance(values, dict) and values["model"] == pearl.model:
            yield name, values


def _scenes() -> Iterator[tuple[str, Any]]:
    for name in preset.names("scene"):
        yield name, _plain(Scene.load(name))


def _nearest(
    presets: Iterator[tuple[str, Any]], values: dict[str, Any]
) -> tuple[str, dict[str, Any]]:
    """The preset from which the least differs, and that."""
    found = ((name, _difference(values, base)) for name, base in presets)
    return min(found, key=lambda one: len(json.dumps(one)))


def _difference(table: Mapping[str, Any], base: Mapping[str, Any]) -> dict[str, Any]:
    """What `table` has otherwise than `base`, key by key; of tables with other keys all of it."""
    found: dict[str, Any] = {}
    for key, value in table.items():
        beside = base.get(key)
        if isinstance(value, dict) and isinstance(beside, dict) and list(value) == list(beside):
            if inner := _difference(value, beside):
                found[key] = inner
        elif value != beside or (value is None) != (beside is None):
            found[key] = {_WHOLE: _exact(value)} if isinstance(value, dict) else _exact(value)
    return found


def _exact(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _exact(one) for key, one in value.items()}
    if isinstance(value, list):
        return [_exact(one) for one in value]
    large = isinstance(value, int) and abs(value) > _EXACT
    return {_NUMBER: str(value)} if large else value

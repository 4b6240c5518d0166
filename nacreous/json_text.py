"""JSON from outside, in which no key stands twice: the parser alone would keep the last one."""

from __future__ import annotations

import json
from typing import Any

__all__ = ["TwiceError", "loads"]


class TwiceError(ValueError):
    """A text one of whose objects has a key twice."""


def loads(text: str) -> Any:
    """What a JSON text says. Raises `ValueError`: `TwiceError`, or the parser's own.

    >>> loads('{"size": 8}')
    {'size': 8}
    >>> loads('{"size": 8, "size": 9}')
    Traceback (most recent call last):
    nacreous.json_text.TwiceError: "size" is given twice; allowed: once
    """
    return json.loads(text, object_pairs_hook=_once)


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    made = dict(pairs)
    if len(made) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise TwiceError(f"{json.dumps(twice)[:60]} is given twice; allowed: once")
    return made

"""TOML read with a bound on depth: the one door for every TOML text, whoever wrote it.

`tomllib` keeps every beginning of a dotted key, so that 80 kB of `a.a.a...` take 6 GB, and calls
itself for every bracket. Nothing of ours is deeper than four levels.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from typing import Any

__all__ = ["DEEPEST", "TooDeepError", "flat", "loads"]

#: Levels of brackets, and parts of a key, that are read.
DEEPEST = 32

# Strings and comments are passed over whole; a string that never ends is left to the parser.
_TOKENS = re.compile(
    r'"""(?:[^"\\]|\\.|"(?!""))*+"{3,5}'
    r"|\'\'\'(?:[^']|'(?!''))*+'{3,5}"
    r'|"(?:[^"\\\n]|\\.)*+"'
    r"|'[^'\n]*+'"
    r"|#[^\n]*+"
    r"|[\[\]{}.,=\n]",
    re.DOTALL,
)


class TooDeepError(ValueError):
    """A text nested deeper than `DEEPEST`; `position`: the character at which it is."""

    def __init__(self, position: int) -> None:
        super().__init__(f"nested too deeply; allowed: {DEEPEST} levels")
        self.position = position


def loads(text: str) -> dict[str, Any]:
    """The keys of a TOML text. Raises `ValueError`: `TooDeepError`, or the parser's own.

    >>> loads("nacre = { seed = 9 }")
    {'nacre': {'seed': 9}}
    >>> loads("a = " + "[" * 80_000)
    Traceback (most recent call last):
    nacreous.toml_text.TooDeepError: nested too deeply; allowed: 32 levels
    """
    _check_depth(text)
    return tomllib.loads(text)


def flat(table: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """The values of all tables inside each other, by dotted key.

    >>> dict(flat({"a": 1, "b": {"c": 2, "d": {"e": 3}}}))
    {'a': 1, 'b.c': 2, 'b.d.e': 3}
    """
    for key, value in table.items():
        if isinstance(value, Mapping):
            yield from ((f"{key}.{inner}", one) for inner, one in flat(value))
        else:
            yield key, value


def _check_depth(text: str) -> None:
    brackets = parts = 0
    for token in _TOKENS.finditer(text):
        sign = token[0]
        if sign == ".":
            parts += 1
        elif sign in ("[", "{"):
            brackets, parts = brackets + 1, 0
        elif sign in ("]", "}"):
            brackets, parts = max(brackets - 1, 0), 0
        elif sign in (",", "=", "\n"):
            parts = 0
        if max(brackets, parts + 1) > DEEPEST:
            raise TooDeepError(token.start())

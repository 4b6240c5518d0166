"""Writing TOML: numbers, texts, lists, tables and lists of tables are all a spec needs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any


def to_toml(values: Mapping[str, Any]) -> str:
    """The text of a TOML file with these keys.

    >>> print(to_toml({"name": "a", "nacre": {"seed": 1}, "lamps": [{"spectrum": "E"}]}), end="")
    name = "a"
    <BLANKLINE>
    [nacre]
    seed = 1
    <BLANKLINE>
    [[lamps]]
    spectrum = "E"
    """
    blocks = ["".join(_line(key, value) for key, value in values.items() if not _heads(value))]
    for key, value in values.items():
        if isinstance(value, Mapping):
            blocks.append(f"[{key}]\n" + "".join(_line(*item) for item in value.items()))
        elif _heads(value):
            blocks.extend(
                f"[[{key}]]\n" + "".join(_line(*item) for item in entry.items()) for entry in value
            )
    return "\n".join(block for block in blocks if block)


def _heads(value: Any) -> bool:
    """Whether the value stands below a heading of its own."""
    tables = isinstance(value, list | tuple) and bool(value) and isinstance(value[0], Mapping)
    return tables or isinstance(value, Mapping)


def _line(key: str, value: Any) -> str:
    return f"{key} = {written(value)}\n"


def written(value: Any) -> str:
    """A value as TOML writes it.

    >>> written(True), written("a"), written([1, 2.5])
    ('true', '"a"', '[1, 2.5]')
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, list | tuple):
        return "[" + ", ".join(written(item) for item in value) + "]"
    if isinstance(value, Mapping):
        return "{ " + ", ".join(_line(*item).rstrip() for item in value.items()) + " }"
    if isinstance(value, int | float):
        return repr(value)
    raise TypeError(f"TOML has no {type(value).__name__}")

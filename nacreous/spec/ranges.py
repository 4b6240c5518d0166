"""Every number of pearl and scene files with its range, as a table for programs without Python.

    python -m nacreous.spec.ranges      prints it; crates/render/src/spec/ranges.csv is that text

A browser hands recipes to the renderer that no `Pearl` and no `Scene` has seen. The renderer checks
their numbers by this table, which is made from the keys' one declaration.
"""

from __future__ import annotations

import csv
import io
import sys
from collections.abc import Iterator
from typing import Any, NamedTuple

from nacreous.spec.pearl import Pearl
from nacreous.spec.scene import Scene
from nacreous.spec.schema import json_schema

__all__ = ["Range", "ranges", "table"]


class Range(NamedTuple):
    """What a number, or the length of a list, may be.

    path: the key with its file's kind in front, as in `scene.lamps[].intensity`; `[]` stands for
    each item of a list, `[0]` for its first; `scene.lamps` alone with kind "length" is how many.
    least, above, most, below: bounds, those of `above` and `below` excluded. allowed: the phrase of
    every message about the key.
    """

    path: str
    kind: str
    least: float | None
    above: float | None
    most: float | None
    below: float | None
    allowed: str


def ranges() -> list[Range]:
    """All of them, in the order of the files.

    >>> next(row for row in ranges() if row.path == "pearl.nacre.protein_nm")[2:]
    (0, None, 200, None, '0 to 200 nm')
    """
    found: dict[tuple[str, str], Range] = {}
    for model in (Pearl, Scene):
        schema = json_schema(model)
        for row in _below(schema, model.preset_kind, "", schema.get("$defs", {})):
            found.setdefault((row.path, row.kind), row)
    return list(found.values())


def table() -> str:
    """The same as the text of a CSV file."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(Range._fields)
    rows.writerows(ranges())
    return text.getvalue()


def _below(
    node: dict[str, Any], path: str, allowed: str, definitions: dict[str, Any]
) -> Iterator[Range]:
    """The ranges of a part of a schema and of all that it holds."""
    if "$ref" in node:
        node = definitions[node["$ref"].rpartition("/")[2]]
    allowed = node.get("allowed", allowed)
    for alternative in (*node.get("anyOf", ()), *node.get("oneOf", ())):
        yield from _below(alternative, path, allowed, definitions)
    for key, inner in node.get("properties", {}).items():
        yield from _below(inner, f"{path}.{key}", allowed, definitions)
    if node.get("type") in ("number", "integer"):
        least, above = node.get("minimum"), node.get("exclusiveMinimum")
        most, below = node.get("maximum"), node.get("exclusiveMaximum")
        yield Range(path, "number", least, above, most, below, allowed)
    if node.get("type") == "array":
        fewest, most = node.get("minItems"), node.get("maxItems")
        yield Range(path, "length", fewest, None, most, None, allowed)
        for place, item in enumerate(node.get("prefixItems", ())):
            yield from _below(item, f"{path}[{place}]", allowed, definitions)
        if "items" in node:
            yield from _below(node["items"], f"{path}[]", allowed, definitions)


if __name__ == "__main__":
    sys.stdout.write(table())

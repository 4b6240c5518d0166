"""Columns called after a pair in other words than `A vs B`: `A or B?`, `Which: A/B`."""

from __future__ import annotations

import re
from collections.abc import Collection

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.table import Table

#: Two things in other words than `vs`. Labels hold these too, so nothing is read by them.
_WORDS = "or|and|oder|und|gegen|ou|et|contre|contra|contro|o|eller|mot|tegen|или|против"
_MARKS = r"\s*(?:(?<!<)/|[|–—:×])\s*|\s+-\s+|\s*(?:か|対|對|ｖｓ|vs)\s*"
_OTHER = re.compile(rf"(\S.*?)(?:[ _]+(?:{_WORDS})[ _]+|{_MARKS})(\S.*)", re.IGNORECASE)
#: The same where what is chosen stands in the cells: the last of such words parts the two.
_LAST = re.compile(_OTHER.pattern.replace(".*?", ".*", 1), re.IGNORECASE)


def renamed_pair(table: Table, columns: Collection[str]) -> tuple[str, str] | None:
    """The first of the columns called after pairs in other words, and its name with `vs`.

    They are, where all columns but one have such names, or where each cell of one is either of two.
    """
    named = [name for name in columns if _OTHER.fullmatch(name)]
    if not named:
        return None
    for name in named:
        pair = _LAST.fullmatch(_unmarked(name))
        versus = _versus(table, name, pair[1].rstrip(), pair[2]) if pair else None
        if versus:
            return name, versus
    if len(named) < len(columns) - 1:
        return None
    return named[0], _OTHER.sub(r"\1 vs \2", _unmarked(named[0]))


def _unmarked(name: str) -> str:
    return name.rstrip("?？ ")


def _versus(table: Table, name: str, before: str, right: str) -> str | None:
    """The name with `vs` where each cell is what stands before or behind the word, or its end."""
    cells = [cell for cell in text_column(table, name).unique().to_pylist() if cell]
    lefts = [cell for cell in cells if re.search(rf"(?<!\w){re.escape(cell)}$", before)]
    if not cells or {*cells} - {*lefts} - {right}:
        return None
    left = min(lefts, key=len, default=before)
    question = before.removesuffix(left).rstrip(" ,;:?？-–—")
    return f"{question}: {left} vs {right}" if question else f"{left} vs {right}"

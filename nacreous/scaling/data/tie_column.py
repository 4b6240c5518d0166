"""A column beside winner and loser, or beside chosen, that says which answers are ties."""

from __future__ import annotations

import re
from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import Faults, quoted
from nacreous.scaling.data.table import Table

_NAMES = frozenset({"tie", "ties", "tied", "istie", "draw", "draws", "drawn", "isdraw"})
_YES = frozenset({"1", "1.0", "true", "yes", "y"})
_NO = frozenset({"0", "0.0", "false", "no", "n", None})


def tie_column(table: Table, taken: Collection[str]) -> str | None:
    """The column of yes and no, or 1 and 0, that is called tie or draw. taken: have a role."""
    for name in table.columns:
        word = re.sub(r"[\s_.\-]+", "", name).casefold()
        if word in _NAMES and name not in taken and {*_words(table, name)} <= _YES | _NO:
            return name
    return None


def ties_of(table: Table, name: str) -> NDArray[np.bool_]:
    """Bool [row], whether the column says that an answer is a tie."""
    cells = text_column(table, name).dictionary_encode()
    said = np.array([cell.lower() in _YES for cell in cells.dictionary.to_pylist()] + [False])
    return said[np.asarray(cells.indices.fill_null(len(said) - 1), dtype=np.int64)]


def refuse_other_ties(
    table: Table, name: str, chosen: str, outcome: NDArray[np.int8], faults: Faults
) -> None:
    """Note ties by that column that are none by `chosen`."""
    text = text_column(table, chosen)
    faults.say_of_column(
        np.flatnonzero(ties_of(table, name) & (outcome != 0)),
        lambda row: (
            f"{name} says that this is a tie, and {chosen} is {quoted(text[row])}; allowed: tie in "
            f"{chosen}, or another name for the column {name}"
        ),
    )


def _words(table: Table, name: str) -> list[str | None]:
    cells = text_column(table, name).unique().to_pylist()
    return [cell if cell is None else cell.lower() for cell in cells]

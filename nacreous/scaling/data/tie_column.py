"""A column beside winner and loser, or beside chosen, that says which answers are ties."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Any
from unicodedata import normalize

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import Faults, listed, quoted
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.table import Table
from nacreous.scaling.data.truth import names_tie, says_tie

_NAMES = frozenset(
    {
        *("tie", "ties", "tied", "istie", "draw", "draws", "drawn", "isdraw", "equal", "isequal"),
        *("unentschieden", "gleich", "gleichstand", "égalité", "egalité", "egalite", "nul"),
        *("empate", "pareggio", "gelijkspel", "引き分け", "同点", "平局", "무승부"),
    }
)
_ALLOWED = "1 and 0, yes and no or TRUE and FALSE"


def names_ties(column: str) -> bool:
    """Whether a column of that name says which answers are ties.

    >>> names_ties("Is tie"), names_ties("tiepin")
    (True, False)
    """
    return re.sub(r"[\s_.\-]+", "", normalize("NFKC", column)).casefold() in _NAMES


def tie_column(table: Table, taken: Collection[str]) -> str | None:
    """The column that is called tie or draw, whose words have to be known. taken: have a role."""
    named = [name for name in table.columns if names_ties(name) and name not in taken]
    if len(named) > 1:
        raise InputError(
            f"{table.place}: columns {' and '.join(named)} may say which answers are ties; "
            "allowed: one of them (remove or rename the other)"
        )
    for name in named:
        _check_words(table, name)
    return named[0] if named else None


def _check_words(table: Table, name: str) -> None:
    """Refuse words that say neither yes nor no, and a cell that says nothing beside both."""
    text = text_column(table, name)
    words = {cell: says_tie(cell) for cell in _said(text)}
    unknown = [cell for cell, tie in words.items() if tie is None]
    if unknown:
        raise InputError(
            f"{table.place}: column {name} holds {listed(unknown)}; allowed: {_ALLOWED}; or "
            "rename the column, where it does not say which answers are ties"
        )
    faults = table.faults()
    if len({*words.values()}) > 1:
        faults.say_of_column(
            np.flatnonzero(is_nothing(text)),
            lambda _: f"{name} is empty, beside {listed(words)}; allowed: one of them",
        )
    faults.stop()


def ties_of(table: Table, name: str) -> NDArray[np.bool_]:
    """Bool [row], whether the column says that an answer is a tie; an empty cell says no."""
    return _told(table, name, True)


def _told(table: Table, name: str, tie: bool) -> NDArray[np.bool_]:
    cells = text_column(table, name).dictionary_encode()
    said = np.array([says_tie(cell) is tie for cell in cells.dictionary.to_pylist()] + [False])
    return said[np.asarray(cells.indices.fill_null(len(said) - 1), dtype=np.int64)]


def refuse_other_ties(
    table: Table, name: str, chosen: str, outcome: NDArray[np.int8], faults: Faults
) -> None:
    """Note ties by that column that are none by `chosen`, and the other way round."""
    text = text_column(table, chosen)
    for tie, what in ((True, "this is a tie"), (False, "this is no tie")):
        faults.say_of_column(
            np.flatnonzero(_told(table, name, tie) & ((outcome == 0) != tie)),
            lambda row, what=what: (  # type: ignore[misc]
                f"{name} says that {what}, and {chosen} is {quoted(text[row])}; allowed: the same "
                f"in both, or another name for the column {name}"
            ),
        )


def refuse_tie_words(table: Table, names: Collection[str]) -> None:
    """Refuse a column beside winner and loser that speaks of ties under a name of its own."""
    for name in names:
        words = [cell for cell in _said(text_column(table, name)) if names_tie(cell)]
        if words:
            raise InputError(
                f"{table.place}: column {name} holds {listed(words)}, and may say which answers "
                f"are ties; allowed: {_ALLOWED} in a column tie, or other words there"
            )


def _said(text: Any) -> list[str]:
    """The different cells that say anything, in their order."""
    import pyarrow as pa

    return list(text.filter(pa.array(~is_nothing(text))).unique().to_pylist())

"""Rows of the store, as `nacreous.scaling` takes them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nacreous.scaling import Answers

__all__ = ["Row", "answers_from", "chosen_of"]

#: An answer as `Store.answers` gives it.
Row = Mapping[str, Any]


def answers_from(rows: Sequence[Row]) -> Answers:
    """Answers, people by number."""
    from nacreous.scaling import Answers

    table: dict[str, Any] = {name: [row[name] for row in rows] for name in ("left", "right")}
    table |= {name: [row[name] for row in rows] for name in ("chosen", "response_ms")}
    table["person"] = [str(row["number"]) for row in rows]
    return Answers.of_table(table, repeats=True)


def chosen_of(row: Row) -> str | None:
    """The label of what was chosen, None for a tie.

    >>> chosen_of({"left": "a", "right": "b", "chosen": "right"})
    'b'
    """
    return None if row["chosen"] == "tie" else str(row[row["chosen"]])

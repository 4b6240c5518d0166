"""The rows of a table in which two things were shown, and those that somebody answered."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.choice import is_unanswered
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import Faults
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.roles import Names
from nacreous.scaling.data.table import Table


def with_pairs(table: Table, column: dict[str, str]) -> Table:
    """The rows with a pair: programs write rows of instructions and breaks between them.

    Such a row has neither of the two things. One whose answer is a stimulus of the table stays, and
    is refused for what it lacks. column: names of columns by role.
    """
    import pyarrow.compute as pc

    sides = ("winner", "loser") if "winner" in column else ("left", "right")
    first, second = (text_column(table, column[side]) for side in sides)
    nothing = is_nothing(first) & is_nothing(second)
    alike = np.asarray(pc.fill_null(pc.equal(first, second), True))
    bare = np.flatnonzero(nothing & alike)
    if len(bare) == 0:
        return table
    kept = np.ones(table.rows, bool)
    kept[bare] = False
    if "chosen" in column:
        labels = _labels(first, second, kept)
        answers = text_column(table, column["chosen"]).take(bare).to_pylist()
        kept[[row for row, cell in zip(bare, answers, strict=True) if cell in labels]] = True
    return table.take(kept)


def unanswered(table: Table, column: dict[str, str], names: Names) -> NDArray[np.int64]:
    """The rows whose `chosen` says that nobody answered."""
    first, second = (text_column(table, column[side]) for side in ("left", "right"))
    labels = _labels(first, second, np.ones(table.rows, bool))
    cells = text_column(table, column["chosen"]).dictionary_encode()
    words = [is_unanswered(cell, labels, names) for cell in cells.dictionary.to_pylist()]
    code = np.asarray(cells.indices.fill_null(len(words)), dtype=np.int64)
    return np.flatnonzero(np.array([*words, True])[code])


def refuse_unanswered(table: Table, column: dict[str, str], names: Names, faults: Faults) -> None:
    """Note rows without an answer, and how they are left out."""
    faults.say_of_rows(
        unanswered(table, column, names),
        lambda _: (
            f"{column['chosen']} is empty; allowed: a label, or skip_unanswered=True leaves such "
            "rows out"
        ),
    )


def _labels(first: Any, second: Any, kept: NDArray[np.bool_]) -> frozenset[str]:
    import pyarrow as pa

    mask = pa.array(kept)
    return frozenset(
        label for text in (first, second) for label in text.filter(mask).unique().to_pylist()
    )

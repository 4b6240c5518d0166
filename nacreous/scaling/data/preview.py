"""Rows of Qualtrics that nobody answered: the experimenter's looks at the survey, and test data."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.table import Table

#: By column, what it holds there, in small letters, and as numbers where Qualtrics exports those.
_WORDS = {
    "Status": {"survey preview", "survey test"},
    "DistributionChannel": {"preview", "test"},
}
_NUMBERS = {"1", "2"}


def without_previews(table: Table, skip: bool) -> Table:
    """The rows of people. Others are refused, or left out where that was said by `skip`."""
    column, previews = _previews(table)
    if len(previews) == 0:
        return table
    if skip:
        kept = np.ones(table.rows, bool)
        kept[previews] = False
        return table.take(kept)
    faults = table.faults()
    text = text_column(table, column)
    faults.say_of_column(
        previews,
        lambda row: (
            f"{column} is {quoted(text[row])}, and nobody answered there; allowed: rows of people "
            "(remove it), or skip_unanswered=True leaves such rows out"
        ),
    )
    faults.stop()
    return table


def _previews(table: Table) -> tuple[str, NDArray[np.int64]]:
    """The column that tells, and the rows."""
    for column, words in _WORDS.items():
        if column not in table.columns:
            continue
        meant = words | (_NUMBERS if column == "Status" and table.texts else set())
        cells = text_column(table, column).to_pylist()
        rows = [row for row, cell in enumerate(cells) if cell and cell.lower() in meant]
        if rows:
            return column, np.array(rows, np.int64)
    return "", np.zeros(0, np.int64)

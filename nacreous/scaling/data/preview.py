"""Rows of Qualtrics that no person gave: looks at the survey, test data, and what it calls spam.

Its numbers and names of `Status` are the value labels of its exports.
"""

from __future__ import annotations

import re

import numpy as np

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.table import Table

#: By column, what it holds there: in small letters, without marks.
_WORDS = {
    "Status": {
        *("survey preview", "survey test", "survey preview spam", "offline survey preview"),
        *("spam", "possible spam", "imported spam", "ex spam", "synthetic"),
    },
    "DistributionChannel": {"preview", "test"},
}
#: The same of `Status` where Qualtrics exports numbers: a preview has 1 in it, a test 2, spam 8,
#: and made-up data 256. Imported answers (4), offline ones (16) and employees' (32) are people's.
_NOBODY = 1 | 2 | 8 | 256


def without_previews(table: Table, skip: bool) -> Table:
    """The rows of people. Others are refused, or left out where that was said by `skip`."""
    for column, words in _WORDS.items():
        if column in table.columns:
            table = _without(table, column, words, skip)
    return table


def _without(table: Table, column: str, words: set[str], skip: bool) -> Table:
    """The rows of people, as far as this column says."""
    text = text_column(table, column)
    numbers = column == "Status" and bool(table.texts)
    cells = text.to_pylist()
    nobody = np.array([bool(cell) and _is_nobody(cell, words, numbers) for cell in cells], bool)
    if skip:
        return table.take(~nobody) if nobody.any() else table
    faults = table.faults()
    faults.say_of_column(
        np.flatnonzero(nobody),
        lambda row: (
            f"{column} is {quoted(text[row])}, which is no person's answer; allowed: rows of "
            "people (remove it), or skip_unanswered=True leaves such rows out"
        ),
    )
    faults.stop()
    return table


def _is_nobody(cell: str, words: set[str], numbers: bool) -> bool:
    if numbers and cell.isdecimal():
        return bool(int(cell) & _NOBODY)
    return " ".join(re.findall(r"\w+", cell.casefold())) in words

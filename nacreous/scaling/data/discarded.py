"""Rows that a program marks as no answer: looks at a survey, tests, spam, and work turned down.

Who only did not finish is a person, whose answers count.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.nothing import NOTHING
from nacreous.scaling.data.program import GORILLA, SOSCI
from nacreous.scaling.data.table import Table

_NOBODY = "no person's answer"
_REFUSED = "no answer that counts"


@dataclass(frozen=True)
class _Mark:
    """A column that says so, by which words (in small letters, without marks), and what they mean.

    words: None where any does.

    beside: sets of columns, one of which is there too, so that a name as common is the program's
    own; small and large letters of these are alike.
    """

    column: str
    words: Collection[str] | None
    meaning: str
    beside: tuple[frozenset[str], ...] = (frozenset(),)


#: Prolific's exports of submissions, and its parameter of an address. Who returns one takes the
#: consent back.
_PROLIFIC = (
    frozenset({"Submission id"}),
    frozenset({"Participant id", "Session id"}),
    frozenset({"PROLIFIC_PID"}),
    frozenset({"Prolific id"}),
)
_MARKS = (
    # The value labels of Qualtrics's exports.
    _Mark(
        "Status",
        {
            *("survey preview", "survey test", "survey preview spam", "offline survey preview"),
            *("spam", "possible spam", "imported spam", "ex spam", "synthetic"),
        },
        _NOBODY,
    ),
    _Mark("DistributionChannel", {"preview", "test"}, _NOBODY),
    # SoSci Survey's "Additional Variables in the Data Set": an "interview" is a participant's.
    _Mark("MODE", {"pretest", "admin"}, _NOBODY, (SOSCI.marks,)),
    # Amazon's API reference, "Assignment": Submitted, Approved or Rejected.
    _Mark("AssignmentStatus", {"rejected"}, _REFUSED),
    # Who reviews its file writes a reason, or any mark, to turn work down.
    _Mark("Reject", None, _REFUSED, (frozenset({"AssignmentStatus"}),)),
    # Gorilla's "Participant Status": who is live, or has left, is a person.
    _Mark(
        "Participant Status",
        {"rejected", "rejectedmanual", "rejectedtime limit", "rejectedtimelimit"},
        _REFUSED,
        (GORILLA.marks,),
    ),
    *(
        _Mark(column, {"rejected", "returned", "timed out"}, _REFUSED, _PROLIFIC)
        for column in ("Status", "status")
    ),
)
#: The same of Qualtrics's `Status` where it exports numbers: a preview has 1 in it, a test 2, spam
#: 8, and made-up data 256. Imported answers (4), offline ones (16) and employees' (32) are of
#: people.
_BITS = 1 | 2 | 8 | 256


def without_discarded(table: Table, skip: bool) -> Table:
    """The rows that count. Others are refused, or left out where that was said by `skip`."""
    names = {*map(_bare, table.columns)}
    for mark in _MARKS:
        known = any({*map(_bare, each)} <= names for each in mark.beside)
        if known and mark.column in table.columns:
            table = _without(table, mark, skip)
    return table


def _bare(column: str) -> str:
    """A name in small letters, without what parts its words."""
    return re.sub(r"[\s_]+", "", column).casefold()


def _without(table: Table, mark: _Mark, skip: bool) -> Table:
    """The rows that count, as far as this column says."""
    text = text_column(table, mark.column)
    numbers = mark.column == "Status" and bool(table.texts)
    cells = text.to_pylist()
    out = np.array([bool(cell) and _is_out(cell, mark.words, numbers) for cell in cells], bool)
    if skip:
        return table.take(~out) if out.any() else table
    faults = table.faults()
    allowed = "rows of people" if mark.meaning == _NOBODY else "rows that count"
    faults.say_of_column(
        np.flatnonzero(out),
        lambda row: (
            f"{mark.column} is {quoted(text[row])}, which is {mark.meaning}; allowed: {allowed} "
            "(remove it), or skip_unanswered=True leaves such rows out"
        ),
    )
    faults.stop()
    return table


def _is_out(cell: str, words: Collection[str] | None, numbers: bool) -> bool:
    if words is None:
        return cell.lower() not in NOTHING
    if numbers and cell.isdecimal():
        return bool(int(cell) & _BITS)
    return " ".join(re.findall(r"[^\W_]+", cell.casefold())) in words

"""Rows of practice and of catch trials, as jsPsych, PsychoPy, Gorilla and others mark them."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.column import codes_of, text_column
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.table import Table
from nacreous.scaling.data.truth import says_true

_PRACTICE = r"(?:practi[cs]e|training|warmup|familiari[sz]ation|übungs?|entra[iî]nement|練習)"
_CATCH = r"(?:catch|attention(?:al)?check)"
#: What stands around these words in names of columns and in their cells.
_AROUND = r"(?:is|trial|block|phase|task)?{}(?:{})?s?[0-9]*"
_BEHIND = "trial|block|round|phase|session|run|part|task|pair|item|question|試行"
_MARKS = {
    reason: re.compile(_AROUND.format(word, _BEHIND))
    for reason, word in (("practice", _PRACTICE), ("catch", _CATCH))
}
#: Columns whose cells say in words what a trial is for.
_PHASES = frozenset(
    f"{of}{what}"
    for of in ("", "trial", "task", "block", "experiment", "exp", "part", "session", "screen")
    for what in ("phase", "stage", "kind", "purpose", "type", "name", "label", "category")
) | {"trial", "block", "task", "part", "section", "condition", "cond", "display"}
#: Columns that tell what was done to people rather; there attention and training may be that.
_CONDITIONS = frozenset({"condition", "cond"})
#: The number of a trial in one of PsychoPy's loops, filled in its own rows alone.
_LOOP = re.compile(rf".*{_PRACTICE}.*\.thisn")


def marked(table: Table, roles: Mapping[str, str]) -> tuple[NDArray[np.bool_], list[str | None]]:
    """Bool [row], what counts; and for each row why it does not, by a key of `REASONS`, or None.

    A column marks rows where some trials of one person are marked and others are not: a column in
    which each person has one value tells of people, and is a group. roles: columns by role.
    """
    why: list[str | None] = [None] * table.rows
    for name in table.columns:
        if name in roles.values():
            continue
        found = _reasons(table, name)
        if any(found) and _varies(table, np.array([one is not None for one in found]), roles):
            why = [old or new for old, new in zip(why, found, strict=True)]
    return np.array([reason is None for reason in why], bool), why


def may_mark(column: str, cells: tuple[str, ...]) -> bool:
    """Whether a group's column may mark practice or catch trials; one has to ask.

    >>> may_mark("is_practice", ("yes", "no")), may_mark("sex", ("f", "m"))
    (True, False)
    """
    name = _bare(column)
    if name in _PHASES:
        return len(cells) > 1 and any(_of_phase("", cell) for cell in cells)
    return len(cells) > 1 and _reason_of(name) is not None


def _reasons(table: Table, column: str) -> list[str | None]:
    """For each row why it does not count, as far as this column says."""
    name = _bare(column)
    of_flag = _reason_of(name)
    loop = _LOOP.fullmatch(name) is not None
    if of_flag is None and not loop and name not in _PHASES:
        return []
    text = text_column(table, column)
    if loop:
        return [None if empty else "practice" for empty in is_nothing(text)]
    cells = [
        "" if empty else cell or ""
        for cell, empty in zip(text.to_pylist(), is_nothing(text), strict=True)
    ]
    if of_flag is None:
        known = {cell: _of_phase(name, cell) for cell in set(cells)}
        return [known[cell] for cell in cells] if any(known.values()) else []
    told = [bool(cell) and says_true(cell) for cell in cells]
    return [of_flag if true else None for true in told] if None not in told else []


def _of_phase(name: str, cell: str) -> str | None:
    """Why a row does not count whose phase is called so; name: of the column."""
    word = _bare(cell)
    if name in _CONDITIONS:
        return None if word == "training" else _reason_of(word)
    return "catch" if re.fullmatch(r"attention(?:trial)?s?", word) else _reason_of(word)


def _reason_of(word: str) -> str | None:
    return next((reason for reason, mark in _MARKS.items() if mark.fullmatch(word)), None)


def _varies(table: Table, marks: NDArray[np.bool_], roles: Mapping[str, str]) -> bool:
    """Whether one person has rows with and without the mark; where nobody is known, all rows."""
    if "person" not in roles:
        return bool(marks.any() and not marks.all())
    people, code = codes_of(text_column(table, roles["person"]))
    sums = np.zeros((2, len(people)), bool)
    known = code >= 0
    sums[marks[known].astype(int), code[known]] = True
    return bool(sums.all(axis=0).any())


def _bare(word: str) -> str:
    return re.sub(r"[\s_\-]+", "", word).casefold()

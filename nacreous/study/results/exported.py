"""An export read back, so that the same answers count as in the store from which it came."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import compress
from os import PathLike
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from nacreous.number import said, truth_of
from nacreous.problem import InputError
from nacreous.scaling.data.column import group_column, text_column
from nacreous.scaling.data.fault import hint_of, quoted
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.program import names_people
from nacreous.scaling.data.table import Table, column_names, read_table
from nacreous.scaling.data.truth import says_true
from nacreous.scaling.data.uncounted import counted_by_reason
from nacreous.study.results.scale import called_simulated
from nacreous.study.results.uncounted import uncounted, why_not
from nacreous.study.store.codebook import BEFOREHAND, CHOSEN_BY, COLUMNS
from nacreous.study.store.person_columns import IDENTIFYING, PERSON
from nacreous.study.task.counting import KINDS, counts
from nacreous.study.task.row import Row
from nacreous.study.task.tasks import columns_of_tasks, task_of

if TYPE_CHECKING:
    from nacreous.scaling import Answers
    from nacreous.scaling.report.settings import Settings

__all__ = ["exported_answers", "exported_settings"]

_NAMES = tuple(column.name for column in COLUMNS)
_COUNTED = (*(column.name for column in columns_of_tasks()), "person", "trial", "response_ms")
#: Columns of words that may be any, such as a stimulus called NA.
_WORDS = (*(column.name for column in columns_of_tasks()), "kind", "person", "question")
_KNOWN = (*_NAMES, *(column.name for column in (CHOSEN_BY, *PERSON, *IDENTIFYING)))


def exported_answers(
    path: str | PathLike[str], question: str | None = None, *, simulated: bool = False
) -> Answers | None:
    r"""The answers that count of a file by `nacreous study export`, also saved anew.

    None for any other table, which is known by its columns. question: an id, needed where the
    study has several. simulated: those of simulated observers instead of people's. Raises
    `InputError` for what cannot be read, and where no answers are left.

    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     other = Path(folder, "other.csv")
    ...     _ = other.write_text("left,right,chosen\na,b,left\n")
    ...     print(exported_answers(other))
    None
    """
    simulated = truth_of("simulated", simulated)
    if not _is_export(path):
        return None
    table = read_table(path, [_NAMES])
    rows = _rows(table, str(path))
    asked = sorted({str(row["question"]) for row in rows})
    if len(asked) == 1 and question is None:
        question = asked[0]
    elif question is None:
        raise InputError(
            f"{path}: answers several questions, and none is chosen; "
            f'wanted: question="{asked[0]}" or another of {", ".join(asked)}'
        )
    elif question not in asked:
        raise InputError(f"{path}: question is {said(question)}; {hint_of(question, asked)}")
    answered = [row["question"] == question for row in rows]
    why = [
        why_not(row, simulated=simulated) if own else "question"
        for own, row in zip(answered, rows, strict=True)
    ]
    which = np.array([reason is None for reason in why], bool)
    if not which.any():
        own = list(compress(rows, answered))
        others = any(counts(row, simulated=not simulated) for row in own)
        way = "without" if simulated else "with"
        whose = "people" if simulated else "simulated observers"
        hint = f"; those of {whose} do {way} --simulated" if others else ""
        raise InputError(
            f"{path}: no answers to {question!a} count: {uncounted(own, simulated=simulated)}; "
            f"wanted: at least one that does{hint}"
        )
    counted = table.take(which)
    kept = [rows[place] for place in np.flatnonzero(which)]
    answers = task_of(kept[0]).answers(
        {name: [cast("Any", row)[name] for row in kept] for name in _COUNTED},
        {name: group_column(counted, name) for name in table.columns if name not in _KNOWN},
    )
    answers = replace(answers, uncounted=counted_by_reason(why))
    return called_simulated(answers) if simulated else answers


def exported_settings(path: str | PathLike[str]) -> Settings | None:
    """How the study's own report fits the answers of such a file; None for any other table.

    Raises `InputError` for what cannot be read, for words that no export has, and where nothing is
    said of how pairs were chosen: by the answers so far, they stretch the most likely scale.
    """
    if not _is_export(path):
        return None
    table = read_table(path, [_NAMES])
    if CHOSEN_BY.name not in table.columns:
        raise InputError(f"{path}: has no column {CHOSEN_BY.name}; {_WHOLE}")
    words = {word or "" for word in _texts(table, CHOSEN_BY.name)}
    if "" in words:
        raise InputError(f"{path}: {CHOSEN_BY.name} is empty; {_WHOLE}")
    try:
        found = [task_of({}).settings(None if word == BEFOREHAND else word) for word in words]
    except InputError as problem:
        raise InputError(f"{path}: {problem}") from None
    if len(found) > 1:
        listed = ", ".join(sorted(words))
        raise InputError(f"{path}: {CHOSEN_BY.name} is {listed}; allowed: one of them")
    return found[0] if found else task_of({}).settings(None)


def _is_export(path: str | PathLike[str]) -> bool:
    """Whether a file has all columns of an export.

    Raises `InputError` where one that says which rows count and most others are there, but not all.
    """
    here = column_names(path, [_NAMES])
    lacking = [name for name in _NAMES if name not in here]
    alike = {name.casefold() for name in here}
    known = len(alike.intersection(_NAMES))
    if not lacking or known < _MOST_OF_THEM or not alike.intersection(("kind", "simulated")):
        return not lacking
    called = {name: _called(name, here) for name in lacking}
    told = [name for name, other in called.items() if not other]
    told += [f"{name} (called {quoted(other)})" for name, other in called.items() if other]
    more = f" and {len(told) - 4} more" if len(told) > 4 else ""
    raise InputError(
        f"{path}: is an export of a study without the column{'s' if len(lacking) > 1 else ''} "
        f"{', '.join(told[:4])}{more}; wanted: the file as `nacreous study export` wrote "
        "it, with its names of columns in small letters"
    )


def _called(name: str, here: Sequence[str]) -> str | None:
    """What a column of an export that is not there is called in this file, where that is plain."""
    others = [other for other in here if other not in _KNOWN]
    alike = [other for other in others if other.strip().casefold() == name]
    people = [other for other in others if name == "person" and names_people(other)]
    return next(iter(alike or people), None)


#: How many of an export's columns make a table likely one.
_MOST_OF_THEM = 12

_WHOLE = (
    "wanted: the file as `nacreous study export` wrote it; or say how it is to be fitted, as by "
    "--prior hierarchical where pairs were chosen by the answers so far, "
    f"--method maximum-likelihood where {BEFOREHAND}"
)


def _rows(table: Table, where: str) -> list[Row]:
    """Rows as the store gives them, as far as the file says."""
    texts = {name: _texts(table, name) for name in _NAMES}
    rows = []
    first: dict[int, int] = {}
    comma = table.separator == ";"
    for place in range(table.rows):
        row: dict[str, Any] = {name: levels[place] for name, levels in texts.items()}
        cell = f"{where}: row {table.numbers[place]}"
        row["seq"] = int(_number(row["sequence"] or "", f"{cell}: sequence", comma) or 0)
        if first.setdefault(row["seq"], place) != place:
            raise InputError(
                f"{cell}: sequence is {row['seq']}, as in row {table.numbers[first[row['seq']]]}; "
                "allowed: each once, for a file of one export (not of several, one below another)"
            )
        trial = _number(row["trial"], f"{cell}: trial", comma)
        row["trial"] = row["seq"] if trial is None else trial  # of an erased person
        row["response_ms"] = _number(row["response_ms"], f"{cell}: response_ms", comma)
        row["simulated"] = _whether(row["simulated"], f"{cell}: simulated")
        _check_reason(row["excluded"], f"{cell}: excluded")
        if row["kind"] not in KINDS:
            raise InputError(
                f"{cell}: kind is {said(row['kind'] or '')}; allowed: {', '.join(KINDS)}"
            )
        # Numbers and random names are labels here, and told apart by none.
        row["number"], row["erased_as"] = row["person"], None
        rows.append(cast("Row", row))
    return rows


def _texts(table: Table, name: str) -> list[str | None]:
    """A column as text; None for an empty cell, and for what programs write there, such as NA."""
    text = text_column(table, name)
    texts: list[str | None] = text.to_pylist()
    if name in _WORDS:
        return texts
    return [None if empty else cell for cell, empty in zip(texts, is_nothing(text), strict=True)]


def _number(text: str | None, quantity: str, decimal_comma: bool) -> float | None:
    if text is None:
        return None
    try:
        number = float(text.replace(",", ".", 1) if decimal_comma else text)
    except ValueError:
        number = math.nan
    if decimal_comma and re.fullmatch(r"[1-9][0-9]{0,2}\.[0-9]{3}", text):
        number = math.nan  # the point may part thousands
    if not math.isfinite(number):
        raise InputError(f"{quantity} is {text[:40]!a}; allowed: a number")
    return number


def _whether(text: str | None, quantity: str) -> bool:
    """As spreadsheets write it: who takes a simulated answer for a person's would say too much."""
    told = says_true(text or "")
    if told is None:
        raise InputError(f"{quantity} is {(text or '')[:40]!a}; allowed: true or false")
    return told


def _check_reason(text: str | None, quantity: str) -> None:
    """No reason is "no": who so filled the column meant that these answers count."""
    if text is not None and says_true(text) is False:
        raise InputError(
            f"{quantity} is {text[:40]!a}, a word for no; wanted: an empty cell for answers that "
            "count, or a reason (yes is one)"
        )

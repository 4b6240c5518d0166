"""An export read back, so that the same answers count as in the store from which it came."""

from __future__ import annotations

import csv
import math
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from nacreous.problem import InputError
from nacreous.scaling.data.table import Table, read_table
from nacreous.study.results.scale import called_simulated
from nacreous.study.store.codebook import COLUMNS
from nacreous.study.task.counting import counts
from nacreous.study.task.row import Row
from nacreous.study.task.tasks import task_of

if TYPE_CHECKING:
    from nacreous.scaling import Answers

__all__ = ["exported_answers"]

_NAMES = tuple(column.name for column in COLUMNS)
_LONGEST_HEAD = 100_000


def exported_answers(
    path: str | PathLike[str], question: str | None = None, *, simulated: bool = False
) -> Answers | None:
    r"""The answers that count of a .csv or .parquet file by `nacreous study export`.

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
    if not set(_NAMES) <= set(_head(Path(path))):
        return None
    table = read_table(path)
    rows = _rows(table, str(path))
    asked = sorted({str(row["question"]) for row in rows})
    if len(asked) == 1 and question is None:
        question = asked[0]
    elif question not in asked:
        raise InputError(f"{path}: question is {question!a}; allowed: {', '.join(asked)}")
    which = [
        place
        for place, row in enumerate(rows)
        if row["question"] == question and counts(row, simulated=simulated)
    ]
    if not which:
        others = any(row["question"] == question and counts(row, simulated=True) for row in rows)
        hint = "; those of simulated observers do with --simulated" if others else ""
        raise InputError(f"{path}: no answers to {question!a} count; wanted: at least one{hint}")
    groups = {name: _texts(table, name) for name in table.columns if name not in _NAMES}
    answers = task_of(rows[which[0]]).answers(
        [rows[place] for place in which],
        {name: [levels[place] for place in which] for name, levels in groups.items()},
    )
    return called_simulated(answers) if simulated else answers


def _head(path: Path) -> list[str]:
    """The names of a table's columns; of what is none, nothing, for whoever reads it says why."""
    try:
        if path.suffix.lower() == ".csv" and path.is_file():
            with path.open(encoding="utf-8-sig", newline="") as lines:
                return next(csv.reader([lines.readline(_LONGEST_HEAD)]), [])
        if path.suffix.lower() == ".parquet" and path.is_file():
            from pyarrow import parquet

            return list(parquet.read_schema(path).names)
    except (OSError, ValueError, csv.Error):
        pass
    return []


def _rows(table: Table, where: str) -> list[Row]:
    """Rows as the store gives them, as far as the file says."""
    texts = {name: _texts(table, name) for name in _NAMES}
    rows = []
    for place in range(table.rows):
        row: dict[str, Any] = {name: levels[place] for name, levels in texts.items()}
        cell = f"{where}: row {place + 1}"
        row["seq"] = int(_number(row["sequence"], f"{cell}: sequence") or 0)
        row["trial"] = _number(row["trial"], f"{cell}: trial")
        row["response_ms"] = _number(row["response_ms"], f"{cell}: response_ms")
        row["simulated"] = _whether(row["simulated"], f"{cell}: simulated")
        # Numbers and random names are labels here, and told apart by none.
        row["number"], row["erased_as"] = row["person"], None
        rows.append(cast("Row", row))
    return rows


def _texts(table: Table, name: str) -> list[str | None]:
    """A column as text; empty cells are None."""
    values = table.columns[name].to_pylist()
    return [None if value is None or value == "" else str(value) for value in values]


def _number(text: str | None, quantity: str) -> float | None:
    if text is None:
        return None
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise InputError(f"{quantity} is {text[:40]!a}; allowed: a number")
    return number


def _whether(text: str | None, quantity: str) -> bool:
    """As spreadsheets write it: who takes a simulated answer for a person's would say too much."""
    told = _WORDS.get((text or "").lower())
    if told is None:
        raise InputError(f"{quantity} is {(text or '')[:40]!a}; allowed: true or false")
    return told


_WORDS = {"true": True, "1": True, "1.0": True, "false": False, "0": False, "0.0": False}

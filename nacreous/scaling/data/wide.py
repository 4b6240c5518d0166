"""Answers with a row a person and a column a pair, as survey programs write them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from nacreous.scaling.data.column import NOTHING, text_column
from nacreous.scaling.data.fault import Faults, listed, quoted
from nacreous.scaling.data.pair_name import pair_of_name, pair_of_question
from nacreous.scaling.data.program import is_response_id, names_people
from nacreous.scaling.data.roles import Names, column_of
from nacreous.scaling.data.table import Table


def is_wide(table: Table) -> bool:
    """Whether columns are called after pairs, such as "A vs B", or Qualtrics says so of them."""
    return bool(_pairs(table))


def long_of(table: Table, names: Names, faults: Faults) -> Table:
    """The same answers, one a row, in the columns left, right and chosen.

    Who answered is in the column of people, Qualtrics's ResponseId, or else the row. Empty cells
    are questions that were not put. A cell that names neither of its pair is noted as a fault,
    except codes and words for sides where the column's own name gives the pair.
    """
    import pyarrow as pa

    pairs = _pairs(table)
    _refuse_questions(table, pairs, names, faults)
    lefts: list[str] = []
    rights: list[str] = []
    chosen: list[str] = []
    rows: list[int] = []
    for column, (left, right, exact) in pairs.items():
        for row, cell in enumerate(text_column(table, column).to_pylist()):
            if cell is None or (cell not in (left, right) and cell.lower() in NOTHING):
                continue
            if not exact and cell not in (left, right, "left", "right", names.get("tie", "tie")):
                allowed = f"{quoted(left)} or {quoted(right)}, of which its question speaks"
                verdict = f"{column} is {quoted(cell)}; allowed: {allowed}, as text"
                faults.say_of_rows(np.array([row]), lambda _, said=verdict: said)  # type: ignore[misc]
            lefts.append(left)
            rights.append(right)
            chosen.append(cell)
            rows.append(row)
    order = np.argsort(np.array(rows, np.int64), kind="stable")
    source = np.array(rows, np.int64)[order]
    columns: dict[str, Any] = {
        name: column.take(pa.array(source))
        for name, column in table.columns.items()
        if name not in pairs
    }
    for name, cells in (("left", lefts), ("right", rights), ("chosen", chosen)):
        columns[name] = pa.array([cells[at] for at in order], pa.large_string())
    person = _person(table, names)
    if person != "person":
        own = [f"row {number}" for number in table.numbers[source]]
        columns["person"] = columns.pop(person) if person else pa.array(own, pa.large_string())
    return replace(table, columns=columns, numbers=table.numbers[source])


def _person(table: Table, names: Names) -> str | None:
    """The column of people; Qualtrics's own number of a response before others."""
    given = column_of(table, "person", names)
    if given is not None or "person" in names:
        return given
    known = [name for name in table.columns if names_people(name)]
    return next(iter(sorted(known, key=lambda name: not is_response_id(name))), None)


def _pairs(table: Table) -> dict[str, tuple[str, str, bool]]:
    """For each column of a pair both labels, and whether its name alone gives them."""
    found: dict[str, tuple[str, str, bool]] = {}
    for name in table.columns:
        text = table.texts.get(name)
        pair = pair_of_name(name) if text is None else pair_of_question(text)
        if pair:
            found[name] = (*pair, text is None)
    return found


def _refuse_questions(
    table: Table, pairs: dict[str, tuple[str, str, bool]], names: Names, faults: Faults
) -> None:
    """Note columns that hold a stimulus and name no pair, or half of the answers would be lost."""
    known = {label for left, right, _ in pairs.values() for label in (left, right)}
    known = {label for label in known if not label.isdecimal()}  # as in a column of progress
    people = {_person(table, names)}
    for name in table.columns:
        if name in pairs or name in people:
            continue
        held = known.intersection(text_column(table, name).unique().to_pylist())
        if held:
            asked = f" ({quoted(table.texts[name])})" if table.texts.get(name) else ""
            faults.say(
                f"column {name}{asked} holds {listed(sorted(held))} and names no pair; allowed: "
                'a name or question such as "A vs B", or no such column (remove it)'
            )

"""Answers with a row a person and a column a pair, as survey programs write them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from nacreous.scaling.data.choice import SIDES
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.count import count_column, counts_of
from nacreous.scaling.data.fault import Faults, in_one_line, listed, quoted
from nacreous.scaling.data.likeness import number_of
from nacreous.scaling.data.nothing import NOTHING
from nacreous.scaling.data.pair_columns import pairs_of
from nacreous.scaling.data.pair_name import PairName
from nacreous.scaling.data.program import is_response_id, names_people
from nacreous.scaling.data.respondent import refuse_twice
from nacreous.scaling.data.roles import Names, column_of
from nacreous.scaling.data.table import Table

#: The most people that a table with a column a pair may have by its counts.
_MOST_PEOPLE = 1_000_000


def long_of(table: Table, names: Names, faults: Faults) -> Table:
    """The same answers, one a row, in the columns left, right and chosen.

    Who answered is in the column of people, Qualtrics's ResponseId, or else the row, which a column
    `count` may say to be so many people. Empty cells
    are questions that were not put. A cell that names neither of its pair is noted as a fault,
    except codes and words for sides where the column's own name gives the pair.
    """
    import pyarrow as pa

    pairs = pairs_of(table, faults)
    faults.stop()
    table, people = _people_counted(table, pairs, names)
    _refuse_questions(table, pairs, names, faults)
    rows, lefts, rights, chosen = _answered(table, pairs, names, faults)
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
    if "person" not in names:
        refuse_twice(table, person, pairs)
    if person != "person":
        own = pa.array(people, pa.large_string()).take(pa.array(source))
        columns["person"] = columns.pop(person) if person else own
    return replace(table, columns=columns, numbers=table.numbers[source])


def _people_counted(
    table: Table, pairs: dict[str, PairName], names: Names
) -> tuple[Table, list[str]]:
    """A row for each person where a column counts them, and what each is called by its row."""
    known = _person(table, names)
    column = column_of(table, "count", names)
    if column is None and "count" not in names:
        column = count_column(table, {*pairs, known or ""})
    if column is None:
        return table, [f"row {number}" for number in table.numbers]
    faults = table.faults()
    counts = counts_of(table, column, faults)
    if counts.sum() > _MOST_PEOPLE:
        faults.say(f"column {column} counts {counts.sum()} people; allowed: 1 to {_MOST_PEOPLE}")
    if known is not None:
        faults.say_of_column(
            np.flatnonzero(counts > 1),
            lambda row: (
                f"{column} is {counts[row]}, and {known} names one person; allowed: rows without "
                f"{known} that stand for so many people, or count='' to leave the column unused"
            ),
        )
    faults.stop()
    row = np.repeat(np.arange(table.rows), counts)
    columns = {name: cells.take(row) for name, cells in table.columns.items() if name != column}
    each = np.concatenate([np.arange(count) for count in counts]) + 1
    people = [
        f"row {number}" if count == 1 else f"row {number} ({at} of {count})"
        for number, count, at in zip(table.numbers[row], counts[row], each, strict=True)
    ]
    return replace(table, columns=columns, numbers=table.numbers[row]), people


def _answered(
    table: Table, pairs: dict[str, PairName], names: Names, faults: Faults
) -> tuple[list[int], list[str], list[str], list[str]]:
    """For each answer its row, the left and the right one, and the cell."""
    rows: list[int] = []
    lefts: list[str] = []
    rights: list[str] = []
    chosen: list[str] = []
    for column, pair in pairs.items():
        both = (pair.left, pair.right)
        for row, cell in enumerate(text_column(table, column).to_pylist()):
            if cell is None or (cell not in both and cell.lower() in NOTHING):
                continue
            if table.texts.get(column) and not _is_answer(cell, both, names):
                verdict = (
                    f"{column} is {quoted(cell)}; allowed: {quoted(pair.left)} or "
                    f"{quoted(pair.right)}, of which its question speaks, as text"
                )
                faults.say_of_rows(np.array([row]), lambda _, said=verdict: said)  # type: ignore[misc]
            rows.append(row)
            lefts.append(pair.left)
            rights.append(pair.right)
            chosen.append(cell)
    return rows, lefts, rights, chosen


def _is_answer(cell: str, pair: tuple[str, str], names: Names) -> bool:
    """Whether a cell of Qualtrics says one of a pair, a side or a tie; a code may say anything."""
    words = (names.get("tie", "tie"), names.get("left_word"), names.get("right_word"))
    number = number_of(cell)
    alike = number is not None and number in map(number_of, pair)
    return cell in (*pair, *words) or cell.casefold() in SIDES or alike


def _person(table: Table, names: Names) -> str | None:
    """The column of people; Qualtrics's own number of a response before others."""
    given = column_of(table, "person", names)
    if given is not None or "person" in names:
        return given
    known = [name for name in table.columns if names_people(name)]
    return next(iter(sorted(known, key=lambda name: not is_response_id(name))), None)


def _refuse_questions(
    table: Table, pairs: dict[str, PairName], names: Names, faults: Faults
) -> None:
    """Note columns that hold a stimulus and name no pair, or half of the answers would be lost."""
    known = {label for pair in pairs.values() for label in (pair.left, pair.right)}
    known = {label for label in known if not label.isdecimal()}  # as in a column of progress
    people = {_person(table, names)}
    for name in table.columns:
        if name in pairs or name in people:
            continue
        held = known.intersection(text_column(table, name).unique().to_pylist())
        if held:
            asked = f" ({quoted(in_one_line(table.texts[name]))})" if table.texts.get(name) else ""
            faults.say(
                f"column {name}{asked} holds {listed(sorted(held))} and names no pair; allowed: "
                'a name or question such as "A vs B", or no such column (remove it)'
            )

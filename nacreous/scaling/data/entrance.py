"""The one way in for answers: a table's rows checked, or every fault named by row and column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.column import (
    Grouping,
    check_labels,
    codes_of,
    group_column,
    number_column,
    text_column,
    time_column,
)
from nacreous.scaling.data.fault import Faults, listed, nearest, quoted
from nacreous.scaling.data.label import check_number, labels_of
from nacreous.scaling.data.table import Table


class Names(TypedDict, total=False):
    """What the columns are called, where not as usual, and the word for a tie."""

    person: str
    left: str
    right: str
    chosen: str
    time: str
    trial: str
    response_s: str
    response_ms: str
    tie: str


class Fields(TypedDict):
    """The fields of `Answers`, checked."""

    stimuli: tuple[str, ...]
    left: NDArray[np.int64]
    right: NDArray[np.int64]
    outcome: NDArray[np.int8]
    people: tuple[str, ...]
    person: NDArray[np.int64] | None
    groups: Mapping[str, Grouping]
    response_s: NDArray[np.float64] | None
    time: NDArray[np.float64] | None
    sided: bool


NEEDED = ("left", "right", "chosen")
OPTIONAL = ("person", "time", "trial", "response_s", "response_ms")


def fields_of(
    table: Table, names: Names, stimuli: Iterable[object] | None, repeats: bool, sided: bool
) -> Fields:
    """Check a table's rows and return what `Answers` holds."""
    faults = Faults(table.place, table.first_row)
    column = _columns(table, names, faults)
    faults.stop()
    labels, left, right = _stimuli(table, column, stimuli, faults)
    people, person = _people(table, column, faults)
    time = time_column(table, column["time"], faults) if "time" in column else None
    trial = time_column(table, column["trial"], faults) if "trial" in column else None
    response_s = _response(table, column, faults)
    faults.stop()
    outcome = _outcome(table, column, names.get("tie", "tie"), labels, left, right, faults)
    faults.stop()
    if not repeats:
        asked = [person, left, right, time, trial]
        columns = [column for column in asked if column is not None]
        if person is None:
            texts = [text_column(table, name) for name in table.columns]
            columns = [] if time is None else [codes_of(text)[1] for text in texts]
        _refuse_repeats(table, columns, person is not None, faults)
    faults.stop()
    others = [name for name in table.columns if name not in column.values()]
    return Fields(
        stimuli=labels,
        left=left,
        right=right,
        outcome=outcome,
        people=people,
        person=person,
        groups={name: group_column(table, name) for name in others},
        response_s=response_s,
        time=trial if time is None else time,
        sided=sided,
    )


def _columns(table: Table, names: Names, faults: Faults) -> dict[str, str]:
    """For each role the name of the column that has it; optional ones only where they are."""
    unknown = sorted(set(names) - {*NEEDED, *OPTIONAL, "tie"})
    if unknown:
        near = nearest(unknown[0], [*NEEDED, *OPTIONAL, "tie"])
        hint = f"did you mean {near}?" if near else f"allowed: {', '.join(NEEDED + OPTIONAL)}, tie"
        raise InputError(f"{unknown[0]} is no role of a column; {hint}")
    found: dict[str, str] = {}
    for role in (*NEEDED, *OPTIONAL):
        given: Any = names.get(role)
        name = role if given is None else str(given)
        if role == "trial" and given is None and name not in table.columns:
            name = "order" if _holds_numbers(table, "order") else name
        if name in table.columns:
            found[role] = name
        elif role in NEEDED or given is not None:
            faults.say(f"has no column {name}; {_hint(name, table)}")
    if "response_s" in found and "response_ms" in found:
        faults.say("has both response_s and response_ms; allowed: one of them")
    for name in set(found.values()):
        roles = [role for role in found if found[role] == name]
        if len(roles) > 1:
            faults.say(f"column {name} is used as {' and as '.join(roles)}; allowed: one of them")
    return found


def _holds_numbers(table: Table, name: str) -> bool:
    """Whether a column is there and numbers the trials; AB and BA in it would be a group."""
    scratch = Faults(table.place)
    if name in table.columns:
        number_column(table, name, scratch, -np.inf)
    return name in table.columns and not scratch


def _hint(name: str, table: Table) -> str:
    near = nearest(name, table.columns)
    return f"did you mean {near}?" if near else f"columns here: {listed(table.columns)}"


def _stimuli(
    table: Table, column: dict[str, str], given: Iterable[object] | None, faults: Faults
) -> tuple[tuple[str, ...], NDArray[np.int64], NDArray[np.int64]]:
    import pyarrow as pa

    texts = [text_column(table, column[side]) for side in ("left", "right")]
    for side, text in zip(("left", "right"), texts, strict=True):
        check_labels(table, column[side], text, faults)
    found, both = codes_of(pa.concat_arrays(texts))
    left, right = both[: table.rows], both[table.rows :]
    itself = np.flatnonzero((left == right) & (left >= 0))
    faults.say_of_rows(
        itself,
        lambda row: f"{quoted(found[left[row]])} is paired with itself; allowed: two stimuli",
    )
    faults.stop()
    if given is None:
        check_number(found, table.place)
        return found, left, right
    labels = labels_of(given)
    place = {label: index for index, label in enumerate(labels)}
    order = np.array([place.get(label, -1) for label in found], np.int64)
    for side, code in (("left", left), ("right", right)):
        faults.say_of_rows(
            np.flatnonzero(order[code] < 0),
            lambda row, side=side, code=code: (  # type: ignore[misc]
                f"{column[side]} is {quoted(found[code[row]])}; allowed: {listed(labels)}"
            ),
        )
    faults.stop()
    return labels, order[left], order[right]


def _people(
    table: Table, column: dict[str, str], faults: Faults
) -> tuple[tuple[str, ...], NDArray[np.int64] | None]:
    if "person" not in column:
        return (), None
    text = text_column(table, column["person"])
    check_labels(table, column["person"], text, faults)
    return codes_of(text)


def _response(table: Table, column: dict[str, str], faults: Faults) -> NDArray[np.float64] | None:
    if "response_s" in column:
        return number_column(table, column["response_s"], faults, 0.0)
    if "response_ms" in column:
        return number_column(table, column["response_ms"], faults, 0.0) / 1000
    return None


def _outcome(
    table: Table,
    column: dict[str, str],
    tie: str,
    labels: tuple[str, ...],
    left: NDArray[np.int64],
    right: NDArray[np.int64],
    faults: Faults,
) -> NDArray[np.int8]:
    """1 where the left one was chosen, -1 the right one, 0 neither.

    The words left, right and tie count only where no stimulus bears them as its name.
    """
    name = column["chosen"]
    text = text_column(table, name)
    check_labels(table, name, text, faults)
    faults.stop()
    found, code = codes_of(text)
    place = {label: index for index, label in enumerate(labels)}
    words = {"left": -2, "right": -3, tie: -4}
    meaning = np.array([place.get(each, words.get(each, -5)) for each in found], np.int64)[code]
    outcome = np.zeros(table.rows, np.int8)
    is_left, is_right = (meaning == left) | (meaning == -2), (meaning == right) | (meaning == -3)
    outcome[is_left], outcome[is_right] = 1, -1

    def verdict(row: int) -> str:
        pair = f"{quoted(labels[left[row]])} or {quoted(labels[right[row]])}"
        return f"{name} is {quoted(found[code[row]])}; allowed: {pair}, left, right or {tie}"

    faults.say_of_rows(np.flatnonzero(~(is_left | is_right | (meaning == -4))), verdict)
    return outcome


def _refuse_repeats(table: Table, columns: list[NDArray[Any]], known: bool, faults: Faults) -> None:
    """Note rows that say again what an earlier row said, with nothing to tell them apart.

    With people known: the same person, left, right, and time and trial where there are such
    columns. Without people two such rows may well be two people; only rows that are the same in
    every column are refused, and only where a time is among them.
    """
    if not columns:
        return
    first = _earlier_twin([np.nan_to_num(column, nan=np.inf) for column in columns])
    who = "the same person on the same pair" if known else "the same in every column"
    faults.say_of_rows(
        np.flatnonzero(first >= 0),
        lambda row: (
            f"repeats row {first[row] + table.first_row}: {who}, and no time or trial tells "
            "them apart; remove one, or pass repeats=True"
        ),
    )


def _earlier_twin(columns: list[Any]) -> NDArray[np.int64]:
    """For each row the first row equal to it in all columns, or -1 for the first itself."""
    key = np.zeros(len(columns[0]), np.int64)
    for column in columns:  # joined two at a time, so that the key never grows beyond rows²
        _, code = np.unique(column, return_inverse=True)
        _, key = np.unique(key * (code.max() + 1) + code, return_inverse=True)
    order = np.argsort(key, kind="stable")
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    first = np.empty(len(key), np.int64)
    first[order] = np.repeat(order[starts], np.diff(np.append(starts, len(key))))
    return np.where(first == np.arange(len(key)), -1, first)

"""A long table of rankings, a row for each stimulus on each tray, with its faults by row."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.column import check_labels, codes_of, text_column
from nacreous.scaling.data.fault import Faults, hint_of, listed, quoted
from nacreous.scaling.data.label import check_number, labels_of
from nacreous.scaling.data.likeness import check_alike
from nacreous.scaling.data.number_column import number_column
from nacreous.scaling.data.table import Table
from nacreous.scaling.data.trays import MOST_ON_A_TRAY, Trays

__all__ = ["RankColumns", "trays_of_table"]

Index = NDArray[np.int64]


@dataclass(frozen=True)
class RankColumns:
    """What the columns are called; `person` is used where it is there, and must be if named."""

    tray: str = "tray"
    stimulus: str = "stimulus"
    rank: str = "rank"
    person: str | None = None

    @classmethod
    def of(cls, names: Mapping[str, str]) -> RankColumns:
        """The names that a caller gave, checked."""
        allowed = [each.name for each in fields(cls)]
        for key, name in names.items():
            if key not in allowed:
                raise InputError(f"{quoted(key)} is no column here; {hint_of(key, allowed)}")
            if not isinstance(name, str) or not name:
                raise InputError(f"{key} is {said(name)}; allowed: the name of a column")
        return cls(**names)

    @property
    def wanted(self) -> list[Collection[str]]:
        """The columns that make a row of text the header."""
        return [(self.tray, self.stimulus, self.rank)]


@dataclass(frozen=True, eq=False)
class _Rows:
    """The table's rows by tray, the best first: positions of rows, and what stands in them."""

    row: Index
    tray: Index
    stimulus: Index
    rank: NDArray[np.float64]


def trays_of_table(table: Table, columns: RankColumns, stimuli: Iterable[object] | None) -> Trays:
    """The trays of a table, in the order in which they first stand there."""
    faults = table.faults()
    wanted = [columns.tray, columns.stimulus, columns.rank]
    if columns.person is not None:
        wanted.append(columns.person)
    for name in wanted:
        if name not in table.columns:
            here = listed(table.columns)
            faults.say(f"has no column {name}; columns here: {here}")
    faults.stop()
    person = columns.person or ("person" if "person" in table.columns else None)
    tray, names = _coded(table, columns.tray, faults)
    stimulus, labels = _coded(table, columns.stimulus, faults)
    who, people = (
        (np.zeros(table.rows, np.int64), ()) if person is None else _coded(table, person, faults)
    )
    rank = number_column(table, columns.rank, None, faults, 1)
    bad = np.flatnonzero(rank != np.rint(np.nan_to_num(rank, nan=1.0)))
    bad = bad[~np.isnan(rank[bad])]
    faults.say_of_rows(
        bad, lambda row: f"{columns.rank} is {rank[row]:g}; allowed: a whole number, 1 the best"
    )
    faults.stop()
    check_number(labels, table.place)
    check_alike(labels, table.place)
    if person is not None:
        check_alike(people, f"{table.place}: column {person}")
    key, first = _in_order(who * (len(names) + 1) + tray)
    rows = _sorted(key, stimulus, rank)
    _check_rows(table, rows, labels, columns, faults)
    faults.stop()
    labels, stimulus = _renamed(table, labels, rows, stimuli, faults)
    return Trays(
        labels,
        stimulus,
        np.bincount(rows.tray),
        np.bincount(rows.tray, ~np.isnan(rows.rank)).astype(np.int64),
        people,
        None if person is None else who[first],
    )


def _coded(table: Table, name: str, faults: Faults) -> tuple[Index, tuple[str, ...]]:
    text = text_column(table, name)
    check_labels(table, name, text, faults)
    labels, code = codes_of(text)
    return code, labels


def _in_order(key: Index) -> tuple[Index, Index]:
    """Numbers from 0 in the order of appearance, and the first row of each."""
    _, first, place = np.unique(key, return_index=True, return_inverse=True)
    order = np.argsort(first)
    number = np.empty(len(order), np.int64)
    number[order] = np.arange(len(order))
    return number[place], first[order]


def _sorted(key: Index, stimulus: Index, rank: NDArray[np.float64]) -> _Rows:
    row = np.lexsort((stimulus, rank, key))  # NaN comes last
    return _Rows(row, key[row], stimulus[row], rank[row])


def _check_rows(
    table: Table, rows: _Rows, labels: tuple[str, ...], columns: RankColumns, faults: Faults
) -> None:
    """Note what no ranking has: a stimulus twice, ties, gaps, trays of one and without order."""
    number, rank = table.numbers[rows.row], rows.rank

    def say(places: Index, verdict: Callable[[int, int], str], earlier: Index) -> None:
        """What is wrong at places of the sorted rows, given an earlier place of each."""
        both = {
            int(rows.row[at]): (int(at), int(other))
            for at, other in zip(places, earlier, strict=True)
        }
        faults.say_of_rows(rows.row[places], lambda row: verdict(*both[row]))

    def named(at: int) -> str:
        return quoted(labels[rows.stimulus[at]])

    by = np.lexsort((rows.row, rows.stimulus, rows.tray))
    same = (np.diff(rows.tray[by]) == 0) & (np.diff(rows.stimulus[by]) == 0)
    say(
        by[1:][same],
        lambda at, other: (
            f"{columns.stimulus} is {named(at)} again, as in row {number[other]} of the same tray; "
            "allowed: each stimulus once on a tray"
        ),
        by[:-1][same],
    )
    near, step = np.diff(rows.tray) == 0, np.diff(rank)
    tie = np.flatnonzero(near & (step == 0))
    say(
        tie + 1,
        lambda at, other: (
            f"{columns.rank} of {named(at)} is {rank[at]:g}, as that of {named(other)} in row "
            f"{number[other]}; allowed: no ties, each rank once on a tray"
        ),
        tie,
    )
    start = np.flatnonzero(np.diff(rows.tray, prepend=-1))
    gap = np.concatenate((start[rank[start] > 1], np.flatnonzero(near & (step > 1)) + 1))
    say(
        gap,
        lambda at, _: (
            f"{columns.rank} of {named(at)} is {rank[at]:g}, and the one before it is missing on "
            "the tray; allowed: 1, 2, 3 and so on, empty for those not put in order"
        ),
        gap,
    )
    _check_trays(rows, start, columns, faults)


def _check_trays(rows: _Rows, start: Index, columns: RankColumns, faults: Faults) -> None:
    """Note trays of too few or too many stimuli, and those without an order."""
    size = np.bincount(rows.tray)
    many = dict(zip(rows.row[start].tolist(), size.tolist(), strict=True))
    faults.say_of_rows(
        rows.row[start[np.isnan(rows.rank[start])]],
        lambda _: f"{columns.rank} is empty on the whole tray; allowed: 1 for the best",
    )
    faults.say_of_rows(
        rows.row[start[(size < 2) | (size > MOST_ON_A_TRAY)]],
        lambda row: (
            f"its tray holds {many[row]} {'stimulus' if many[row] == 1 else 'stimuli'}; "
            f"allowed: 2 to {MOST_ON_A_TRAY}"
        ),
    )


def _renamed(
    table: Table,
    labels: tuple[str, ...],
    rows: _Rows,
    stimuli: Iterable[object] | None,
    faults: Faults,
) -> tuple[tuple[str, ...], Index]:
    """Labels and indices in the order of a caller, who allows no others."""
    if stimuli is None:
        return labels, rows.stimulus
    wanted = labels_of(stimuli)
    place = {label: at for at, label in enumerate(wanted)}
    code = np.array([place.get(label, -1) for label in labels], np.int64)[rows.stimulus]
    unknown = np.flatnonzero(code < 0)
    faults.say_of_rows(
        np.sort(rows.row[unknown]),
        lambda row: (
            f"stimulus is {quoted(labels[rows.stimulus[rows.row == row][0]])}; "
            f"allowed: {listed(wanted)}"
        ),
    )
    faults.stop()
    return wanted, code

"""Square matrices from outside: counts, ties and proportions, checked once."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import array_of, number_of, said
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.count import are_grouped
from nacreous.scaling.data.csv_table import parse_csv_cells
from nacreous.scaling.data.fault import Faults, listed, quoted
from nacreous.scaling.data.label import MOST_STIMULI
from nacreous.scaling.data.nothing import NOTHING
from nacreous.scaling.data.table import read_bytes

#: How far a proportion and its mirror may be from 1 together: two roundings to two decimals.
ROUNDING = 0.011
MOST_COUNT = 2.0**53
#: What stands where a stimulus meets itself.
_DIAGONAL = frozenset({"", "-", "\u2013", "\u2014", "/", "*", "."})
_TOTALS = frozenset({"total", "totals", "sum", "all", "gesamt", "summe", "合計", "計"})


def labelled_matrix(name: str, values: Any) -> tuple[NDArray[np.float64], list[object] | None]:
    """The numbers of a nested list, an array or a DataFrame, and the labels of the last."""
    if not hasattr(values, "columns"):
        return _square(name, array_of(name, values)), None
    columns = list(values.columns)
    if hasattr(values, "iloc"):  # pandas: rows have labels too
        index = list(values.index)
        if index not in (columns, list(range(len(columns)))):
            raise InputError(f"{name}: rows and columns differ in their labels; allowed: the same")
        columns = [int(c) + 1 for c in columns] if columns == list(range(len(columns))) else columns
    if not hasattr(values, "to_numpy"):  # pyarrow, which knows its columns' names alone
        columns = list(values.column_names)
        return _square(name, array_of(name, np.array(values.columns).T)), columns
    return _square(name, array_of(name, values.to_numpy())), columns


def check_counts(
    name: str, matrix: NDArray[np.float64], labels: Sequence[object] | None = None
) -> NDArray[np.float64]:
    """Whole counts of 0 or more with nothing on the diagonal. labels: for messages."""
    diagonal = np.eye(len(matrix), dtype=bool)
    counts = np.where(diagonal & np.isnan(matrix), 0.0, matrix)
    with np.errstate(invalid="ignore"):
        shares = (counts >= 0) & (counts <= 1)
        if shares[~diagonal].all() and (counts[~diagonal] % 1).any():
            raise InputError(
                f"{name}: holds numbers between 0 and 1, as shares are; allowed: counts of "
                "answers, or in Python Comparisons.of_proportions"
            )
        whole = (counts >= 0) & (counts <= MOST_COUNT) & (counts == np.floor(counts))
    _stop_at(name, counts, ~whole, "a whole number, 0 or more", labels)
    itself = "0, for nothing is compared with itself"
    _stop_at(name, counts, diagonal & (counts != 0), itself, labels)
    return counts


def check_ties(ties: Any, size: int) -> NDArray[np.float64]:
    """Whole symmetric counts of the same size."""
    values, _ = labelled_matrix("ties", ties)
    if len(values) != size:
        raise InputError(f"ties has {len(values)} rows; allowed: {size}, as counts")
    matrix = check_counts("ties", values)
    _stop_at("ties", matrix, matrix != matrix.T, "the same as its mirror, for a tie has no side")
    return matrix


def check_proportions(name: str, matrix: NDArray[np.float64], answers: object) -> Any:
    """Proportions that add up to 1 with their mirrors, then exactly so; 0 on the diagonal."""
    people = number_of("answers", answers)
    if not 1 <= people <= MOST_COUNT:
        raise InputError(f"answers is {people:g}; allowed: 1 or more a pair")
    diagonal = np.eye(len(matrix), dtype=bool)
    shares = np.where(diagonal, 0.5, matrix)
    with np.errstate(invalid="ignore"):
        _stop_at(name, shares, ~((shares >= 0) & (shares <= 1)), "0 to 1")
        total = shares + shares.T
        _stop_at(name, shares, np.abs(total - 1) > ROUNDING, "1 less its mirror")
    return np.where(diagonal, 0.0, shares / total)


def read_matrix(path: Path) -> tuple[NDArray[np.float64], list[str] | None]:
    """A matrix of numbers from a CSV file, and its labels where it has them."""
    content = read_bytes(path)
    place = printable(str(path))
    rows = parse_csv_cells(place, content)
    titles = _titles(rows)
    rows = _without_totals(place, rows[titles:], titles + 1)
    if {"left", "right"} <= {*map(str.lower, rows[0])} or {"winner", "loser"} <= {*rows[0]}:
        raise InputError(
            f"{place}: row {titles + 1} has the names of a table of answers "
            f"({listed(rows[0])}); allowed with "
            "Comparisons.read_counts: a square of counts; read this by Answers.read"
        )
    labels: list[str] | None = None
    order: list[int] | None = None
    first_row = titles + 1
    if len(rows) == len(rows[0]) + 1:
        labels, rows = rows[0], rows[1:]
        first_row += 1
    elif _has_corner(rows):
        labels = rows[0][1:]
        own = [row[0] for row in rows[1:]]
        if sorted(own) != sorted(labels):
            differ = "rows and columns differ in their labels"
            raise InputError(f"{place}: {differ}; allowed: the same")
        order = [labels.index(label) for label in own]
        rows = [row[1:] for row in rows[1:]]
        first_row += 1
    elif len(rows) > 1 and _are_labels(rows[0][1:]) and _are_labels([row[0] for row in rows[1:]]):
        shape = f"{len(rows) - 1} rows and {len(rows[0]) - 1} columns"
        raise InputError(f"{place}: has {shape} with labels; allowed: as many, one a stimulus")
    matrix = _matrix_of(place, rows, first_row, order or list(range(len(rows))))
    return _square(place, matrix)[np.argsort(order) if order else slice(None)], labels


def _titles(rows: list[list[str]]) -> int:
    """How many rows above the labels fill their first cell alone, and not with a count."""
    for at, row in enumerate(rows):
        if len(row) < 2 or any(row[1:]) or _number(row[0]) is not None:
            return at
    return 0


def _are_labels(cells: list[str]) -> bool:
    return bool(cells) and all(_number(cell) is None for cell in cells)


def _without_totals(place: str, rows: list[list[str]], first_row: int) -> list[list[str]]:
    """A square with labels without a last row and column of sums, which have to be the sums."""
    if len(rows) < 3 or (rows[0][0] and not _are_labels([row[0] for row in rows[1:]])):
        return rows
    if rows[0][-1].casefold() in _TOTALS:
        for at, row in enumerate(rows[1:], first_row + 1):
            _check_sum(f"{place}: row {at}: {rows[0][-1]}", row, "column")
        rows = [row[:-1] for row in rows]
    if rows[-1][0].casefold() in _TOTALS:
        for column in zip(*(row[1:] for row in rows), strict=True):
            _check_sum(f"{place}: {rows[-1][0]} below {quoted(column[0])}", list(column), "row")
        rows = rows[:-1]
    return rows


def _check_sum(what: str, cells: list[str], line: str) -> None:
    if not _is_sum(cells):
        total = sum(_number(cell) or 0.0 for cell in cells[1:-1])
        raise InputError(
            f"{what} is {quoted(cells[-1])}; allowed: {total:.15g}, the sum, or no such {line}"
        )


def _is_sum(cells: list[str]) -> bool:
    """Whether the last cell is the sum of those between it and the label; of nothing it may be."""
    numbers = [_number(cell) for cell in cells[1:-1]]
    total = _number(cells[-1])
    return cells[-1] in _DIAGONAL or total == sum(number or 0.0 for number in numbers)


def _has_corner(rows: list[list[str]]) -> bool:
    """Whether a square has labels in its first row and column.

    With an empty corner it may also be counts with an empty diagonal. Those have numbers all along
    the first row, and an empty cell at the end.
    """
    corner = rows[0][0]
    if len(rows) != len(rows[0]) or (corner and _number(corner) is not None):
        return False
    numbers = all(_number(cell) is not None for cell in rows[0][1:])
    return bool(corner) or not numbers or rows[-1][-1] != ""


def _matrix_of(
    place: str, rows: list[list[str]], first_row: int, own: list[int]
) -> NDArray[np.float64]:
    """The numbers in cells of text; an empty diagonal is NaN. own: for each row its own column."""
    width = max((len(row) for row in rows), default=0)
    matrix = np.full((len(rows), width), np.nan)
    cells = [(at, j, cell) for at, row in enumerate(rows) for j, cell in enumerate(row)]
    _refuse_grouped(place, cells, first_row)
    bad: list[int] = []
    for index, (i, j, cell) in enumerate(cells):
        itself = j == own[i] and (cell in _DIAGONAL or cell.lower() in NOTHING)
        number = np.nan if itself else _number(cell)
        if number is None:
            bad.append(index)
        else:
            matrix[i, j] = number
    faults = Faults(place, np.array([at for at, *_ in cells], np.int64) + first_row)
    faults.say_of_column(
        np.array(bad, np.int64),
        lambda index: (
            f"column {cells[index][1] + 1} is {quoted(cells[index][2])}; allowed: a whole number, "
            "0 or more"
        ),
        such="cells",
    )
    faults.stop()
    return matrix


def _refuse_grouped(place: str, cells: list[tuple[int, int, str]], first_row: int) -> None:
    """Refuse counts with marks between their thousands, all in one line."""
    import pyarrow as pa

    grouped = np.flatnonzero(are_grouped(pa.array([cell for *_, cell in cells], pa.large_string())))
    faults = Faults(place, np.array([at for at, *_ in cells], np.int64) + first_row)
    faults.say_of_column(
        grouped,
        lambda index: (
            f"column {cells[index][1] + 1} is {quoted(cells[index][2])}; allowed: a whole number "
            f"without a mark in it, such as {re.sub('[^0-9]', '', cells[index][2])}"
        ),
        such="cells",
    )
    faults.stop()


def _number(cell: str) -> float | None:
    try:
        return float(cell)
    except ValueError:
        return None


def _square(name: str, matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    size = matrix.shape[0] if matrix.ndim else 0
    if matrix.ndim != 2 or matrix.shape[1] != size:
        shape = " x ".join(str(length) for length in matrix.shape) or "a single number"
        raise InputError(f"{name} is {shape}; allowed: a square, one row and one column a stimulus")
    if not 2 <= size <= MOST_STIMULI:
        raise InputError(f"{name} has {size} stimuli; allowed: 2 to {MOST_STIMULI}")
    return matrix


def _stop_at(
    name: str,
    matrix: NDArray[np.float64],
    bad: Any,
    allowed: str,
    labels: Sequence[object] | None = None,
) -> None:
    """Name the first few cells that are bad, by labels or by indices from 0."""
    cells = np.argwhere(bad)
    if len(cells) == 0:
        return

    def place(i: int, j: int) -> str:
        if labels is None:
            return f"{name}[{i}, {j}]"
        return f"{name}: row {quoted(labels[i])}, column {quoted(labels[j])}"

    lines = [
        f"{place(i, j)} is {said(float(matrix[i, j])).removesuffix('.0')}; allowed: {allowed}"
        for i, j in cells[:5].tolist()
    ]
    if len(cells) > len(lines):
        lines.append(f"{name}: {len(cells)} such cells in all")
    raise InputError("\n".join(lines))

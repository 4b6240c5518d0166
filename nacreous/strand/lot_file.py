"""Lots as tables: a pearl a row, read with every fault told, and written whole."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import nearest, quoted
from nacreous.scaling.data.number_column import number_column
from nacreous.scaling.data.spreadsheet import as_given, as_written
from nacreous.scaling.data.table import Table, read_table
from nacreous.strand.lot import MOST_PEARLS, QUANTITIES, Lot, Quantity
from nacreous.strand.matching import matching
from nacreous.strand.sorting import Sorting, Strand
from nacreous.trade import range_of

if TYPE_CHECKING:
    from nacreous.scaling.data.fault import Faults

__all__ = ["read_lot", "read_sorted", "write_lot", "write_sorted"]

Array = NDArray[np.float64]

_NAME, _LUSTER = "name", "luster"
_NUMBERS = [quantity.name for quantity in QUANTITIES]
_LUSTER_RAD = _NUMBERS[-1]
#: What sorting adds.
_PLACED = ("strand", "place", "target_mm")


def read_lot(path: str | PathLike[str]) -> Lot:
    """Read a lot: a CSV (or .parquet) table of pearls.

    Columns: size_mm; L, a, b, or L*, a*, b*; facet_spread_rad in radians, or luster in the trade's
    words, English or Japanese; name where pearls have names, otherwise they are numbered. Others
    are left alone.
    Semicolons, tabs and decimal commas are understood. Raises `InputError` with all faults.
    """
    return _lot_of(_table(path))


def read_sorted(path: str | PathLike[str]) -> tuple[Lot, Sorting]:
    """Read what `write_sorted` wrote. A lot without a column strand is one strand as it lies."""
    table = _table(path)
    lot = _lot_of(table)
    if _PLACED[0] not in table.columns:
        if len(lot) < 2:
            raise InputError(f"{table.place}: holds 1 pearl; allowed in a strand: at least two")
        everyone = np.arange(len(lot))
        return lot, Sorting((_strand(lot, everyone, _even(lot)),), everyone[:0])
    faults = table.faults()
    _require(table, _PLACED, faults)
    faults.stop()
    number, place, target_mm = (number_column(table, one, None, faults, 0) for one in _PLACED)
    hung = ~np.isnan(number)
    for name, column in ((_PLACED[0], number), (_PLACED[1], place)):
        _say_unwhole(name, column, faults)
    faults.say_of_rows(
        np.flatnonzero(hung & (np.isnan(place) | np.isnan(target_mm))),
        lambda row: "place or target_mm is empty; allowed: numbers, as nacreous strand sort writes",
    )
    _say_odd_strands(number, place, faults)
    faults.stop()
    strands = []
    for one in np.unique(number[hung]):
        pearls = np.flatnonzero(number == one)
        pearls = pearls[np.argsort(place[pearls], kind="stable")]
        strands.append(_strand(lot, pearls, target_mm[pearls]))
    if not strands:
        raise InputError(f"{table.place}: no pearl is in a strand; allowed: at least two")
    return lot, Sorting(tuple(strands), np.flatnonzero(~hung))


def _say_unwhole(name: str, column: Array, faults: Faults) -> None:
    """Numbers of strands and places that cannot be counted."""
    whole = np.isnan(column) | ((column >= 1) & (column == np.floor(column)))
    faults.say_of_rows(
        np.flatnonzero(~whole),
        lambda row: f"{name} is {column[row]:g}; allowed: a whole number from 1 on",
    )


def _say_odd_strands(number: Array, place: Array, faults: Faults) -> None:
    """Two pearls at one place of a strand, and a strand of one pearl."""

    def alone(row: int) -> str:
        return f"strand is {number[row]:g} for this pearl alone; allowed: at least two pearls"

    def again(row: int) -> str:
        return f"place is {place[row]:g} in strand {number[row]:g} again; allowed: each once"

    for one in np.unique(number[~np.isnan(number)]):
        pearls = np.flatnonzero(number == one)
        faults.say_of_rows(pearls if len(pearls) == 1 else pearls[:0], alone)
        first = np.unique(place[pearls], return_index=True)[1]
        faults.say_of_rows(np.delete(pearls, first), again)


def write_lot(path: Path, lot: Lot) -> None:
    """Write a lot as CSV."""
    rows = zip(lot.names, lot.values.tolist(), strict=True)
    _write(path, [_NAME, *_NUMBERS], ([as_written(name), *_rounded(v)] for name, v in rows))


def write_sorted(path: Path, lot: Lot, sorting: Sorting) -> None:
    """Write a lot as CSV, strand by strand in the order in which the pearls hang, spares last."""

    def rows() -> Iterable[list[object]]:
        for number, strand in enumerate(sorting.strands, 1):
            for place, at in enumerate(strand.pearls.tolist()):
                placed = [number, place + 1, round(float(strand.target_mm[place]), 4)]
                yield [*placed, as_written(lot.names[at]), *_rounded(lot.values[at].tolist())]
        for at in sorting.spare.tolist():
            yield ["", "", "", as_written(lot.names[at]), *_rounded(lot.values[at].tolist())]

    _write(path, [*_PLACED, _NAME, *_NUMBERS], rows())


def _write(path: Path, titles: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(titles)
        table.writerows(rows)


def _rounded(values: list[float]) -> list[float]:
    """Finer than any instrument measures."""
    return [round(value, 5) for value in values]


def _table(path: str | PathLike[str]) -> Table:
    return read_table(path, [set(_NUMBERS[:1])], rows="pearls", most_rows=MOST_PEARLS)


def _lot_of(table: Table) -> Lot:
    faults = table.faults()
    by_word = _LUSTER_RAD not in table.columns and _LUSTER in table.columns
    _require(table, _NUMBERS[:-1] if by_word else _NUMBERS, faults)
    faults.stop()
    columns = [
        _luster_rad(table, faults)
        if by_word and quantity.name == _LUSTER_RAD
        else _numbers(table, quantity, faults)
        for quantity in QUANTITIES
    ]
    names = _names(table, faults)
    _say_apart(table, columns, faults)
    faults.stop()
    return Lot(names, np.column_stack(columns))


def _numbers(table: Table, quantity: Quantity, faults: Faults) -> Array:
    """A column; each cell that is no number, or none in its range, is a fault."""
    column, unread = _column(table, quantity.name), table.faults()
    values = number_column(table, column, None, unread, -np.inf)
    if unread:
        number_column(table, column, None, faults, -np.inf)  # says so with the other faults
    text = text_column(table, column)

    def verdict(row: int) -> str:
        given = "empty" if np.isnan(values[row]) else quoted(text[row])
        return f"{column} is {given}; allowed: {quantity.allowed}"

    inside = (values >= quantity.least) & (values <= quantity.most)
    inside[sorted(unread.rows)] = True  # told already
    faults.say_of_rows(np.flatnonzero(~inside), verdict)
    return values


def _say_apart(table: Table, columns: Sequence[Array], faults: Faults) -> None:
    """Columns that say one quantity twice, where the two differ: L and L*, luster by both ways."""
    for quantity, values in zip(QUANTITIES, columns, strict=True):
        starred = f"{quantity.name}*"
        if not {quantity.name, starred} <= set(table.columns):
            continue
        other = number_column(table, starred, None, faults, -np.inf)
        texts = text_column(table, starred)
        faults.say_of_rows(
            np.flatnonzero(~(np.isnan(other) | np.isnan(values) | (other == values))),
            lambda row, name=quantity.name, starred=starred, values=values, texts=texts: (  # type: ignore[misc]
                f"{starred} is {quoted(texts[row])} and {name} {values[row]:g}; allowed: both "
                "alike, or one of the columns"
            ),
        )
    if {_LUSTER_RAD, _LUSTER} <= set(table.columns):
        _say_luster_apart(table, columns[-1], faults)


def _say_luster_apart(table: Table, spread_rad: Array, faults: Faults) -> None:
    """Words for luster whose range does not hold the facets' spread beside them."""
    texts = [text or "" for text in text_column(table, _LUSTER).to_pylist()]

    def verdict(row: int) -> str:
        try:
            held = range_of(_LUSTER, texts[row])
        except InputError as problem:
            return str(problem)
        if np.isnan(spread_rad[row]) or held.holds(float(spread_rad[row])):
            return ""
        return (
            f"{_LUSTER} is {quoted(texts[row])}, {_LUSTER_RAD} {held.text}, and {_LUSTER_RAD} is "
            f"{spread_rad[row]:g}; allowed: both alike, or one of the columns"
        )

    said = {row: verdict(row) for row, text in enumerate(texts) if text.strip()}
    bad = [row for row, text in said.items() if text]
    faults.say_of_rows(np.array(bad, np.int64), lambda row: said[row])


def _column(table: Table, name: str) -> str:
    """The column's name as it stands: instruments write L*, a* and b*."""
    return f"{name}*" if name not in table.columns and f"{name}*" in table.columns else name


def _require(table: Table, wanted: Sequence[str], faults: Faults) -> None:
    for name in wanted:
        if _column(table, name) not in table.columns:
            near = nearest(name, table.columns) if len(name) > 1 else None
            hint = f"; is it {quoted(near)}?" if near else f"; it has {', '.join(table.columns)}"
            or_luster = f" or {_LUSTER}" if name == _LUSTER_RAD else ""
            faults.say(f"has no column {name}{or_luster}{hint}")


def _names(table: Table, faults: Faults) -> tuple[str, ...]:
    """The pearls' names, all different; numbers from 1 where there is no such column."""
    if _NAME not in table.columns:
        return tuple(str(number) for number in range(1, table.rows + 1))
    texts = text_column(table, _NAME).to_pylist()
    seen: dict[str, int] = {}
    bad = [row for row, text in enumerate(texts) if not text or seen.setdefault(text, row) != row]
    faults.say_of_rows(
        np.array(bad, np.int64),
        lambda row: f"{_NAME} is {quoted(texts[row] or '')}; allowed: a name for each pearl alone",
    )
    return tuple(as_given(text or "") for text in texts)


def _luster_rad(table: Table, faults: Faults) -> Array:
    """The facets' spread that each word for luster sets."""
    texts = [text or "" for text in text_column(table, _LUSTER).to_pylist()]
    values, said = np.full(len(texts), np.nan), [""] * len(texts)
    for row, text in enumerate(texts):
        try:
            values[row] = range_of(_LUSTER, text).sets
        except InputError as problem:
            said[row] = str(problem)
    faults.say_of_rows(np.flatnonzero(np.isnan(values)), lambda row: said[row])
    return values


def _even(lot: Lot) -> Array:
    return np.full(len(lot), float(np.median(lot.size_mm)))


def _strand(lot: Lot, pearls: NDArray[np.int64], target_mm: Array) -> Strand:
    return Strand(pearls, target_mm, matching(lot.take(pearls), target_mm))

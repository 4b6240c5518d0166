"""Tables of a wavelength with n, k or both, as CSV, into dispersions."""

from __future__ import annotations

import csv
import io
import re
from typing import NamedTuple

from nacreous.medium.column_name import column_of
from nacreous.medium.dispersion import dispersion_of_rows
from nacreous.medium.number_rows import NumberRow, Parts, is_float, numbers_of
from nacreous.medium.wavelength_name import is_wavelength, nm_per_unit, stated_unit
from nacreous.number import said
from nacreous.problem import InputError

#: How a row of numbers begins, whatever marks its numbers have.
_DIGIT = re.compile(r'"?[+\-\u2212]?[.,]?[0-9]')
#: What stands for the unit of n and k, which have none.
_NO_UNIT = frozenset({"", "1", "-", "\u2013", "\u2014", "none", "dimensionless", "unitless"})
_DECIMAL_COMMA = re.compile(r"[+-]?[0-9]*,[0-9]+(?:[eEdD][+-]?[0-9]+)?")


class _Block(NamedTuple):
    """A line of names, its columns behind the first and the first one's unit, and its rows."""

    number: int
    columns: list[str]
    nm_per_unit: float
    rows: list[NumberRow]


def parts_of_csv(text: str) -> Parts:
    """Blocks of rows, each below its header `wl,n`, `wl,k` or `wl,n,k`; wavelengths in um.

    Without a header two columns are n, three are n and k. A header that says nm is believed.
    Columns are parted by tabs, semicolons, commas or blanks; between tabs and semicolons decimals
    may have commas. `#` begins a comment; titles above a header and notes below the rows are
    passed over. A row below the header may hold the units.
    """
    parts: Parts = {}
    for number, columns, unit, rows in _blocks(_rows(text)):
        if not rows:
            raise InputError(f"row {number} names columns, and no row of numbers is below it")
        table = numbers_of("", rows, columns, each=True)
        for i, name in enumerate(columns):
            if name in parts:
                raise InputError(f"{name} is given twice; allowed: once")
            parts[name] = dispersion_of_rows(unit * table[:, 0], table[:, 1 + i])
    return parts


def _blocks(rows: list[NumberRow]) -> list[_Block]:
    """Each line of names with the rows of numbers below it."""
    blocks: list[_Block] = []
    note: NumberRow | None = None
    above: NumberRow | None = None
    for row in rows:
        above, before = row, above
        is_below = before is not None and blocks and before.number == blocks[-1].number
        if before is not None and is_below and _are_units(row.cells):
            blocks[-1] = blocks[-1]._replace(nm_per_unit=_of_units(before, row))
            continue
        if _is_header(row.cells):
            blocks.append(_Block(row.number, *_header(row), []))
            note = None
        elif not _is_data(row.cells):
            note = row
        elif note is not None:
            _header(note)  # numbers stand below it, so it has to be one
        else:
            if not blocks:
                names = ["n", "k"][: max(1, len(row.cells) - 1)]
                blocks.append(_Block(row.number, names, 1e3, []))
            blocks[-1].rows.append(row)
    return blocks


def _are_units(cells: list[str]) -> bool:
    """Whether a row below names holds units: of the wavelength, and none of n and k."""
    first, *others = cells
    units = first.strip("()[]").isalpha() and not any(map(column_of, others))
    return units and all(cell.strip("()[] ").casefold() in _NO_UNIT for cell in others)


def _of_units(names: NumberRow, units: NumberRow) -> float:
    """The unit in nm that a row of units says; it may not be another than the names say."""
    unit, named = stated_unit(units.cells[0]), stated_unit(names.cells[0])
    if unit is None or named not in (None, unit):
        also = "" if named is None else f", and row {names.number} says {said(names.cells[0])}"
        raise InputError(
            f"row {units.number} is a row of units and says {said(units.cells[0])}{also}; allowed: "
            "um or nm"
        )
    return unit


def _is_header(cells: list[str]) -> bool:
    return is_wavelength(cells[0]) or any(cell.lower() in ("n", "k") for cell in cells[1:])


def _is_data(cells: list[str]) -> bool:
    """Whether a row is meant as numbers, though some of its cells may be none."""
    first, *others = cells
    if not others:
        return is_float(first)
    return is_float(first) or bool(_DIGIT.match(first)) or all(map(is_float, others))


def _header(row: NumberRow) -> tuple[list[str], float]:
    """Names of the columns behind the first, and the first one's unit in nm."""
    names = row.cells[1:]
    try:
        unit = nm_per_unit(row.cells[0])
        columns = [column for column in map(column_of, names) if column is not None]
        if not columns or len(columns) < len(names):
            raise InputError(f"columns are {said(names)}; allowed: wl, then n, k or both")
    except InputError as problem:
        raise InputError(f"row {row.number}: {problem}") from None
    return columns, unit


def _rows(text: str) -> list[NumberRow]:
    """The cells of each line that has any, decimals with points."""
    lines = [line.split("#")[0].strip() for line in io.StringIO(text, newline=None)]
    numbers = [line for line in lines if _DIGIT.match(line)] or lines
    separator = next((sign for sign in "\t;," if any(sign in line for line in numbers)), " ")
    if separator == " ":
        return [NumberRow(at, line.split()) for at, line in enumerate(lines, start=1) if line]
    reader = csv.reader(lines, delimiter=separator)
    try:
        rows = [NumberRow(reader.line_num, [cell.strip() for cell in row]) for row in reader]
    except csv.Error as problem:
        raise InputError(f"no table ({problem}); allowed: rows of numbers") from None
    for row in rows:
        while row.cells and not row.cells[-1]:
            row.cells.pop()
    rows = [row for row in rows if row.cells]
    return rows if separator == "," else _pointed(rows)


def _pointed(rows: list[NumberRow]) -> list[NumberRow]:
    """The rows with decimal commas as points, where no number has a point."""
    points = [(at, cell) for at, cells in rows for cell in cells if "." in cell and is_float(cell)]
    commas = [(at, cell) for at, cells in rows for cell in cells if _DECIMAL_COMMA.fullmatch(cell)]
    if points and commas:
        (one, comma), (other, point) = commas[0], points[0]
        has = f"row {one} has {said(comma)}"
        beside = f"and row {other} {said(point)}" if other != one else f"beside {said(point)}"
        raise InputError(f"{has} {beside}; allowed: one decimal mark, and none between thousands")
    return [
        NumberRow(
            at,
            [cell.replace(",", ".") if _DECIMAL_COMMA.fullmatch(cell) else cell for cell in cells],
        )
        for at, cells in rows
    ]

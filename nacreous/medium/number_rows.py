"""Rows of a wavelength with n, k or both, as numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from nacreous.medium.dispersion import ALLOWED, Dispersion, fits
from nacreous.number import said
from nacreous.problem import InputError

#: The dispersion of "n" and that of "k"; one of them may be missing.
Parts: TypeAlias = dict[str, Dispersion]

#: A number whose thousands are parted by points, commas, blanks or apostrophes.
_GROUPED = re.compile(r"[+-]?[0-9]{1,3}([., '\u2019][0-9]{3})+([.,][0-9]*)?")


class NumberRow(NamedTuple):
    """The cells of a row as text, and its number in the file or the block."""

    number: int
    cells: list[str]


def numbers_of(
    place: str, rows: Sequence[NumberRow], columns: Sequence[str], *, each: bool = False
) -> NDArray[np.float64]:
    """Float64 `[row, column]`: a wavelength and what `columns` names, "n" or "k", each.

    place: how messages begin before a row's number, such as "DATA[0]: data, ". There is a row.
    each: every row has to have n and k that a medium can have, and not one of them alone.
    """
    found = []
    for number, cells in rows:
        row = row_of(f"{place}row {number}", cells, len(columns) + 1)
        if row[0] <= 0:
            raise InputError(f"{place}row {number} has wavelength {row[0]:g}; allowed: above 0")
        found.append(row)
    table = np.array(found)
    # Some published tables leave the range in a few rows, at absorption edges and by noise around
    # 0: these are refused where they are asked for. One of -k is of the other sign's convention.
    for name, values in zip(columns, table[:, 1:].T, strict=True):
        wrong = np.flatnonzero(~fits(name, values))
        if each and 0 < len(wrong) < len(rows):
            raise InputError(
                f"{place}row {rows[wrong[0]].number} has {name} = {values[wrong[0]]:g}; allowed: "
                f"{ALLOWED[name]}"
            )
        if not fits(name, values).any():
            raise InputError(
                f"{place}row {rows[0].number} has {name} = {values[0]:g}, and no row has "
                f"{ALLOWED[name]}; allowed: {name} {ALLOWED[name]}"
            )
    return table


def row_of(place: str, cells: list[str], columns: int) -> list[float]:
    """So many numbers, or one clear message."""
    if len(cells) != columns:
        numbers = f"{len(cells)} number{'s' * (len(cells) != 1)}"
        commas = " (decimal commas need semicolons or tabs between columns)"
        hint = commas if len(cells) == 2 * columns else ""
        raise InputError(f"{place} has {numbers}; allowed: {columns}{hint}")
    for cell in cells:
        if not _is_number(cell):
            marks = ", without marks between thousands" if _GROUPED.fullmatch(cell) else ""
            raise InputError(f"{place} has {said(cell)}; allowed: finite numbers{marks}")
    return [_float(cell) for cell in cells]


def _is_number(cell: str) -> bool:
    # Python would also take 1_5 for 15.
    plain = cell.isascii() and "_" not in cell
    return plain and is_float(cell) and bool(np.isfinite(_float(cell)))


def is_float(cell: str) -> bool:
    """Whether a cell is a number, not a finite one only.

    >>> is_float("0.4D-1"), is_float("nan"), is_float("0,4")
    (True, True, False)
    """
    try:
        _float(cell)
    except ValueError:
        return False
    return True


def _float(cell: str) -> float:
    """A number, whose exponent Fortran writes with a D."""
    return float(re.sub("[dD]", "e", cell))

"""Long numbers that a spreadsheet or a program rounded to a few digits: `1.23457E+12`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.fault import Faults, quoted

#: A number that shows fewer digits than it has.
_ROUNDED = re.compile(r"[+-]?[1-9](?:[.,]([0-9]+))?([eE])\+?([0-9]{1,3})")
#: The least power of ten: spreadsheets, with E, write so in narrow columns what has more digits
#: than fit; programs, with e, write 1e+05 for a round number.
_LEAST_POWER = {"E": 6, "e": 11}


def digits_lost(cell: str) -> tuple[int, int] | None:
    """Of a number how many digits it has and how many are shown; None where all are, or no number.

    >>> digits_lost("1.23457E+12"), digits_lost("1E+3"), digits_lost("1.5")
    ((13, 6), None, None)
    """
    found = _ROUNDED.fullmatch(cell)
    if not found:
        return None
    shown, power = 1 + len(found[1] or ""), int(found[3])
    lost = power >= _LEAST_POWER[found[2]] and shown <= power
    return (power + 1, shown) if lost else None


def refuse_rounded(
    name: str,
    found: Sequence[str],
    code: NDArray[np.signedinteger[Any]],
    faults: Faults,
    labels: Iterable[str] = frozenset(),
) -> None:
    """Note in one line that a column's numbers have lost digits, by which several would be one.

    found: the column's values. code: for each row the index of its value. labels: what is a label
    all the same.
    """
    lost = {at: digits_lost(cell) for at, cell in enumerate(found) if cell not in {*labels}}
    rounded = [at for at, digits in lost.items() if digits]

    def verdict(row: int) -> str:
        has, shown = lost[int(code[row])] or (0, 0)
        return (
            f"{name} is {quoted(found[code[row]])}, a number of {has} digits that a spreadsheet "
            f"rounded to {shown}; allowed: all its digits (save the column as text)"
        )

    faults.say_of_column(np.flatnonzero(np.isin(code, rounded)), verdict)

"""Answers that a table gives twice, with nothing to tell them apart."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.fault import Faults
from nacreous.scaling.data.table import Table


def refuse_repeats(
    table: Table, columns: list[NDArray[Any]], person: NDArray[np.int64] | None, faults: Faults
) -> None:
    """Note rows that say again what an earlier row said, with nothing to tell them apart.

    With people known: the same person, left, right, and time and trial where there are such
    columns. Without people two such rows may well be two people; only rows that are the same in
    every column are refused, and only where a time is among them.
    """
    if not columns:
        return
    first = _earlier_twin([np.nan_to_num(column, nan=np.inf) for column in columns])
    who = "the same person on the same pair" if person is not None else "the same in every column"
    again = np.flatnonzero(first >= 0)
    _, at = np.unique(table.numbers[again], return_index=True)  # a row of a wide table is several
    faults.say_of_rows(
        again[at],
        lambda row: (
            f"repeats row {table.numbers[first[row]]}: {who}, and no time or trial tells "
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

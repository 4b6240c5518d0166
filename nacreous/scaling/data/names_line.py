"""Lines in place of the names of columns: an answer, or the names once more further down."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.pair_name import pairs_in


def check_headless(place: str, row: int, names: list[str], columns: list[Any]) -> None:
    """Refuse a line of names that is an answer: what it has, the rows below have there too."""
    import pyarrow.compute as pc

    again = [
        name
        for name, column in zip(names, columns, strict=True)
        if pc.any(pc.equal(pc.utf8_trim_whitespace(column), name)).as_py()
    ]
    if len(again) > 1:
        raise InputError(
            f"{place}: row {row} seems to be an answer, for {listed(again)} stand in rows below it "
            "too; allowed: a line of column names first, such as left,right,chosen"
        )


def check_label_twice(
    place: str, row: int, names: list[str], twice: list[str], known: Collection[str]
) -> None:
    """Refuse a line of names that has one twice and none that is known: an answer repeats one.

    Names of pairs are names.
    """
    if twice and not any(name.casefold() in known or pairs_in(name) for name in names):
        raise InputError(
            f"{place}: row {row} holds {listed(twice)} more than once, as an answer does; allowed: "
            "a line of column names first, such as left,right,chosen, each name once"
        )


def check_repeated_header(
    place: str, names: list[str], columns: list[Any], numbers: NDArray[np.int64]
) -> None:
    """Refuse the line of names again further down, as where files were joined."""
    import pyarrow.compute as pc

    rows = np.arange(len(numbers))
    for name, column in zip(names, columns, strict=True):
        text = pc.fill_null(pc.utf8_trim_whitespace(column.take(rows)), "")
        rows = rows[np.asarray(pc.equal(text, name))]
    if len(rows):
        raise InputError(
            f"{place}: row {numbers[rows[0]]} is the line of column names again; allowed: once, at "
            "the top (remove it)"
        )

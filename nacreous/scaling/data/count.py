"""Rows that stand for several answers: how many of them each one counts."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import Faults, quoted
from nacreous.scaling.data.number_column import number_column
from nacreous.scaling.data.number_text import has_decimal_points
from nacreous.scaling.data.table import MOST_ROWS, Table

_COUNTS = frozenset({"count", "counts", "freq", "frequency"})
#: Names that count answers, or number trials and weigh pearls: one has to ask.
_PERHAPS = frozenset({"n", "weight", "weights", "times", "votes", "nanswers"})
#: A name of one side's answers, such as `n_left`, `win1` and `votes for B`.
_OF_A_SIDE = re.compile(r"(.*[\W_\d])?(n|wins?|won|counts?|votes?|freq|frequency)([\W_\d].*)?")
_WHOLE = r"^[0-9]+(\.0*)?$"
#: A whole number with marks between its thousands, or with three decimals.
_GROUPED = r"^[1-9][0-9]{0,2}([.,' \x{2019}\x{a0}\x{202f}][0-9]{3})+$"


def count_column(table: Table, taken: Collection[str]) -> str | None:
    """The column that says how many answers a row stands for, by its name.

    A name that may mean something else is refused where whole numbers stand below it, and so is a
    column that only numbers the rows. taken: columns that have another role.
    """
    for name in table.columns:
        word = re.sub(r"[\s_.\-]+", "", name).casefold()
        if name in taken or word not in _COUNTS | _PERHAPS:
            continue
        cells = _whole_numbers(table, name)
        if word in _COUNTS and not _numbers_rows(cells):
            return name
        if cells is not None and (cells != 1).any():
            raise InputError(
                f"{table.place}: column {name} may say how many answers a row stands for; allowed: "
                f"count={name!r} where it does, count='' where it does not"
            )
    return None


def counts_of(table: Table, name: str, faults: Faults) -> NDArray[np.int64]:
    """int64 [row], how many answers each row stands for; anything but whole numbers is a fault."""
    text = text_column(table, name)
    faults.say_of_column(
        np.flatnonzero(are_grouped(text)),
        lambda row: (
            f"{name} is {quoted(text[row])}; allowed: a whole number without a mark in it, such as "
            f"{re.sub('[^0-9]', '', str(text[row]))}"
        ),
    )
    faults.stop()
    values = number_column(table, name, None, faults, -np.inf)
    faults.stop()
    bad = ~((values >= 0) & (values <= MOST_ROWS) & (values == np.rint(values)))
    faults.say_of_column(
        np.flatnonzero(bad),
        lambda row: (
            f"{name} is {quoted(text[row]) if text[row].is_valid else 'empty'}; allowed: a whole "
            f"number from 0 to {MOST_ROWS}, or count='' to leave the column unused"
        ),
    )
    faults.stop()
    total = values.sum()
    if not 1 <= total <= MOST_ROWS:
        faults.say(f"column {name} counts {total:.0f} answers; allowed: 1 to {MOST_ROWS}")
    faults.stop()
    return values.astype(np.int64)


def are_grouped(text: Any) -> NDArray[np.bool_]:
    """Bool [row], cells such as 1,250 and 1.250, where no cell of the column has a decimal point.

    Of answers there are only whole numbers, so 1.250 is a thousand, or 12.000 may be.
    """
    import pyarrow.compute as pc

    if has_decimal_points(text):
        return np.zeros(len(text), bool)
    return np.asarray(pc.fill_null(pc.match_substring_regex(text, _GROUPED), False))


def counts_of_sides(table: Table, taken: Collection[str]) -> list[str]:
    """Columns that seem to count the answers for either side, such as `n_left` and `n_right`."""
    likely = [
        name for name in table.columns if name not in taken and _OF_A_SIDE.fullmatch(_parted(name))
    ]
    return [name for name in likely if _whole_numbers(table, name) is not None]


def _parted(name: str) -> str:
    """A name in small letters, its words parted: `winsLeft` as `wins_left`."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).casefold()


def _whole_numbers(table: Table, name: str) -> NDArray[np.float64] | None:
    """The column as whole numbers of 0 or more; None where anything else is in it."""
    import pyarrow as pa
    import pyarrow.compute as pc

    text = text_column(table, name)
    text = pc.if_else(
        pa.array(are_grouped(text)), pc.replace_substring_regex(text, "[^0-9]", ""), text
    )
    if text.null_count or not pc.all(pc.match_substring_regex(text, _WHOLE)).as_py():
        return None
    return np.asarray(pc.cast(text, pa.float64()))


def _numbers_rows(cells: Any) -> bool:
    """Whether the cells go up by one from 0 or 1, as a running number of trials does."""
    if cells is None or len(cells) < 3:
        return False
    return bool(cells[0] in (0, 1) and (np.diff(cells) == 1).all())

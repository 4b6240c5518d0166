"""Numbers as text: which mark parts their decimals, and what is none."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

#: The decimal mark of a table; None where either may be.
DecimalMark = Literal[",", "."] | None

_WIDE = str.maketrans("０１２３４５６７８９．，＋－−", "0123456789.,+--")


def numbers_of(cells: Sequence[str], mark: DecimalMark) -> NDArray[np.float64] | None:
    """float64 [cell], or None where any of them is no finite number, or may be one of two.

    >>> numbers_of(["20,5", "31"], "."), numbers_of(["20", "inf"], ".")
    (array([20.5, 31. ]), None)
    >>> numbers_of(["1.250", "900"], "."), numbers_of(["1.250", "900"], ",")
    (array([  1.25, 900.  ]), None)
    """
    import pyarrow as pa

    text = pa.array([cell.translate(_WIDE) for cell in cells], pa.large_string())
    good, values = parsed(pointed(text, mark))
    if mark != "." and may_be_thousands(text).any():
        return None
    return values if good.all() and np.isfinite(values).all() else None


def may_be_thousands(text: Any) -> NDArray[np.bool_]:
    """Bool [row], cells such as 1.250, where no cell of the column has a point that is decimal."""
    import pyarrow.compute as pc

    if has_decimal_points(text):
        return np.zeros(len(text), bool)
    may = pc.match_substring_regex(text, r"^[+-]?[1-9][0-9]{0,2}\.[0-9]{3}$")
    return np.asarray(pc.fill_null(may, False))


def has_decimal_points(text: Any) -> bool:
    """Whether any cell is a number whose point can be nothing but decimal: 0.834, 1.25, 1250.5."""
    import pyarrow.compute as pc

    sure = r"^\s*[+-]?((0[0-9]*|[0-9]{4,})?\.[0-9]+|[0-9]+\.([0-9]{1,2}|[0-9]{4,}))\s*$"
    return bool(pc.any(pc.match_substring_regex(text, sure)).as_py())


def has_decimal_commas(text: Any) -> bool:
    """Whether any cell is a number whose comma can be nothing but decimal: 0,834, 1,25, 1250,5."""
    import pyarrow.compute as pc

    sure = r"^\s*[+-]?((0[0-9]*|[0-9]{4,}),[0-9]+|[0-9]+,([0-9]{1,2}|[0-9]{4,}))\s*$"
    return bool(pc.any(pc.match_substring_regex(text, sure)).as_py())


def parsed(text: Any) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """Whether each cell is empty or a number, and the numbers, NaN where there is none."""
    import pyarrow as pa
    import pyarrow.compute as pc

    number = r"^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$"
    good = pc.fill_null(pc.match_substring_regex(text, number), True)
    value = pc.cast(pc.if_else(good, text, pa.scalar(None, text.type)), pa.float64())
    return np.asarray(good), np.asarray(pc.fill_null(value, np.nan)).copy()


def pointed(text: Any, mark: DecimalMark) -> Any:
    """Decimal commas as points, where the column's commas can be nothing else.

    1,250 may be a thousand and a quarter of one; 0,834 and 1,25 may not. Beside a decimal point a
    comma is none.
    """
    import pyarrow.compute as pc

    def some(pattern: str) -> bool:
        return bool(pc.any(pc.match_substring_regex(text, pattern)).as_py())

    comma = r"^[+-]?[0-9]+,[0-9]+$"
    sure = mark == "," or has_decimal_commas(text)
    if not some(comma) or not sure or some(r"\."):
        return text
    return pc.replace_substring_regex(text, r"^([+-]?[0-9]+),([0-9]+)$", r"\1.\2")

"""Columns of numbers and of lengths of time, with the faults of each by row."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.decimal_mark import decimal_mark_of
from nacreous.scaling.data.duration import is_duration, seconds_in, seconds_of
from nacreous.scaling.data.fault import Faults, quoted
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.number_text import DecimalMark, may_be_thousands, parsed, pointed
from nacreous.scaling.data.table import Table


def number_column(
    table: Table, name: str, role: str | None, faults: Faults, least: float
) -> NDArray[np.float64]:
    """float64 [row], finite and `least` or more; anything else is noted as a fault.

    Empty cells are NaN: that the time of one answer is unknown spoils no other. So are the words
    for nothing (`NOTHING`), and -1 where numbers are at least 0, which says that nobody answered.
    A list of one number, as PsychoPy writes it, is that number. A decimal comma is read where it
    cannot be one between thousands; unless points are decimal in this table (`decimal_mark_of`), a
    point that may part thousands is refused likewise. role: of a column that may be left unused, or
    None.
    """
    text = _filled(text_column(table, name), least)
    doubtful = may_be_thousands(text) & (not _is_float(table.columns[name]))
    mark = decimal_mark_of(table) if doubtful.any() or _has_commas(text) else "."
    good, values = parsed(pointed(text, mark))
    if mark != ".":
        good &= ~doubtful
    bad = ~good | np.isinf(values) | (values < least)
    _say_bad(name, role, text, bad, least, faults, mark)
    return values


def seconds_column(
    table: Table, name: str, role: str, faults: Faults, per_s: float
) -> NDArray[np.float64]:
    """float64 [row], how long each answer took in seconds: 0 or more, NaN where empty.

    per_s: how many of a bare number are a second. Durations, and text such as
    0 days 00:00:00.812, have their own unit.
    """
    array = table.columns[name]
    if is_duration(array):
        values = seconds_of(array)
        _say_bad(name, role, values, values < 0, 0.0, faults)
        return values
    cells = _filled(text_column(table, name), 0.0).dictionary_encode()
    said = [seconds_in(cell) for cell in cells.dictionary.to_pylist()]
    if not said or None in said:
        return number_column(table, name, role, faults, 0.0) / per_s
    code = np.asarray(cells.indices.fill_null(len(said)), dtype=np.int64)
    values = np.array([*said, np.nan], np.float64)[code]
    _say_bad(name, role, text_column(table, name), values < 0, 0.0, faults)
    return values


def _filled(text: Any, least: float) -> Any:
    """Cells out of their lists of one; those that say nothing are empty."""
    import pyarrow as pa
    import pyarrow.compute as pc

    text = pc.replace_substring_regex(text, r"^\[\s*['\"]?([^,\[\]'\"]*)['\"]?\s*\]$", r"\1")
    nothing = pc.or_(pc.equal(text, ""), pa.array(is_nothing(text)))
    if least == 0:
        nothing = pc.or_(
            nothing, pc.fill_null(pc.match_substring_regex(text, r"^-1(\.0*)?$"), False)
        )
    return pc.if_else(nothing, pa.scalar(None, text.type), text)


def _say_bad(
    name: str,
    role: str | None,
    text: Any,
    bad: NDArray[np.bool_],
    least: float,
    faults: Faults,
    mark: DecimalMark = ".",
) -> None:
    allowed = "a number" if least == -np.inf else f"a number of at least {least:g}"
    if role in ("time", "trial"):
        allowed += " or a time in ISO 8601, such as 2026-03-01T09:30"
    say = faults.say_of_column if role else faults.say_of_rows
    unused = f", or {unused_by(role)}" if role else ""
    say(
        np.flatnonzero(bad),
        lambda row: (
            f"{name} is {quoted(text[row])}; allowed: {allowed}{_hint(text[row], mark)}{unused}"
        ),
    )


def _is_float(column: Any) -> bool:
    import pyarrow as pa

    return bool(pa.types.is_floating(column.type))


def _has_commas(text: Any) -> bool:
    import pyarrow.compute as pc

    return bool(pc.any(pc.match_substring(text, ",")).as_py())


def unused_by(role: str) -> str:
    """How a column that may be missing is left unused."""
    return f"{role}='' to leave the column unused"


def _hint(cell: object, mark: DecimalMark) -> str:
    if mark != "." and re.fullmatch(r"[+-]?[1-9][0-9]{0,2}\.[0-9]{3}", str(cell)):
        decimal = "1,25" if mark else "1.25"
        return f" without a point that may part thousands, such as 1250 or {decimal}"
    return " with a decimal point" if re.fullmatch(r"[^\[]*,.*", str(cell)) else ""

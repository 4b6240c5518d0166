"""Columns that say when, or in which order, each answer was given."""

from __future__ import annotations

from datetime import datetime
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.duration import is_duration, seconds_in, seconds_of
from nacreous.scaling.data.fault import Faults, quoted
from nacreous.scaling.data.kind import kind_said
from nacreous.scaling.data.nothing import NOTHING
from nacreous.scaling.data.number_column import number_column, unused_by
from nacreous.scaling.data.table import Table


def time_column(table: Table, name: str, role: str, faults: Faults) -> NDArray[np.float64]:
    """float64 [row]: numbers as they are, dates and times as seconds since 1970, empty as NaN.

    Text is read as a number or as ISO 8601, such as 2026-03-01T09:30:00+09:00. Times without an
    offset are taken as they stand; they may not be mixed with those of another offset than 0.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    array = table.columns[name]
    if is_duration(array):
        return seconds_of(array)
    if not pa.types.is_temporal(array.type):
        text = text_column(table, name)
        passed = _passed(text)
        if passed is not None:
            return passed
        dated = pc.fill_null(pc.match_substring_regex(text, r"^[0-9]{4}-[0-9]{2}-[0-9]{2}"), False)
        if not pc.any(dated).as_py():
            return number_column(table, name, role, faults, -np.inf)
        return _instants(text, name, role, faults)
    try:
        instant = pc.cast(array, pa.timestamp("us"), safe=False)
    except (pa.ArrowInvalid, pa.ArrowNotImplementedError):  # a time of day
        faults.say(f"column {name} holds {kind_said(array.type)}; allowed: numbers or ISO 8601")
        return np.full(table.rows, np.nan)
    seconds = np.asarray(pc.fill_null(pc.cast(instant, pa.int64()), 0)) / 1e6
    return np.where(np.asarray(array.is_null()), np.nan, seconds)


def _passed(text: Any) -> NDArray[np.float64] | None:
    """Seconds since some beginning, such as 0 days 00:01:30; None of a time of day or a date."""
    cells = text.dictionary_encode()
    found = cells.dictionary.to_pylist()
    said = [seconds_in(cell) if cell[:1] in "-P" or " day" in cell else None for cell in found]
    if not said or None in said:
        return None
    code = np.asarray(cells.indices.fill_null(len(said)), dtype=np.int64)
    return np.array([*said, np.nan], np.float64)[code]


def _instants(text: Any, name: str, role: str, faults: Faults) -> NDArray[np.float64]:
    """Seconds since 1970 of times in ISO 8601."""
    cells = text.dictionary_encode()
    seconds = np.full(len(cells.dictionary) + 1, np.nan)
    bare = shifted = False
    bad: list[int] = []
    for at, cell in enumerate(cells.dictionary.to_pylist()):
        if cell.lower() in NOTHING:
            continue
        try:
            instant = datetime.fromisoformat(cell)
        except ValueError:
            bad.append(at)
            continue
        offset = instant.utcoffset()
        bare, shifted = bare or offset is None, shifted or bool(offset)
        seconds[at] = (instant.replace(tzinfo=None) - datetime(1970, 1, 1)).total_seconds()
        seconds[at] -= offset.total_seconds() if offset else 0.0
    code = np.asarray(cells.indices.fill_null(len(seconds) - 1), dtype=np.int64)
    faults.say_of_column(
        np.flatnonzero(np.isin(code, bad)),
        lambda row: (
            f"{name} is {quoted(text[row])}; allowed: a time in ISO 8601, such as "
            f"2026-03-01T09:30, or {unused_by(role)}"
        ),
    )
    if bare and shifted:
        faults.say(
            f"column {name} has times with an offset and without; allowed: all or none, or "
            f"{unused_by(role)}"
        )
    return seconds[code]

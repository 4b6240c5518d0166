"""Lengths of time in seconds, from columns and cells that say their unit themselves."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

_TICKS_PER_S = {"s": 1, "ms": 1e3, "us": 1e6, "ns": 1e9}
#: As pandas and Python write a length of time: 0 days 00:00:00.812, 0:00:00.812.
_LENGTH = re.compile(
    r"(?P<sign>-?)(?:(?P<days>[0-9]+) days?,? \+?)?"
    r"(?P<h>[0-9]{1,4}):(?P<min>[0-5][0-9]):(?P<s>[0-5][0-9](?:\.[0-9]*)?)"
)
_DAYS = re.compile(r"(?P<sign>-?)(?P<days>[0-9]+) days?")
#: As Polars and ISO 8601 write it: PT0.812S.
_ISO = re.compile(
    r"(?P<sign>-?)P(?=[0-9T])(?:(?P<days>[0-9]+)D)?(?:T(?=[0-9])(?:(?P<h>[0-9]+)H)?"
    r"(?:(?P<min>[0-9]+)M)?(?:(?P<s>[0-9]+(?:\.[0-9]*)?)S)?)?"
)


def is_duration(array: Any) -> bool:
    """Whether an Arrow column is of a kind that has its unit, as pandas's Timedelta has."""
    import pyarrow as pa

    return bool(pa.types.is_duration(array.type))


def seconds_of(array: Any) -> NDArray[np.float64]:
    """float64 [row], a duration column in seconds, whatever its unit; NaN where empty."""
    import pyarrow as pa
    import pyarrow.compute as pc

    ticks = np.asarray(pc.fill_null(pc.cast(array, pa.int64()), 0)).astype(np.float64)
    return np.where(np.asarray(array.is_null()), np.nan, ticks / _TICKS_PER_S[array.type.unit])


def seconds_in(cell: str) -> float | None:
    """The seconds in a text that says its units itself; None of any other.

    >>> seconds_in("0 days 00:00:00.812"), seconds_in("00:01:00"), seconds_in("PT0.5S")
    (0.812, 60.0, 0.5)
    >>> seconds_in("00:30"), seconds_in("0.812")
    (None, None)
    """
    found = _LENGTH.fullmatch(cell) or _DAYS.fullmatch(cell) or _ISO.fullmatch(cell)
    if not found:
        return None
    days, clock = (
        sum(float(found.groupdict().get(part) or 0) * weight for part, weight in each.items())
        for each in ({"days": 86400.0}, {"h": 3600.0, "min": 60.0, "s": 1.0})
    )
    if not found["sign"]:
        return days + clock
    return clock - days if "+" in cell else -days - clock  # pandas: -1 days +23:59:59

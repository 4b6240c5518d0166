"""What `nacreous scale` cautions of: columns and labels that may mean something else."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from nacreous.scaling.data.exclusion import may_exclude
from nacreous.scaling.data.fault import listed, quoted
from nacreous.scaling.data.practice import may_mark
from nacreous.scaling.data.spreadsheet_date import made_dates

if TYPE_CHECKING:
    from nacreous.scaling.report.analysis import Analysis

#: Half of the answers to one pair hardly take longer, or shorter, in seconds: the unit is another.
_SLOW_S, _FAST_S = 60.0, 0.02


def cautions(found: Analysis) -> list[str]:
    """In a line each what is likely not as it was meant, though the file can be read so."""
    return _dates(found) + _unit(found) + _marks(found)


def _dates(found: Analysis) -> list[str]:
    dates = made_dates(found.fit.stimuli)
    if not dates:
        return []
    return [
        f"caution: labels such as {listed(dates, 3)} are dates and others are not: a spreadsheet "
        "may have made dates of them; allowed: labels as they were (save the columns as text)"
    ]


def _unit(found: Analysis) -> list[str]:
    """That response times are so long or short that their unit is likely another."""
    times = None if found.answers is None else found.answers.response_s
    if times is None or np.isnan(times).all():
        return []
    median = float(np.nanmedian(times))
    if median >= _SLOW_S:
        hint = "if they are milliseconds, --column response_ms=NAME --column response_s="
    elif 0 < median <= _FAST_S:
        hint = "if they are seconds, --column response_s=NAME --column response_ms="
    else:
        return []
    return [f"caution: half of the response times are {median:g} s or longer; {hint}"]


def _marks(found: Analysis) -> list[str]:
    """Columns that may mark practice, catch trials or exclusions, and whose rows all count."""
    groups = {} if found.answers is None else found.answers.groups
    return [
        f"caution: column {quoted(name)} may mark practice or catch trials, and holds "
        f"{listed(group.levels, 3)}; all these rows count (remove those that should not)"
        for name, group in groups.items()
        if may_mark(name, group.levels)
    ] + [
        f"caution: column {quoted(name)} may say which rows are no good, and holds "
        f"{listed(group.levels, 3)}; all these rows count (remove those that should not, or call "
        "the column excluded)"
        for name, group in groups.items()
        if may_exclude(name, group.levels)
    ]

"""A scale as a table: for pandas, and for notebooks."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

import numpy as np

from nacreous.problem import InputError

if TYPE_CHECKING:
    from pandas import DataFrame

    from nacreous.scaling.fit.scale import Scale


def frame_of(scale: Scale) -> DataFrame:
    """A row for each stimulus, in the order of `stimuli`."""
    try:
        import pandas as pd
    except ImportError:
        raise InputError("to_frame needs pandas; install it by: pip install pandas") from None
    value, se, interval = _columns(scale)
    columns = {"value": value, "se": se, "low": interval[:, 0], "high": interval[:, 1]}
    index = pd.Index(scale.stimuli, name="stimulus")
    frame = pd.DataFrame(columns, index=index)
    frame.attrs["unit"] = scale.unit
    return frame


def html_of(scale: Scale) -> str:
    """The same as a table of HTML, from the most preferred on, with the unit in its head."""
    value, se, interval = _columns(scale)
    rows = []
    for i in np.argsort(-value, kind="stable"):
        cells = (value[i], se[i], *interval[i])
        numbers = "".join(
            f'<td style="text-align:right">{"" if np.isnan(cell) else f"{cell:z.3f}"}</td>'
            for cell in cells
        )
        rows.append(f"<tr><th>{escape(scale.stimuli[i])}</th>{numbers}</tr>")
    head = "".join(f"<th>{name}</th>" for name in ("stimulus", scale.unit, "se", "95 %", ""))
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>"


def _columns(scale: Scale) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Values, standard errors and intervals of 95 %; NaN where the answers give no errors."""
    try:
        return scale.scale, scale.se, scale.intervals()
    except InputError:
        none = np.full(len(scale.scale), np.nan)
        return scale.scale, none, np.column_stack((none, none))

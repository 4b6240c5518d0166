"""Numbers of buttons in files of jsPsych, which count from 0 at the left."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import Faults
from nacreous.scaling.data.program import JSPSYCH, program_of
from nacreous.scaling.data.table import Table


def refuse_buttons_as_labels(
    table: Table,
    name: str,
    found: tuple[str, ...],
    meanings: list[int],
    shown: tuple[NDArray[np.int64], ...],
    faults: Faults,
) -> None:
    """Note numbers of buttons that are labels too, where the two say different things."""
    code, *sides = shown
    for at, side in ((found.index(each), int(each)) for each in ("0", "1") if each in found):
        rows = code == at
        other = np.flatnonzero(rows & (sides[side] != meanings[at]))
        if meanings[at] >= 0 and are_buttons(table, rows):
            faults.say_of_column(
                other,
                lambda _, number=side: (  # type: ignore[misc]
                    f"{name} is {number}, which may be a button or the stimulus of that name; "
                    "allowed: other names of stimuli (rename)"
                ),
            )


def are_buttons(table: Table, rows: NDArray[np.bool_]) -> bool:
    """Whether jsPsych says of these rows that a button was pressed, and no key or slider."""
    program = program_of(table.columns)
    if program is None or program.name != JSPSYCH.name:
        return False
    kinds = text_column(table, "trial_type").to_pylist()
    return all("button-response" in (kinds[row] or "") for row in np.flatnonzero(rows))

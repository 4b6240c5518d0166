"""The answers so far, counted for the pairs that the next participant sees."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from nacreous.scaling.data.comparisons import Comparisons

__all__ = ["counts_of"]


def counts_of(labels: Sequence[str], tally: Iterable[Mapping[str, Any]]) -> dict[str, Comparisons]:
    """The counts of each question that has any, from the rows of `Store.tally`.

    People's answers alone; a program's where a question has no others, so that a rehearsal goes as
    the study will **(ours)**.

    >>> row = {"question": "q", "left": "a", "right": "b", "chosen": "left", "count": 3}
    >>> counts_of(["a", "b"], [{**row, "simulated": True}])
    {'q': Comparisons(3 answers, 2 stimuli, 1 pair)}
    >>> people = {**row, "chosen": "tie", "count": 1, "simulated": False}
    >>> counts_of(["a", "b"], [{**row, "simulated": True}, people])
    {'q': Comparisons(1 answers, 2 stimuli, 1 pair)}
    """
    by_question: dict[str, list[Mapping[str, Any]]] = {}
    for row in tally:
        by_question.setdefault(row["question"], []).append(row)
    return {question: _counted(labels, rows) for question, rows in by_question.items()}


def _counted(labels: Sequence[str], rows: list[Mapping[str, Any]]) -> Comparisons:
    people = [row for row in rows if not row["simulated"]]
    index = {label: place for place, label in enumerate(labels)}
    wins, ties = np.zeros((2, len(labels), len(labels)))
    for row in people or rows:
        left, right = index[row["left"]], index[row["right"]]
        if row["chosen"] == "tie":
            ties[[left, right], [right, left]] += row["count"]
        elif row["chosen"] == "left":
            wins[left, right] += row["count"]
        else:
            wins[right, left] += row["count"]
    return Comparisons.of_counts(wins, ties, labels)

"""What people who look are expected to choose, as far as their answers say so."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.study.task.asked import Asked
from nacreous.study.task.counting import counts
from nacreous.study.task.pair.keys import PairKeys
from nacreous.study.task.pair.reading import answers
from nacreous.study.task.row import Row

__all__ = ["Shares", "expected_shares"]

#: By question and by whether people are simulated: float64 [n, n], in the order of the study's
#: labels, how often each is chosen over each.
Shares = Mapping[tuple[str, bool], NDArray[np.float64]]

#: From fewer people a scale says too little of what chance does to one of them **(ours)**; until
#: then they are held to coins, which flags fewer.
_LEAST_PEOPLE = 10


def expected_shares(rows: Sequence[Row], asked: Asked[PairKeys]) -> Shares:
    """How often each is chosen over each, by question and by whether people are simulated."""
    from nacreous.scaling import thurstone

    index = {label: at for at, label in enumerate(asked.labels)}
    found = {}
    for question in asked.questions:
        for simulated in (False, True):
            shares = np.full((len(index), len(index)), 0.5)
            found[question, simulated] = shares
            own = [
                row
                for row in rows
                if row["question"] == question and counts(row, simulated=simulated)
            ]
            if len({row["number"] for row in own}) < _LEAST_PEOPLE:
                continue
            try:
                fit = thurstone(answers(own, {}))
            except InputError:  # no scale yet
                continue
            at = [index[label] for label in fit.stimuli]
            shares[np.ix_(at, at)] = fit.proportions
    return found

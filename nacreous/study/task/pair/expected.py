"""What people who look are expected to choose, as far as their answers say so."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.study.task.asked import Asked
from nacreous.study.task.pair.data import PairData
from nacreous.study.task.pair.keys import PairKeys

__all__ = ["Shares", "expected_shares"]

#: By question and by whether people are simulated: float64 [n, n], in the order of the study's
#: labels, how often each is chosen over each.
Shares = Mapping[tuple[str, bool], NDArray[np.float64]]

#: From fewer people a scale says too little of what chance does to one of them **(ours)**; until
#: then they are held to coins, which flags fewer.
_LEAST_PEOPLE = 10


def expected_shares(data: PairData, asked: Asked[PairKeys]) -> Shares:
    """How often each is chosen over each, by question and by whether people are simulated."""
    from nacreous.scaling import thurstone

    count = len(asked.labels)
    found = {}
    for place, question in enumerate(asked.questions):
        for simulated in (False, True):
            shares = np.full((count, count), 0.5)
            found[question, simulated] = shares
            kept = data.counts & (data.simulated == simulated) & (data.question == place)
            own = data if kept.all() else data.take(np.flatnonzero(kept))
            if len(np.unique(own.person)) < _LEAST_PEOPLE:
                continue
            seen = np.unique(np.concatenate([own.left, own.right]))
            try:
                fit = thurstone(_compared(own, seen, asked))
            except InputError:  # no scale yet
                continue
            shares[np.ix_(seen, seen)] = fit.proportions
    return found


def _compared(data: PairData, seen: NDArray[np.int16], asked: Asked[PairKeys]) -> Comparisons:
    """The answers counted, of those stimuli alone that were seen."""
    labels = tuple(printable(asked.labels[at]) for at in seen)
    place = np.zeros(len(asked.labels), np.int32)  # of four bytes, for there may be millions
    place[seen] = np.arange(len(seen))
    left, right = place[data.left], place[data.right]
    return Comparisons.of_outcomes(labels, left, right, data.outcome, sided=True)

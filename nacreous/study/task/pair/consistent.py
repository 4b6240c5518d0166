"""Flags from what a person's answers say of each other, by the checks of `nacreous.scaling`."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.response import FASTEST_S, MOST_FAST
from nacreous.study.task.asked import Asked
from nacreous.study.task.flag import RATE, Flag
from nacreous.study.task.pair.chance import at_least, one_sided
from nacreous.study.task.pair.circles import circle_flags
from nacreous.study.task.pair.data import PairData
from nacreous.study.task.pair.expected import expected_shares
from nacreous.study.task.pair.keys import PairKeys

__all__ = ["consistency_flags"]


def consistency_flags(data: PairData, asked: Asked[PairKeys]) -> dict[int, list[Flag]]:
    """Flags by person's number.

    What chance does is known from the scale that the people's answers (or the simulated ones,
    for simulated people) have so far.
    """
    shares = expected_shares(data, asked)
    circles = circle_flags(data, asked, shares)
    stacked = np.array([shares[one, way] for one in asked.questions for way in (False, True)])
    return {
        number: [
            *_repeats(own, stacked),
            *_sides(own),
            *circles.get(number, []),
            *_fast(own),
        ]
        for number, own in data.by_person()
    }


def _repeats(own: PairData, shares: NDArray[np.float64]) -> Iterator[Flag]:
    """Pairs asked again and answered otherwise, more than people who look would have.

    own: of one person. shares: float64 [question and whether simulated, n, n].
    """
    count = shares.shape[-1]
    asked = own.question.astype(np.int64) * count**2 + own.pair(count)
    before, now = _before(asked, own)
    known = own.repeat & (before != 0) & (now != 0)
    if not np.any(known & (before != now)):
        return
    again = own.take(np.flatnonzero(known))
    expected = shares[2 * again.question + again.simulated, again.left, again.right]
    otherwise = int(np.count_nonzero(before[known] != now[known]))
    if at_least(otherwise, (2 * expected * (1 - expected)).tolist()) <= RATE:
        yield Flag("repeats", f"{otherwise}/{len(expected)}")


def _before(asked: NDArray[np.int64], own: PairData) -> tuple[NDArray[np.int8], NDArray[np.int8]]:
    """What each answer's pair was answered when it was first asked, 0 where it was not; and now."""
    now = own.first_won
    first = np.flatnonzero(~own.repeat)
    known, back = np.unique(asked[first][::-1], return_index=True)  # the last one, of several
    before = np.zeros(len(now), np.int8)
    if len(known):
        place = np.minimum(np.searchsorted(known, asked), len(known) - 1)
        answered = now[first][::-1][back]
        before = np.where(known[place] == asked, answered[place], 0)
    return before, now


def _sides(own: PairData) -> Iterator[Flag]:
    """One side, chosen more often than coins would."""
    lefts, total = int(np.sum(own.outcome == 1)), int(np.count_nonzero(own.outcome))
    if total and one_sided(lefts, total) <= RATE:
        left = 2 * lefts > total
        yield Flag("left" if left else "right", f"{lefts if left else total - lefts}/{total}")


def _fast(own: PairData) -> Iterator[Flag]:
    """How many answers came faster than anyone reacts."""
    times_ms = own.response_ms[~np.isnan(own.response_ms)]
    fast = int(np.sum(times_ms / 1000 < FASTEST_S))
    if len(times_ms) and fast / len(times_ms) > MOST_FAST:
        yield Flag("fast", f"{fast}/{len(times_ms)}")

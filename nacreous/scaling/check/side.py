"""Side bias: the left one chosen more often than the right, whatever stands there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.check.share import Share
from nacreous.scaling.check.ways_round import WaysRound, ways_round
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.given import answers_of
from nacreous.scaling.distribution import binom
from nacreous.scaling.fit.blocks import numbered
from nacreous.scaling.fit.uncertainty import holm, level_of
from nacreous.value import value_class

#: Standard deviations by which pairs may stand one way round more often than tossed coins do.
_BY_CHANCE = 2.0
#: A side that gets more than this share of the choices decides most of them.
_MOST = 0.75


@value_class
class SideBias:
    """How often the left one was chosen.

    - `left`: its share of all answers without ties
    - `p_value`: where sides were `exchanged` the exact binomial test against 1/2; elsewhere a share
      other than 1/2 may be the stimuli's doing, and each pair is held against itself the other way
      round (N. Mantel and W. Haenszel, 1959); None where no pair tells
    - `exchanged`: whether pairs stood either way round as often as tossed coins would have it
    - `balanced`: share of answers that have a partner with the sides exchanged
    - `decides`: whether the side made most choices: by `p_value`, and `left` surely beyond 3/4
    - `by_person`: the left share of each person; {} where people are unknown
    - `biased`: the people whose own exact test, corrected for the number of people (Holm 1979), is
      below 1 - level, against 1/2 and against what all choose in the pairs that they saw
    """

    left: Share
    p_value: float | None
    exchanged: bool
    balanced: float
    decides: bool
    by_person: Mapping[str, Share]
    biased: tuple[str, ...]


def side_bias(answers: Any, level: float = 0.95) -> SideBias:
    """The share of left answers, in all and by person.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.
    Raises `InputError` where left and right are no places (answers from a list of pairs), or all
    answers are ties.

    >>> table = {"left": ["a", "b"] * 8, "right": ["b", "a"] * 8, "chosen": ["left"] * 16}
    >>> bias = side_bias(Answers.of_table(table))
    >>> print(bias.left)
    16 of 16, 1.00 (0.81 to 1.00)
    """
    answers = answers_of(answers)
    level = level_of(level)
    if not answers.sided:
        raise InputError("the answers have no sides: the first of a pair was not the left one")
    decided = answers.decided()
    if not len(decided):
        raise InputError("all answers are ties; allowed: one or more with a choice")
    chose_left = decided.outcome == 1
    total, lefts = len(chose_left), int(chose_left.sum())
    ways = ways_round(decided)
    by_person, biased = _people(decided, ways, level)
    exchanged = ways.exchanged(_BY_CHANCE)
    p_value = float(_exact(np.array([lefts]), np.array([total]))[0])
    left, found = Share.of(lefts, total, level), p_value if exchanged else ways.p_value
    return SideBias(
        left=left,
        p_value=found,
        exchanged=exchanged,
        balanced=_balanced(answers),
        decides=bool(
            found is not None and found < 1 - level and (left.low > _MOST or left.high < 1 - _MOST)
        ),
        by_person=by_person,
        biased=biased,
    )


def _exact(lefts: NDArray[np.int64], totals: NDArray[np.int64]) -> NDArray[np.float64]:
    """Two-sided exact binomial tests against 1/2, twice the smaller tail."""
    fewer = np.minimum(lefts, totals - lefts)
    return np.asarray(np.minimum(1.0, 2 * binom.cdf(fewer, totals, 0.5)), np.float64)


def _people(
    decided: Answers, ways: WaysRound, level: float
) -> tuple[dict[str, Share], tuple[str, ...]]:
    """decided: answers with a choice."""
    if decided.person is None:
        return {}, ()
    person, chose_left = decided.person, decided.outcome == 1
    total = np.bincount(person, minlength=len(decided.people))
    lefts = np.bincount(person[chose_left], minlength=len(decided.people))
    known = np.flatnonzero(total)
    alone = _exact(lefts[known], total[known])
    beside = np.ones(len(known))
    for at in np.flatnonzero(alone < 1 - level):
        rows = np.flatnonzero((person == known[at]) & ways.both)
        beside[at] = _unequal(int(chose_left[rows].sum()), ways.expected[rows])
    corrected = holm(np.maximum(alone, beside))
    shares = {
        decided.people[index]: Share.of(int(lefts[index]), int(total[index]), level)
        for index in known.tolist()
    }
    return shares, tuple(decided.people[index] for index in known[corrected < 1 - level].tolist())


def _unequal(lefts: int, chances: NDArray[np.float64]) -> float:
    """Two-sided exact test of a sum of choices with chances of their own, twice the smaller tail.

    >>> round(_unequal(0, np.array([0.5, 0.5])), 3)
    0.5
    """
    sums = np.ones(1)
    for chance in chances:
        sums = np.convolve(sums, (1 - chance, chance))
    return float(min(1.0, 2 * min(sums[: lefts + 1].sum(), sums[lefts:].sum())))


def _balanced(answers: Answers) -> float:
    """The share of answers that have a partner with the sides exchanged."""
    count = len(answers.stimuli)
    low = np.minimum(answers.left, answers.right)
    high = np.maximum(answers.left, answers.right)
    _, pair = numbered(low * count + high, count**2)
    lead = np.where(answers.left < answers.right, 1, -1)
    unpaired = np.abs(np.bincount(pair, weights=lead)).sum()
    return float(1 - unpaired / len(answers))

"""Side bias: the left one chosen more often than the right, whatever stands there."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.check.share import Share
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.fit.uncertainty import holm, level_of
from nacreous.value import value_class


@value_class
class SideBias:
    """How often the left one was chosen.

    - `left`: its share of all answers without ties; `p_value`: the exact binomial test against 1/2
    - `balanced`: share of pairs shown as often either way round; where it is far from 1, a share
      other than 1/2 may be the stimuli's doing, and a fit with `order=True` tells them apart
    - `by_person`: the left share of each person; {} where people are unknown
    - `biased`: the people whose own exact test, corrected for the number of people (Holm 1979), is
      below 1 - level
    """

    left: Share
    p_value: float
    balanced: float
    by_person: Mapping[str, Share]
    biased: tuple[str, ...]


def side_bias(answers: Answers, level: float = 0.95) -> SideBias:
    """The share of left answers, in all and by person.

    Raises `InputError` where left and right are no places (answers from a list of pairs), or all
    answers are ties.

    >>> table = {"left": ["a", "b"] * 8, "right": ["b", "a"] * 8, "chosen": ["left"] * 16}
    >>> bias = side_bias(Answers.of_table(table))
    >>> print(bias.left)
    16 of 16, 1.00 (0.81 to 1.00)
    """
    level = level_of(level)
    if not answers.sided:
        raise InputError("the answers have no sides: the first of a pair was not the left one")
    decided = answers.outcome != 0
    if not decided.any():
        raise InputError("all answers are ties; allowed: one or more with a choice")
    chose_left = answers.outcome[decided] == 1
    total, lefts = len(chose_left), int(chose_left.sum())
    by_person, biased = _people(answers, decided, chose_left, level)
    return SideBias(
        left=Share.of(lefts, total, level),
        p_value=float(_exact(np.array([lefts]), np.array([total]))[0]),
        balanced=_balanced(answers),
        by_person=by_person,
        biased=biased,
    )


def _exact(lefts: NDArray[np.int64], totals: NDArray[np.int64]) -> NDArray[np.float64]:
    """Two-sided exact binomial tests against 1/2, twice the smaller tail."""
    from scipy.stats import binom

    fewer = np.minimum(lefts, totals - lefts)
    return np.asarray(np.minimum(1.0, 2 * binom.cdf(fewer, totals, 0.5)), np.float64)


def _people(
    answers: Answers, decided: NDArray[np.bool_], chose_left: NDArray[np.bool_], level: float
) -> tuple[dict[str, Share], tuple[str, ...]]:
    if answers.person is None:
        return {}, ()
    person = answers.person[decided]
    total = np.bincount(person, minlength=len(answers.people))
    lefts = np.bincount(person[chose_left], minlength=len(answers.people))
    known = np.flatnonzero(total)
    corrected = holm(_exact(lefts[known], total[known]))
    shares = {
        answers.people[index]: Share.of(int(lefts[index]), int(total[index]), level)
        for index in known.tolist()
    }
    return shares, tuple(answers.people[index] for index in known[corrected < 1 - level].tolist())


def _balanced(answers: Answers) -> float:
    """The share of answers that have a partner with the sides exchanged."""
    count = len(answers.stimuli)
    low = np.minimum(answers.left, answers.right)
    high = np.maximum(answers.left, answers.right)
    _, pair = np.unique(low * count + high, return_inverse=True)
    lead = np.where(answers.left < answers.right, 1, -1)
    unpaired = np.abs(np.bincount(pair, weights=lead)).sum()
    return float(1 - unpaired / len(answers))

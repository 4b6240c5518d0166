"""Test and retest: the same person, the same pair, asked twice."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.share import Share
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.given import answers_of
from nacreous.scaling.data.person import known_people
from nacreous.value import value_class


@value_class
class Retest:
    """How often people answered a pair the second time as the first.

    - `agreement`: all repeats; `same_sides` those with left and right as before, `reversed` those
      with the sides changed; None where there are none
    - `kappa`: agreement beyond chance (Cohen 1960), with `kappa_low` and `kappa_high` from the
      interval of `agreement`, chance held fixed. Which of a pair counts as the first is arbitrary,
      so each repeat enters both ways round: without ties kappa is 2 · agreement - 1.
    - `by_person`: for each person with repeats, the agreement
    """

    agreement: Share
    same_sides: Share | None
    reversed: Share | None
    kappa: float
    kappa_low: float
    kappa_high: float
    by_person: Mapping[str, Share]


def retest(answers: Any, level: float = 0.95) -> Retest | None:
    """Compare each person's first two answers to a pair; None where nobody was asked twice.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.
    First and second go by `time` where it is known, else by row. A tie agrees with a tie only.
    Raises `InputError` where people are unknown.

    >>> table = {"left": ["a", "b"], "right": ["b", "a"], "chosen": ["a", "a"], "person": ["x"] * 2}
    >>> retest(Answers.of_table(table)).agreement.share
    1.0
    """
    answers = answers_of(answers)
    person = known_people(answers)
    first, second = _repeats(answers, person)
    if len(first) == 0:
        return None
    swapped = answers.left > answers.right
    choice = np.where(swapped, -answers.outcome, answers.outcome)
    same = choice[first] == choice[second]
    sides = answers.left[first] == answers.left[second]
    agreement = Share.of(int(same.sum()), len(same), level)
    tied = [float(np.mean(choice[rows] == 0)) for rows in (first, second)]
    by_chance = tied[0] * tied[1] + (1 - tied[0]) * (1 - tied[1]) / 2

    def beyond_chance(share: float) -> float:
        return (share - by_chance) / (1 - by_chance) if by_chance < 1 else 1.0

    return Retest(
        agreement=agreement,
        same_sides=_share(same[sides], level),
        reversed=_share(same[~sides], level),
        kappa=beyond_chance(agreement.share),
        kappa_low=beyond_chance(agreement.low),
        kappa_high=beyond_chance(agreement.high),
        by_person=_by_person(answers, person[first], same, level),
    )


def _repeats(
    answers: Answers, person: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The rows of first and of second answers of a person to a pair."""
    low = np.minimum(answers.left, answers.right)
    high = np.maximum(answers.left, answers.right)
    count = len(answers.stimuli)
    when = np.arange(len(answers)) if answers.time is None else answers.time
    pair = low * count + high
    order = np.lexsort((when, pair, person))
    new = np.ones(len(order), bool)
    new[1:] = (pair[order][1:] != pair[order][:-1]) | (person[order][1:] != person[order][:-1])
    starts = np.flatnonzero(new)
    starts = starts[np.diff(np.append(starts, len(order))) >= 2]
    return order[starts], order[starts + 1]


def _share(same: NDArray[np.bool_], level: float) -> Share | None:
    return Share.of(int(same.sum()), len(same), level) if len(same) else None


def _by_person(
    answers: Answers, person: NDArray[np.int64], same: NDArray[np.bool_], level: float
) -> dict[str, Share]:
    total = np.bincount(person, minlength=len(answers.people))
    agreed = np.bincount(person, weights=same, minlength=len(answers.people))
    return {
        answers.people[index]: Share.of(agreed[index], total[index], level)
        for index in np.flatnonzero(total).tolist()
    }

"""Response time: how long people looked, and whether near pairs took longer."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.number import number_of, row_of
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.given import answers_of
from nacreous.scaling.rank import rank_correlation
from nacreous.value import value_class

#: Nobody sees two pictures, compares them and presses a key in less: simple reactions to light
#: alone take about 0.2 s (R. D. Luce, Response Times, 1986).
FASTEST_S = 0.2
#: A person with more answers too fast than this share did not look.
MOST_FAST = 0.1


@value_class
class ResponseTime:
    """Seconds until the answer.

    - `median_s`: of all answers with a time, `answers` of them; `by_person` {} where unknown
    - `too_fast`: int64, the rows of answers faster than `fastest_s`
    - `hasty`: people with more than a tenth of their answers too fast
    - `correlation`, `p_value`: Spearman's rank correlation of the time with the distance on the
      scale, where one was given: below 0 where near pairs took longer, as they do for people who
      look. None without a scale, or where either does not vary. The p-value takes answers as
      independent.
    """

    median_s: float
    answers: int
    by_person: Mapping[str, float]
    fastest_s: float
    too_fast: NDArray[np.int64]
    hasty: tuple[str, ...]
    correlation: float | None
    p_value: float | None


def response_time(
    answers: Any, scale: ArrayLike | None = None, fastest_s: float = FASTEST_S
) -> ResponseTime | None:
    """Medians, hasty answers, and the relation to `scale` [n]; None where no time is known.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.

    >>> table = {"left": ["a"] * 3, "right": ["b"] * 3, "chosen": ["a"] * 3}
    >>> table["response_s"] = [0.9, 0.1, 1.2]
    >>> time = response_time(Answers.of_table(table))
    >>> time.median_s, time.too_fast.tolist()
    (0.9, [1])
    """
    answers = answers_of(answers)
    limit = number_of("fastest_s", fastest_s)
    if not 0 <= limit <= 3600:
        raise InputError(f"fastest_s is {limit:g}; allowed: 0 to 3600")
    if answers.response_s is None or np.all(np.isnan(answers.response_s)):
        return None
    timed = np.flatnonzero(~np.isnan(answers.response_s))
    seconds = answers.response_s[timed]
    fast = seconds < limit
    by_person, hasty = _people(answers, timed, seconds, fast)
    correlation, p_value = _relation(answers, timed, seconds, scale)
    return ResponseTime(
        median_s=float(np.median(seconds)),
        answers=len(seconds),
        by_person=by_person,
        fastest_s=limit,
        too_fast=timed[fast],
        hasty=hasty,
        correlation=correlation,
        p_value=p_value,
    )


def _people(
    answers: Answers,
    timed: NDArray[np.int64],
    seconds: NDArray[np.float64],
    fast: NDArray[np.bool_],
) -> tuple[dict[str, float], tuple[str, ...]]:
    if answers.person is None:
        return {}, ()
    person = answers.person[timed]
    order = np.argsort(person, kind="stable")
    count = np.bincount(person)
    here = np.flatnonzero(count)
    labels = [answers.people[index] for index in here.tolist()]
    own = np.split(seconds[order], np.cumsum(count[here])[:-1])
    share = np.bincount(person, weights=fast)[here] / count[here]
    medians = {label: float(np.median(part)) for label, part in zip(labels, own, strict=True)}
    return medians, tuple(labels[index] for index in np.flatnonzero(share > MOST_FAST).tolist())


def _relation(
    answers: Answers,
    timed: NDArray[np.int64],
    seconds: NDArray[np.float64],
    scale: ArrayLike | None,
) -> tuple[float | None, float | None]:
    if scale is None:
        return None, None
    values = row_of("scale", scale)
    if len(values) != len(answers.stimuli) or not np.all(np.isfinite(values)):
        raise InputError(f"scale has {len(values)} values; allowed: {len(answers.stimuli)}, finite")
    distance = np.abs(values[answers.left] - values[answers.right])[timed]
    if len(seconds) < 3 or np.ptp(seconds) == 0 or np.ptp(distance) == 0:
        return None, None
    return rank_correlation(distance, seconds)

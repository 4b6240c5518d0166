"""People as clusters: a covariance that lets the answers of one person hang together."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous._core import PairModel, PersonalAnswers
from nacreous.problem import InputError

if TYPE_CHECKING:
    from nacreous.scaling.data.answers import Answers

Array = NDArray[np.float64]


def personal(answers: Answers | None) -> PersonalAnswers:
    """The answers with who gave them, as the compiled room holds them."""
    if answers is None or answers.person is None:
        raise InputError("it is not known who gave the answers; allowed: answers with people")
    here, person = np.unique(answers.person, return_inverse=True)
    if len(here) < 2:
        raise InputError(f"the answers are those of {len(here)} person; allowed: 2 or more people")
    return PersonalAnswers(
        len(answers.stimuli),
        np.ascontiguousarray(answers.left, np.int64),
        np.ascontiguousarray(answers.right, np.int64),
        np.ascontiguousarray(answers.outcome, np.int8),
        np.ascontiguousarray(person, np.int64),
        len(here),
    )


def sandwich(model: PairModel, answers: Answers | None, parameters: Array, inverse: Array) -> Array:
    """Covariance of the parameters with people as clusters (Liang and Zeger 1986).

    The inverse information, on both sides of the sum of squares of each person's score, times
    C / (C - 1) for C people.
    """
    scores = model.scores(personal(answers), parameters)
    people = len(scores)
    meat = scores.T @ scores * (people / (people - 1))
    return np.asarray(inverse @ meat @ inverse)

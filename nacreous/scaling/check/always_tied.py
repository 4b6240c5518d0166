"""People who never chose: every answer of theirs was a tie."""

from __future__ import annotations

from typing import Any

import numpy as np

from nacreous.scaling.data.given import answers_of
from nacreous.scaling.data.person import known_people
from nacreous.value import value_class

__all__ = ["AlwaysTied", "always_tied"]

#: Fewer answers name nobody; nor does what more than 1 of 100 such people would do by chance.
_LEAST_ANSWERS, _CHANCE = 3, 0.01


@value_class
class AlwaysTied:
    """A person who never chose, and how many of all the ties are theirs."""

    person: str
    ties: int
    of: int


def always_tied(answers: Any) -> tuple[AlwaysTied, ...]:
    """Those of 3 answers or more who never chose, where others tie too seldom for that.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.
    As often as all who chose something tie, fewer than 1 of 100 would never choose by chance.
    Raises `InputError` where people are unknown.

    >>> table = {"left": list("aaba"), "right": list("bccb"), "chosen": ["tie", "tie", "tie", "a"]}
    >>> always_tied(table | {"person": ["mika", "mika", "mika", "jun"]})
    (AlwaysTied(person='mika', ties=3, of=3),)
    """
    answers = answers_of(answers)
    person, count = known_people(answers), len(answers.people)
    tie = answers.outcome == 0
    asked = np.bincount(person, minlength=count)
    ties = np.bincount(person, tie, count).astype(np.int64)
    never = (ties == asked) & (asked > 0)
    others = int(asked[~never].sum())
    usual = float(ties[~never].sum()) / others if others else 1.0
    named = never & (asked >= _LEAST_ANSWERS) & (usual**asked < _CHANCE)
    return tuple(
        AlwaysTied(answers.people[at], int(ties[at]), int(tie.sum()))
        for at in np.flatnonzero(named)
    )

"""The consistency of each person, from that person's own answers."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.triads import Triads, circular_triads
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.person import known_people
from nacreous.value import value_class


@value_class
class PersonalTriads:
    """The circular triads of one person, who gave so many `answers`."""

    person: str
    answers: int
    triads: Triads


def triads_by_person(answers: Answers) -> tuple[PersonalTriads, ...]:
    """Circular triads and zeta of each person, in the order of `answers.people`.

    A person's zeta is None unless that person compared every pair of those stimuli that the person
    saw at all, and preferred one of a pair. People who saw fewer than three are left out.

    >>> table = {"left": ["a", "b", "c"], "right": ["b", "c", "a"], "chosen": ["a", "b", "c"]}
    >>> table["person"] = ["mika"] * 3
    >>> mika, = triads_by_person(Answers.of_table(table))
    >>> mika.person, mika.triads.circular
    ('mika', 1.0)
    """
    found = []
    for person, rows in rows_by_person(answers):
        part = answers.take(rows)
        seen, codes = np.unique(np.concatenate([part.left, part.right]), return_inverse=True)
        if len(seen) >= 3:
            stimuli = tuple(answers.stimuli[index] for index in seen)
            left, right = codes[: len(part)], codes[len(part) :]
            own = Answers(stimuli, left, right, part.outcome, sided=part.sided)
            found.append(PersonalTriads(person, len(part), circular_triads(own)))
    return tuple(found)


def rows_by_person(answers: Answers) -> Iterator[tuple[str, NDArray[np.int64]]]:
    """Each person's label and the rows of that person's answers; or one clear message."""
    person = known_people(answers)
    order = np.argsort(person, kind="stable")
    ends = np.searchsorted(person[order], np.arange(len(answers.people) + 1))
    for index, label in enumerate(answers.people):
        rows = order[ends[index] : ends[index + 1]]
        if len(rows):
            yield label, rows

"""The consistency of each person, from that person's own answers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.tournament import EQUAL, Shares
from nacreous.scaling.check.triads import Triads, triads_of
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.given import answers_of
from nacreous.scaling.data.person import known_people
from nacreous.scaling.fit.blocks import blocks_of
from nacreous.value import value_class


@value_class
class PersonalTriads:
    """The circular triads of one person, who gave so many `answers`."""

    person: str
    answers: int
    triads: Triads


def triads_by_person(answers: Any) -> tuple[PersonalTriads, ...]:
    """Circular triads and zeta of each person, in the order of `answers.people`.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.
    A person's zeta is None unless that person compared every pair of those stimuli that the person
    saw at all, and preferred one of a pair. People who saw fewer than three are left out.

    >>> table = {"left": ["a", "b", "c"], "right": ["b", "c", "a"], "chosen": ["a", "b", "c"]}
    >>> table["person"] = ["mika"] * 3
    >>> mika, = triads_by_person(Answers.of_table(table))
    >>> mika.person, mika.triads.circular
    ('mika', 1.0)
    """
    answers = answers_of(answers)
    blocks = blocks_of(answers)
    share = blocks.chosen / blocks.answers
    beats = np.where(np.abs(share - 0.5) < EQUAL, 0.5, share > 0.5)
    ends = np.searchsorted(blocks.person, np.arange(len(blocks.people) + 1))
    asked = np.bincount(blocks.person, blocks.answers).astype(np.int64)
    found = []
    for at, person in enumerate(blocks.people):
        own = slice(ends[at], ends[at + 1])
        pair = blocks.pair[own]
        triads = _triads(blocks.stimuli, blocks.first[pair], blocks.second[pair], beats[own])
        if triads is not None:
            found.append(PersonalTriads(person, int(asked[at]), triads))
    return tuple(found)


def _triads(
    stimuli: tuple[str, ...], first: NDArray[np.int64], second: NDArray[np.int64], beats: Any
) -> Triads | None:
    """Of one person's majorities; None of fewer than three stimuli."""
    seen = np.flatnonzero(
        np.bincount(first, minlength=len(stimuli)) + np.bincount(second, minlength=len(stimuli))
    )
    if len(seen) < 3:
        return None
    place = np.zeros(len(stimuli), np.int64)
    place[seen] = np.arange(len(seen))
    shares = Shares(len(seen), place[first], place[second], beats)
    return triads_of(shares, tuple(stimuli[index] for index in seen))


def rows_by_person(answers: Answers) -> Iterator[tuple[str, NDArray[np.int64]]]:
    """Each person's label and the rows of that person's answers; or one clear message."""
    person = known_people(answers)
    order = np.argsort(person, kind="stable")
    ends = np.searchsorted(person[order], np.arange(len(answers.people) + 1))
    for index, label in enumerate(answers.people):
        rows = order[ends[index] : ends[index + 1]]
        if len(rows):
            yield label, rows

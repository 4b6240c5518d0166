"""Answers by person and pair: what all comparisons of people with each other start from."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.person import known_people

Array = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class OnLeft:
    """Of the blocks, what was answered with the first of the pair on the left, float64 [block]."""

    answers: Array
    chosen: Array
    tied: Array


@dataclass(frozen=True, eq=False)
class Blocks:
    """One row a block: all that one person answered about one pair, sorted by person.

    - `stimuli`, `people`: labels; only people who answered
    - `person`, `pair`: int64 [block], indices into people and into pairs
    - `first`, `second`: int64 [pair], indices into stimuli, first < second
    - `answers`: float64 [block], how often the pair was answered; `chosen`: how often the first was
      chosen, a tie counting half; `tied`: how often it was a tie
    - `width`: float64 [person], in z, how near two things are that the person calls equal; None
      where all are taken to be alike in this
    - `on_left`: the answers with the first on the left; None where left and right are no places
    - `expected`: float64 [block], the choices of the first expected of this person, where a side
      draws people; None where that is not looked at
    """

    stimuli: tuple[str, ...]
    people: tuple[str, ...]
    person: Index
    pair: Index
    first: Index
    second: Index
    answers: Array
    chosen: Array
    tied: Array
    width: Array | None = None
    on_left: OnLeft | None = None
    expected: Array | None = None

    @property
    def share(self) -> Array:
        """float64 [pair], how often the first of a pair was chosen by all people together."""
        pairs = len(self.first)
        chosen = np.bincount(self.pair, self.chosen, pairs)
        return np.asarray(chosen / np.bincount(self.pair, self.answers, pairs))

    @property
    def residual(self) -> Array:
        """float64 [block], by how much `chosen` exceeds what all people together would give.

        Where people have widths of ties or pulls of the side, what all would give at this person's.
        """
        if self.expected is not None:
            return np.asarray(self.chosen - self.expected)
        from nacreous.scaling.fit.own_ties import own_shares

        share = self.share[self.pair] if self.width is None else own_shares(self, self.width)
        return np.asarray(self.chosen - self.answers * share)

    def leads(self, values: Array) -> Array:
        """float64 [..., pair], the lead of first over second for values [..., stimulus]."""
        return np.asarray(values[..., self.first] - values[..., self.second])

    def metric(self) -> Array:
        """float64 [stimulus, r], L with L L' the inverse of how far the slopes of people vary.

        A person's slopes are the sum of residual times (+1 at the first, -1 at the second). Their
        covariance, summed over people whose answers to a pair are dealt at random, is the sum over
        blocks of residual² d d'; it has no inverse along values that no pair tells apart.
        """
        count = len(self.stimuli)
        varied = np.bincount(self.pair, self.residual**2, len(self.first))
        total = np.zeros((count, count))
        total[self.first, self.second] = total[self.second, self.first] = -varied
        np.fill_diagonal(total, -total.sum(axis=1))
        values, vectors = np.linalg.eigh(total)
        kept = values > 1e-9 * max(float(values[-1]), 1e-300)
        return np.asarray(vectors[:, kept] / np.sqrt(values[kept]))


def blocks_of(answers: Answers) -> Blocks:
    """The blocks of answers whose people are known; raises `InputError` where they are not.

    >>> table = {"left": ["a", "b"], "right": ["b", "a"], "chosen": ["a", "tie"]}
    >>> blocks = blocks_of(Answers.of_table(table | {"person": ["mika", "mika"]}))
    >>> blocks.answers, blocks.chosen
    (array([2.]), array([1.5]))
    """
    here, person = numbered(known_people(answers), len(answers.people))
    count = len(answers.stimuli)
    first = np.minimum(answers.left, answers.right)
    second = np.maximum(answers.left, answers.right)
    pairs, pair = numbered(first * count + second, count**2)
    choice = np.where(answers.left > answers.right, -answers.outcome, answers.outcome)
    block, row = numbered(person * len(pairs) + pair, len(here) * len(pairs))
    left = (answers.left == first).astype(np.float64)
    on_left = (left, left * (choice + 1) / 2, left * (choice == 0))
    return Blocks(
        stimuli=answers.stimuli,
        people=tuple(answers.people[index] for index in here),
        person=block // len(pairs),
        pair=block % len(pairs),
        first=pairs // count,
        second=pairs % count,
        answers=np.bincount(row).astype(np.float64),
        chosen=np.asarray(np.bincount(row, (choice + 1) / 2), np.float64),
        tied=np.asarray(np.bincount(row, choice == 0), np.float64),
        on_left=OnLeft(*(np.asarray(np.bincount(row, each), np.float64) for each in on_left))
        if answers.sided
        else None,
    )


def numbered(codes: Index, most: int) -> tuple[Index, Index]:
    """The different codes in order, and each one's place among them; codes: from 0 to below most.

    >>> [found.tolist() for found in numbered(np.array([7, 3, 7]), 8)]
    [[3, 7], [1, 0, 1]]
    """
    if most > 4 * len(codes) + 1000:
        found, place = np.unique(codes, return_inverse=True)
        return found, place
    there = np.zeros(most, np.bool_)  # marking is faster than sorting, and takes less memory
    there[codes] = True
    place = np.cumsum(there, dtype=np.int32)
    place -= 1
    return np.flatnonzero(there), place[codes].astype(np.int64)

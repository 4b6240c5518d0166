"""How the side draws each person, which is no part of a scale.

Whom the left one draws, whatever stands there, has shares nearer to a half than others of the same
scale where sides were tossed, and would pass for less sharp. Where pairs stood both ways round,
people are therefore held against what is expected of someone who answered the left and the right
ones as they did: the mean over a person's pull, given the answers, of what all give at that pull.
How pulls are distributed among people is learnt from all of them, without a form (N. Laird, JASA
73 (1978) 805-811), so that the expectation is right on average however much each one's own is off.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.fit.blocks import Array, Blocks
from nacreous.scaling.fit.side import LEAST_EXCHANGED

__all__ = ["OwnSides", "drawn_by_side", "with_own_sides"]

#: Pulls that people may have, in z.
_PULLS = np.linspace(-4.0, 4.0, 17)
#: Leads follow from the pulls and pulls from leads so often; steps of the pulls' weights between.
_ROUNDS, _STEPS = 12, 10
#: Leads in z beyond which nothing changes any more, and the longest step of one.
_FARTHEST, _LONGEST = 20.0, 1.0
#: So many people tell the leads and how pulls are distributed; as many are held at a time.
_AT_ONCE = 2000
#: As of so many people more the distribution in all people counts in that of a part **(ours)**.
_OF_ALL = 4


def _tells(blocks: Blocks) -> bool:
    """Whether left and right are places, and enough pairs stood both ways round to tell a pull."""
    if blocks.on_left is None:
        return False
    pairs = len(blocks.first)
    left = np.bincount(blocks.pair, blocks.on_left.answers, pairs)
    right = np.bincount(blocks.pair, blocks.answers, pairs) - left
    return bool(2 * np.minimum(left, right).sum() >= LEAST_EXCHANGED * (left + right).sum())


def with_own_sides(blocks: Blocks) -> Blocks:
    """The blocks with what is expected of each person at a pull of the side of one's own.

    Widths of ties that people have stay as they are. Where the answers tell no pull, so do the
    blocks.
    """
    sides = OwnSides.of(blocks)
    return blocks if sides is None else sides.held()


@dataclass(frozen=True, eq=False)
class OwnSides:
    """What answers tell of people's pulls.

    `leads`: of pairs, in z; `weights`: of each pull among all people; `likelihood`: float64
    [person, pull], of a person's answers, the largest of each being 1.
    """

    blocks: Blocks
    leads: Array
    weights: Array
    likelihood: Array

    @classmethod
    def of(cls, blocks: Blocks) -> OwnSides | None:
        """None where the answers tell no pull."""
        if not _tells(blocks):
            return None
        people = len(blocks.people)
        some = np.zeros(people, np.bool_)
        some[np.linspace(0, people - 1, min(people, _AT_ONCE)).astype(np.int64)] = True
        leads, weights = _learnt(_Cells.of(blocks, some[blocks.person]), len(blocks.first))
        parts = [cells.likelihood(leads) for cells in _at_a_time(blocks)]
        return cls(blocks, leads, weights, np.vstack(parts))

    def held(self, part: NDArray[np.int64] | None = None) -> Blocks:
        """The blocks with what is expected of each person.

        part: int64 [person], parts of the people in each of which pulls are distributed in another
        way, learnt from its people, and that of all as if of a few people more; so a part
        that is drawn more than the others is not taken for less sharp.
        """
        blocks, people = self.blocks, len(self.likelihood)
        pulls = self._pulls(np.zeros(people, np.int64) if part is None else part)
        expected = np.zeros(len(blocks.person))
        start = 0
        for cells in _at_a_time(blocks):
            share = cells.half(self.leads) * pulls[start + cells.person]
            expected += np.bincount(cells.block, cells.asked * share.sum(axis=1), len(expected))
            start += cells.people
        # What all together gave is what is expected of all together, pair by pair.
        pairs = len(blocks.first)
        gap = np.bincount(blocks.pair, blocks.chosen - expected, pairs) / np.bincount(
            blocks.pair, blocks.answers, pairs
        )
        return replace(blocks, expected=expected + blocks.answers * gap[blocks.pair])

    def _pulls(self, part: NDArray[np.int64]) -> Array:
        """float64 [person, pull], how likely each pull is of a person, given the answers."""
        count = np.bincount(part)[:, None]
        weights = np.tile(self.weights, (len(count), 1))
        found = _given(weights[part], self.likelihood)
        for _ in range(_ROUNDS * _STEPS if len(count) > 1 else 0):
            sums = np.zeros_like(weights)
            np.add.at(sums, part, found)
            weights = (sums + _OF_ALL * self.weights) / (count + _OF_ALL)
            found = _given(weights[part], self.likelihood)
        return found


def _at_a_time(blocks: Blocks) -> Iterator[_Cells]:
    """The cells of so many people at a time as memory bears."""
    for start in range(0, len(blocks.people), _AT_ONCE):
        yield _Cells.of(blocks, (blocks.person >= start) & (blocks.person < start + _AT_ONCE))


def _given(weights: Array, likelihood: Array) -> Array:
    """How likely each pull is, given the answers, float64 [person, pull]."""
    found = weights * likelihood
    return np.asarray(found / found.sum(axis=1, keepdims=True))


def drawn_by_side(blocks: Blocks) -> Array:
    """float64 [person], by how many more choices of the left one than its pairs' shares give."""
    if blocks.on_left is None:
        return np.zeros(len(blocks.people))
    left, share = blocks.on_left, blocks.share[blocks.pair]
    right = blocks.answers - left.answers
    for_left = left.chosen - left.answers * share
    for_right = right * share - (blocks.chosen - left.chosen)
    return np.asarray(np.bincount(blocks.person, for_left + for_right, len(blocks.people)))


@dataclass(frozen=True, eq=False)
class _Cells:
    """What people answered to pairs one way round; `sign` is 1 where the first stood left, or -1.

    `won`, `tied`, `lost`: of the first; `width`: of ties, in z, [cell, 1].
    """

    block: NDArray[np.int64]
    person: NDArray[np.int64]
    pair: NDArray[np.int64]
    sign: Array
    asked: Array
    won: Array
    tied: Array
    width: Array
    people: int

    @classmethod
    def of(cls, blocks: Blocks, rows: NDArray[np.bool_]) -> _Cells:
        """The cells of some blocks."""
        left = blocks.on_left
        if left is None:
            raise ValueError("blocks without sides")
        block = np.tile(np.flatnonzero(rows), 2)
        sign = np.repeat([1.0, -1.0], len(block) // 2)
        whole = (blocks.answers, blocks.chosen, blocks.tied)
        parts = zip(whole, (left.answers, left.chosen, left.tied), strict=True)
        one, two = np.split(block, 2)
        counts = [np.append(part[one], all_[two] - part[two]) for all_, part in parts]
        kept = counts[0] > 0
        asked, chosen, tied = (count[kept] for count in counts)
        block, sign = block[kept], sign[kept]
        _, person = np.unique(blocks.person[block], return_inverse=True)
        width = np.zeros(len(block)) if blocks.width is None else blocks.width[blocks.person[block]]
        return cls(
            block,
            person,
            blocks.pair[block],
            sign,
            asked,
            chosen - tied / 2,
            tied,
            np.minimum(width, 2 * _FARTHEST)[:, None],
            int(person.max(initial=-1)) + 1,
        )

    def half(self, leads: Array) -> Array:
        """float64 [cell, pull], the share of the first, a tie counting half."""
        won, lost = self._chances(leads)
        return np.asarray((1 + won - lost) / 2)

    def likelihood(self, leads: Array) -> Array:
        """float64 [person, pull], of a person's answers; the largest of each person is 1."""
        won, lost = (np.maximum(chance, 1e-300) for chance in self._chances(leads))
        tied = np.maximum(1 - won - lost, 1e-300)
        of_cell = self.won[:, None] * np.log(won) + self.tied[:, None] * np.log(tied)
        of_cell += (self.asked - self.won - self.tied)[:, None] * np.log(lost)
        found = np.zeros((self.people, len(_PULLS)))
        for at in range(len(_PULLS)):
            found[:, at] = np.bincount(self.person, of_cell[:, at], self.people)
        return np.asarray(np.exp(found - found.max(axis=1, keepdims=True)))

    def _chances(self, leads: Array) -> tuple[Array, Array]:
        """That the first is chosen, and that the second is."""
        from scipy.special import ndtr

        lead = leads[self.pair][:, None] + self.sign[:, None] * _PULLS
        return np.asarray(ndtr(lead - self.width)), np.asarray(ndtr(-lead - self.width))


def _learnt(cells: _Cells, pairs: int) -> tuple[Array, Array]:
    """Leads of pairs, in z, and the weight of each pull among people, the likeliest by EM.

    The normal distribution the weights start from counts as one person's, so that none is lost.
    """
    leads, people = np.zeros(pairs), cells.people
    start = np.exp(-(_PULLS**2) / 2)
    weights = start = start / start.sum()
    given = np.asarray(np.bincount(cells.pair, cells.won + cells.tied / 2, pairs), np.float64)
    for _ in range(_ROUNDS):
        likelihood = cells.likelihood(leads)
        for _ in range(_STEPS):
            weights = (_given(weights, likelihood).sum(axis=0) + start) / (people + 1)
        pull = _given(weights, likelihood)[cells.person]
        leads = _moved(cells, leads, pull, given)
    return leads, weights


def _moved(cells: _Cells, leads: Array, pull: Array, given: Array) -> Array:
    """Leads a step of Newton's nearer to where all together are expected to choose as they did."""
    count = len(leads)
    step = 1e-4
    made, more = (
        np.bincount(cells.pair, cells.asked * (cells.half(at) * pull).sum(axis=1), count)
        for at in (leads, leads + step)
    )
    change = step * (given - made) / np.maximum(more - made, 1e-9)
    moved = leads + np.clip(change, -_LONGEST, _LONGEST)
    return np.asarray(np.clip(moved, -_FARTHEST, _FARTHEST))

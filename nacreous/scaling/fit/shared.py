"""Do all people share one scale? Their answers dealt anew to each other, pair by pair."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.fit.blocks import Array, Blocks, blocks_of
from nacreous.scaling.fit.case_v import thurstone
from nacreous.value import value_class

__all__ = ["MOST_STIMULI", "SharedScale", "shared_scale"]

#: Beyond, matrices of stimuli by stimuli take longer than anyone waits.
MOST_STIMULI = 500
#: Numbers dealt at a time: 32 MB of them.
_AT_ONCE = 1 << 22
#: Standard deviations below 0 beyond which 1 of 100 tossing coins would be called reversed.
_REVERSED = -2.326


@value_class
class SharedScale:
    """Whether people share one scale, as `shared_scale` tested it.

    - `people`, `permutations`: how many there are, and how often answers were dealt anew
    - `p_value`: how often people who share one scale differ as much; least 1 / (permutations + 1)
    - `z`: by how many standard deviations of the dealt ones the true people differ more
    - `sharper_p_value`: the same for the part of the differences that lies along the scale of all:
      some people tell the stimuli apart more sharply than others, or **the other way round**
    - `order_p_value`: the same for the part across it: people have other orders or distances
    - `reversed`: people who chose against the scale of all more than 99 of 100 coin-tossers would
    """

    people: int
    permutations: int
    p_value: float
    z: float
    sharper_p_value: float
    order_p_value: float
    reversed: tuple[str, ...]

    def differ(self, level: float = 0.95) -> bool:
        """Whether people differ by more than chance, at a level."""
        return self.p_value < 1 - level

    def verdict(self, level: float = 0.95) -> str:
        """What was found, in a line.

        >>> import nacreous as nc
        >>> own = nc.scaling.simulate([0.8, 0.0, -0.8], people=60, person_spread=1.0, seed=1)
        >>> nc.scaling.shared_scale(own).verdict()
        'people do not share one scale, p 0.001 (other orders)'
        """
        if not self.differ(level):
            return f"nothing says that people do not share one scale, p {self.p_value:.2g}"
        ways = ["other orders"] if self.order_p_value < 1 - level else []
        ways += ["sharper, or the other way round"] if self.sharper_p_value < 1 - level else []
        way = f" ({'; '.join(ways)})" if ways else ""
        return f"people do not share one scale, p {self.p_value:.3g}{way}"


def shared_scale(answers: Answers, permutations: int = 999, seed: int = 1) -> SharedScale:
    """Test whether all people judge by one scale, by dealing answers anew within each pair.

    The statistic is the sum over people of g' V^-1 g, with g the slopes of a person's answers
    against the shares of all people, and V their covariance where answers are dealt at random.
    Products of a person's answers to the same pair are left out, and such answers are dealt
    together: that people remember what they said is no scale of their own. The test is exact for
    any number of people, with ties, repeats, missing pairs and pairs of one's own, under no model
    of choice; only where it is split does a scale of all people tell along from across. An
    effect of the side that differs between people is found too.

    permutations: 99 to 1 000 000. Raises `InputError` where people are unknown, where no two
    answered the same pair, where all agree on every pair, and beyond 500 stimuli.

    >>> import nacreous as nc
    >>> alike = nc.scaling.simulate([1.0, 0.0, -1.0], people=40, seed=3)
    >>> nc.scaling.shared_scale(alike).differ()
    False
    """
    whole_of("permutations", permutations, 99, 1_000_000)
    blocks = blocks_of(answers)
    if len(blocks.stimuli) > MOST_STIMULI:
        raise InputError(f"{len(blocks.stimuli)} stimuli; allowed: at most {MOST_STIMULI}")
    strata = _strata(blocks)
    if not strata:
        raise InputError(
            "no two people answered the same pair in different ways; "
            "allowed: pairs that two or more people answered, and not all alike"
        )
    leads = blocks.leads(thurstone(answers, prior=1.0).scale)
    metric = _along_first(blocks, leads)
    true = _statistics(blocks, metric, blocks.residual[None])[0]
    dealt = np.concatenate(
        [
            _statistics(blocks, metric, values)
            for values in _deals(blocks.residual, strata, permutations, seed_of(seed))
        ]
    )
    # Whole, along, across; a deal that repeats the true one must count, whatever rounding says.
    margin = 1e-9 * np.abs(true).max()
    p_values = (1 + (dealt >= true - margin).sum(axis=0)) / (1 + permutations)
    spread = float(dealt[:, 0].std())
    return SharedScale(
        people=len(blocks.people),
        permutations=permutations,
        p_value=float(p_values[0]),
        z=float((true[0] - dealt[:, 0].mean()) / spread) if spread > 0 else 0.0,
        sharper_p_value=float(p_values[1]),
        order_p_value=float(p_values[2]),
        reversed=_reversed(blocks, leads),
    )


def _strata(blocks: Blocks) -> list[NDArray[np.int64]]:
    """Blocks that may be exchanged, int64 [stratum, size]: of one pair, answered as often.

    Strata of a size stand together; those in which nothing can change are left out.
    """
    _, code = np.unique(
        np.stack([blocks.pair, blocks.answers.astype(np.int64)]), axis=1, return_inverse=True
    )
    order = np.argsort(code.ravel(), kind="stable")
    starts = np.flatnonzero(np.diff(code.ravel()[order], prepend=-1))
    by_size: dict[int, list[NDArray[np.int64]]] = {}
    for rows in np.split(order, starts[1:]):
        if np.ptp(blocks.residual[rows]) > 1e-9:
            by_size.setdefault(len(rows), []).append(rows)
    return [np.stack(by_size[size]) for size in sorted(by_size)]


def _deals(
    values: Array, strata: list[NDArray[np.int64]], permutations: int, seed: int
) -> Iterator[Array]:
    """Values dealt anew within strata, float64 [deal, block], as many as memory bears."""
    random = np.random.default_rng(seed)
    at_once = max(1, _AT_ONCE // len(values))
    for start in range(0, permutations, at_once):
        count = min(at_once, permutations - start)
        dealt = np.tile(values, (count, 1))
        for rows in strata:
            lots = np.broadcast_to(values[rows], (count, *rows.shape))
            dealt[:, rows] = random.permuted(lots, axis=2)
        yield dealt


def _along_first(blocks: Blocks, leads: Array) -> Array:
    """The metric turned so that its first axis is the way in which sharper people differ.

    Of people whose values are s times those of all, the share of a pair changes with ln s by lead
    times phi(lead).
    """
    metric = blocks.metric()
    asked = np.bincount(blocks.pair, blocks.answers, len(leads))
    change = asked * leads * np.exp(-(leads**2) / 2)
    slopes = np.zeros(len(blocks.stimuli))
    np.add.at(slopes, blocks.first, change)
    np.add.at(slopes, blocks.second, -change)
    along = metric.T @ slopes
    size = np.linalg.norm(along)
    if size == 0:
        return metric
    turn, _ = np.linalg.qr(np.column_stack([along / size, np.eye(len(along))]))
    return np.asarray(metric @ turn)


def _statistics(blocks: Blocks, metric: Array, dealt: Array) -> Array:
    """The statistic of each deal: whole, along and across the scale of all, [deal, 3]."""
    found = np.zeros((len(dealt), 3))
    ends = np.searchsorted(blocks.person, np.arange(len(blocks.people) + 1))
    rows = metric[blocks.first[blocks.pair]] - metric[blocks.second[blocks.pair]]
    for begin, end in pairwise(ends.tolist()):
        own, asked = dealt[:, begin:end], rows[begin:end]
        squares = (own @ asked) ** 2 - own**2 @ asked**2
        found[:, 0] += squares.sum(axis=1)
        found[:, 1] += squares[:, 0]
    found[:, 2] = found[:, 0] - found[:, 1]
    return found


def _reversed(blocks: Blocks, leads: Array) -> tuple[str, ...]:
    """People who choose against the scale of all: against tosses of a coin, 1 of 100 would."""
    lead, count = leads[blocks.pair], len(blocks.people)
    gain = np.bincount(blocks.person, (blocks.chosen - blocks.answers / 2) * lead, count)
    error = np.sqrt(np.bincount(blocks.person, blocks.answers * lead**2 / 4, count))
    against = gain < _REVERSED * np.maximum(error, 1e-12)
    return tuple(blocks.people[index] for index in np.flatnonzero(against))

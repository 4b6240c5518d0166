"""Transitivity of shares: of those who prefer a to b and b to c, how many prefer a to c.

D. Davidson and J. Marschak, Experimental tests of a stochastic decision theory (1959): with
p(a, b) and p(b, c) both at least 1/2, p(a, c) is at least 1/2 (weak), the smaller of the two
(moderate), or the larger (strong stochastic transitivity). Thurstone's and Bradley and Terry's
models have the strong one.
"""

from __future__ import annotations

from itertools import permutations
from math import comb
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of
from nacreous.scaling.check.tournament import EQUAL, shares_of
from nacreous.scaling.data.given import comparisons_of
from nacreous.value import value_class

#: Up to so many triads, 200 stimuli, each is looked at; beyond, as many are drawn.
MOST_TRIADS = 1_313_400
MOST_NAMED = 20


class Violation(NamedTuple):
    """A triad in its order of preference, with its three shares: how many preferred which."""

    triad: tuple[str, str, str]
    first_over_second: float
    second_over_third: float
    first_over_third: float
    kind: str


@value_class
class Transitivity:
    """How many triads of `triads` violate transitivity.

    A weak violation is also a moderate, and a moderate one also a strong. `triads` counts those of
    which all three pairs were compared. `sampled`: there are too many to look at all, and the
    counts are of a random sample. `worst` names the first weak, then moderate, then strong ones.
    """

    weak: int
    moderate: int
    strong: int
    triads: int
    sampled: bool
    worst: tuple[Violation, ...]


def transitivity(data: Any, seed: int = 1) -> Transitivity:
    """Look for violations in whatever `comparisons_of` takes, of 3 or more stimuli.

    A tie counts half for each; where equal shares leave more than one order of a triad open, the
    order with the mildest violation counts. Beyond 200 stimuli 1 313 400 triads are drawn at random
    with the `seed`. Chance alone makes violations where shares are near each other: take the
    numbers as a description, and `goodness` as the test.

    >>> cycle = transitivity([("a", "b"), ("b", "c"), ("c", "a")])
    >>> cycle.weak, cycle.triads
    (1, 1)
    """
    seed = seed_of(seed)
    comparisons = comparisons_of(data)
    shares = shares_of(comparisons)
    sampled = comb(shares.stimuli, 3) > MOST_TRIADS
    triads = _drawn(shares.stimuli, seed) if sampled else _all(shares.stimuli)
    first, second, third = triads.T
    share = np.stack(
        [shares.of(first, second), shares.of(first, third), shares.of(second, third)], axis=1
    )
    compared = ~np.isnan(share).any(axis=1)
    triads, share = triads[compared], share[compared]
    level, order = _levels(share)
    return Transitivity(
        weak=int(np.count_nonzero(level >= 3)),
        moderate=int(np.count_nonzero(level >= 2)),
        strong=int(np.count_nonzero(level >= 1)),
        triads=len(triads),
        sampled=sampled,
        worst=_worst(share, triads, level, order, comparisons.stimuli),
    )


_ORDERS = tuple(permutations(range(3)))
_KINDS = ("", "strong", "moderate", "weak")


def _all(count: int) -> NDArray[np.int64]:
    """All triads first < second < third, [triad, 3]."""
    second, third = np.triu_indices(count, 1)
    # The pairs (second, third) in which second > first are the last of the list.
    starts = len(second) - np.array([comb(count - 1 - first, 2) for first in range(count)])
    rows = [
        np.stack([np.full(len(second) - start, first), second[start:], third[start:]], axis=1)
        for first, start in enumerate(starts)
    ]
    return np.concatenate(rows)


def _drawn(count: int, seed: int) -> NDArray[np.int64]:
    """Triads at random, each as likely, [triad, 3]."""
    triads = np.sort(np.random.default_rng(seed).integers(0, count, (MOST_TRIADS, 3)), axis=1)
    return triads[(triads[:, 0] < triads[:, 1]) & (triads[:, 1] < triads[:, 2])]


def _over(share: NDArray[np.float64], one: int, other: int) -> NDArray[np.float64]:
    """The share that chose one place of a triad over another; `share` has 0-1, 0-2 and 1-2."""
    low, high = min(one, other), max(one, other)
    column = share[..., low + high - 1]
    return column if one < other else 1 - column


def _levels(share: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """For each triad 3 weak, 2 moderate, 1 strong violation, 0 none; and in which order."""
    level = np.full(len(share), 9, np.int64)
    best = np.zeros(len(share), np.int64)
    for index, (a, b, c) in enumerate(_ORDERS):
        ab, bc, ac = _over(share, a, b), _over(share, b, c), _over(share, a, c)
        here = (
            (ac < np.maximum(ab, bc) - EQUAL).astype(np.int64)
            + (ac < np.minimum(ab, bc) - EQUAL)
            + (ac < 0.5 - EQUAL)
        )
        better = (ab >= 0.5 - EQUAL) & (bc >= 0.5 - EQUAL) & (here < level)
        level[better], best[better] = here[better], index
    return level, best


def _worst(
    share: NDArray[np.float64],
    triads: NDArray[np.int64],
    level: NDArray[np.int64],
    order: NDArray[np.int64],
    stimuli: tuple[str, ...],
) -> tuple[Violation, ...]:
    rows = np.flatnonzero(level)
    rows = rows[np.argsort(-level[rows], kind="stable")][:MOST_NAMED]
    found = []
    for row in rows.tolist():
        a, b, c = _ORDERS[order[row]]
        own = share[row]
        shares = (float(_over(own, a, b)), float(_over(own, b, c)), float(_over(own, a, c)))
        triad = (stimuli[triads[row, a]], stimuli[triads[row, b]], stimuli[triads[row, c]])
        found.append(Violation(triad, *shares, _KINDS[level[row]]))
    return tuple(found)

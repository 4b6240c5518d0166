"""What chance does to an honest person: repeats answered otherwise, choices in circles, a side."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.distribution import binom

__all__ = ["at_least", "circles_by_chance", "one_sided"]

#: Simulated sets of answers by which circles are judged; always the same ones.
_DRAWS = 2000
_SEED = 1940


def at_least(count: int, chances: Sequence[float]) -> float:
    """The chance that so many or more of independent events happen, each with its own chance.

    >>> round(at_least(2, [0.5, 0.5, 0.5]), 6)
    0.5
    """
    ways = np.ones(1)
    for chance in chances:
        ways = np.convolve(ways, [1 - chance, chance])
    return float(np.sum(ways[count:]))


def one_sided(lefts: int, total: int) -> float:
    """The chance that one side is chosen so often or more, whichever it is, where none draws.

    The exact binomial test. Sides are balanced for every participant, so honest people vary less.

    >>> one_sided(10, 10) == 2 / 2**10
    True
    """
    return float(min(1.0, 2 * binom.cdf(min(lefts, total - lefts), total, 0.5)))


def circles_by_chance(shares: NDArray[np.float64], stream: int = 0) -> NDArray[np.int64]:
    """Circular triads of simulated people who compare all pairs once, one number a person.

    shares: float64 [n, n], how often i is chosen over j. stream: of random numbers; others for
    other questions to the same people.

    >>> coins = np.full((3, 3), 0.5)
    >>> abs(float(np.mean(circles_by_chance(coins))) - 0.25) < 0.05
    True
    """
    count = len(shares)
    first, second = np.triu_indices(count, 1)
    random = np.random.default_rng([_SEED, stream])
    won = random.random((_DRAWS, len(first))) < shares[first, second]
    wins = np.zeros((_DRAWS, count), np.int64)
    for pair, (i, j) in enumerate(zip(first.tolist(), second.tolist(), strict=True)):
        wins[:, i] += won[:, pair]
        wins[:, j] += ~won[:, pair]
    # Kendall and Babington Smith 1940, equation (1).
    sure = count * (count - 1) * (2 * count - 1) // 6
    return np.asarray((sure - np.sum(wins**2, axis=1)) // 2, np.int64)

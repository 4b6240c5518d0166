"""Who beats whom: the shares of answers by pair, as triads and transitivity need them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons

#: Shares nearer to each other than this are equal: the same fraction, computed another way.
EQUAL = 1e-9


class Shares(NamedTuple):
    """Pairs first < second in the order of (first, second), and the share that chose the first."""

    stimuli: int
    first: NDArray[np.int64]
    second: NDArray[np.int64]
    share: NDArray[np.float64]

    def of(self, first: NDArray[np.int64], second: NDArray[np.int64]) -> NDArray[np.float64]:
        """The shares of some pairs first < second; NaN where nobody compared them."""
        codes = self.first * self.stimuli + self.second
        asked = first * self.stimuli + second
        row = np.minimum(np.searchsorted(codes, asked), len(codes) - 1)
        return np.where(codes[row] == asked, self.share[row], np.nan)

    @property
    def majority(self) -> NDArray[np.float64]:
        """float64 [pair]: 1 where most chose the first, 0 where most chose the second, else 0.5."""
        even = np.abs(self.share - 0.5) < EQUAL
        return np.where(even, 0.5, (self.share > 0.5).astype(np.float64))


def shares_of(comparisons: Comparisons) -> Shares:
    """The shares of three or more stimuli. A tie counts as half an answer for each.

    >>> shares_of(Comparisons.of_counts([[0, 3, 0], [1, 0, 2], [0, 2, 0]])).share.tolist()
    [0.75, 0.5]
    """
    count = len(comparisons.stimuli)
    if count < 3:
        raise InputError(f"{count} stimuli; allowed: 3 or more, for triads")
    pairs = comparisons.unsided()
    total = pairs.left_wins + pairs.right_wins + pairs.ties
    return Shares(count, pairs.left, pairs.right, (pairs.left_wins + pairs.ties / 2) / total)

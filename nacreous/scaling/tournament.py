"""Who beats whom: the majority of answers by pair, as triads and transitivity need it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.comparisons import Comparisons

#: Shares nearer to each other than this are equal: the same fraction, computed another way.
EQUAL = 1e-9


def preference(comparisons: Comparisons) -> NDArray[np.float64]:
    """float64 [n, n]: the share that chose i over j, NaN where nobody compared them.

    A tie counts as half an answer for each.

    >>> preference(Comparisons.of_counts([[0, 3], [1, 0]]))
    array([[ nan, 0.75],
           [0.25,  nan]])
    """
    wins, ties = comparisons.matrix, comparisons.tie_matrix
    wins += ties / 2
    total = wins + wins.T
    with np.errstate(invalid="ignore"):
        return np.where(total > 0, wins / total, np.nan)


def majority(comparisons: Comparisons) -> NDArray[np.float64]:
    """float64 [n, n]: 1 where most chose i over j, 0 where most chose j, 0.5 where as many did.

    NaN where nobody compared them, and on the diagonal.
    """
    share = preference(comparisons)
    with np.errstate(invalid="ignore"):
        even = np.abs(share - 0.5) < EQUAL
        return np.where(np.isnan(share), np.nan, np.where(even, 0.5, (share > 0.5).astype(float)))


def check_three(comparisons: Comparisons) -> None:
    """Refuse two stimuli, which have no triad."""
    if len(comparisons.stimuli) < 3:
        raise InputError(f"{len(comparisons.stimuli)} stimuli; allowed: 3 or more, for triads")

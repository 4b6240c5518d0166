"""Ranks, and how far two columns have the same ones."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.distribution import t

__all__ = ["rank_correlation", "ranks"]

Array = NDArray[np.float64]


def ranks(values: Array) -> Array:
    """float64 [n], from 1 for the smallest; equal values share their mean rank.

    >>> ranks(np.array([0.5, 2.0, 0.5, 9.0])).tolist()
    [1.5, 3.0, 1.5, 4.0]
    """
    _, which, count = np.unique(values, return_inverse=True, return_counts=True)
    return np.asarray((np.cumsum(count) - (count - 1) / 2)[which], np.float64)


def rank_correlation(one: Array, two: Array) -> tuple[float, float]:
    """Spearman's correlation of two columns, and its p value by Student's t.

    Both have three values or more, which are not all equal.


    >>> value, p = rank_correlation(np.array([1.0, 2, 3, 4]), np.array([1.0, 9, 8, 10]))
    >>> round(value, 6), round(p, 6)
    (0.8, 0.2)
    """
    value = float(np.corrcoef(ranks(one), ranks(two))[0, 1])
    free = len(one) - 2
    if abs(value) >= 1:
        return value, 0.0
    lever = abs(value) * (free / ((1 + value) * (1 - value))) ** 0.5
    return value, float(2 * t.sf(lever, free))

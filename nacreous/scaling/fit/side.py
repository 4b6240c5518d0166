"""Whether the pull of the side is fitted in each group where groups are compared.

A side that pulls draws shares of tossed sides nearer to a half, so that people whom it pulls more
would pass for less sharp.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.fit.existence import pair_model

__all__ = ["LEAST_EXCHANGED", "fits_side", "tells_side"]

#: Of the answers of each group, such a share has a partner with the sides exchanged **(ours)**:
#: half of them have where two people saw each pair with tossed sides.
LEAST_EXCHANGED = 0.25


def fits_side(order: bool | None, data: Sequence[Comparisons], link: str, ties: bool) -> bool:
    """Whether to fit the pull of the side: as asked for, or where each group's answers tell it.

    data: all groups that are to be fitted alike; ties: whether their width is fitted.

    >>> counts = Comparisons.of_counts([[0, 30], [20, 0]])  # which says nothing of sides
    >>> fits_side(None, [counts], "probit", ties=False)
    False
    """
    if order is None:
        return all(tells_side(each, link, ties) for each in data)
    if not isinstance(order, bool):
        raise InputError(f"order is {said(order)}; allowed: True, False, None")
    return order


def tells_side(comparisons: Comparisons, link: str, ties: bool) -> bool:
    """Whether answers tell the pull of the side: pairs stood both ways round, and it is finite."""
    if not comparisons.sided or _exchanged(comparisons) < LEAST_EXCHANGED:
        return False
    return pair_model(comparisons, link, ties, True).existence() not in ("order", "ties")


def _exchanged(comparisons: Comparisons) -> float:
    """The share of answers that have a partner with the sides exchanged."""
    left, right = comparisons.left, comparisons.right
    answers = comparisons.left_wins + comparisons.right_wins + comparisons.ties
    _, pair = np.unique(
        np.minimum(left, right) * len(comparisons.stimuli) + np.maximum(left, right),
        return_inverse=True,
    )
    unpaired = np.abs(np.bincount(pair, np.where(left < right, answers, -answers))).sum()
    return float(1 - unpaired / answers.sum())

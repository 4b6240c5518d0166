"""Whether ties are answers of their own: the default where they are more than a few.

A tie that counts half is an answer without chance in it. Shares of pairs then vary less than those
of tossed coins, and the test of fit is too lenient. With no more than a few that is nothing, and no
threshold need be fitted.
"""

from __future__ import annotations

from collections.abc import Sequence

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.fit.existence import pair_model

__all__ = ["FEW", "fits_ties"]

#: Ties are a few up to this share of the answers: variances are then right within a twentieth.
FEW = 0.05


def fits_ties(ties: bool | None, data: Sequence[Comparisons], link: str, order: bool) -> bool:
    """Whether to fit how wide ties are: as asked for, or where ties are more than a few.

    data: all groups that are to be fitted alike. None also asks that each has a finite threshold;
    a group without a tie, which may have been offered none, has the threshold 0.

    >>> counts = Comparisons.of_counts([[0, 30], [20, 0]], [[0, 9], [9, 0]])
    >>> fits_ties(None, [counts], "probit", order=False)
    True
    """
    if ties is not None:
        if not isinstance(ties, bool):
            raise InputError(f"ties is {said(ties)}; allowed: True, False, None")
        return ties
    tied = sum(float(each.ties.sum()) for each in data)
    if tied <= FEW * sum(each.total for each in data):
        return False
    return all(
        not each.ties.any()
        or pair_model(each, link, True, order).existence() not in ("ties", "order")
        for each in data
    )

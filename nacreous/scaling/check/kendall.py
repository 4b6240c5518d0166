"""How far people agree: Kendall's u.

M. G. Kendall and B. Babington Smith, On the method of paired comparisons, Biometrika 31 (1940).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import comparisons_of
from nacreous.value import value_class


@value_class
class Agreement:
    """Kendall's coefficient of agreement and its test against tossing coins.

    - `u`: 1 where all gave the same answers, about 0 where they answered at random; `least` is the
      smallest that so many answers can have
    - `statistic`, `df`, `p_value`: chi-squared, corrected for continuity, where every pair has the
      same number of answers (Kendall's). Otherwise (`equal` is False) the sum over pairs of
      (wins - losses)² / answers, with as many degrees of freedom as pairs.
    - `pairs`, `answers`: how many were used
    """

    u: float
    least: float
    statistic: float
    df: float
    p_value: float
    equal: bool
    pairs: int
    answers: float


def agreement(data: Any) -> Agreement:
    """Kendall's u of whatever `comparisons_of` takes. Ties are left out.

    Pairs with one answer say nothing about agreement and do not count. Raises `InputError` where no
    pair has two.

    >>> round(agreement([("a", "b"), ("a", "b"), ("b", "a")]).u, 3)
    -0.333
    """
    from scipy.stats import chi2

    counts = comparisons_of(data).unsided()
    total = counts.left_wins + counts.right_wins
    used = total >= 2
    if not used.any():
        raise InputError("no pair has two answers without a tie; allowed: 2 or more, to agree on")
    total, wins = total[used], counts.left_wins[used]
    losses = total - wins
    agreeing = float(np.sum(wins * (wins - 1) + losses * (losses - 1)) / 2)
    possible = float(np.sum(total * (total - 1)) / 2)
    half = np.floor(total / 2)
    fewest = float(np.sum(half * (half - 1) + (total - half) * (total - half - 1)) / 2)
    pairs, each = len(total), float(total[0])
    equal = bool(np.all(total == each)) and each > 2
    if equal:
        df = pairs * each * (each - 1) / (each - 2) ** 2
        excess = agreeing - 1 - possible / 2 * (each - 3) / (each - 2)
        statistic = max(0.0, 4 / (each - 2) * excess)
    else:
        df = float(pairs)
        statistic = float(np.sum((wins - losses) ** 2 / total))
    return Agreement(
        u=2 * agreeing / possible - 1,
        least=2 * fewest / possible - 1,
        statistic=statistic,
        df=df,
        p_value=float(chi2.sf(statistic, df)),
        equal=equal,
        pairs=pairs,
        answers=float(total.sum()),
    )

"""How far people agree who ranked the same trays: Kendall's W.

M. G. Kendall, B. Babington Smith, The problem of m rankings, Annals of Mathematical Statistics 10
(1939), 275.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said, seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.rankings import Rankings
from nacreous.scaling.distribution import chi2
from nacreous.value import value_class

__all__ = ["Concordance", "concordance"]

Index = NDArray[np.int64]

#: Numbers that are held at a time.
_NUMBERS = 1 << 22


@value_class
class Concordance:
    """Kendall's coefficient of concordance and its test, as `concordance` found it.

    - `w`: 1 where all ranked alike, 0 where the sums of ranks are equal; by chance about
      1 / rankings of a tray. Of several trays the weighted mean, each with its greatest sum of
      squares
    - `p_value`: how often people who rank at random agree as well, by shuffling each ranking; least
      1 / (permutations + 1)
    - `statistic`, `df`: chi-squared, Friedman's, which a p value of tables goes with
    - `rankings`, `trays`: how many were used, and of how many sets of stimuli; `left_out`: those in
      part, or of a set that nobody else ranked
    """

    w: float
    p_value: float
    statistic: float
    df: int
    rankings: int
    trays: int
    left_out: int

    @property
    def chi_squared_p_value(self) -> float:
        """By the chi-squared distribution; too large with few rankings."""
        return float(chi2.sf(self.statistic, self.df))


@dataclass(frozen=True, eq=False)
class _Set:
    """Rankings of one set of stimuli, as ranks from 0, int64 [ranking, stimulus]."""

    ranks: Index

    def squares(self, ranks: Index) -> NDArray[np.float64]:
        """Sums of squares of the sums of ranks about their mean, of [..., ranking, stimulus]."""
        sums = ranks.sum(axis=-2)
        middle = ranks.shape[-2] * (ranks.shape[-1] - 1) / 2
        return np.asarray(((sums - middle) ** 2).sum(axis=-1), np.float64)

    @property
    def most(self) -> float:
        """The greatest sum there can be."""
        count, size = self.ranks.shape
        return float(count**2 * (size**3 - size)) / 12


def concordance(rankings: Rankings, permutations: int = 9999, seed: int = 1) -> Concordance:
    """Kendall's W of people who put the same trays wholly in order.

    permutations: 99 to 1 000 000; seed: 0 to 2^63 - 1. Raises `InputError` for best and worst,
    where no two whole rankings are of the same stimuli, and where a person ranked a tray twice:
    that someone agrees with themselves is no agreement.

    >>> from nacreous.scaling import Rankings
    >>> found = concordance(Rankings.of_lists([["a", "b", "c"], ["a", "c", "b"], ["b", "a", "c"]]))
    >>> round(found.w, 3), round(found.p_value, 1)
    (0.444, 0.4)
    """
    if not isinstance(rankings, Rankings):
        raise InputError(f"the rankings are {said(rankings)}; allowed: Rankings")
    if rankings.task != "ranking":
        raise InputError("only best and worst were named; allowed here: whole rankings")
    whole_of("permutations", permutations, 99, 1_000_000)
    seed = seed_of(seed)
    sets = _sets(rankings)
    most = sum(each.most for each in sets)
    true = sum(float(each.squares(each.ranks)) for each in sets)
    dealt = np.zeros(permutations)
    random = np.random.default_rng(seed)
    for each in sets:
        at_once = max(1, _NUMBERS // each.ranks.size)
        for start in range(0, permutations, at_once):
            count = min(at_once, permutations - start)
            lots = random.permuted(np.broadcast_to(each.ranks, (count, *each.ranks.shape)), axis=2)
            dealt[start : start + count] += each.squares(lots)
    used = sum(len(each.ranks) for each in sets)
    statistic = sum(
        12 * float(each.squares(each.ranks)) / (count * size * (size + 1))
        for each in sets
        for count, size in [each.ranks.shape]
    )
    return Concordance(
        w=true / most,
        p_value=float(1 + (dealt >= true * (1 - 1e-9)).sum()) / (1 + permutations),
        statistic=statistic,
        df=sum(each.ranks.shape[1] - 1 for each in sets),
        rankings=used,
        trays=len(sets),
        left_out=len(rankings) - used,
    )


def _sets(rankings: Rankings) -> list[_Set]:
    """Whole rankings by what lay on the tray, where two or more are of the same."""
    found: dict[tuple[int, ...], list[tuple[list[int], int]]] = {}
    starts, sizes = rankings.starts.tolist(), rankings.sizes.tolist()
    for tray in np.flatnonzero(rankings.ordered == rankings.sizes).tolist():
        items = rankings.items[starts[tray] : starts[tray] + sizes[tray]]
        who = -1 if rankings.person is None else int(rankings.person[tray])
        order = np.argsort(items)  # the place of each stimulus, in the order of the stimuli
        found.setdefault(tuple(np.sort(items).tolist()), []).append((order.tolist(), who))
    sets = []
    for same in found.values():
        people = [who for _, who in same if who >= 0]
        if len(set(people)) < len(people):
            twice = next(who for at, who in enumerate(people) if who in people[:at])
            raise InputError(
                f"{quoted(rankings.people[twice])} ranked the same stimuli twice; allowed: each "
                "person once a tray"
            )
        if len(same) > 1:
            sets.append(_Set(np.array([order for order, _ in same], np.int64)))
    if not sets:
        raise InputError(
            "no two whole rankings are of the same stimuli; allowed: 2 or more, to agree on"
        )
    return sets

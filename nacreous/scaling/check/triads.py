"""Circular triads: a beats b, b beats c, and yet c beats a.

M. G. Kendall and B. Babington Smith, On the method of paired comparisons, Biometrika 31 (1940).
"""

from __future__ import annotations

from collections import Counter
from dataclasses import field
from functools import cache
from itertools import product
from math import comb
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.circle import count_open
from nacreous.scaling.check.tournament import Shares, shares_of
from nacreous.scaling.data.given import comparisons_of
from nacreous.scaling.distribution import chi2
from nacreous.value import value_class

#: Up to so many stimuli chance is counted out exactly.
MOST_EXACT = 10
#: Circular triads are listed by name up to this many stimuli.
MOST_LISTED = 100


@value_class
class Triads:
    """How many triads go round in a circle.

    - `circular`: their number; with tied pairs, the mean over breaking every tie by a coin
    - `complete`: triads of which all three pairs were compared; `tied`: pairs without a majority
    - `most`: the largest number of circular triads that so many stimuli can have
    - `zeta`: Kendall's coefficient of consistence, 1 - circular / most; 1: none, 0: as many as
      can be. None unless every pair was compared and one of them has a majority.
    - `p_value`: how often coin-tossers would have so few circular triads, or fewer: exact to
      10 stimuli without ties (and to 4 with), else from Kendall's chi-squared; None where zeta is
    - `wins`: float64 [n], how many others each beats, a tie counting half
    - `stimuli`: labels; `won`: bool [n, n], whether the row's beat the column's, up to 100 stimuli
    """

    circular: float
    complete: int
    tied: int
    most: int
    zeta: float | None
    p_value: float | None
    wins: NDArray[np.float64]
    stimuli: tuple[str, ...] = field(repr=False)
    won: NDArray[np.bool_] = field(repr=False)

    @property
    def untied(self) -> int:
        """How many circular triads `named` lists."""
        won = self.won.astype(np.float64)  # each circle stands in the trace of the cube three times
        return round(float(np.sum((won @ won) * won.T)) / 3)

    @property
    def named(self) -> tuple[tuple[str, str, str], ...]:
        """The circular triads as labels, (a, b, c) with a over b over c over a.

        Only up to 100 stimuli, and only those without ties. Worked out when asked for: of
        thousands of people they are millions.
        """
        found = []
        for first in range(len(self.won)):
            later = np.arange(len(self.won)) > first
            # first over second, second over third, third over first
            closed = self.won & np.outer(self.won[first] & later, self.won[:, first] & later)
            found += [(first, *pair) for pair in np.argwhere(closed).tolist()]
        names = self.stimuli
        return tuple((names[i], names[j], names[k]) for i, j, k in found)


def circular_triads(data: Any) -> Triads:
    """Count the circular triads in the majority of all answers.

    `data` is whatever `comparisons_of` takes, of 3 or more stimuli.

    >>> triads = circular_triads([("a", "b"), ("b", "c"), ("c", "a")])
    >>> triads.circular, triads.zeta, triads.named
    (1.0, 0.0, (('a', 'b', 'c'),))
    """
    comparisons = comparisons_of(data)
    return triads_of(shares_of(comparisons), comparisons.stimuli)


def triads_of(shares: Shares, stimuli: tuple[str, ...]) -> Triads:
    """The same, of shares of three or more stimuli, and of the labels of these."""
    count, beats = shares.stimuli, shares.majority
    table = np.zeros((count, count))
    table[shares.first, shares.second] = beats
    table[shares.second, shares.first] = 1 - beats
    wins = table.sum(axis=1)
    tied = int(np.count_nonzero(beats == 0.5))
    most = most_circular(count)
    full = len(beats) == comb(count, 2)
    told = full and tied < len(beats)  # coins alone have no consistency
    if full:
        circular, complete = circular_of(wins, tied), comb(count, 3)
    elif count <= MOST_LISTED:
        circular, complete = _counted(table, shares)
    else:
        circular, complete = count_open(shares)
    return Triads(
        circular=circular,
        complete=complete,
        tied=tied,
        most=most,
        zeta=1 - circular / most if told else None,
        p_value=chance(count, circular, tied) if told else None,
        wins=wins,
        stimuli=stimuli,
        won=(table == 1) if count <= MOST_LISTED else np.zeros((0, 0), bool),
    )


def _counted(table: NDArray[np.float64], shares: Shares) -> tuple[float, int]:
    """As `count_open`, from few stimuli's table of who beats whom, ties being halves."""
    met = np.zeros(table.shape)
    met[shares.first, shares.second] = met[shares.second, shares.first] = 1
    # Each circle stands in the trace of the cube three times; products of halves are exact.
    circular = float(np.sum((table @ table) * table.T)) / 3
    return circular, round(float(np.sum((met @ met) * met)) / 6)


def circular_of(wins: NDArray[np.float64], tied: int) -> float:
    """Circular triads where every pair was compared, from how many others each beats.

    wins: float64 [n], a tie counting half. tied: pairs without a majority, broken by coins.

    >>> circular_of(np.array([1.0, 1.0, 1.0]), 0)
    1.0
    """
    count = len(wins)
    # Equation (1) there, less what the coins of ties add to the variance of wins.
    circular = count * (count - 1) * (2 * count - 1) / 12 - float(wins @ wins) / 2 - tied / 4
    return max(0.0, circular)


def most_circular(count: int) -> int:
    """The largest number of circular triads among so many stimuli.

    >>> [most_circular(count) for count in (3, 4, 7)]
    [1, 2, 14]
    """
    return (count**3 - (4 if count % 2 == 0 else 1) * count) // 24


def chance(count: int, circular: float, tied: int = 0) -> float:
    """How often tosses of a coin give so few circular triads, or fewer.

    >>> round(chance(7, 1) * 2**21)
    13440
    """
    if count <= 4 or (count <= MOST_EXACT and tied == 0):  # the approximation needs five
        few = sum(number for triads, number in _ways(count).items() if triads <= circular)
        return few / float(2 ** comb(count, 2))
    df = count * (count - 1) * (count - 2) / (count - 4) ** 2
    # Kendall's half, with the sign that makes it "or fewer": for 8 to 10 stimuli
    # this is within 0.025 of the exact counts, and the printed + 1/2 only within 0.12.
    statistic = 8 / (count - 4) * (comb(count, 3) / 4 - circular - 0.5) + df
    return float(chi2.sf(statistic, df))


@cache
def _ways(count: int) -> dict[int, int]:
    """The number of tournaments by their circular triads.

    One stimulus after the other meets all that remain. Only how many have won how often matters.
    """
    states = Counter({((0,) * count, 0): 1})
    for _ in range(count):
        after: Counter[tuple[tuple[int, ...], int]] = Counter()
        for (won, squares), number in states.items():
            first, rest = won[0], won[1:]
            levels = sorted(set(rest))
            sizes = [rest.count(level) for level in levels]
            for lost in product(*(range(size + 1) for size in sizes)):
                ways, following = number, []
                for level, size, beaten in zip(levels, sizes, lost, strict=True):
                    ways *= comb(size, beaten)
                    following += [level] * beaten + [level + 1] * (size - beaten)
                total = first + sum(lost)
                after[tuple(sorted(following)), squares + total**2] += ways
        states = after
    sure = count * (count - 1) * (2 * count - 1) // 6
    result: Counter[int] = Counter()
    for (_, squares), number in states.items():
        result[(sure - squares) // 2] += number
    return dict(result)

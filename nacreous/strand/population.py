"""Pearls drawn from a population of stated means and spreads."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of, whole_of, within
from nacreous.problem import InputError
from nacreous.spec.complaint import nearest, shown
from nacreous.strand.lot import MOST_PEARLS, QUANTITIES, Lot
from nacreous.value import value_class

__all__ = ["AKOYA", "LEAST_INSIDE", "Population"]

#: The least share of a population that its quantities' ranges must hold **(ours)**: of less, what
#: is drawn has little of the mean and the spread that were asked for.
LEAST_INSIDE = 0.1

Array = NDArray[np.float64]

_NAMES = [quantity.name for quantity in QUANTITIES]


@value_class
class Population:
    """Means and standard deviations of what a lot's pearls have, by the names of `QUANTITIES`.

    Each is drawn by itself from a normal distribution; the facets' spread, whose words go by equal
    ratios, from a log-normal one: its mean is the median, its spread that of the natural logarithm.
    What falls out of a quantity's range is drawn again within it. Raises `InputError`, also where
    less than `LEAST_INSIDE` of a quantity falls into its range.
    """

    mean: Mapping[str, float]
    deviation: Mapping[str, float]

    def __post_init__(self) -> None:
        """Check everything."""
        for name, given in (("mean", self.mean), ("deviation", self.deviation)):
            if set(given) != set(_NAMES):
                raise InputError(
                    f"{name} has {', '.join(given) or 'nothing'}; allowed: {', '.join(_NAMES)}"
                )
        for quantity in QUANTITIES:
            name = quantity.name
            within(f"mean {name}", self.mean[name], quantity.least, quantity.most)
            within(f"spread {name}", self.deviation[name], 0, 100)
        least, most = self._ends()
        for quantity, share in zip(QUANTITIES, _shares(least, most)[1], strict=True):
            if share < LEAST_INSIDE:
                raise InputError(
                    f"spread {quantity.name} is {self.deviation[quantity.name]:g}, with which "
                    f"{share:.1%} of the pearls are within {quantity.allowed}; allowed: a spread "
                    f"that leaves {LEAST_INSIDE:.0%} there"
                )

    def replace(self, mean: Mapping[str, float], deviation: Mapping[str, float]) -> Population:
        """With some of the means and deviations changed; another name is refused."""
        for name in (*mean, *deviation):
            if name not in _NAMES:
                near = nearest(name, _NAMES)
                hint = f"did you mean {near}?" if near else f"allowed: {', '.join(_NAMES)}"
                raise InputError(f"{shown(name)} is no quantity of a lot; {hint}")
        return Population({**self.mean, **mean}, {**self.deviation, **deviation})

    def draw(self, count: int, seed: int = 1) -> Lot:
        """So many pearls. The first ones of a seed are the same, however many are drawn.

        >>> AKOYA.draw(3, seed=7).names == AKOYA.draw(5, seed=7).names[:3]
        True
        """
        count = whole_of("count", count, 1, MOST_PEARLS)
        random = np.random.default_rng(seed_of(seed))
        drawn = _again_within(random.standard_normal((count, len(QUANTITIES))), *self._ends())
        mean, spread = self._arrays()
        values = mean + spread * drawn
        values[:, -1] = mean[-1] * np.exp(spread[-1] * drawn[:, -1])
        ends = np.array([(one.least, one.most) for one in QUANTITIES])
        names = tuple(f"{number:04}" for number in range(1, count + 1))
        return Lot(names, np.clip(values, ends[:, 0], ends[:, 1]))  # the last bit may be beyond

    def _arrays(self) -> tuple[Array, Array]:
        """Float64 [quantity], means and deviations."""
        mean, spread = (
            np.array([float(by[name]) for name in _NAMES]) for by in (self.mean, self.deviation)
        )
        return mean, spread

    def _ends(self) -> tuple[Array, Array]:
        """Float64 [quantity], the ends of the ranges in deviations from the means."""
        mean, spread = self._arrays()
        ends = np.array([(one.least, one.most) for one in QUANTITIES])
        off = ends - mean[:, None]
        off[-1] = np.log(ends[-1] / mean[-1])
        with np.errstate(divide="ignore", invalid="ignore"):
            off /= spread[:, None]
        all_alike = spread == 0
        return np.where(all_alike, -np.inf, off[:, 0]), np.where(all_alike, np.inf, off[:, 1])


def _shares(least: Array, most: Array) -> tuple[Array, Array]:
    """The share of a standard normal distribution below `least`, and that up to `most`."""
    from scipy.special import ndtr

    below = ndtr(least)
    return below, ndtr(most) - below


def _again_within(drawn: Array, least: Array, most: Array) -> Array:
    """Draws from a standard normal distribution, those out of the range drawn again within it.

    How far out in its tail a draw lies is a share between 0 and 1, each as probable, and nothing
    else of it is used: the same share of the range's own distribution is the new draw. So the
    pearls of a seed stay the same, however many are drawn.
    """
    from scipy.special import ndtr, ndtri

    below, inside = _shares(least, most)
    above = ndtr(-most)
    with np.errstate(divide="ignore", invalid="ignore"):
        low, high = ndtr(drawn) / below, ndtr(-drawn) / above
    again = np.where(drawn < least, below + low * inside, below + (1 - high) * inside)
    out = (drawn < least) | (drawn > most)
    found = drawn.copy()
    found[out] = ndtri(again[out])
    return found


#: White to cream Akoya of 7.0 to 7.5 mm before sorting; all numbers **(ours)**, for no survey of a
#: lot was found.
AKOYA = Population(
    {"size_mm": 7.25, "L": 94.0, "a": 0.5, "b": 4.0, "facet_spread_rad": 0.035},
    {"size_mm": 0.25, "L": 1.5, "a": 1.0, "b": 2.0, "facet_spread_rad": 0.25},
)

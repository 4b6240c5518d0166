"""Pearls drawn from a population of stated means and spreads."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from nacreous.number import seed_of, whole_of, within
from nacreous.problem import InputError
from nacreous.spec.complaint import nearest, shown
from nacreous.strand.lot import MOST_PEARLS, QUANTITIES, Lot
from nacreous.value import value_class

__all__ = ["AKOYA", "Population"]

_NAMES = [quantity.name for quantity in QUANTITIES]


@value_class
class Population:
    """Means and standard deviations of what a lot's pearls have, by the names of `QUANTITIES`.

    Each is drawn by itself from a normal distribution; the facets' spread, whose words go by equal
    ratios, from a log-normal one: its mean is the median, its spread that of the natural logarithm.
    What falls out of a quantity's range is put to its end. Raises `InputError`.
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
        drawn = random.standard_normal((count, len(QUANTITIES)))
        mean, spread = (
            np.array([by[name] for name in _NAMES]) for by in (self.mean, self.deviation)
        )
        values = mean + spread * drawn
        values[:, -1] = mean[-1] * np.exp(spread[-1] * drawn[:, -1])
        ends = np.array([(one.least, one.most) for one in QUANTITIES])
        names = tuple(f"{number:04}" for number in range(1, count + 1))
        return Lot(names, np.clip(values, ends[:, 0], ends[:, 1]))


#: White to cream Akoya of 7.0 to 7.5 mm before sorting; all numbers **(ours)**, for no survey of a
#: lot was found.
AKOYA = Population(
    {"size_mm": 7.25, "L": 94.0, "a": 0.5, "b": 4.0, "facet_spread_rad": 0.035},
    {"size_mm": 0.25, "L": 1.5, "a": 1.0, "b": 2.0, "facet_spread_rad": 0.25},
)

"""How well the pearls of a strand match: their differences, and one score."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.strand.lot import Lot
from nacreous.value import value_class

__all__ = ["LUSTER_WEIGHT", "SIZE_WEIGHT_PER_MM", "Matching", "looks_apart", "matching"]

Array = NDArray[np.float64]

#: A tenth of a millimetre counts as much as a CIEDE2000 of 1 **(ours)**: the trade sorts by half
#: millimetres, and one of these counts 5.
SIZE_WEIGHT_PER_MM = 10.0
#: A ratio of e between facets' spreads counts as much as a CIEDE2000 of 5 **(ours)**: from a word
#: for luster to the next counts about 3.
LUSTER_WEIGHT = 5.0

#: Rows of a matrix worked out at once.
_BLOCK = 256


@value_class
class Matching:
    """A strand's differences in mean, each in units of CIEDE2000; 0 for pearls that are all alike.

    neighbours: of pearls side by side. overall: of all pairs. A pair's difference is CIEDE2000 of
    the body colours + `SIZE_WEIGHT_PER_MM` x difference of sizes + `LUSTER_WEIGHT` x difference of
    the logarithms of the facets' spreads. Sizes are counted from those that the strand's form
    wants, so that a graduated strand is not worse for being graduated.
    """

    neighbours: float
    overall: float

    @property
    def score(self) -> float:
        """Half of each **(ours)**: the eye goes along a strand, and takes it in as one."""
        return 0.5 * (self.neighbours + self.overall)

    @property
    def word(self) -> str:
        """The trade's word for the score."""
        from nacreous.trade import word_of

        return word_of("matching", self.score).en


def looks_apart(lot: Lot) -> Array:
    """Float64 [pearl, pearl]: differences of colour and luster of all pairs."""
    apart = np.empty((len(lot), len(lot)))
    for begin in range(0, len(lot), _BLOCK):
        rows = slice(begin, begin + _BLOCK)
        apart[rows] = colour.delta_e_2000(lot.lab[rows, None], lot.lab[None])
    spread = LUSTER_WEIGHT * np.log(lot.facet_spread_rad)
    apart += np.abs(spread[:, None] - spread)
    return apart


def matching(strand: Lot, target_mm: Array) -> Matching:
    """How well a strand's pearls match, in the order in which they hang.

    target_mm: [pearl], the size that the strand's form wants at each place; all the same in an
    even strand.

    >>> twin = [7.2, 94, 0.5, 4, 0.035]
    >>> matching(Lot(("a", "b"), [twin, twin]), np.full(2, 7.25)).score
    0.0
    """
    if len(strand) < 2:
        return Matching(0.0, 0.0)
    off_mm = SIZE_WEIGHT_PER_MM * (strand.size_mm - target_mm)
    apart = looks_apart(strand) + np.abs(off_mm[:, None] - off_mm)
    pairs = len(strand) * (len(strand) - 1)
    return Matching(float(np.diagonal(apart, 1).mean()), float(apart.sum() / pairs))

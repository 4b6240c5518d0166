"""Answers by pair beside what a fit expects of them: the cells of all tests of fit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.scaling.fit.scale import Scale

#: No expected share is smaller, so that a statistic stays a number.
_LEAST = 1e-12


@value_class
class Cells:
    """Observed and expected counts of the outcomes first, second and tie, float64 [row, 3].

    A row is a pair; where the fit has an order effect, a pair one way round. `outcomes` is 3 for
    fits with ties, else 2, and ties are in `observed` by halves. `parameters` counts what was
    fitted, one less than the stimuli among it where the scale is `floating`: without a design.
    """

    stimuli: tuple[str, ...]
    first: NDArray[np.int64]
    second: NDArray[np.int64]
    observed: NDArray[np.float64]
    expected: NDArray[np.float64]
    outcomes: int
    parameters: int
    floating: bool

    @property
    def total(self) -> NDArray[np.float64]:
        """float64 [row], the answers."""
        return np.asarray(self.observed.sum(axis=1))

    @property
    def degrees(self) -> int:
        """Free shares less fitted values; a scale floats freely in each set apart from others."""
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

        count = len(self.stimuli)
        edges = coo_array((np.ones(len(self.first)), (self.first, self.second)), (count, count))
        sets, _ = connected_components(edges, directed=False)
        free = len(self.first) * (self.outcomes - 1)
        return max(0, free - self.parameters + (int(sets) - 1 if self.floating else 0))

    @property
    def g2(self) -> float:
        """Twice the log-likelihood that one free share a row has over the fit."""
        from scipy.special import xlogy

        return max(0.0, float(2 * np.sum(xlogy(self.observed, self.observed / self._least))))

    @property
    def x2(self) -> float:
        """Pearson's chi-squared."""
        cells = slice(0, self.outcomes)
        gap = self.observed[:, cells] - self.expected[:, cells]
        return float(np.sum(gap**2 / self._least[:, cells]))

    @property
    def x2_moments(self) -> tuple[float, float]:
        """Mean and variance of Pearson's chi-squared where the model holds, with so few answers.

        With many they are df and 2 df. The variance of a row of known shares is J. B. S. Haldane's
        (Biometrika 29, 1937). Fitting takes from the mean of a row in proportion to that variance
        and to the row's weight in the fit **(ours)**; simulated studies of 3 answers a pair and
        more agree.
        """
        c = self.outcomes
        shares = self._least[:, :c] / self.total[:, None]
        variance = 2 * (c - 1) + (np.sum(1 / shares, axis=1) - c**2 - 2 * c + 2) / self.total
        weight = self.total * (1 - np.sum(shares**2, axis=1))
        free = len(shares) * (c - 1)
        taken = float(np.average(variance, weights=weight)) / (2 * (c - 1))
        mean = max(1.0, free - (free - self.degrees) * taken)
        return mean, float(np.sum(variance)) * self.degrees / free

    @property
    def unlikely(self) -> NDArray[np.float64]:
        """float64 [row], expected answers other than the likeliest outcome."""
        return np.asarray(self.total - self.expected.max(axis=1))

    def part(self, rows: NDArray[np.bool_]) -> Cells:
        """Some of the rows; stimuli that are in none of them are sets of their own."""
        return Cells(
            stimuli=self.stimuli,
            first=self.first[rows],
            second=self.second[rows],
            observed=self.observed[rows],
            expected=self.expected[rows],
            outcomes=self.outcomes,
            parameters=self.parameters,
            floating=self.floating,
        )

    @property
    def residuals(self) -> NDArray[np.float64]:
        """float64 [row], standard deviations by which the first was chosen too often.

        Among those who chose one, so that it is independent of how many called them equal: X2 is
        the sum of the squares of these and of `tie_residuals`.
        """
        least = self._least
        first, second = least[:, 0], least[:, 1]
        gap = self.observed - self.expected
        size = np.sqrt(first * second * (first + second))
        return np.asarray((gap[:, 0] * second - gap[:, 1] * first) / size)

    @property
    def tie_residuals(self) -> NDArray[np.float64]:
        """float64 [row], standard deviations by which too many are ties; 0 where none can be."""
        if self.outcomes == 2:
            return np.zeros(len(self.first))
        tied, rest = self._least[:, 2], self._least[:, 0] + self._least[:, 1]
        gap = self.observed[:, 2] - self.expected[:, 2]
        return np.asarray(gap / np.sqrt(tied * rest / self.total))

    @property
    def _least(self) -> NDArray[np.float64]:
        return np.maximum(self.expected, _LEAST * self.total[:, None])


def cells_of(fit: Scale) -> Cells:
    """The cells of a fitted scale."""
    counts = fit.comparisons
    ties = fit.tie_threshold is not None and bool(counts.ties.any())
    halves, tied = (0.0, counts.ties) if ties else (counts.ties / 2, np.zeros_like(counts.ties))
    observed = np.stack([counts.left_wins + halves, counts.right_wins + halves, tied], axis=1)
    expected = fit.outcomes() * observed.sum(axis=1, keepdims=True)
    first, second = counts.left, counts.right
    if fit.order_effect is None and counts.sided:
        first, second, (observed, expected) = _folded(first, second, [observed, expected])
    return Cells(
        stimuli=fit.stimuli,
        first=first,
        second=second,
        observed=observed,
        expected=expected,
        outcomes=3 if ties else 2,
        # A threshold without a tie to fit it to costs nothing.
        parameters=fit.free_parameters - (fit.tie_threshold is not None and not ties),
        floating=fit.design is None,
    )


def _folded(
    left: NDArray[np.int64], right: NDArray[np.int64], tables: list[NDArray[np.float64]]
) -> tuple[NDArray[np.int64], NDArray[np.int64], list[NDArray[np.float64]]]:
    """Both ways round of a pair as one row, the lower index first."""
    swapped = left > right
    first, second = np.where(swapped, right, left), np.where(swapped, left, right)
    count = int(second.max()) + 1
    pairs, row = np.unique(first * count + second, return_inverse=True)
    folded = []
    for table in tables:
        turned = np.where(swapped[:, None], table[:, [1, 0, 2]], table)
        summed = np.zeros((len(pairs), 3))
        np.add.at(summed, row, turned)
        folded.append(summed)
    return pairs // count, pairs % count, folded

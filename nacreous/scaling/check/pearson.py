"""Pearson's test of fit, with few answers a pair and beside pairs that are near certain."""

from __future__ import annotations

import numpy as np

from nacreous.scaling.check.cells import Cells
from nacreous.scaling.distribution import chi2, poisson

#: Of a row with fewer expected answers against its likeliest outcome, the squared residual is next
#: to nothing or huge. W. G. Cochran (1954) allows no smaller expectation.
NEAR_CERTAIN = 1.0
#: From this multiple of chi-squared's own variance on, near certain rows make nearly all of it, and
#: no chi-squared has such a mean and such a variance near its mean.
_MOST_VARIANCE = 2.0
#: Share of the risk that goes to the near certain rows (Bonferroni); the others keep the rest.
_OF_CERTAIN = 0.2


def x2_p_value(cells: Cells) -> float | None:
    """Of Pearson's chi-squared; None where nothing is left to test.

    From a chi-squared scaled to the mean and the variance that it has with so few answers. Where
    near certain rows would make that variance, they are tested apart: all of their unlikely answers
    together, as a Poisson count, beside Pearson's of the other rows.
    """
    if cells.degrees == 0:
        return None
    mean, variance = cells.x2_moments
    if variance <= _MOST_VARIANCE * 2 * mean:
        return _scaled(cells)
    certain = cells.unlikely < NEAR_CERTAIN
    if not certain.any():
        return _bounded(cells)
    apart, others = _reversals(cells.part(certain)), cells.part(~certain)
    if others.degrees > 0:
        return min(1.0, apart / _OF_CERTAIN, _bounded(others) / (1 - _OF_CERTAIN))
    return apart if apart < _OF_CERTAIN else None


def _scaled(cells: Cells) -> float:
    mean, variance = cells.x2_moments
    scale = max(variance, 1e-9) / (2 * mean)
    return float(chi2.sf(cells.x2 / scale, mean / scale))


def _bounded(cells: Cells) -> float:
    """No smaller than chi-squared's own, where the scaled one would crowd at 0."""
    mean, variance = cells.x2_moments
    if variance <= _MOST_VARIANCE * 2 * mean:
        return _scaled(cells)
    return max(_scaled(cells), float(chi2.sf(cells.x2, cells.degrees)))


def _reversals(cells: Cells) -> float:
    """Chance of so many answers against the likeliest outcomes, or more."""
    rows, likeliest = np.arange(len(cells.first)), cells.expected.argmax(axis=1)
    found = float(np.sum(cells.total - cells.observed[rows, likeliest]))
    # Ties by halves: rounded down, so that the test errs towards the model.
    return float(poisson.sf(np.floor(found + 1e-9) - 1, np.sum(cells.unlikely)))

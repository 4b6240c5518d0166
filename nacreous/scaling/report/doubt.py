"""How sure the places and the distances are, and which neighbours are told apart."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.uncertainty import holm
from nacreous.scaling.report.settings import Settings
from nacreous.value import value_class

__all__ = ["Doubt", "Neighbours", "doubt_of", "neighbours_of"]

#: From fewer people a bootstrap is rough (B. Efron and R. Tibshirani, 1993, chapter 19).
FEW_PEOPLE = 20


@value_class
class Doubt:
    """Margins of a scale, in its unit.

    `by`: what was resampled, "people" or "answers"; "information" where nothing was. `samples`:
    how often. `intervals` [n, 2], `se` [n], `covariance` [n, n] of the places.
    """

    by: str
    samples: int
    intervals: NDArray[np.float64]
    se: NDArray[np.float64]
    covariance: NDArray[np.float64]


@value_class
class Neighbours:
    """Two things that follow each other on the scale, the higher one first.

    `p_value` is Holm's over all neighbours; `apart`: it is below 1 - level. `expected`: the share
    that should choose the first.
    """

    first: str
    second: str
    difference: float
    low: float
    high: float
    p_value: float
    apart: bool
    expected: float


def doubt_of(
    fit: Scale, settings: Settings, progress: Callable[[float], None] | None = None
) -> Doubt:
    """Resample people where they are known, else answers; without resamplings, trust the model."""
    people = fit.answers is not None and len(fit.answers.people) > 1
    # The row means of 1996 and the fractions of printed tables give nothing to draw from.
    counts = np.stack([fit.comparisons.left_wins, fit.comparisons.right_wins, fit.comparisons.ties])
    if settings.bootstrap == 0 or fit.method == "least-squares" or np.any(counts % 1):
        kind = "people" if people and fit.method == "maximum-likelihood" else "expected"
        covariance = fit.covariance(kind)
        intervals = fit.intervals(settings.level, kind=kind)
        by = "clusters" if kind == "people" else "information"
        return Doubt(by, 0, intervals, np.sqrt(np.diag(covariance)), covariance)
    by = "people" if people else "answers"
    drawn = fit.bootstrap(settings.bootstrap, by=by, seed=settings.seed, progress=progress)
    covariance = drawn.covariance
    return Doubt(by, settings.bootstrap, drawn.intervals(settings.level), drawn.se, covariance)


def neighbours_of(fit: Scale, doubt: Doubt, level: float) -> tuple[Neighbours, ...]:
    """Each thing with the next one down, from the top."""
    from scipy.stats import norm

    order = np.argsort(-fit.scale, kind="stable")
    above, below = order[:-1], order[1:]
    difference = fit.scale[above] - fit.scale[below]
    cov = doubt.covariance
    variance = cov[above, above] + cov[below, below] - 2 * cov[above, below]
    se = np.sqrt(np.maximum(variance, 0.0))
    if not np.all(np.isfinite(se)):
        raise InputError("the margins of the differences have no end; allowed: more answers")
    z = np.divide(difference, se, out=np.zeros_like(se), where=se > 0)
    p_values = holm(2 * norm.sf(z))
    reach = float(norm.ppf((1 + level) / 2)) * se
    share = fit.proportions[above, below]
    return tuple(
        Neighbours(
            fit.stimuli[above[k]],
            fit.stimuli[below[k]],
            float(difference[k]),
            float(difference[k] - reach[k]),
            float(difference[k] + reach[k]),
            float(p_values[k]),
            bool(p_values[k] < 1 - level),
            float(share[k]),
        )
        for k in range(len(above))
    )

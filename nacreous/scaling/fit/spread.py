"""A prior over the spread of the values: how far they are apart is learnt from the answers too.

A normal prior of one spread pulls a scale together by as much as it was told to, rightly only if
the true spread is that one. Here the spread itself has a prior, log-normal about 1 z, on a grid of
eleven from 0.2 to 5 z. At each, the values have a normal posterior (Laplace: the most likely ones,
and the inverse of the observed information); each counts by its prior and by how likely it makes
the answers, values integrated out (Tierney and Kadane 1986). The most likely spread alone would
not do: where answers are few it collapses.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.fit.existence import pair_model
from nacreous.scaling.fit.uncertainty import inverse
from nacreous.scaling.fit.unit import factor
from nacreous.value import value_class

__all__ = ["HIERARCHICAL", "Prior", "SpreadPosterior", "prior_variance", "spread_posterior"]

Array = NDArray[np.float64]

#: What a fit's prior is: none, a spread in the model's own unit, or a prior over the spread.
Prior = float | Literal["hierarchical"] | None

HIERARCHICAL: Literal["hierarchical"] = "hierarchical"
#: Spreads in z **(ours)**: from stimuli that nobody tells apart to such as nobody confuses.
_SPREADS_Z = np.geomspace(0.2, 5.0, 11)
#: Of the logarithm of the spread, about 1 z **(ours)**.
_LOG_SPREAD = 0.8
#: A spread of less weight moves no digit that is printed.
_LEAST_WEIGHT = 1e-5


@value_class
class SpreadPosterior:
    """What the answers tell of the spread, and of the values over all spreads.

    spreads   float64 [k], in the model's own unit; weights: float64 [k], their sum 1
    mean      float64 [parameter], as a fit has them: values, side, ties
    observed  float64 [parameter, parameter], the mean covariance within a spread, by observed
              information; expected: by expected information
    between   float64 [parameter, parameter]: how the parameters move with the spread
    """

    spreads: Array
    weights: Array
    mean: Array
    observed: Array
    expected: Array
    between: Array

    @property
    def spread(self) -> float:
        """The mean spread, in the model's own unit."""
        return float(self.weights @ self.spreads)


def prior_variance(model: str) -> float:
    """Of a value in the model's own unit squared, over all spreads, before there are answers.

    >>> round(prior_variance("probit"), 2)
    2.7
    """
    spreads, weights = _grid(model)
    return float(weights @ spreads**2)


def spread_posterior(
    comparisons: Comparisons, model: str, ties: bool = False, order: bool = False
) -> SpreadPosterior:
    """Fit at each spread, and put the fits together.

    >>> from nacreous.scaling import paper
    >>> found = spread_posterior(paper(), "probit")
    >>> round(found.spread, 1)
    0.8
    """
    spreads, before = _grid(model)
    rooms = [pair_model(comparisons, model, ties, order, spread) for spread in spreads.tolist()]
    fits = [room.fit()[0] for room in rooms]
    count = len(comparisons.stimuli)
    likely = np.array(
        [
            room.log_likelihood(fit)
            - 0.5 * fit[:count] @ fit[:count] / spread**2
            - count * np.log(spread)
            - 0.5 * np.linalg.slogdet(room.information(fit, False))[1]
            for room, fit, spread in zip(rooms, fits, spreads.tolist(), strict=True)
        ]
    )
    likely += np.log(before)
    weights = np.exp(likely - likely.max())
    weights[weights < _LEAST_WEIGHT * weights.sum()] = 0.0
    weights /= weights.sum()
    kept = np.flatnonzero(weights)
    mean = np.sum([weights[k] * fits[k] for k in kept], axis=0)
    observed, expected = (
        np.sum([weights[k] * inverse(rooms[k].information(fits[k], kind)) for k in kept], axis=0)
        for kind in (False, True)
    )
    away = np.stack([np.sqrt(weights[k]) * (fits[k] - mean) for k in kept])
    return SpreadPosterior(spreads, weights, mean, observed, expected, away.T @ away)


def _grid(model: str) -> tuple[Array, Array]:
    """The spreads in the model's own unit, and their weights before there are answers."""
    weights = np.exp(-0.5 * (np.log(_SPREADS_Z) / _LOG_SPREAD) ** 2)
    unit = "z" if model == "probit" else "logit"
    return _SPREADS_Z * factor("z", unit), weights / weights.sum()

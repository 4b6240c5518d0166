"""Bias reduction: a scale that answers do not stretch, and that always is finite.

The most likely scale is too wide on average where answers are few. D. Firth (Biometrika 80 (1993)
27) moves the slope of the likelihood by what its bias would be; for a response of which g(p) is
linear, as here, by h (d2p / dp) / 2 a row, h being the row's leverage (Kosmidis and Firth 2009):
-h e / 2 for probit at a lead e, h (1/2 - p) for logit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous._core import PairModel
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.fit.existence import require_joined
from nacreous.scaling.fit.uncertainty import inverse
from nacreous.scaling.fit.unit import Model

__all__ = ["bias_reduced"]

Array = NDArray[np.float64]

#: One step moves no value further: beyond, all curves are flat.
_LONGEST = 2.0
_MOST_STEPS = 500
_NEAR = 1e-9


def bias_reduced(room: PairModel, comparisons: Comparisons, model: Model, order: bool) -> Array:
    """The parameters, float64: values with mean 0, then the effect of the side where `order`.

    room: the model without a prior and without ties of their own, which count half each. Raises
    `InputError` where answers do not join all stimuli, and where no parameters are found.
    """
    require_joined(comparisons)
    count = len(comparisons.stimuli)
    parameters = np.zeros(count + order)
    for _ in range(_MOST_STEPS):
        covariance = inverse(room.information(parameters, True), count)
        step = covariance @ _slope(comparisons, model, order, parameters, covariance)
        step[:count] -= step[:count].mean()
        length = float(np.abs(step).max())
        parameters = parameters + step * min(1.0, _LONGEST / max(length, _LONGEST))
        if length < _NEAR:
            return parameters
    raise InputError(
        "method is 'bias-reduced', which finds no scale of these answers; allowed: more answers, "
        "or prior='hierarchical'"
    )


def _slope(
    comparisons: Comparisons, model: Model, order: bool, parameters: Array, covariance: Array
) -> Array:
    """The slope of the likelihood, moved by its bias."""
    left, right = comparisons.left, comparisons.right
    count = len(comparisons.stimuli)
    total = comparisons.left_wins + comparisons.right_wins + comparisons.ties
    wins = comparisons.left_wins + comparisons.ties / 2
    lead = parameters[left] - parameters[right]
    own = np.diag(covariance)
    variance = own[left] + own[right] - 2 * covariance[left, right]
    if order:
        lead = lead + parameters[count]
        variance = variance + own[count] + 2 * (covariance[left, count] - covariance[right, count])
    chance, steepness, bent = _curve(lead, model)
    noise = chance * (1 - chance)
    leverage = total * steepness**2 / noise * variance
    pull = (wins - total * chance) * steepness / noise + 0.5 * leverage * bent
    slope = np.zeros(count + order)
    np.add.at(slope, left, pull)
    np.subtract.at(slope, right, pull)
    slope[count:] = pull.sum()
    return slope


def _curve(lead: Array, model: Model) -> tuple[Array, Array, Array]:
    """Chance of the left one, its slope, and how the slope's logarithm changes with the lead."""
    from scipy.special import expit, ndtr

    if model == "logit":
        chance = np.asarray(expit(lead))
        return chance, chance * (1 - chance), 1 - 2 * chance
    # Beyond, both are 1e-300 and their ratio is nothing.
    lead = np.clip(lead, -8.0, 8.0)
    return np.asarray(ndtr(lead)), np.exp(-(lead**2) / 2) / np.sqrt(2 * np.pi), -lead

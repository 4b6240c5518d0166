"""People with values of their own, spread continuously about a mean: one standard deviation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nacreous.scaling.check.link import slopes_at
from nacreous.scaling.distribution import norm
from nacreous.scaling.fit.blocks import Array, Blocks
from nacreous.scaling.fit.unit import factor

__all__ = ["OwnValues", "fit_own_values", "spread_ends"]

#: Standard deviations of people's values among which the most likely is looked for.
_SMALLEST, _LARGEST = 0.01, 10.0
_NEWTON_STEPS = 30
#: Spreads beyond, in z, are not told from each other: people then give nearly sure answers, and
#: Laplace's approximation draws large spreads in (docs/people.md).
_TOLD = 1.5


@dataclass(frozen=True, eq=False)
class OwnValues:
    """The most likely mean of people's values and their spread.

    `values`: float64 [stimulus], mean 0, in the model's own unit; `spread`: the standard deviation
    of a person's value of one stimulus about it, 0.01 to 10; `log_likelihood`: Laplace's
    approximation to the integral over people's values.
    """

    values: Array
    spread: float
    log_likelihood: float


def fit_own_values(blocks: Blocks, model: str = "probit") -> OwnValues:
    """Maximise the marginal likelihood of normal values of one spread about a mean for all people.

    The integral over a person's values is Laplace's approximation at their mode (L. Tierney and
    J. B. Kadane, JASA 81, 1986), the slopes exact.
    """
    from scipy.optimize import minimize

    likelihood = Marginal(blocks, model)
    count = len(blocks.stimuli)
    start = np.append(np.zeros(count), np.log(0.5))
    bounds = [(-50.0, 50.0)] * count + [(np.log(_SMALLEST), np.log(_LARGEST))]
    found = minimize(likelihood.loss, start, jac=True, method="L-BFGS-B", bounds=bounds)
    values = found.x[:-1] - found.x[:-1].mean()
    return OwnValues(values, float(np.exp(found.x[-1])), -float(found.fun))


def spread_ends(
    blocks: Blocks, found: OwnValues, model: str = "probit", level: float = 0.95
) -> tuple[float, float | None]:
    """The interval of the spread by its profile likelihood; None for an upper end not told.

    There the lower end is 1.5 z at most, 2.4 logit: up to that, spreads are told from each other.
    """
    from scipy.optimize import brentq

    deficit = _Deficit(blocks, found, model, level)
    most = _TOLD * factor("z", "z" if model == "probit" else "logit")
    at = float(np.log(min(found.spread, most)))
    ends = [np.log(_SMALLEST), np.log(most), np.log(_LARGEST)]
    low, high, far = (deficit(float(end)) for end in ends)
    told = found.spread < most and high > 0 and far > 0
    upper = float(np.exp(brentq(deficit, at, ends[1], xtol=0.01))) if told else None
    if low <= 0:
        return 0.0, upper
    if deficit(at) >= 0:  # even the largest that can be told is too small
        return most, upper
    return float(np.exp(brentq(deficit, ends[0], at, xtol=0.01))), upper


class _Deficit:
    """By how much more than chance allows a spread is less likely than the most likely one."""

    def __init__(self, blocks: Blocks, found: OwnValues, model: str, level: float) -> None:
        self._blocks, self._found, self._model = blocks, found, model
        self._allowed = float(norm.ppf((1 + level) / 2)) ** 2 / 2  # chi-squared with 1 df

    def __call__(self, log_spread: float) -> float:
        from scipy.optimize import minimize

        likelihood = Marginal(self._blocks, self._model)

        def loss(mean: Array) -> tuple[float, Array]:
            value, slopes = likelihood.loss(np.append(mean, log_spread))
            return value, slopes[:-1]

        bounds = [(-50.0, 50.0)] * len(self._found.values)
        best = minimize(loss, self._found.values, jac=True, method="L-BFGS-B", bounds=bounds)
        return float(best.fun) + self._found.log_likelihood - self._allowed


class Marginal:
    """The marginal likelihood; each call starts from the modes that the last one found."""

    def __init__(self, blocks: Blocks, model: str) -> None:
        self._blocks, self._model = blocks, model
        self._first = blocks.first[blocks.pair]
        self._second = blocks.second[blocks.pair]
        self._passed = blocks.answers - blocks.chosen
        self._shape = (len(blocks.people), len(blocks.stimuli))
        self._mode = np.zeros(self._shape)

    def loss(self, parameters: Array) -> tuple[float, Array]:
        """Minus its logarithm, and the slopes, at (values, ln spread)."""
        mean, log_spread = parameters[:-1], float(parameters[-1])
        precision = float(np.exp(-2 * log_spread))
        off = self._modes(mean, precision)
        log, _, weight, bend = self._at(mean + off)
        count = self._shape[1]
        inverse = np.linalg.inv(self._curvature(weight, precision))
        at, one, two = self._blocks.person, self._first, self._second
        # How far a block's lead varies about the mode, and what that does to the slopes.
        leverage = inverse[at, one, one] + inverse[at, two, two] - 2 * inverse[at, one, two]
        pull = np.einsum("cij,cj->ci", inverse, self._sums(bend * leverage))
        total = float(log.sum() - precision * (off**2).sum() / 2)
        total += float(np.linalg.slogdet(inverse)[1].sum()) / 2
        total -= self._shape[0] * count * log_spread
        d_mean = precision * (off - pull / 2).sum(axis=0)
        trace = float(np.trace(inverse, axis1=1, axis2=2).sum())
        d_spread = precision * (float((off**2).sum()) + trace - float((pull * off).sum()))
        d_spread -= self._shape[0] * count
        return -total, -np.append(d_mean, d_spread)

    def _modes(self, mean: Array, precision: float) -> Array:
        """Each person's most likely departure from the mean, float64 [person, stimulus]."""
        off = self._mode
        for _ in range(_NEWTON_STEPS):
            _, slope, weight, _ = self._at(mean + off)
            gradient = self._sums(slope) - precision * off
            step = np.linalg.solve(self._curvature(weight, precision), gradient[..., None])[..., 0]
            off = off + np.clip(step, -2, 2)
            if np.abs(step).max() < 1e-8:
                break
        self._mode = off
        return off

    def _at(self, own: Array) -> tuple[Array, Array, Array, Array]:
        """By block: log-likelihood, its slope by the lead, minus the second, that one's slope."""
        at = self._blocks.person
        lead = own[at, self._first] - own[at, self._second]
        up, down = slopes_at(lead, self._model), slopes_at(-lead, self._model)
        chosen, passed = self._blocks.chosen, self._passed
        return (
            chosen * up.log + passed * down.log,
            chosen * up.first - passed * down.first,
            -chosen * up.second - passed * down.second,
            -chosen * up.third + passed * down.third,
        )

    def _sums(self, by_block: Array) -> Array:
        """Sums over a person's blocks, + at the first stimulus and - at the second."""
        people, count = self._shape
        base = self._blocks.person * count
        size = people * count
        found = np.bincount(base + self._first, by_block, size)
        return np.asarray(found - np.bincount(base + self._second, by_block, size)).reshape(
            self._shape
        )

    def _curvature(self, weight: Array, precision: float) -> Array:
        """Minus the second derivatives of each person's log posterior."""
        people, count = self._shape
        one, two = (
            (self._blocks.person * count + stimulus) * count
            for stimulus in (self._first, self._second)
        )
        size = people * count * count
        found = np.bincount(one + self._first, weight, size)
        found += np.bincount(two + self._second, weight, size)
        found -= np.bincount(one + self._second, weight, size)
        found -= np.bincount(two + self._first, weight, size)
        curvature = found.reshape(people, count, count)
        return np.asarray(curvature + precision * np.eye(count))

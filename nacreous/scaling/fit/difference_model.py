"""The likelihood of judged differences: a generalised linear model with signed differences.

A judgement of the pairs (a, b) and (c, d), a before b and c before d in the order of the stimuli,
says that the first differs more with probability F((v_b - v_a) - (v_d - v_c)), F normal or logistic
(Maloney and Yang 2003; as a linear model Knoblauch and Maloney 2008). The first stimulus is 0, so
that parameters are the values of all others. The likelihood is concave in them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.quadruples import Quadruples
from nacreous.scaling.fit.unit import Model

Array = NDArray[np.float64]
Index = NDArray[np.int64]

#: Newton's steps; a likelihood with a maximum takes ten, one without goes on and on.
_MOST_STEPS = 60
_SETTLED = 1e-9


@dataclass(frozen=True, eq=False)
class Questions:
    """What was asked, each question once, and which question each judgement answered.

    - `pairs`: int64 [question, 4], the earlier and the later stimulus of the first pair and of the
      second; `design`: float64 [question, stimulus], +1 and -1, the first pair less the second
    - `question`: int64 [judgement]; `upper`: bool [judgement], the answer is the question's first
    """

    pairs: Index
    design: Array
    question: Index
    upper: NDArray[np.bool_]

    def counts(self, weights: Array | None = None) -> Array:
        """float64 [question, 2], how often the first and the second pair was judged larger."""
        count = len(self.design)
        sides = np.where(self.upper, 0, 1)
        found = np.bincount(2 * self.question + sides, weights, 2 * count)
        return np.asarray(found.reshape(count, 2), np.float64)


def questions_of(data: Quadruples) -> Questions:
    """The questions of judgements, whichever pair, and of a pair whichever stimulus, stood first.

    >>> asked = questions_of(Quadruples.of_tuples([("1", "2", "3", "4", "first")] * 2))
    >>> asked.design.tolist(), asked.counts().tolist()
    ([[-1.0, 1.0, 1.0, -1.0]], [[2.0, 0.0]])
    """
    count = len(data.stimuli)
    low, high = data.ordered.reshape(-1, 2, 2).transpose(2, 0, 1)
    code = low * count + high
    turned = code[:, 0] > code[:, 1]
    pairs = np.sort(code, axis=1)
    both, question = np.unique(pairs, axis=0, return_inverse=True)
    shown = np.stack((both // count, both % count), axis=2).reshape(-1, 4)
    upper = (data.outcome > 0) != turned
    design = design_of(shown, count)
    return Questions(shown, design, np.asarray(question, np.int64).reshape(-1), upper)


def design_of(pairs: Index, count: int) -> Array:
    """float64 [question, stimulus]: the difference of the first pair less that of the second.

    pairs: int64 [question, 4], of each pair the earlier stimulus first; a stimulus may be in both.
    """
    design = np.zeros((len(pairs), count))
    for each, sign in zip(pairs.T, (-1.0, 1.0, 1.0, -1.0), strict=True):
        np.add.at(design, (np.arange(len(pairs)), each), sign)
    return design


def log_chance(lead: Array, model: Model) -> Array:
    """The logarithm of F."""
    from scipy.special import log_expit, log_ndtr

    return np.asarray(log_ndtr(lead) if model == "probit" else log_expit(lead))


def slope(lead: Array, model: Model) -> Array:
    """The derivative of ln F: f / F."""
    if model == "probit":
        normal = -0.5 * lead**2 - 0.5 * np.log(2 * np.pi)
        return np.asarray(np.exp(normal - log_chance(lead, model)))
    return np.asarray(np.exp(log_chance(-lead, model)))


def bend(lead: Array, model: Model) -> Array:
    """Minus the second derivative of ln F, above 0."""
    steep = slope(lead, model)
    if model == "probit":
        return np.asarray(np.maximum(steep * (steep + lead), 0.0))
    return np.asarray(steep * (1 - steep))


def expected_bend(lead: Array, model: Model) -> Array:
    """What one judgement tells of its lead, on average: f^2 / (F (1 - F))."""
    return np.asarray(slope(lead, model) * slope(-lead, model))


def log_likelihood(lead: Array, counts: Array, model: Model) -> float:
    """Of counts [question, 2] at leads [question]; without constant terms."""
    first, second = counts.T
    return float(first @ log_chance(lead, model) + second @ log_chance(-lead, model))


def observed(lead: Array, counts: Array, model: Model) -> Array:
    """float64 [question]: minus the second derivative by the lead."""
    first, second = counts.T
    return np.asarray(first * bend(lead, model) + second * bend(-lead, model))


def gradient(lead: Array, counts: Array, model: Model) -> Array:
    """float64 [question]: the derivative by the lead."""
    first, second = counts.T
    return np.asarray(first * slope(lead, model) - second * slope(-lead, model))


def maximum(design: Array, counts: Array, model: Model, start: Array | None = None) -> Array | None:
    """The most likely parameters, float64 [parameter]; None where Newton finds no end.

    design: float64 [question, parameter].
    """
    return _climbed(design, counts, model, start, None)


def held_maximum(design: Array, counts: Array, model: Model, centre: Array, spread: float) -> Array:
    """The same with a normal prior about `centre`, which always has an end."""
    found = _climbed(design, counts, model, centre, (centre, 1 / spread**2))
    return centre if found is None else found


def _climbed(
    design: Array,
    counts: Array,
    model: Model,
    start: Array | None,
    prior: tuple[Array, float] | None,
) -> Array | None:
    size = design.shape[1]
    centre, weight = prior or (np.zeros(size), 0.0)

    def height(values: Array) -> float:
        pull = float(((values - centre) ** 2).sum()) * weight / 2
        return log_likelihood(design @ values, counts, model) - pull

    at = np.zeros(size) if start is None else start
    top = height(at)
    for _ in range(_MOST_STEPS):
        lead = design @ at
        up = design.T @ gradient(lead, counts, model) - weight * (at - centre)
        bent = (design.T * observed(lead, counts, model)) @ design + weight * np.eye(size)
        try:
            step = np.linalg.solve(bent, up)
        except np.linalg.LinAlgError:
            return None
        if not np.isfinite(step).all() or np.abs(step).max() > 1e6:
            return None
        length = 1.0
        while (higher := height(at + length * step)) < top - 1e-9 * abs(top) and length > 1e-6:
            length /= 2
        at, top = at + length * step, higher
        if np.abs(step).max() < _SETTLED * max(1.0, float(np.abs(at).max())):
            return at
    return None

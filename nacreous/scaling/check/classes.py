"""Classes of people, each with a scale of its own: mixtures, fitted by EM from many starts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.link import slopes_at
from nacreous.scaling.fit.blocks import Array, Blocks

__all__ = ["Mixture", "fit_classes"]

#: Weight of half the squared values, without which a class of one mind would have no finite scale.
_RIDGE = 0.1
#: How sure the random partitions are from which EM starts.
_SURE = 0.9
#: After so many rounds only the best few starts go on.
_FIRST_ROUNDS, _KEPT = 12, 4
_MOST_ROUNDS = 300
#: Log-likelihood by which a round must gain.
_GAIN = 1e-6


@dataclass(frozen=True, eq=False)
class Mixture:
    """A fitted mixture, its largest class first.

    `shares`: float64 [class], of the people; `values`: float64 [class, stimulus], mean 0, in the
    model's own unit; `belonging`: float64 [person, class], how likely each is in each;
    `log_likelihood`: of the answers, without the ridge.
    """

    shares: Array
    values: Array
    belonging: Array
    log_likelihood: float


def fit_classes(
    blocks: Blocks, count: int, model: str = "probit", starts: int = 20, seed: int = 1
) -> Mixture:
    """The best of `starts` runs of EM for `count` classes, 1 or more.

    A run starts from a random partition of the people (A. P. Dempster, N. M. Laird and D. B. Rubin,
    JRSS B 39, 1977); a round takes two Newton steps on each class's values.
    """
    runs = _Runs(blocks, count, model)
    random = np.random.default_rng(seed)
    starts = starts if count > 1 else 1
    drawn = random.integers(0, count, (len(blocks.people), starts, 1)) == np.arange(count)
    belonging = (
        np.where(drawn, _SURE, (1 - _SURE) / max(1, count - 1)) if count > 1 else drawn + 0.0
    )
    values = np.zeros((starts, count, len(blocks.stimuli)))
    likelihood = np.full(starts, -np.inf)
    for number in range(_MOST_ROUNDS):
        before = likelihood
        values, shares, belonging, likelihood = runs.round(values, belonging)
        if number == _FIRST_ROUNDS and starts > _KEPT:
            kept = np.argsort(-likelihood, kind="stable")[:_KEPT]
            values, shares, likelihood = values[kept], shares[kept], likelihood[kept]
            belonging = belonging[:, kept]
        elif number > 5 and np.all(likelihood - before < _GAIN):
            break
    best = int(np.argmax(likelihood))
    order = np.argsort(-shares[best], kind="stable")
    own = values[best][order]
    return Mixture(
        shares=shares[best][order],
        values=own - own.mean(axis=1, keepdims=True),
        belonging=belonging[:, best][:, order],
        log_likelihood=float(likelihood[best]),
    )


class _Runs:
    """All starts side by side: arrays are [start, class, ...] or [person, start, class]."""

    def __init__(self, blocks: Blocks, count: int, model: str) -> None:
        from scipy.sparse import csr_array

        self._blocks, self._count, self._model = blocks, count, model
        shape = (len(blocks.people), len(blocks.first))
        at = (blocks.person, blocks.pair)
        self._chosen = csr_array((blocks.chosen, at), shape)
        self._passed = csr_array((blocks.answers - blocks.chosen, at), shape)

    def round(
        self, values: Array, belonging: Array
    ) -> tuple[Array, Array, Array, NDArray[np.float64]]:
        """One round: values, shares, how likely each person is where, log-likelihood by start."""
        flat = belonging.reshape(len(belonging), -1)
        chosen, passed = self._chosen.T @ flat, self._passed.T @ flat
        for _ in range(2):
            values = self._step(values, chosen.T, passed.T)
        shares = np.maximum(belonging.mean(axis=0), 1e-12)
        up = slopes_at(self._blocks.leads(values.reshape(flat.shape[1], -1)), self._model).log
        down = slopes_at(-self._blocks.leads(values.reshape(flat.shape[1], -1)), self._model).log
        own = (self._chosen @ up.T + self._passed @ down.T).reshape(belonging.shape)
        joint = own + np.log(shares)
        top = joint.max(axis=2, keepdims=True)
        weight = np.exp(joint - top)
        total = weight.sum(axis=2, keepdims=True)
        return values, shares, weight / total, (top + np.log(total)).sum(axis=(0, 2))

    def _step(self, values: Array, chosen: Array, passed: Array) -> Array:
        """A Newton step on the penalised log-likelihood of every class of every start."""
        one, two, count = self._blocks.first, self._blocks.second, values.shape[-1]
        flat = values.reshape(-1, count)
        lead = self._blocks.leads(flat)
        up, down = slopes_at(lead, self._model), slopes_at(-lead, self._model)
        slope = chosen * up.first - passed * down.first
        weight = -chosen * up.second - passed * down.second
        curvature = np.zeros((len(flat), count, count))
        curvature[:, one, two] = curvature[:, two, one] = -weight
        diagonal = np.arange(count)
        curvature[:, diagonal, diagonal] = _RIDGE - curvature.sum(axis=2)
        signs = np.zeros((len(one), count))
        signs[np.arange(len(one)), one], signs[np.arange(len(one)), two] = 1.0, -1.0
        gradient = slope @ signs - _RIDGE * flat
        step = np.linalg.solve(curvature, gradient[..., None])[..., 0]
        return np.asarray(flat + np.clip(step, -2, 2)).reshape(values.shape)

"""Which pairs to show next: those whose answers are expected to tell the most.

From the answers so far and a prior comes a posterior of the scale, taken as normal: by default with
a prior over the spread of the values (`nacreous.scaling.fit.spread`). An answer to the pair i, j
tells, in bits,

    H(mean of p) - mean of H(p)        p = F(v_i - v_j), v_i - v_j normal under the posterior

its mutual information with the scale (Lindley 1956; Houlsby et al. 2011), by Gauss and Hermite's
rule. A batch is chosen in one of three ways:

greedy  after each pair the posterior's covariance is updated as if the pair had been answered (by
        its expected information, a step of rank one, as for D-optimal designs), and the next is
        chosen; so no pair is asked again before it is worth it
tree    the spanning tree of the largest sum of bits, with which ASAP (Mikhailiuk et al. 2021) and
        hybrid MST (Li et al. 2018) fill batches: every stimulus is in it and all are connected;
        further trees follow on the updated covariance
drawn   as greedy, but each pair is drawn by lot with a chance in proportion to its bits

Pairs chosen by the answers so far stretch the most likely scale: what looks near is asked about
again, what looks far is not, and chance that put two things too far apart is never found out. Fit
them with the same prior (`prior="hierarchical"`), which mends it. Bias reduction
(`method="bias-reduced"`) does not after greedy pairs or trees, but after drawn ones, where a scale
without any prior is wanted.

Each pair's sides are chosen so that every stimulus stands on either side equally often.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said, seed_of, truth_of, whole_of, within
from nacreous.problem import InputError
from nacreous.scaling.compare.estimate import fit_of
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.given import comparisons_of
from nacreous.scaling.data.label import labels_of
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.spread import HIERARCHICAL, Prior, prior_variance
from nacreous.scaling.fit.unit import check_model
from nacreous.scaling.planning.bits import bits_of, chance_of
from nacreous.value import value_class

__all__ = ["NextPair", "next_pairs"]

Array = NDArray[np.float64]

#: A posterior covariance of this many stimuli fills 32 MB and takes a second to find.
_MOST = 2000


@value_class
class NextPair:
    """A pair to show, and how many bits its answer is expected to tell about the scale."""

    left: str
    right: str
    bits: float


def next_pairs(
    data: Any = None,
    batch: int = 1,
    *,
    stimuli: Iterable[object] | None = None,
    method: str = "greedy",
    model: str = "probit",
    prior: Prior = HIERARCHICAL,
    seed: int = 1,
    distinct: bool = False,
) -> tuple[NextPair, ...]:
    """The pairs to show next, the most telling first.

    data     answers or counts so far; None at the start of a study, when `stimuli` are needed.
    batch    how many pairs. They are chosen as if the ones before had been answered already.
    method   "greedy"; "tree": every stimulus at least once in each stimuli - 1 pairs; or "drawn".
    prior    "hierarchical", or the spread of the values' normal prior in the model's own unit.
    seed     decides between pairs that tell equally much. Same arguments, same pairs.
    distinct no pair twice in the batch: for one person, who would give the same answer again.

    Against random pairs an eighth less squared error at equal answers, by either method (simulated:
    12 stimuli, spread 1 z, 110 answers, one fit for both). Raises `InputError` for values that
    cannot be used.

    >>> first = next_pairs(stimuli=["a", "b", "c", "d"], batch=3, method="tree")
    >>> len({label for pair in first for label in (pair.left, pair.right)})
    4
    >>> [pair] = next_pairs([("a", "b")] * 9 + [("b", "c"), ("c", "b")])
    >>> sorted([pair.left, pair.right])
    ['a', 'c']
    """
    check_model(model)
    if prior is None:
        raise InputError("prior is None; allowed: a spread, 0.001 to 1000, or 'hierarchical'")
    if prior != HIERARCHICAL:
        within("prior", prior, 1e-3, 1e3)
    whole_of("batch", batch, 1, 1_000_000)
    if method not in ("greedy", "tree", "drawn"):
        raise InputError(f"method is {said(method)}; allowed: greedy, tree, drawn")
    random = np.random.default_rng(seed_of(seed))
    labels, comparisons = _so_far(data, stimuli)
    most = len(labels) * (len(labels) - 1) // 2
    if truth_of("distinct", distinct) and batch > most:
        raise InputError(f"batch is {batch}; allowed: 1 to {most}, the distinct pairs there are")
    mean, covariance = _posterior(labels, comparisons, model, prior)
    if method == "tree":
        pairs = _trees(mean, covariance, batch, model, random, distinct)
    else:
        pick = _largest if method == "greedy" else _by_lot
        pairs = _one_by_one(mean, covariance, batch, model, random, distinct, pick)
    sides = _Sides(len(labels), comparisons)
    found = []
    for first, second, bits in pairs:
        left, right = sides.placed(first, second, random)
        found.append(NextPair(labels[left], labels[right], bits))
    return tuple(found)


def _so_far(
    data: Any, stimuli: Iterable[object] | None
) -> tuple[tuple[str, ...], Comparisons | None]:
    comparisons = None if data is None else comparisons_of(data)
    if stimuli is None and comparisons is None:
        raise InputError("neither data nor stimuli are given; allowed: one of them, or both")
    labels = comparisons.stimuli if stimuli is None and comparisons else labels_of(stimuli or ())
    if comparisons is not None and set(comparisons.stimuli) - set(labels):
        strange = sorted(set(comparisons.stimuli) - set(labels))
        raise InputError(f"the data have the stimulus {said(strange[0])}; allowed: those given")
    if len(labels) > _MOST:
        raise InputError(f"{len(labels)} stimuli; allowed: 2 to {_MOST}")
    if comparisons is not None and comparisons.stimuli != labels:
        comparisons = _among(labels, comparisons)
    return labels, comparisons


def _among(labels: tuple[str, ...], comparisons: Comparisons) -> Comparisons:
    """The same counts, with stimuli that have none yet."""
    place = np.array([labels.index(label) for label in comparisons.stimuli])
    left, right = place[comparisons.left], place[comparisons.right]
    turned = (left > right) & (not comparisons.sided)
    left, right = np.where(turned, right, left), np.where(turned, left, right)
    rows = np.lexsort((right, left))
    return Comparisons(
        stimuli=labels,
        left=left[rows],
        right=right[rows],
        left_wins=np.where(turned, comparisons.right_wins, comparisons.left_wins)[rows],
        right_wins=np.where(turned, comparisons.left_wins, comparisons.right_wins)[rows],
        ties=comparisons.ties[rows],
        sided=comparisons.sided,
    )


def _posterior(
    labels: tuple[str, ...], comparisons: Comparisons | None, model: str, prior: Prior
) -> tuple[Array, Array]:
    """Mean and covariance of the values; the prior's own before there are answers."""
    if comparisons is None:
        variance = prior_variance(model) if isinstance(prior, str) else float(prior or 0.0) ** 2
        return np.zeros(len(labels)), variance * np.eye(len(labels))
    fit: Scale = fit_of(comparisons.unsided(), model, ties=False, prior=prior)
    return fit.scale, fit.parameter_covariance("expected")[: len(labels), : len(labels)]


def _leads(mean: Array, covariance: Array) -> tuple[Array, Array]:
    """Mean and variance of each pair's lead, float64 [i, j]."""
    own = np.diag(covariance)
    variance = own[:, None] + own[None, :] - 2 * covariance
    return mean[:, None] - mean[None, :], np.maximum(variance, 0.0)


def _one_by_one(
    mean: Array,
    covariance: Array,
    batch: int,
    model: str,
    random: np.random.Generator,
    distinct: bool,
    pick: Callable[[Array, np.random.Generator], int],
) -> list[tuple[int, int, float]]:
    first, second = np.triu_indices(len(mean), 1)
    chosen = []
    lead, variance = (table[first, second] for table in _leads(mean, covariance))
    bits = bits_of(lead, variance, model)
    allowed = np.ones(len(bits), dtype=bool)
    for _ in range(batch):
        best = pick(np.where(allowed, bits, -np.inf), random)
        allowed[best] = not distinct
        i, j = int(first[best]), int(second[best])
        chosen.append((i, j, float(bits[best])))
        along = covariance[:, i] - covariance[:, j]
        covariance = _answered(covariance, i, j, lead[best], model)
        gain = _gain(lead[best], variance[best], model)
        # What the pair's answer takes from every lead's variance.
        fall = gain * (along[first] - along[second]) ** 2
        changed = fall > 1e-4 * variance
        variance = np.maximum(variance - fall, 0.0)
        bits[changed] = bits_of(lead[changed], variance[changed], model)
    return chosen


def _trees(
    mean: Array,
    covariance: Array,
    batch: int,
    model: str,
    random: np.random.Generator,
    distinct: bool,
) -> list[tuple[int, int, float]]:
    from scipy.sparse.csgraph import minimum_spanning_tree

    chosen: list[tuple[int, int, float]] = []
    allowed = np.ones(covariance.shape, dtype=bool)
    while len(chosen) < batch:
        lead, variance = _leads(mean, covariance)
        bits = bits_of(lead, variance, model)
        # Small random parts decide between equals; edges of weight 0 would be none.
        costs = np.where(allowed, -1 - bits - 1e-9 * random.random(bits.shape), 0.0)
        tree = minimum_spanning_tree(np.triu(costs, 1)).tocoo()
        edges = list(zip(tree.row.tolist(), tree.col.tolist(), strict=True))
        edges.sort(key=lambda edge: -bits[edge])
        chosen += [(i, j, float(bits[i, j])) for i, j in edges]
        for i, j in edges:
            allowed[i, j] = not distinct
            covariance = _answered(covariance, i, j, lead[i, j], model)
    return chosen[:batch]


def _largest(bits: Array, random: np.random.Generator) -> int:
    """The place of the largest, one of those within 1e-9 of it."""
    return int(random.choice(np.flatnonzero(bits >= bits.max() - 1e-9)))


def _by_lot(bits: Array, random: np.random.Generator) -> int:
    """A place, with a chance in proportion to its bits; those that are not allowed are -inf."""
    chances = np.maximum(bits, 0.0)
    if chances.sum() <= 0.0:  # nothing tells anything
        chances = np.isfinite(bits).astype(np.float64)
    return int(random.choice(len(bits), p=chances / chances.sum()))


def _gain(lead: float, variance: float, model: str) -> float:
    """How much of the outer product of covariances an answer takes off (Sherman, Morrison 1950)."""
    chance = float(chance_of(np.array([lead]), model)[0])
    noise = max(chance * (1 - chance), 1e-12)
    slope = np.exp(-(lead**2) / 2) / np.sqrt(2 * np.pi) if model == "probit" else noise
    information = float(slope**2 / noise)
    return information / (1 + information * variance)


def _answered(covariance: Array, i: int, j: int, lead: float, model: str) -> Array:
    """The covariance after one more answer to a pair, by the information expected of it."""
    along = covariance[:, i] - covariance[:, j]
    return covariance - _gain(lead, float(along[i] - along[j]), model) * np.outer(along, along)


class _Sides:
    """How often each pair stood either way, and each stimulus on the left."""

    def __init__(self, size: int, comparisons: Comparisons | None) -> None:
        self._shown = np.zeros((size, size))
        if comparisons is not None and comparisons.sided:
            total = comparisons.left_wins + comparisons.right_wins + comparisons.ties
            self._shown[comparisons.left, comparisons.right] = total
        self._lean = self._shown.sum(axis=1) - self._shown.sum(axis=0)

    def placed(self, i: int, j: int, random: np.random.Generator) -> tuple[int, int]:
        """Left and right: the rarer way of the pair, else by which was on the left more often."""
        lead = self._shown[i, j] - self._shown[j, i]
        lean = self._lean[i] - self._lean[j]
        toss = 1 if random.random() < 0.5 else -1
        turned = next(x for x in (lead, lean, toss) if x) > 0
        left, right = (j, i) if turned else (i, j)
        self._shown[left, right] += 1
        self._lean[left] += 1
        self._lean[right] -= 1
        return left, right

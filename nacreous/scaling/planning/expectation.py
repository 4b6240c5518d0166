"""What a plan leads to expect, by integrals: counts of answers, and unanimous pairs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.planning.simulation import pairs_of, truth_of

if TYPE_CHECKING:
    from nacreous.scaling.planning.plan import Plan

__all__ = ["expected_comparisons", "unanimous_chances"]

Array = NDArray[np.float64]

#: Gauss-Hermite nodes for the people's own leads.
_NODES = 41


def expected_comparisons(plan: Plan) -> Comparisons:
    """Expected counts of a planned study, fractions of answers; as many on either side."""
    stimuli, truth = truth_of(plan.scale)
    first, second = pairs_of(plan.pairs, stimuli)
    size = len(stimuli)
    leads, weights = _leads(plan, truth[first] - truth[second])
    half = plan.people * plan.repeats / 2
    table = np.zeros((size, size, 3))
    for left, right, sign in ((first, second, 1.0), (second, first, -1.0)):
        chances = _outcomes(plan, sign * leads + plan.order)
        np.add.at(table, (left, right), half * np.einsum("opn,n->po", chances, weights))
    rows = np.nonzero(table.sum(axis=2))
    wins, losses, ties = np.moveaxis(table[rows], -1, 0)
    return Comparisons(stimuli, rows[0], rows[1], wins, losses, ties, sided=True)


def unanimous_chances(plan: Plan) -> Array:
    """How likely all answers to each pair are the same, float64 [pair].

    People answer for themselves; the answers of one person to one pair share that person's lead.
    """
    stimuli, truth = truth_of(plan.scale)
    first, second = pairs_of(plan.pairs, stimuli)
    low, high = np.minimum(first, second), np.maximum(first, second)
    pairs, times = np.unique(low * len(stimuli) + high, return_counts=True)
    leads, weights = _leads(plan, truth[pairs // len(stimuli)] - truth[pairs % len(stimuli)])
    # On the left half of the time: its own chance there, and the other's to lose.
    on_left, on_right = (_outcomes(plan, sign * leads + plan.order) for sign in (1.0, -1.0))
    answers = (times * plan.repeats)[:, np.newaxis]
    chosen = ((on_left[0] + on_right[1]) / 2) ** answers @ weights
    refused = ((on_left[1] + on_right[0]) / 2) ** answers @ weights
    return np.asarray(chosen**plan.people + refused**plan.people)


def _leads(plan: Plan, lead: Array) -> tuple[Array, Array]:
    """Leads as people have them, float64 [pair, node], with the weight of each node."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(_NODES)
    spread = np.sqrt(2.0) * plan.person_spread
    return lead[:, np.newaxis] + spread * nodes, weights / weights.sum()


def _outcomes(plan: Plan, lead: Array) -> Array:
    """Chances of left, right and tie for leads of the left, float64 [outcome, ...]."""
    from scipy.special import ndtr

    if plan.model == "probit":
        left, right = ndtr(lead - plan.tie), ndtr(-lead - plan.tie)
    else:
        strong, weak = np.exp(np.minimum(lead, 0.0)), np.exp(-np.maximum(lead, 0.0))
        total = strong + weak + plan.tie * np.sqrt(strong * weak)
        left, right = strong / total, weak / total
    careful = 1 - plan.lapse
    left, right = (careful * chance + plan.lapse / 2 for chance in (left, right))
    return np.stack([left, right, np.maximum(1 - left - right, 0.0)])

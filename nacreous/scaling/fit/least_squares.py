"""The paper's estimator: case V by least squares on z, the inverse normal of the proportions.

With every pair compared, the values are the row means of z (Mosteller 1951; paper, table 1). Where
pairs are missing, the least squares over those that are there (Gulliksen 1956), each with the same
weight. A proportion of 0 or 1 has no z; such a pair counts as `extremes` answers out of n against
the unanimous choice: p = 0.5 / n by default.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import number_of, said
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.fit.existence import islands, pair_model, require_maximum
from nacreous.scaling.fit.maximum_likelihood import counted
from nacreous.scaling.fit.scale import Scale

Array = NDArray[np.float64]


def least_squares(data: Any, extremes: float = 0.5) -> Scale:
    """The scale in z; a tie counts half for either. Errors as `thurstone`.

    >>> from nacreous.scaling import paper_proportions, Comparisons
    >>> fit = least_squares(Comparisons.of_proportions(paper_proportions(), 104))
    >>> fit.scale.round(3).tolist()
    [0.278, 0.809, 0.324, 0.419, -0.308, -0.623, -0.9]
    """
    if not 1e-3 <= number_of("extremes", extremes) <= 1:
        raise InputError(f"extremes is {said(extremes)}; allowed: 0.001 to 1 answer")
    data, comparisons = counted(data)
    room = pair_model(comparisons, "probit")
    if len(comparisons.stimuli) < 2 or islands(comparisons).max() > 0:
        require_maximum(comparisons, room)
    pairs = comparisons.unsided()
    values = projection(pairs) @ z_of_pairs(pairs, float(extremes))
    return Scale(
        stimuli=comparisons.stimuli,
        scale=values,
        unit="z",
        model="probit",
        method="least-squares",
        comparisons=comparisons,
        log_likelihood=room.log_likelihood(values),
        answers=data if isinstance(data, Answers) else None,
        parameters=values,
        pair_model=room,
    )


def z_of_pairs(pairs: Comparisons, extremes: float = 0.5) -> Array:
    """float64 [row]: the inverse normal of how often left was chosen over right."""
    from scipy.special import ndtri

    total = pairs.left_wins + pairs.right_wins + pairs.ties
    wins = pairs.left_wins + 0.5 * pairs.ties
    least = np.minimum(extremes, 0.5 * total)
    unanimous = (wins == 0) | (wins == total)
    wins = np.where(unanimous, np.clip(wins, least, total - least), wins)
    return np.asarray(ndtri(wins / total))


def projection(pairs: Comparisons) -> Array:
    """[stimulus, row]: what makes the values of z by least squares, with mean 0."""
    incidence = np.zeros((len(pairs), len(pairs.stimuli)))
    rows = np.arange(len(pairs))
    incidence[rows, pairs.left] = 1.0
    incidence[rows, pairs.right] = -1.0
    laplacian = incidence.T @ incidence
    shift = 1.0 / len(pairs.stimuli)
    return np.asarray(np.linalg.solve(laplacian + shift, incidence.T))


def covariance(comparisons: Comparisons, values: Array, kind: str) -> Array:
    """Of the values, to first order: the spread of z is that of p over the density at z.

    kind: "expected", p by the fitted values, or "observed", p as counted (unanimous pairs as z has
    them).
    """
    pairs = comparisons.unsided()
    total = pairs.left_wins + pairs.right_wins + pairs.ties
    if kind == "expected":
        z = values[pairs.left] - values[pairs.right]
    elif kind == "observed":
        z = z_of_pairs(pairs)
    else:
        raise InputError(f"kind is {said(kind)}; allowed for least squares: expected, observed")
    from scipy.special import log_ndtr

    log_density = -0.5 * z**2 - 0.5 * np.log(2 * np.pi)
    variance = np.exp(log_ndtr(z) + log_ndtr(-z) - 2 * log_density) / total
    operator = projection(pairs)
    return np.asarray((operator * variance) @ operator.T)

"""Row means of z: from the shares of pairs to values by least squares, and how sure these are."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons

Array = NDArray[np.float64]


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
    if kind == "expected":
        z = values[pairs.left] - values[pairs.right]
    elif kind == "observed":
        z = z_of_pairs(pairs)
    else:
        raise InputError(f"kind is {said(kind)}; allowed here: expected, observed")
    variance = z_variance(pairs, z)
    operator = projection(pairs)
    return np.asarray((operator * variance) @ operator.T)


def z_variance(pairs: Comparisons, z: Array) -> Array:
    """float64 [row]: of z of pairs whose answers are independent, to first order."""
    from scipy.special import log_ndtr

    total = pairs.left_wins + pairs.right_wins + pairs.ties
    log_density = -0.5 * z**2 - 0.5 * np.log(2 * np.pi)
    return np.asarray(np.exp(log_ndtr(z) + log_ndtr(-z) - 2 * log_density) / total)

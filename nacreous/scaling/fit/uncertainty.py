"""How sure a scale is: covariances, standard errors, intervals that hold one by one or together."""

from __future__ import annotations

from itertools import combinations
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from nacreous.number import number_of, said
from nacreous.problem import InputError
from nacreous.value import value_class

Array = NDArray[np.float64]

CONTROLS = ("none", "holm", "bonferroni", "tukey")


@value_class
class Difference:
    """How far `first` is above `second`, in `unit`.

    `low`, `high`: the interval; `se`: standard error; `p_value`: how likely so large a difference
    were if there was none, corrected for the number of differences where they were asked together.
    """

    first: str
    second: str
    value: float
    se: float
    low: float
    high: float
    p_value: float
    unit: str

    def __repr__(self) -> str:
        """In one line with the interval."""
        names = f"{self.first} - {self.second}"
        interval = f"{self.low:z.3f} to {self.high:z.3f}"
        return f"Difference({names}: {self.value:z.3f}, {interval} {self.unit})"


def inverse(information: Array, floating: int = 0) -> Array:
    """The covariance of parameters, the inverse of their information.

    floating: how many of the first parameters have only differences, and get mean 0; their common
    shift, about which nothing is known, is taken out. Raises `InputError` where more is unknown.
    """
    matrix = information.copy()
    # A weight near the others', for the sake of rounding; any positive one gives the same answer.
    weight = float(np.diagonal(matrix)[:floating].mean()) if floating else 0.0
    matrix[:floating, :floating] += weight / max(floating, 1)
    covariance = _inverse_of_positive(matrix)
    if floating:
        covariance[:floating, :floating] -= 1 / (weight * floating)
    if not np.isfinite(covariance).all() or (np.diagonal(covariance) < 0).any():
        raise InputError(
            "the answers leave a combination of the parameters unknown; allowed: columns of the "
            "design that differ between stimuli and do not repeat each other, or a prior"
        )
    return np.asarray(covariance)


def _inverse_of_positive(matrix: Array) -> Array:
    """The inverse of a positive definite matrix; NaN where it is not."""
    if len(matrix) <= 200:  # no time to be won, and SciPy takes a while to import
        try:
            half = np.linalg.inv(np.linalg.cholesky(matrix))
        except np.linalg.LinAlgError:
            return np.full_like(matrix, np.nan)
        return np.asarray(half.T @ half)
    from scipy.linalg.lapack import dpotrf, dpotri

    factor, unfactored = dpotrf(matrix, lower=1, overwrite_a=1)
    inverse, uninverted = dpotri(factor, lower=1, overwrite_c=1)
    if unfactored or uninverted:
        return np.full_like(matrix, np.nan)
    return np.asarray(np.tril(inverse) + np.tril(inverse, -1).T)


def centred(covariance: Array) -> Array:
    """The covariance of values after their mean was taken from them."""
    rows = covariance - covariance.mean(axis=0, keepdims=True)
    return np.asarray(rows - rows.mean(axis=1, keepdims=True))


def root_of_diagonal(covariance: Array) -> Array:
    """Standard errors; rounding below 0 counts as 0."""
    return np.sqrt(np.maximum(np.diagonal(covariance), 0.0))


class Known(Protocol):
    """Errors of a scale: their covariance, and the degrees of freedom of contrasts."""

    @property
    def covariance(self) -> Array:
        """float64 [n, n]."""

    def freedom(self, contrasts: Array) -> Array:
        """Of contrasts [k, n], float64 [k]; infinite makes them normal."""


def intervals(
    values: Array, errors: Known, level: float, simultaneous: str | bool = False
) -> Array:
    """float64 [n, 2]: intervals about each value, by Student's t where freedom is finite."""
    freedom = errors.freedom(np.eye(len(values)))
    reach = quantile(errors.covariance, level, control_of(simultaneous), freedom)
    half = reach * root_of_diagonal(errors.covariance)
    return np.column_stack((values - half, values + half))


def differences(
    labels: tuple[str, ...],
    values: Array,
    errors: Known,
    unit: str,
    level: float,
    simultaneous: str | bool,
    pairs: list[tuple[int, int]] | None = None,
) -> list[Difference]:
    """The differences of some pairs (all, by default), with intervals and p values."""
    control = control_of(simultaneous)
    chosen = list(combinations(range(len(labels)), 2)) if pairs is None else pairs
    first, second = np.array(chosen, np.int64).T
    contrast = np.zeros((len(chosen), len(labels)))
    rows = np.arange(len(chosen))
    contrast[rows, first] = 1.0
    contrast[rows, second] = -1.0
    of_pairs = contrast @ errors.covariance @ contrast.T
    freedom = errors.freedom(contrast)
    found, se = contrast @ values, root_of_diagonal(of_pairs)
    z = np.divide(np.abs(found), se, out=np.zeros_like(se), where=se > 0)
    p = _corrected(two_sided(z, freedom), z, of_pairs, control, freedom)
    half = quantile(of_pairs, level, control, freedom) * se
    numbers = np.column_stack((found, se, found - half, found + half, p)).tolist()
    return [
        Difference(labels[i], labels[j], value, error, low, high, p_value, unit)
        for (i, j), (value, error, low, high, p_value) in zip(chosen, numbers, strict=True)
    ]


def control_of(simultaneous: str | bool) -> str:
    """Which control of many intervals at once; False is none, True is Tukey's."""
    if isinstance(simultaneous, bool):
        return "tukey" if simultaneous else "none"
    if simultaneous not in CONTROLS:
        allowed = f"False, {', '.join(CONTROLS)}"
        raise InputError(f"simultaneous is {said(simultaneous)}; allowed: {allowed}")
    return simultaneous


def level_of(level: float) -> float:
    """A level of confidence in range, or one clear message."""
    if not 0.5 <= number_of("level", level) <= 0.9999:
        raise InputError(f"level is {said(level)}; allowed: 0.5 to 0.9999")
    return float(level)


def two_sided(size: Array, freedom: Array) -> Array:
    """How often |t| is above sizes, float64 [k], by Student's t; normal where freedom is infinite.

    >>> two_sided(np.array([1.96, 2.0]), np.array([np.inf, 2.0])).round(3).tolist()
    [0.05, 0.184]
    """
    from scipy.special import ndtr, stdtr

    finite = np.where(np.isfinite(freedom), freedom, 1.0)
    return np.asarray(2 * np.where(np.isfinite(freedom), stdtr(finite, -size), ndtr(-size)))


def quantile(covariance: Array, level: float, control: str, freedom: Array) -> Array:
    """How many standard errors an interval reaches to either side, float64 [k]."""
    from scipy.special import ndtri, stdtrit

    miss = 1 - level_of(level)
    if control == "tukey":
        largest = largest_together(covariance, freedom)
        return np.full(len(covariance), np.quantile(largest, level))
    each = miss / 2 if control == "none" else miss / 2 / len(covariance)
    finite = np.where(np.isfinite(freedom), freedom, 1.0)
    return np.asarray(-np.where(np.isfinite(freedom), stdtrit(finite, each), ndtri(each)))


def largest_together(covariance: Array, freedom: Array) -> Array:
    """The largest |value| in standard errors that are known from the least of these freedoms.

    The multivariate t distribution: one error in common, so that a small one makes all look large.
    """
    largest, least = largest_of_normal(covariance), float(freedom.min())
    if np.isinf(least):
        return largest
    scale = np.random.default_rng(2).chisquare(least, len(largest)) / least
    return np.asarray(largest / np.sqrt(scale))


def largest_of_normal(covariance: Array, draws: int = 100_000) -> Array:
    """The largest |value| in standard errors, of normal values with mean 0 and that covariance.

    Drawn, with a fixed seed: for all differences of equal precision this is the distribution of the
    studentised range (Tukey), and it holds for unequal ones too (Hothorn, Bretz, Westfall 2008).
    100 000 draws know its 95 % point to 0.005. Simulated numbers, not answers.
    """
    values, vectors = np.linalg.eigh(covariance)
    kept = values > 1e-12 * values[-1]
    root = vectors[:, kept] * np.sqrt(values[kept])
    se = root_of_diagonal(covariance)
    root = root[se > 0] / se[se > 0, None]
    random = np.random.default_rng(1)
    at_once = max(1, 4_000_000 // max(len(covariance), 1))
    largest = [
        np.abs(random.standard_normal((min(at_once, draws - done), root.shape[1])) @ root.T).max(
            axis=1, initial=0.0
        )
        for done in range(0, draws, at_once)
    ]
    return np.concatenate(largest)


def holm(p_values: NDArray[np.float64]) -> NDArray[np.float64]:
    """P-values corrected for their number: S. Holm, 1979.

    >>> holm(np.array([0.01, 0.04, 0.03])).tolist()
    [0.03, 0.06, 0.06]
    """
    order = np.argsort(p_values)
    times = len(p_values) - np.arange(len(p_values))
    corrected = np.empty(len(p_values))
    corrected[order] = np.minimum(1.0, np.maximum.accumulate(p_values[order] * times))
    return corrected


def _corrected(p: Array, z: Array, covariance: Array, control: str, freedom: Array) -> Array:
    """P values that hold for all together."""
    if control == "none":
        return p
    if control == "bonferroni":
        return np.minimum(p * len(p), 1.0)
    if control == "holm":
        return holm(p)
    largest = np.sort(largest_together(covariance, freedom))
    above = len(largest) - np.searchsorted(largest, z)
    return np.asarray((above + 1) / (len(largest) + 1))

"""Goodness of fit: whether a scale describes the answers it was fitted to, and where not."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.check.cells import Cells, cells_of
from nacreous.scaling.check.pearson import x2_p_value
from nacreous.scaling.check.worst import Misfit, worst_of
from nacreous.scaling.distribution import chi2, norm
from nacreous.scaling.fit.uncertainty import level_of
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.scaling.fit.scale import Scale

#: With more than a fifth of the expected counts below 5, G2 is no chi-squared (Cochran 1954).
LEAST_EXPECTED = 5.0
MOST_SPARSE = 0.2
#: With fewer answers a pair on average, no statistic here can tell.
LEAST_ANSWERS = 2.0
#: The variance of an angle in square degrees is 821 over the number of answers, Mosteller's (4).
MOSTELLER = 821.0
#: Beyond, residuals are not divided by what the fit leaves free of them: that takes n³ steps.
MOST_ADJUSTED = 500
#: From this overdispersion on, chance is no likely reason, and the advice is given.
OVERDISPERSED = 2.0
_MODELS = {"probit": "case V", "logit": "the Bradley-Terry model"}


@value_class
class Goodness:
    """How well a fitted scale describes its answers.

    - `g2`, `g2_p_value`: the likelihood-ratio statistic against one free share a pair (deviance)
    - `x2`, `x2_p_value`: Pearson's chi-squared; its p-value is from a chi-squared scaled to the
      mean and variance that it has with so few answers, and holds down to 3 answers a pair; pairs
      that are near certain are then tested apart. None where they leave nothing else to test
    - `mosteller`, `mosteller_p_value`: F. Mosteller's test (Psychometrika 16, 1951), which compares
      shares as angles, the arcsines of their roots; None for fits with ties or an order effect
    - `df`: degrees of freedom of all three: free shares less fitted values. 0: nothing to test, and
      the p-values are None
    - `overdispersion`: g2 / df, or x2 / df where more than a fifth of pairs are `sparse`; near 1
      where the model holds; None without df
    - `residuals`: float64 [n, n], by how many standard deviations i was chosen over j more often
      than fitted (Pearson's), NaN where not compared. Where ties are answers of their own, among
      those who chose one; elsewhere a tie counts half
    - `tie_residuals`: the same of ties, positive where too many called them equal; None where ties
      are no answers of their own. Squares of both, a pair once, sum to x2 in fits without an order
      effect
    - `adjusted`: the same, divided by the share that the fit leaves free, so that their standard
      deviation is 1 where the model holds (S. J. Haberman, 1973); None for fits by least squares,
      with ties, order effect, prior or design, and beyond 500 stimuli
    - `largest`: the pair with the largest share of x2; `misfits`: up to three, the largest first
    - `sparse`: the share of pairs with an expected count below 5, for which the p-values of g2 and
      of Mosteller's test are too small
    - `describes`: whether g2, or x2 where more than a fifth of pairs are sparse, leaves the model
      standing at `level`; None without df, with fewer than 2 answers a pair, or where that
      p-value is None
    - `verdict`: the same in words; `advice`: what follows for the errors of the scale, or ""
    """

    g2: float
    g2_p_value: float | None
    x2: float
    x2_p_value: float | None
    mosteller: float | None
    mosteller_p_value: float | None
    df: int
    overdispersion: float | None
    residuals: NDArray[np.float64]
    tie_residuals: NDArray[np.float64] | None
    adjusted: NDArray[np.float64] | None
    largest: Misfit
    misfits: tuple[Misfit, ...]
    sparse: float
    describes: bool | None
    verdict: str
    advice: str


def goodness(fit: Scale, level: float = 0.95) -> Goodness:
    """Compare the answers with what the fit expects of them.

    In a fit without ties a tie counts half for each; in one without an order effect both ways round
    are one pair. The p-values take answers as independent of each other.

    >>> import nacreous as nc
    >>> from nacreous.scaling.fit.case_v import thurstone
    >>> found = goodness(thurstone(nc.scaling.paper()))
    >>> round(found.g2, 2), round(found.x2, 2), found.df
    (104.05, 101.21, 15)
    >>> found.verdict
    'case V does not describe these data; largest misfit 1-3'
    """
    level = level_of(level)
    if not hasattr(fit, "log_likelihood"):
        raise InputError(f"fit is {said(fit)}; wanted: a scale, such as thurstone(answers)")
    cells = cells_of(fit)
    df = cells.degrees
    plain = fit.order_effect is None and cells.outcomes == 2
    g2, x2 = cells.g2, cells.x2
    mosteller = _mosteller(cells) if plain else None
    g2_p_value, mosteller_p_value = _p_value(g2, df), _p_value(mosteller, df)
    pearson = x2_p_value(cells)
    sparse = float(np.mean((cells.expected[:, : cells.outcomes] < LEAST_EXPECTED).any(axis=1)))
    few = sparse > MOST_SPARSE
    decisive = pearson if few else g2_p_value
    enough = float(np.mean(cells.total)) >= LEAST_ANSWERS
    describes = None if decisive is None or not enough else decisive >= 1 - level
    residuals = _matrix(cells, cells.residuals)
    free = _free(fit, cells) if plain and cells.floating and _most_likely(fit) else None
    misfits = worst_of(fit, cells)
    overdispersion = (x2 if few else g2) / df if df else None
    return Goodness(
        g2=g2,
        g2_p_value=g2_p_value,
        x2=x2,
        x2_p_value=pearson,
        mosteller=mosteller,
        mosteller_p_value=mosteller_p_value,
        df=df,
        overdispersion=overdispersion,
        residuals=residuals,
        tie_residuals=_matrix(cells, cells.tie_residuals, 1) if cells.outcomes > 2 else None,
        adjusted=None if free is None else _matrix(cells, cells.residuals / np.sqrt(free)),
        largest=misfits[0],
        misfits=misfits,
        sparse=sparse,
        describes=describes,
        verdict=_verdict(_MODELS[fit.model], describes, df, misfits[0]),
        advice=_advice("X2" if few else "G2", describes, overdispersion),
    )


def _most_likely(fit: Scale) -> bool:
    """Whether nothing but the answers made the scale, so that the leverage below is right."""
    return fit.method == "maximum-likelihood" and fit.prior is None


def _p_value(statistic: float | None, df: int) -> float | None:
    return None if statistic is None or df == 0 else float(chi2.sf(statistic, df))


def _mosteller(cells: Cells) -> float:
    """Squares of differences of angles in degrees over their variance, his equation (6)."""
    observed, expected = (
        np.degrees(np.arcsin(np.sqrt(counts[:, 0] / cells.total)))
        for counts in (cells.observed, cells.expected)
    )
    return float(np.sum((observed - expected) ** 2 * cells.total) / MOSTELLER)


def _free(fit: Scale, cells: Cells) -> NDArray[np.float64] | None:
    """[row], the share of each residual's variance that the fit leaves, 1 less its leverage."""
    from scipy.linalg import pinvh

    count = len(cells.stimuli)
    if count > MOST_ADJUSTED:
        return None
    share = cells.expected[:, 0] / cells.total
    slope = norm.pdf(norm.ppf(share)) if fit.model == "probit" else share * (1 - share)
    weight = cells.total * slope**2 / (share * (1 - share))
    information = np.zeros((count, count))
    information[cells.first, cells.second] = information[cells.second, cells.first] = -weight
    np.fill_diagonal(information, -information.sum(axis=1))
    covariance = pinvh(information)
    variance = np.diag(covariance)
    spread = variance[cells.first] + variance[cells.second]
    free = 1 - weight * (spread - 2 * covariance[cells.first, cells.second])
    # A pair that alone joins two sets is always fitted exactly; its residual is 0 and stays so.
    return np.where(free > 1e-9, free, 1.0)


def _matrix(cells: Cells, residuals: NDArray[np.float64], turned: int = -1) -> NDArray[np.float64]:
    """[n, n]; turned: what the residual of a pair the other way round is multiplied by."""
    count = len(cells.stimuli)
    total, number = np.zeros((count, count)), np.zeros((count, count))
    for first, second, sign in (
        (cells.first, cells.second, 1),
        (cells.second, cells.first, turned),
    ):
        np.add.at(total, (first, second), sign * residuals)
        np.add.at(number, (first, second), 1)
    with np.errstate(invalid="ignore"):  # both ways round together, each of variance 1
        return np.where(number > 0, total / np.sqrt(number), np.nan)


def _verdict(model: str, describes: bool | None, df: int, largest: Misfit) -> str:
    if describes is None and df > 0:
        return f"too few answers a pair to tell whether {model} describes them"
    if describes is None:
        return f"nothing to test: {model} has as many values as there are shares"
    if describes:
        return f"nothing in these counts speaks against {model}"
    return f"{model} does not describe these data; largest misfit {largest}"


def _advice(name: str, describes: bool | None, overdispersion: float | None) -> str:
    if describes is not False or overdispersion is None or overdispersion < OVERDISPERSED:
        return ""
    return (
        f"{name}/df is {overdispersion:.1f}, where 1 is expected: errors that take answers as "
        "independent are too small; resample people"
    )

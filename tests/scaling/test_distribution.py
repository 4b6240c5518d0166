"""Tails and quantiles are those of scipy.stats."""

import numpy as np
import pytest
from scipy import stats

from nacreous.scaling import distribution
from nacreous.scaling.rank import rank_correlation, ranks

X = np.array([-40.0, -3.0, -0.2, 0.0, 0.2, 1.0, 3.0, 12.0, 80.0])
Q = np.array([1e-9, 0.025, 0.5, 0.8, 0.975, 1 - 1e-9])
DEGREES = np.array([[0.4], [1.0], [2.5], [7.0], [123.4], [1e6], [np.inf]])
COUNTS = np.arange(-1.0, 30.0)


@pytest.mark.parametrize(
    ("name", "function", "arguments"),
    [
        ("norm", "sf", (X,)),
        ("norm", "pdf", (X,)),
        ("norm", "ppf", (Q,)),
        ("t", "sf", (X, DEGREES)),
        ("t", "ppf", (Q, DEGREES)),
        ("chi2", "sf", (np.maximum(X, 0), DEGREES[:-1])),
        ("chi2", "ppf", (Q[:-1], DEGREES[1:-1])),
        ("f", "sf", (np.maximum(X, 0), 3, DEGREES[:-1])),
        ("binom", "cdf", (COUNTS[1:], 29, 0.5)),
        ("binom", "cdf", (COUNTS[1:], 2_000_000, 1e-6)),
        ("poisson", "sf", (COUNTS, 4.2)),
        ("poisson", "sf", (COUNTS, 0.0)),
    ],
)
def test_tails_and_quantiles_are_those_of_scipy(name, function, arguments):
    ours = getattr(getattr(distribution, name), function)(*arguments)
    theirs = getattr(getattr(stats, name), function)(*arguments)
    np.testing.assert_allclose(ours, theirs, rtol=1e-8, atol=1e-300)


@pytest.mark.parametrize("levels", [3, 10**6])
def test_ranks_and_their_correlation_are_those_of_scipy(levels):
    one, two = np.random.default_rng(1).integers(levels, size=(2, 60)).astype(float)
    np.testing.assert_array_equal(ranks(one), stats.rankdata(one))
    theirs = stats.spearmanr(one, two)
    assert rank_correlation(one, two) == pytest.approx((theirs.statistic, theirs.pvalue), rel=1e-9)
    assert rank_correlation(one, one) == (pytest.approx(1), pytest.approx(0))

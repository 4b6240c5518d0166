"""A prior over the spread, and bias reduction: by other integrals, other programs, known truth."""

from itertools import product

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize
from scipy.special import expit, log_ndtr, ndtr

from nacreous.problem import InputError
from nacreous.scaling import Comparisons, bradley_terry, goodness, paper, thurstone
from nacreous.scaling.fit.spread import prior_variance, spread_posterior
from nacreous.scaling.planning.simulation import simulate

TWO = Comparisons.of_counts([[0, 28], [8, 0]])


def of_spread(spread_z):
    return np.exp(-0.5 * (np.log(spread_z) / 0.8) ** 2)


@pytest.mark.parametrize(
    ("fit", "log_chance", "unit"),
    [
        (thurstone, log_ndtr, 1.0),
        (bradley_terry, lambda lead: -np.logaddexp(0, -lead), 1 / 0.6139),
    ],
)
def test_two_values_are_those_of_the_integral_over_values_and_spreads(fit, log_chance, unit):
    """Of the lead alone, which is normal with twice the variance; Laplace is off by a little."""
    above = below = 0.0
    for spread_z in np.geomspace(0.2, 5.0, 11):
        spread = np.sqrt(2) * spread_z * unit

        def likely(lead, spread=spread):
            told = 28 * log_chance(lead) + 8 * log_chance(-lead) + 18
            return np.exp(told - 0.5 * (lead / spread) ** 2) / spread

        below += of_spread(spread_z) * quad(likely, -20, 20, limit=200)[0]
        above += of_spread(spread_z) * quad(lambda x: x * likely(x), -20, 20, limit=200)[0]
    found = fit(TWO, prior="hierarchical").scale
    assert found[0] - found[1] == pytest.approx(above / below, rel=0.04)


def test_many_answers_leave_the_most_likely_scale():
    fit, plain = thurstone(paper(), prior="hierarchical"), thurstone(paper())
    assert fit.scale == pytest.approx(plain.scale, rel=0.01)
    assert fit.se == pytest.approx(plain.se, rel=0.02)
    assert fit.log_likelihood == pytest.approx(plain.log_likelihood, abs=0.1)


@pytest.mark.parametrize("spread", [0.3, 1.0, 3.0])
def test_the_spread_is_found(spread):
    truth = spread * np.random.default_rng(4).standard_normal(24)
    found = spread_posterior(simulate(list(truth), people=30, seed=2).comparisons(), "probit")
    assert found.spread == pytest.approx(np.std(truth), rel=0.2)
    assert found.weights.sum() == pytest.approx(1.0)


def test_what_never_lost_is_placed():
    answers = [("a", "b")] * 3 + [("b", "c")] * 3
    a, b, c = thurstone(answers, prior="hierarchical").scale
    assert np.inf > a > b > c > -np.inf


def test_independent_people_have_the_errors_of_independent_answers():
    """Of the mean variance over studies; people here differ by nothing but chance."""
    truth = list(np.random.default_rng(1).standard_normal(6))
    ratios = []
    for seed in range(12):
        answers = simulate(truth, people=40, seed=seed)
        fit = thurstone(answers, prior="hierarchical")
        ratios.append(np.trace(fit.covariance("people")) / np.trace(fit.covariance("expected")))
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.08)


def test_a_unit_changes_nothing_but_the_unit():
    fit = thurstone(paper(), prior="hierarchical")
    assert fit.to("JOD").se == pytest.approx(fit.se / 0.67449, rel=1e-4)
    assert fit.posterior.spread == fit.to("JOD").posterior.spread


def test_before_answers_a_value_varies_as_the_prior_says():
    spreads = np.geomspace(0.2, 5.0, 11)
    assert prior_variance("probit") == pytest.approx(
        np.average(spreads**2, weights=of_spread(spreads))
    )
    assert prior_variance("logit") == pytest.approx(prior_variance("probit") / 0.6139**2, rel=1e-3)


# --- bias reduction -------------------------------------------------------------------------------


def of_jeffreys(counts):
    """Bradley and Terry's most likely scale with Jeffreys' prior, by another optimiser."""
    wins = counts.matrix
    size = len(wins)
    total = wins + wins.T

    def height(free):
        values = np.append(free, -free.sum())
        chance = expit(values[:, None] - values[None, :])
        weight = total * chance * (1 - chance)
        information = np.diag(weight.sum(axis=1)) - weight
        told = (wins * np.log(chance)).sum()
        return -told - 0.5 * np.linalg.slogdet(information[1:, 1:])[1]

    free = minimize(height, np.zeros(size - 1), method="BFGS", options={"gtol": 1e-8}).x
    return np.append(free, -free.sum())


def test_the_logit_scale_is_the_most_likely_one_with_jeffreys_prior():
    """Firth (1993), section 3.1: in canonical models the two are one."""
    wins = np.array([[0, 3, 5, 4], [1, 0, 2, 6], [0, 2, 0, 3], [0, 0, 1, 0]])
    counts = Comparisons.of_counts(wins)
    found = bradley_terry(counts, method="bias-reduced").scale
    assert found == pytest.approx(of_jeffreys(counts), abs=1e-5)


@pytest.mark.parametrize(("fit", "chance"), [(thurstone, ndtr), (bradley_terry, expit)])
def test_two_stimuli_are_less_biased_than_by_the_likelihood(fit, chance):
    """Exactly: over all outcomes of 20 answers, each by how likely it is."""
    from scipy.stats import binom

    lead, answers = 0.6, 20
    means = {"bias-reduced": 0.0, "maximum-likelihood": 0.0}
    for method, won in product(means, range(1, answers)):
        counts = Comparisons.of_counts([[0, won], [answers - won, 0]])
        found = fit(counts, method=method).scale
        means[method] += binom.pmf(won, answers, chance(lead)) * (found[0] - found[1])
    # Without the two outcomes that have no most likely scale, for both.
    within = binom.cdf(answers - 1, answers, chance(lead)) - binom.pmf(0, answers, chance(lead))
    bias = {name: mean / within - lead for name, mean in means.items()}
    assert abs(bias["bias-reduced"]) < 0.3 * bias["maximum-likelihood"]


def test_the_side_is_bias_reduced_too():
    answers = simulate([0.4, 0.0, -0.4], people=60, repeats=2, seed=3, order=0.3)
    fit = thurstone(answers, "bias-reduced", order=True)
    plain = thurstone(answers, order=True)
    assert 0.9 < fit.order_effect / plain.order_effect < 1.0
    assert fit.scale == pytest.approx(plain.scale, abs=0.01)


def test_bias_reduction_places_what_never_lost():
    scale = thurstone([("a", "b")] * 3 + [("b", "c")] * 3, "bias-reduced").scale
    assert np.isfinite(scale).all()
    assert scale[0] > scale[1] > scale[2]


def test_both_fits_are_tested_and_told_apart_as_others():
    answers = simulate([0.5, 0.2, 0.0, -0.7], people=12, seed=1)
    for options in ({"prior": "hierarchical"}, {"method": "bias-reduced"}):
        fit = thurstone(answers, **options)
        assert goodness(fit).df == 3
        assert len(fit.differences()) == 6
        assert "over people" in str(fit)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"prior": "flat"}, "prior is 'flat'; allowed: a spread, 0.001 to 1000, 'hierarchical'"),
        ({"prior": "hierarchical", "design": np.eye(7)}, "prior is 'hierarchical'; allowed with a"),
        ({"method": "bias-reduced", "prior": 1.0}, "prior is given; allowed with method 'bias-red"),
        ({"method": "bias-reduced", "ties": True}, "ties is True; allowed with method 'bias-reduc"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(arguments, message):
    with pytest.raises(InputError) as refusal:
        thurstone(paper(), **arguments)
    assert message in str(refusal.value)


def test_answers_that_do_not_join_all_have_no_bias_reduced_scale():
    with pytest.raises(InputError, match="no scale joins all stimuli"):
        thurstone([("a", "b"), ("c", "d")], "bias-reduced")


@pytest.mark.parametrize("options", [{"prior": "hierarchical"}, {"method": "bias-reduced"}])
def test_nothing_is_drawn_again_for_these_fits(options):
    with pytest.raises(InputError, match="allowed here"):
        thurstone(paper(), **options).bootstrap()

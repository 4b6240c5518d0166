"""Goodness of fit: published numbers, chi-squared where the model holds, and plain words."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2, kstest, norm

import nacreous as nc
from nacreous.scaling import Answers, Comparisons, bradley_terry, goodness, paper, thurstone
from nacreous.scaling import paper_proportions as proportions

GOLDEN = json.loads((Path(__file__).parent.parent / "golden/thurstone/reference.json").read_text())
PROBIT = GOLDEN["probit_maximum_likelihood"]
LOGIT = GOLDEN["bradley_terry_maximum_likelihood"]


@pytest.mark.parametrize(("fit", "golden"), [(thurstone, PROBIT), (bradley_terry, LOGIT)])
def test_deviance_and_pearson_are_those_of_r(fit, golden):
    found = goodness(fit(paper()))
    assert found.g2 == pytest.approx(golden["deviance_G2"], abs=6e-4)
    assert found.x2 == pytest.approx(golden["pearson_X2"], abs=6e-3)
    assert found.df == golden["df"]
    assert found.g2_p_value == pytest.approx(chi2.sf(golden["deviance_G2"], 15), rel=0.01)


def test_mostellers_test_is_the_published_one():
    golden = GOLDEN["mosteller_chi2"]
    counts = goodness(thurstone(paper(), method="least-squares"))
    shares = Comparisons.of_proportions(proportions(), answers=104)
    printed = goodness(thurstone(shares, method="least-squares"))
    assert counts.mosteller == pytest.approx(golden["from_counts"], abs=6e-3)
    assert printed.mosteller == pytest.approx(golden["from_p_2dec"], abs=6e-3)
    assert counts.df == printed.df == golden["df"]


def test_case_v_does_not_describe_the_papers_data():
    found = goodness(thurstone(paper()))
    assert found.verdict == "case V does not describe these data; largest misfit 1-3"
    assert found.describes is False
    assert "G2/df is 6.9" in found.advice
    assert "resample people" in found.advice
    assert found.largest[:2] == ("1", "3")
    assert found.largest.observed == 77 / 104


def test_residuals_are_pearsons_by_hand():
    fit = thurstone(paper())
    share = fit.proportions
    wins = paper().matrix
    with np.errstate(invalid="ignore"):
        by_hand = (wins - 104 * share) / np.sqrt(104 * share * (1 - share))
    found = goodness(fit)
    off = ~np.eye(7, dtype=bool)
    assert found.residuals[off] == pytest.approx(by_hand[off])
    assert np.isnan(np.diag(found.residuals)).all()
    assert np.sum(found.residuals[np.triu_indices(7, 1)] ** 2) == pytest.approx(found.x2)


def simulated(seed: int, sided: bool = False) -> Comparisons:
    """Simulated answers of case V: 200 a pair, six stimuli."""
    random = np.random.default_rng(seed)
    values = np.array([-0.8, -0.4, -0.1, 0.2, 0.4, 0.7])
    left, right = np.triu_indices(6, 1)
    wins = random.binomial(200, norm.cdf(values[left] - values[right]))
    counts = np.zeros((6, 6), int)
    counts[left, right], counts[right, left] = wins, 200 - wins
    return Comparisons.of_counts(counts)


def test_where_case_v_holds_the_statistics_are_chi_squared():
    found = [goodness(thurstone(simulated(seed))) for seed in range(300)]
    for name in ("g2_p_value", "x2_p_value", "mosteller_p_value"):
        assert kstest([getattr(each, name) for each in found], "uniform").pvalue > 1e-3
    adjusted = np.array([each.adjusted[np.triu_indices(6, 1)] for each in found])
    assert adjusted.std(axis=0) == pytest.approx(1, abs=0.2)
    assert found[0].verdict == "nothing in these counts speaks against case V"
    assert found[0].advice == ""


@pytest.mark.parametrize("answers", [3, 5, 15])
def test_few_answers_a_pair_condemn_no_model(answers):
    """Simulated: where case V holds, about one study in twenty may be refused, and not nearly all,
    as by G2 with few answers."""
    random = np.random.default_rng(answers)
    values = np.linspace(-0.6, 0.6, 12)
    left, right = np.triu_indices(12, 1)
    refused, by_g2 = [], []
    for _ in range(300):
        wins = random.binomial(answers, norm.cdf(values[left] - values[right]))
        counts = np.zeros((12, 12), int)
        counts[left, right], counts[right, left] = wins, answers - wins
        try:
            found = goodness(thurstone(counts))
        except nc.InputError:  # one always won
            continue
        assert found.sparse > 0.2
        refused.append(not found.describes)
        by_g2.append(found.g2_p_value < 0.05)
    assert len(refused) > 200
    assert 0.01 < np.mean(refused) < 0.1
    assert answers > 5 or np.mean(by_g2) > 0.2


def near_certain(random: np.random.Generator, values: np.ndarray) -> np.ndarray:
    """Counts of simulated answers of case V, 30 a pair."""
    left, right = np.triu_indices(len(values), 1)
    wins = random.binomial(30, norm.cdf(values[left] - values[right]))
    counts = np.zeros((len(values),) * 2, int)
    counts[left, right], counts[right, left] = wins, 30 - wins
    return counts


@pytest.mark.parametrize("ends", [5.0, 2.5])
@pytest.mark.parametrize("drawn_together", [{"method": "bias-reduced"}, {"prior": 1.0}])
def test_pairs_that_are_near_certain_condemn_no_model(ends, drawn_together):
    """Simulated: 3 to 8 in 100 of many such studies are refused (docs/scaling.md)."""
    random = np.random.default_rng(3)
    values = np.array([ends, 0.5, 0.0, -0.5, -ends])
    found = [goodness(thurstone(near_certain(random, values), **drawn_together)) for _ in range(60)]
    assert all(each.describes is not None for each in found)
    assert np.mean([not each.describes for each in found]) < 0.12


def test_beside_near_certain_pairs_a_circle_and_a_reversed_pair_are_still_found():
    counts = near_certain(np.random.default_rng(1), np.array([4.0, 0.3, 0.0, -0.3, -4.0]))
    circle = counts.copy()
    for first, second in ((1, 2), (2, 3), (3, 1)):
        circle[first, second], circle[second, first] = 22, 8
    assert goodness(thurstone(circle, method="bias-reduced")).describes is False
    reversed_pair = counts.copy()
    reversed_pair[0, 4], reversed_pair[4, 0] = 15, 15
    assert goodness(thurstone(reversed_pair, method="bias-reduced")).describes is False


def test_where_all_other_pairs_are_near_certain_one_pair_tells_nothing():
    counts = [[0, 30, 30], [0, 0, 17], [0, 13, 0]]
    found = goodness(thurstone(counts, method="bias-reduced"))
    assert (found.df, found.x2_p_value, found.describes) == (1, None, None)
    assert found.verdict.startswith("too few answers a pair to tell")


def test_one_answer_a_pair_tells_nothing_of_the_fit():
    random = np.random.default_rng(9)
    counts = np.triu(random.integers(0, 2, (30, 30)), 1)
    counts += np.tril(1 - counts.T, -1)
    found = goodness(bradley_terry(counts))
    assert found.describes is None
    assert found.verdict.startswith(
        "too few answers a pair to tell whether the Bradley-Terry model"
    )
    assert found.advice == ""


def test_two_stimuli_leave_nothing_to_test():
    found = goodness(thurstone([[0, 7], [3, 0]]))
    assert (found.df, found.g2_p_value, found.describes) == (0, None, None)
    assert found.g2 == pytest.approx(0, abs=1e-9)
    assert found.verdict.startswith("nothing to test")


def test_a_tree_is_always_fitted_exactly():
    found = goodness(thurstone([[0, 7, 0], [3, 0, 4], [0, 5, 0]]))
    assert found.df == 0
    assert found.x2 == pytest.approx(0, abs=1e-9)
    assert np.isfinite(found.adjusted[0, 1])
    assert np.isnan(found.adjusted[0, 2])


def answers(seed: int = 5) -> Answers:
    """Simulated answers with sides and ties."""
    random = np.random.default_rng(seed)
    pairs = np.array([random.permutation(4)[:2] for _ in range(3000)])
    lead = (pairs[:, 0] - pairs[:, 1]) * 0.4 + 0.3 + random.normal(size=3000)
    chosen = np.where(lead > 0.2, "left", np.where(lead < -0.2, "right", "tie"))
    left, right = pairs.T.astype(str)
    return Answers.of_table({"left": left, "right": right, "chosen": chosen})


@pytest.mark.parametrize("fit", [thurstone, bradley_terry])
def test_degrees_of_freedom_count_what_was_fitted(fit):
    data = answers()
    # 6 pairs; 12 where either way round is its own; 2 free shares each where ties are fitted
    assert goodness(fit(data, ties=False)).df == 6 - 3
    assert goodness(fit(data, ties=False, order=True)).df == 12 - 3 - 1
    assert goodness(fit(data, ties=True)).df == 2 * 6 - 3 - 1
    assert goodness(fit(data, ties=True, order=True)).df == 2 * 12 - 3 - 2


def test_the_model_that_made_the_data_passes_and_one_without_the_order_effect_fails():
    data = answers()
    full = goodness(thurstone(data, ties=True, order=True))
    assert full.describes
    assert full.mosteller is None
    assert full.adjusted is None
    no_order = goodness(thurstone(data, ties=True))
    assert no_order.g2 > 0
    with_order = thurstone(data, ties=True, order=True)
    assert with_order.log_likelihood - thurstone(data, ties=True).log_likelihood > 10


def test_ties_count_half_where_no_threshold_is_fitted():
    ties = [[0, 4], [4, 0]]
    with_ties = goodness(thurstone(Comparisons.of_counts([[0, 7], [3, 0]], ties), ties=False))
    halves = goodness(thurstone([[0, 9], [5, 0]]))
    assert with_ties.residuals[0, 1] == pytest.approx(halves.residuals[0, 1], abs=1e-9)


def test_nothing_is_nan_or_infinite_but_pairs_not_compared():
    for data in (answers(), paper(), answers().take(np.arange(200))):
        for fit in (thurstone(data), bradley_terry(data), thurstone(data, ties=True)):
            found = goodness(fit)
            numbers = [found.g2, found.x2, found.g2_p_value, found.overdispersion]
            assert np.isfinite(numbers).all()
            off = ~np.eye(len(fit.stimuli), dtype=bool)
            assert np.isfinite(found.residuals[off]).all()


def test_a_level_outside_0_to_1_is_refused():
    with pytest.raises(nc.InputError, match=r"level is 95; allowed: 0\.5 to 0\.9999"):
        goodness(thurstone(paper()), level=95)

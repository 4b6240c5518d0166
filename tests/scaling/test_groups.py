"""Laws of comparing groups: what is equal is equal, what differs is found, people count once."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.special import log_expit, log_ndtr
from scipy.stats import chi2

from nacreous.problem import InputError
from nacreous.scaling import Answers, bradley_terry, paper, thurstone
from nacreous.scaling.compare.estimate import estimate
from nacreous.scaling.compare.groups import compare_groups
from nacreous.scaling.compare.ratio import cluster_ratio, compare_ratios
from nacreous.scaling.planning.simulation import simulate

TRUTH = np.array([-1.0, -0.5, -0.2, 0.0, 0.2, 0.5, 1.0])
BEFORE = np.array([[0, 30, 38, 40], [20, 0, 31, 36], [12, 19, 0, 30], [10, 14, 20, 0]])
AFTER = np.array([[0, 22, 35, 41], [28, 0, 36, 33], [15, 14, 0, 35], [9, 17, 15, 0]])


def best_log_likelihood(counts, log_chance):
    """By a general optimiser, which knows nothing of scales."""

    def loss(free):
        values = np.append(free, 0.0)
        return -(counts * log_chance(values[:, None] - values[None, :])).sum()

    return -minimize(loss, np.zeros(len(counts) - 1), tol=1e-12).fun


@pytest.mark.parametrize(("model", "log_chance"), [("probit", log_ndtr), ("logit", log_expit)])
def test_likelihood_ratio_is_that_of_a_general_optimiser(model, log_chance):
    found = compare_groups({"a": BEFORE, "b": AFTER}, model=model)
    parts = [best_log_likelihood(counts, log_chance) for counts in (BEFORE, AFTER)]
    expected = 2 * (sum(parts) - best_log_likelihood(BEFORE + AFTER, log_chance))
    assert found.statistic == pytest.approx(expected, abs=1e-6)
    assert found.df == 3
    assert found.p_value == pytest.approx(chi2.sf(expected, 3), abs=1e-6)
    assert found.tests[0].name == "likelihood-ratio"


def test_group_against_itself_does_not_differ():
    found = compare_groups({"a": paper(), "b": paper(), "c": paper()})
    assert found.statistic == pytest.approx(0, abs=1e-8)
    assert found.df == 12
    assert found.p_value == pytest.approx(1)
    assert all(abs(one.difference) < 1e-12 for one in found.differences)
    assert len(found.differences) == 3 * 7


def test_permutation_is_the_default_where_people_are_known():
    groups = {name: simulate(TRUTH, 30, seed=k) for k, name in enumerate("ab")}
    found = compare_groups(groups, same_people=False)
    assert [test.name for test in found.tests] == ["permutation", "likelihood-ratio", "robust-wald"]
    assert found.p_value == found.test("permutation").p_value
    assert found.clustered


def test_score_statistic_is_near_the_likelihood_ratio_where_people_are_alike():
    groups = {name: simulate(TRUTH, 400, seed=k) for k, name in enumerate("ab")}
    found = compare_groups(groups, same_people=False)
    ratio = found.test("likelihood-ratio").statistic
    assert found.statistic == pytest.approx(ratio, rel=0.05)


def test_a_moved_stimulus_is_found_and_named():
    moved = TRUTH.copy()
    moved[3] += 0.8
    groups = {"a": simulate(TRUTH, 60, person_spread=0.4), "b": simulate(moved, 60, seed=2)}
    found = compare_groups(groups, same_people=False)
    assert found.p_value <= 0.01
    assert [one.stimulus for one in found.differences if one.p_adjusted < 0.05] == ["4"]
    (fourth,) = (one for one in found.differences if one.stimulus == "4")
    assert fourth.low < -0.8 * 6 / 7 < fourth.high


def test_answers_given_twice_by_one_person_are_no_more_people():
    """Copying every answer doubles the likelihood ratio and leaves the permutation test alone."""
    groups = {name: simulate(TRUTH, 30, seed=k) for k, name in enumerate("ab")}
    twice = {name: part.take(np.tile(np.arange(len(part)), 2)) for name, part in groups.items()}
    once, doubled = (compare_groups(each, same_people=False) for each in (groups, twice))
    ratios = [each.test("likelihood-ratio").statistic for each in (once, doubled)]
    assert ratios[1] == pytest.approx(2 * ratios[0])
    assert doubled.p_value == once.p_value
    wald = [each.test("robust-wald").statistic for each in (once, doubled)]
    assert wald[1] == pytest.approx(wald[0])


def test_order_of_groups_and_of_answers_does_not_matter():
    one, two = simulate(TRUTH, 30, seed=1), simulate(TRUTH, 40, seed=2)
    found = compare_groups({"a": one, "b": two}, same_people=False)
    turned = compare_groups({"b": two.take(np.arange(len(two))[::-1]), "a": one}, same_people=False)
    for test in found.tests:
        assert turned.test(test.name).statistic == pytest.approx(test.statistic)
    assert turned.differences[0].difference == pytest.approx(-found.differences[0].difference)


def test_people_in_both_groups_have_to_be_declared():
    groups = {name: simulate(TRUTH, 20, seed=k) for k, name in enumerate("ab")}
    with pytest.raises(InputError, match=r'person "simulated 1" is in the groups "a" and "b"; say'):
        compare_groups(groups)


def test_same_people_make_differences_surer_where_their_taste_stays():
    """Someone's own taste is in both groups alike, and no difference between them."""
    random = np.random.default_rng(5)
    own = TRUTH + random.normal(0, 1.0, (60, 7))
    people = [simulate(values, 1, repeats=4, seed=k) for k, values in enumerate(own)]
    again = [simulate(values, 1, repeats=4, seed=k + 100) for k, values in enumerate(own)]
    groups = {"a": _together(people), "b": _together(again)}
    paired, apart = (compare_groups(groups, same_people=same) for same in (True, False))
    assert paired.differences[0].se < 0.6 * apart.differences[0].se
    assert paired.p_value > 0.01


def _together(parts):
    """The answers of several observers, each with a label of their own."""
    columns = {
        name: np.concatenate([getattr(part, name) for part in parts])
        for name in ("left", "right", "outcome")
    }
    person = np.repeat(np.arange(len(parts)), [len(part) for part in parts])
    people = tuple(f"simulated {k + 1}" for k in range(len(parts)))
    return replace(parts[0], people=people, person=person, **columns)


def test_a_side_that_draws_one_group_is_told_apart_from_the_places():
    fair = simulate(TRUTH, 60, tie=0.3, seed=1)
    biased = simulate(TRUTH, 60, tie=0.3, order=0.6, seed=2)
    found = compare_groups({"a": fair, "b": biased}, ties=True, order=True, same_people=False)
    assert (found.df, found.test("likelihood-ratio").df) == (6, 6)
    assert found.p_value > 0.05
    assert [(one.name, one.differs()) for one in found.styles] == [("ties", False), ("side", True)]


def test_errors_are_those_of_statsmodels():
    """GLM of statsmodels 0.15.0, clusters by person, use_correction=False, times sqrt(40 / 39)."""
    scale = np.array([0.3, 0.85, 0.3, 0.4, -0.3, -0.6, -0.95])
    found = estimate(simulate(scale, 40, person_spread=0.6, seed=3))
    values = [0.21353463, 0.76990702, 0.28212722, 0.29638984, -0.33160042, -0.51256743, -0.71779087]
    errors = [0.09158638, 0.11467733, 0.10646469, 0.07800875, 0.09407185, 0.10566183, 0.11118176]
    assert found.fit.scale == pytest.approx(values, abs=1e-7)
    assert np.sqrt(np.diag(found.covariance)) == pytest.approx(errors, abs=1e-7)
    assert found.covariance == pytest.approx(found.fit.covariance("people"), abs=1e-12)


def test_fits_are_those_of_each_group_alone():
    found = compare_groups({"a": BEFORE, "b": AFTER}, model="logit")
    assert found.fits["b"].scale == pytest.approx(bradley_terry(AFTER).scale)
    assert found.shared.scale == pytest.approx(bradley_terry(BEFORE + AFTER).scale)


@pytest.mark.parametrize(
    ("groups", "message"),
    [
        ({"a": BEFORE}, "groups holds "),
        ([BEFORE, AFTER], "groups is"),
        ({"a": BEFORE, "b": AFTER[:3, :3]}, 'group "b" has other stimuli than group "a"'),
        ({"a": BEFORE, "b": np.triu(AFTER)}, 'group "b": '),
    ],
)
def test_bad_groups_are_refused_by_name(groups, message):
    with pytest.raises(InputError) as refusal:
        compare_groups(groups)
    assert message in str(refusal.value)


def test_ratio_of_the_papers_photographs_is_distance_by_spread():
    scale = thurstone(paper()).scale
    found = cluster_ratio(paper(), "1234", "567")
    high, low = scale[:4], scale[4:]
    spread = np.sqrt((3 * np.var(high, ddof=1) + 2 * np.var(low, ddof=1)) / 5)
    assert found.ratio == pytest.approx((high.mean() - low.mean()) / spread)
    assert found.low < found.ratio < found.high
    assert found.corrected > found.ratio


def test_ratio_has_no_unit():
    """Twice the scale of the truth is the same ratio, up to what noise says."""
    truth = np.array([0.6, 0.4, 0.2, -0.3, -0.5, -0.7])
    one = simulate(truth, 5000, model="logit", seed=1)
    two = simulate(2 * truth, 5000, model="logit", seed=2)
    found = compare_ratios({"a": one, "b": two}, "123", "456", "logit", same_people=False)
    assert found.low < 1 < found.high
    assert found.corrected == pytest.approx(1, abs=0.1)


def test_tight_clusters_leave_the_ratio_without_an_upper_end():
    found = cluster_ratio(simulate([1.0, 1.0, 1.0, -1.0, -1.0], 30, seed=3), "123", "45")
    assert found.high is None
    assert found.low > 3


@pytest.mark.parametrize(
    ("first", "second", "message"),
    [
        ("12", "89", 'second names "8"'),
        ("12", "23", 'second names "2" again'),
        ("1", "2", "1 and 1 stimuli"),
        ("567", "1234", "distance is -1.08"),
    ],
)
def test_clusters_that_are_none_are_refused(first, second, message):
    with pytest.raises(InputError) as refusal:
        cluster_ratio(paper(), first, second)
    assert message in str(refusal.value)


def test_two_stimuli_are_enough_to_compare_groups():
    groups = {name: simulate([0.3, 0.0], 40, seed=k) for k, name in enumerate("ab")}
    found = compare_groups(groups, same_people=False)
    assert found.df == 1
    assert 0 < found.p_value <= 1


def test_fewer_people_than_stimuli_get_no_wald_test_and_finite_numbers():
    truth = np.linspace(-1, 1, 20)
    groups = {name: simulate(truth, 8, seed=k) for k, name in enumerate("ab")}
    found = compare_groups(groups, same_people=False)
    assert [test.name for test in found.tests] == ["permutation", "likelihood-ratio"]
    assert all(np.isfinite(one.se) and one.se > 0 for one in found.differences)


def test_a_single_person_tells_nothing_of_how_people_differ():
    alone = simulate(TRUTH[:3], 1, repeats=30)
    with pytest.raises(InputError, match="3 or more people"):
        compare_groups({"a": alone, "b": alone}, same_people=False)


def test_people_who_all_answer_alike_are_refused_but_not_their_counts():
    table = {"left": list("abc") * 4, "right": list("bca") * 4, "chosen": list("abc") * 4}
    people = [str(k // 3) for k in range(12)]
    alike = Answers.of_table({**table, "person": people})
    with pytest.raises(InputError, match="all people answered alike"):
        compare_groups({"a": alike, "b": alike}, same_people=True)
    counts = alike.comparisons()
    assert compare_groups({"a": counts, "b": counts}).p_value == pytest.approx(1)


def test_refusals_offer_no_prior_which_tests_do_not_have():
    with pytest.raises(InputError) as refusal:
        compare_groups({"a": BEFORE, "b": np.triu(AFTER)})
    assert "prior" not in str(refusal.value)

"""Laws of planning: exact powers where they can be had, expectations against simulation."""

import numpy as np
import pytest
from scipy.special import ndtr
from scipy.stats import binom

from nacreous.problem import InputError
from nacreous.scaling import Answers, full_design, thurstone
from nacreous.scaling.compare.estimate import estimate
from nacreous.scaling.planning.expectation import expected_comparisons, unanimous_chances
from nacreous.scaling.planning.plan import Plan

TRUTH = {"a": 0.6, "b": 0.2, "c": 0.0, "d": -0.8}


def test_everything_planned_says_that_it_is_simulated():
    plan = Plan(TRUTH, 20)
    assert plan.power("a", "d", studies=20).simulated
    assert plan.precision(studies=20).simulated
    assert plan.group_power(TRUTH, studies=20).simulated
    assert "simulated" in str(plan.power("a", "d", studies=20))


def test_power_for_two_stimuli_is_the_exact_one():
    """One answer a person: the test depends on the count of wins alone, which is binomial."""
    people, lead = 25, 0.6
    chances = binom.pmf(np.arange(people + 1), people, ndtr(lead))
    exact = 0.0
    for wins in range(1, people):
        answers = Answers.of_table(
            {
                "person": range(people),
                "left": ["a"] * people,
                "right": ["b"] * people,
                "chosen": ["a"] * wins + ["b"] * (people - wins),
            }
        )
        found = estimate(answers)
        t = abs(found.fit.scale[0] - found.fit.scale[1]) / np.sqrt(4 * found.covariance[0, 0])
        exact += chances[wins] * (t > 2.0639)  # 24 degrees of freedom, tables of Student's t
    found = Plan({"a": lead, "b": 0.0}, people).power("a", "b", studies=1000, seed=5)
    assert found.power == pytest.approx(exact, abs=4 * found.se)
    assert found.unplaced == pytest.approx(chances[[0, -1]].sum(), abs=0.002)


def test_more_people_and_larger_leads_are_found_more_often():
    few, many = (Plan(TRUTH, n).power("a", "b", studies=120).power for n in (15, 90))
    assert few < many
    assert Plan(TRUTH, 15).power("a", "d", studies=120).power > few


def test_people_who_differ_take_power_away():
    alike, unlike = (
        Plan(TRUTH, 40, person_spread=s).power("a", "b", studies=250).power for s in (0, 1)
    )
    assert unlike < alike - 0.1


def test_people_needed_reach_the_power_asked_for():
    needed = Plan(TRUTH, 10).people_needed("a", "b", power=0.9, studies=200, seed=2)
    assert needed.low <= needed.people <= needed.high
    again = Plan(TRUTH, needed.people).power("a", "b", studies=400, seed=11)
    assert again.power == pytest.approx(0.9, abs=0.06)
    # It does not matter where the search starts.
    assert Plan(TRUTH, 400).people_needed("a", "b", power=0.9, studies=200).people == pytest.approx(
        needed.people, rel=0.15
    )


def test_alike_stimuli_need_more_people_than_there_are(monkeypatch):
    monkeypatch.setattr("nacreous.scaling.planning.plan._MOST_PEOPLE", 2000)
    with pytest.raises(InputError, match=r"2000 people would not .* stimuli that differ more"):
        Plan([0.0, 0.0, 0.5], 200).people_needed("1", "2", studies=20)


@pytest.mark.parametrize(
    "more",
    [
        {},
        {"person_spread": 0.7},
        {"order": 0.3, "tie": 0.3},
        {"model": "logit", "tie": 0.5, "order": -0.4, "lapse": 0.1},
        {"repeats": 3, "person_spread": 0.5},
    ],
)
def test_expected_counts_are_the_mean_of_simulated_ones(more):
    plan = Plan(TRUTH, 4000, **more)
    expected, found = expected_comparisons(plan), plan.answers(seed=3).comparisons()
    assert (expected.left == found.left).all()
    for name in ("left_wins", "right_wins", "ties"):
        counts, mean = getattr(found, name), getattr(expected, name)
        # Of one person's repeats the errors hang together.
        assert np.abs(counts - mean).max() < 4.5 * np.sqrt(mean.max() * plan.repeats) + 1e-9


@pytest.mark.parametrize(
    "more", [{}, {"person_spread": 0.8, "repeats": 3}, {"tie": 0.1, "order": 0.5, "lapse": 0.02}]
)
def test_unanimous_pairs_are_as_many_as_in_simulated_studies(more):
    plan = Plan({"a": 1.2, "b": 0.0, "c": -1.0}, 6, **more)
    counts = []
    for seed in range(1500):
        found = plan.answers(seed).comparisons().unsided()
        wins = np.stack([found.left_wins, found.right_wins, found.ties])
        counts.append((wins[:2] == wins.sum(axis=0)).sum())
    error = np.std(counts) / np.sqrt(len(counts))
    assert plan.unanimous_pairs == pytest.approx(np.mean(counts), abs=4 * error)
    assert (unanimous_chances(plan) <= 1).all()


def test_scale_of_endless_answers_is_the_truth_shrunk_by_what_people_differ():
    plan = Plan(TRUTH, person_spread=0.5)
    truth = np.array(list(TRUTH.values()))
    assert plan.expected_scale == pytest.approx(truth / np.sqrt(1.5), abs=1e-6)


def test_precision_is_that_of_the_information():
    """200 people alike: errors are the standard errors of expected counts, as theory has them."""
    plan = Plan(TRUTH, 200)
    found = plan.precision(studies=600)
    se = thurstone(expected_comparisons(plan)).se
    assert (np.abs(found.error - se) < 4 * found.error_se).all()
    assert found.half_width == pytest.approx(1.97 * se, rel=0.05)


def test_a_design_may_be_the_pairs():
    design = full_design(list(TRUTH), repeats=2)
    assert len(Plan(TRUTH, 5, pairs=design).answers()) == 5 * 12


def test_progress_rises_to_one():
    seen = []
    Plan(TRUTH, 10).people_needed("a", "d", studies=50, progress=seen.append)
    assert seen == sorted(seen)
    assert seen[-1] == 1


def test_same_seed_same_power():
    one, same = (Plan(TRUTH, 10).power("a", "c", studies=50, seed=4) for _ in range(2))
    assert one == same


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda: Plan([1.0]), "scale: 1 stimuli"),
        (lambda: Plan(TRUTH, people=1), "people is 1; allowed: a whole number, 2 to"),
        (lambda: Plan(TRUTH, lapse=-0.1), "lapse is -0.1"),
        (lambda: Plan(TRUTH, pairs=[("a", "z")]), 'pairs[0] names "z"'),
        (lambda: Plan(TRUTH).power("a", "z"), 'there is no stimulus "z"'),
        (lambda: Plan(TRUTH).power("a", "b", studies=1), "studies is 1"),
        (lambda: Plan(TRUTH).power("a", "b", alpha=0), "alpha is 0"),
        (lambda: Plan(TRUTH).group_power([1.0, 2.0]), "other has other stimuli"),
        (lambda: Plan(TRUTH, pairs=[("a", "b")]).precision(), "give no scale"),
        (lambda: Plan(TRUTH).people_needed("a", "b", power=1), "power is 1"),
    ],
)
def test_plans_that_cannot_be_are_refused(act, message):
    with pytest.raises(InputError) as refusal:
        act()
    assert message in str(refusal.value)

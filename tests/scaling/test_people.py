"""Errors over people, however few: laws of CR2, and truths planted in simulated answers."""

import warnings

import numpy as np
import pytest
from scipy.stats import t

import nacreous as nc
from nacreous.problem import InputError
from nacreous.scaling import Answers, simulate, thurstone
from nacreous.scaling.fit.errors import errors_of
from nacreous.scaling.report.chapters import scale
from nacreous.scaling.report.translation import Words

VALUES = np.array([0.6, 0.6, 0.0, -0.6])


def unequal(people, seed=1):
    """Every other person answers a fifth of the pairs."""
    answers = simulate(VALUES, people, repeats=10, person_spread=0.5, seed=seed)
    chance = np.random.default_rng(seed).random(len(answers))
    return answers.take((answers.person % 2 == 0) | (chance < 0.2))


def test_with_equal_designs_an_interval_over_people_is_the_t_interval_of_their_scores():
    answers = simulate(VALUES, 4, repeats=10, person_spread=0.5)
    fit = thurstone(answers)
    found = fit.difference("1", "4")
    half = t.ppf(0.975, 3) * found.se
    assert abs(found.high - found.value - half) < 1e-12
    assert abs(found.p_value - 2 * t.sf(abs(found.value) / found.se, 3)) < 1e-12
    scores = fit.room.scores(
        nc.scaling.fit.clustering.personal(answers), fit.parameters
    ) @ np.linalg.pinv(fit.room.information(fit.parameters, False))
    moved = scores[:, 0] - scores[:, 3]
    assert abs(found.se**2 / (moved @ moved * 4 / 3) - 1) < 1e-9


def test_corrections_worked_out_person_by_person_are_those_of_equal_designs(monkeypatch):
    fit = thurstone(simulate(VALUES, 5, repeats=3, person_spread=0.5))
    short = errors_of(fit, "people")
    monkeypatch.setattr("nacreous.scaling.fit.clustering._common_degrees", lambda *_, **__: None)
    long = errors_of(fit, "people")
    assert np.abs(long.covariance - short.covariance).max() < 1e-12
    assert np.abs(long.freedom(np.eye(4)) - 4).max() < 1e-9


def test_corrected_scores_have_the_spread_that_they_had_before_the_fit():
    # CR2's definition: under the working model the sandwich is unbiased, sum A (H - H M H) A' = H.
    fit = thurstone(unequal(5))
    found = errors_of(fit, "people").clusters
    contrast = np.array([1.0, 0.0, 0.0, -1.0])
    weights = found.lever @ contrast
    shown = np.einsum("cij,cj->ci", found.seen, weights)
    residual = np.diag(np.einsum("ci,ci->c", weights, shown)) - shown @ found.spread @ shown.T
    observed = np.linalg.pinv(fit.room.information(fit.parameters, False))
    expected = contrast @ observed @ found.seen.sum(axis=0) @ observed @ contrast
    assert abs(np.trace(residual) / expected - 1) < 1e-9


def test_people_who_answered_less_leave_fewer_degrees_of_freedom():
    freedom = errors_of(thurstone(unequal(6)), "people").freedom(np.eye(4))
    assert (freedom > 1).all()
    assert (freedom < 4).all()


@pytest.mark.parametrize("people", [1, 2])
def test_fewer_than_three_people_are_refused_in_words_and_never_a_number(people):
    fit = thurstone(simulate(VALUES, people, repeats=10))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        said = str(fit)
        for ask in (lambda: fit.se, fit.intervals, fit.differences, fit.bootstrap, fit.neighbours):
            with pytest.raises(InputError, match=r"cannot tell how people differ; allowed: 3 or"):
                ask()
    assert "nan" not in said
    assert "+-" not in said
    assert "no errors over people" in said
    assert (fit.intervals(kind="expected")[:, 0] < fit.scale).all()


def test_a_stimulus_judged_by_two_people_is_refused_by_name():
    answers = simulate(VALUES, 5, repeats=10)
    seen = (answers.left != 3) & (answers.right != 3)
    with pytest.raises(InputError, match=r'"4" was judged by 2 of 5 people'):
        thurstone(answers.take(seen | (answers.person < 2))).intervals()


def test_people_who_all_answer_alike_give_no_interval_of_zero_width():
    one = simulate(VALUES, 1, repeats=10)
    rows = np.tile(np.arange(len(one)), 4)
    person = np.repeat(np.arange(4), len(one))
    alike = Answers(
        one.stimuli, one.left[rows], one.right[rows], one.outcome[rows], tuple("abcd"), person
    )
    with pytest.raises(InputError, match="all people answered alike"):
        thurstone(alike).intervals()
    found = nc.scaling.analyse(alike, bootstrap=0)
    assert found.doubt.too_few
    assert (found.doubt.intervals[:, 1] - found.doubt.intervals[:, 0] > 0.1).all()


def test_known_people_are_the_unit_unless_asked_otherwise():
    fit = thurstone(simulate(VALUES, 12, repeats=10, person_spread=0.8))
    over, alone = fit.covariance("people"), fit.covariance("expected")
    assert np.array_equal(fit.covariance(), over)
    assert np.array_equal(fit.se, np.sqrt(np.diag(over)))
    assert fit.difference("1", "4") == fit.difference("1", "4", kind="people")
    assert np.array_equal(fit.intervals(), fit.intervals(kind="people"))
    assert np.trace(over) > 2 * np.trace(alone)
    assert "+- is over people; the scale is that of their average answer" in str(fit)


def test_three_people_hold_the_truth_and_seldom_tell_equals_apart():
    # 250 studies by benchmarks/people.py: 0.938 and 0.024. These are 40.
    held, apart = [], 0
    truth = VALUES / np.sqrt(1 + 2 * 0.5**2)
    for seed in range(40):
        fit = thurstone(simulate(VALUES, 3, repeats=10, person_spread=0.5, seed=seed))
        for one in fit.differences(simultaneous="none"):
            i, j = int(one.first) - 1, int(one.second) - 1
            held.append(one.low <= truth[i] - truth[j] <= one.high)
        equals = [one for one in fit.neighbours() if {one.first, one.second} == {"1", "2"}]
        apart += any(one.p_value < 0.05 for one in equals)
    assert 0.87 < np.mean(held) < 0.99
    assert apart <= 5


def test_two_people_make_a_report_of_these_two_alone():
    answers = simulate(VALUES, 2, repeats=10)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for bootstrap in (0, 100):
            found = nc.scaling.analyse(answers, bootstrap=bootstrap)
            assert found.doubt.too_few
            assert found.doubt.by in ("answers", "information")
            assert "say nothing of others" in scale.doubt(found, Words("en"))


def test_how_many_samples_had_no_scale_is_always_said():
    fit = thurstone(simulate([1.3, 0.0, -1.3], 20, seed=1))
    drawn = fit.bootstrap(100)
    assert drawn.without_maximum > 0
    assert f"{drawn.without_maximum} without a maximum" in repr(drawn)
    found = nc.scaling.analyse(fit.answers, bootstrap=100)
    assert found.doubt.without_maximum > 0
    said = f"of the 100 samples {found.doubt.without_maximum} had no scale of their own"
    assert said in scale.doubt(found, Words("en"))
    whole = nc.scaling.analyse(nc.scaling.paper(), bootstrap=100)
    assert "Every sample had a scale of its own." in scale.doubt(whole, Words("en"))

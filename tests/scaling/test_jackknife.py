"""Errors of least squares over people: laws, and truths that were simulated."""

import numpy as np
import pytest

from nacreous.problem import InputError
from nacreous.scaling import analyse, simulate, thurstone
from nacreous.scaling.fit.errors import errors_of

VALUES = np.array([0.5, 0.5, 0.0, -0.5, -0.5])


def fitted(people=10, repeats=5, seed=1, **known):
    answers = simulate(VALUES, people, repeats=repeats, person_spread=0.5, seed=seed, **known)
    return thurstone(answers, method="least-squares")


def test_known_people_are_the_unit_of_least_squares_too():
    fit = fitted()
    assert np.array_equal(fit.covariance(), fit.covariance("people"))
    assert fit.difference("1", "5") == fit.difference("1", "5", kind="people")
    assert fit.difference("1", "5").se > 1.2 * fit.difference("1", "5", kind="expected").se
    assert "+- is over people" in str(fit)
    own, other = fit.covariance(), fit.to("JOD").covariance()
    assert other == pytest.approx(own * 1.4826**2, rel=1e-4)
    assert fit.to("JOD").parameter_covariance() == pytest.approx(fit.parameter_covariance())


def test_each_person_is_left_out_as_if_never_there():
    fit = fitted(people=6)
    answers, found = fit.answers, errors_of(fit, None).clusters
    for person in range(6):
        rest = thurstone(answers.take(answers.person != person), method="least-squares")
        moved = (rest.scale - fit.scale) * np.sqrt(5 / 6)
        assert found.influence[person] == pytest.approx(moved, abs=1e-12)


def test_people_who_answered_the_same_pairs_have_one_degree_of_freedom_fewer_than_they_are():
    contrast = np.array([[1.0, -1, 0, 0, 0], [0, 1, 0, 0, -1]])
    assert errors_of(fitted(people=7), None).freedom(contrast) == pytest.approx([6, 6])


def test_a_pair_that_one_person_alone_answered_leaves_with_that_person():
    fit = fitted(people=8)
    answers = fit.answers
    first = (answers.left == 0) & (answers.right == 4) | (answers.left == 4) & (answers.right == 0)
    lone = thurstone(answers.take(~first | (answers.person == 0)), method="least-squares")
    rest = lone.answers.take(lone.answers.person != 0)
    moved = thurstone(rest, method="least-squares").scale - lone.scale
    influence = errors_of(lone, None).clusters.influence[0]
    assert influence == pytest.approx(moved * np.sqrt(7 / 8), abs=1e-12)


@pytest.mark.parametrize(("people", "repeats"), [(3, 10), (10, 5)])
def test_least_squares_holds_the_truth_and_seldom_tells_equals_apart(people, repeats):
    """250 studies by benchmarks/people.py: 0.94 and 0.96, 0.01 and 0.02. These are 60."""
    truth, held, apart = VALUES / np.sqrt(1.5), [], 0
    for seed in range(60):
        fit = fitted(people, repeats, seed)
        for one in fit.differences(simultaneous="none"):
            i, j = int(one.first) - 1, int(one.second) - 1
            held.append(one.low <= truth[i] - truth[j] <= one.high)
        equals = [
            one for one in fit.differences() if (one.first, one.second) in (("1", "2"), ("4", "5"))
        ]
        apart += any(one.p_value < 0.05 for one in equals)
    assert 0.89 < np.mean(held) < 0.99
    assert apart <= 6


def test_the_report_of_least_squares_is_over_people_and_says_how():
    fit = fitted()
    found = analyse(fit.answers, method="least-squares", bootstrap=0)
    assert found.doubt.by == "jackknife"
    assert found.doubt.intervals == pytest.approx(fit.intervals())
    assert "leaving each person out in turn" in found.text("x.html")
    assert "CR2" not in found.text("x.html")
    assert "ジャックナイフ法" in found.text("x.html", "ja")


def test_two_people_tell_least_squares_nothing_of_others():
    fit = fitted(people=2, repeats=10)
    with pytest.raises(InputError, match="cannot tell how people differ"):
        fit.intervals()
    assert "no errors over people" in str(fit)
    assert (fit.intervals(kind="expected")[:, 0] < fit.scale).all()


def test_where_all_agree_least_squares_sets_no_end_either():
    """Simulated: in 4.7 z nobody ever chose another stimulus over the first."""
    answers = simulate([5.0, 0.5, 0.0, -0.5], people=30, seed=2)
    fit = thurstone(answers, method="least-squares")
    with pytest.raises(InputError, match="how much farther apart these are cannot be told"):
        fit.intervals()
    assert analyse(answers, method="least-squares", bootstrap=0).doubt.endless[0] == ("1",)

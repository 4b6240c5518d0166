"""The pair that is named as the largest misfit is the one that the test of fit finds."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from nacreous.scaling import (
    Answers,
    Comparisons,
    analyse,
    bradley_terry,
    goodness,
    simulate,
    thurstone,
)

TRUTH = np.array([0.6, 0.2, -0.2, -0.6])


def answers(tie: float = 0.3, order: float = 0.0) -> Answers:
    return simulate(TRUTH, 40, tie=tie, order=order, seed=3)


def with_pair(data: Answers, first: str, second: str, outcome: np.ndarray | int) -> Answers:
    """The same answers, but to one pair; outcome: 1 for the first, -1 for the second, 0 a tie."""
    one, two = (data.stimuli.index(label) for label in (first, second))
    ahead = (data.left == one) & (data.right == two)
    behind = (data.left == two) & (data.right == one)
    found = np.where(ahead, outcome, np.where(behind, -np.asarray(outcome), data.outcome))
    return replace(data, outcome=found.astype(np.int8))


@pytest.mark.parametrize("fit", [thurstone, bradley_terry])
@pytest.mark.parametrize("tie", [0.0, 0.3, 1.5])
def test_squares_of_residuals_of_choices_and_of_ties_sum_to_pearsons_statistic(fit, tie):
    found = goodness(fit(answers(tie), ties=tie > 0))
    upper = np.triu_indices(4, 1)
    squares = found.residuals**2
    if found.tie_residuals is not None:
        assert found.tie_residuals == pytest.approx(found.tie_residuals.T, nan_ok=True)
        squares = squares + found.tie_residuals**2
    assert np.sum(squares[upper]) == pytest.approx(found.x2)
    assert (found.tie_residuals is None) == (tie == 0)
    largest = found.residuals[0] if found.tie_residuals is None else squares
    assert largest is not None
    shares = [one.residual**2 + (one.tie_residual or 0) ** 2 for one in found.misfits]
    assert shares == pytest.approx(np.sort(squares[upper])[::-1][:3])


def test_a_pair_that_everyone_calls_equal_is_the_largest_misfit_by_its_ties():
    data = with_pair(answers(), "2", "3", 0)
    found = analyse(data, bootstrap=0)
    worst = found.goodness.largest
    assert {worst.first, worst.second} == {"2", "3"}
    assert worst.by_ties
    assert worst.ties == 1
    expected = f"{40 * worst.ties_expected:.0f}"
    assert found.goodness.verdict.endswith(
        f"2-3: called equal in 40 of 40; the scale expects {expected}"
    )
    page = found.text("a.html")
    assert "100 of 100 answers called them equal, and the scale expects" in page
    assert "A square table of misfits of ties" in page
    assert "「同じ」という回答は100件あたり100件" in found.text("a.html", "ja")


def test_a_pair_that_nobody_calls_equal_among_many_ties_is_the_largest_misfit():
    random = np.random.default_rng(2)
    tied = answers(1.5)
    data = with_pair(tied, "2", "3", np.where(random.random(len(tied)) < 0.6, 1, -1))
    worst = goodness(thurstone(data)).largest
    assert {worst.first, worst.second} == {"2", "3"}
    assert worst.ties == 0
    assert worst.tie_residual < -2
    assert worst.by_ties


def test_a_pair_that_is_turned_round_is_the_largest_misfit_by_its_choices():
    data = answers()
    one = data.outcome[(data.left == 0) & (data.right == 3)]
    assert len(one)
    found = analyse(with_pair(data, "1", "4", -1), bootstrap=0)
    worst = found.goodness.largest
    assert (worst.first, worst.second) == ("4", "1")
    assert not worst.by_ties
    assert worst.observed == 1
    assert "of 100 answers that chose one of them, 100 chose" in found.text("a.html")


def test_ties_do_not_hide_a_misfit_of_those_who_chose():
    # Half call the pair equal, as expected there; the others all choose against the scale.
    wins = np.array([[0, 60, 60, 0], [20, 0, 60, 60], [20, 20, 0, 60], [60, 20, 20, 0.0]])
    ties = np.full((4, 4), 20.0) - 20 * np.eye(4)
    found = goodness(thurstone(Comparisons.of_counts(wins, ties), ties=True))
    assert (found.largest.first, found.largest.second) == ("4", "1")
    assert not found.largest.by_ties


def test_a_pair_in_which_the_side_does_the_reverse_is_named_with_what_stood_left():
    data = answers(0.0, order=1.0)
    left_one = with_pair(data, "2", "3", np.where(data.left == 1, -1, 1))
    found = analyse(left_one, bootstrap=0, order=True)
    worst = found.goodness.largest
    assert {worst.first, worst.second} == {"2", "3"}
    assert worst.left in ("2", "3")
    assert f"with {worst.left} left" in found.goodness.verdict
    page = found.text("a.html")
    assert f'This is so where <b class="name">{worst.left}</b> stood on the left.' in page


def test_every_pair_in_turn_is_found_where_it_alone_is_called_equal():
    data = answers(0.2)
    for first, second in combinations(data.stimuli, 2):
        for fit in (thurstone, bradley_terry):
            worst = goodness(fit(with_pair(data, first, second, 0))).largest
            assert {worst.first, worst.second} == {first, second}
            assert worst.by_ties

"""Ties and the effect of the side, against plain formulas climbed by another program's search."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.special import ndtr

from nacreous.problem import InputError
from nacreous.scaling import Answers, bradley_terry, thurstone


def simulated(seed, count=3000, threshold=0.3, side=0.2):
    """Simulated answers about four stimuli, with ties and a pull to the left."""
    random = np.random.default_rng(seed)
    value = np.array([0.6, 0.2, -0.1, -0.7])
    left = random.integers(4, size=count)
    right = (left + random.integers(1, 4, size=count)) % 4
    felt = value[left] - value[right] + side + random.standard_normal(count)
    outcome = np.where(felt > threshold, 1, np.where(felt < -threshold, -1, 0)).astype(np.int8)
    return Answers(tuple("abcd"), left, right, outcome)


def shares_probit(lead, width):
    left, right = ndtr(lead - width), ndtr(-lead - width)
    return left, right, 1 - left - right


def shares_davidson(lead, log_nu):
    weights = np.exp(np.array([lead / 2, -lead / 2, log_nu + 0 * lead]))
    return tuple(weights / weights.sum(axis=0))


@pytest.mark.parametrize(
    ("model", "shares"), [(thurstone, shares_probit), (bradley_terry, shares_davidson)]
)
def test_ties_and_side_are_what_a_plain_search_finds(model, shares):
    answers = simulated(1)
    counts = answers.comparisons()

    def loss(p):
        value = np.append(p[:3], -p[:3].sum())
        left, right, tie = shares(value[counts.left] - value[counts.right] + p[3], p[4])
        parts = (counts.left_wins, counts.right_wins, counts.ties)
        shares_of_rows = np.maximum((left, right, tie), 1e-300)
        return -sum((n * np.log(q)).sum() for n, q in zip(parts, shares_of_rows, strict=True))

    found = minimize(loss, [0, 0, 0, 0, 0.2], method="BFGS", options={"gtol": 1e-6})
    fit = model(answers, ties=True, order=True)
    width = fit.tie_threshold if model is thurstone else np.log(fit.tie_threshold)
    assert np.abs(fit.scale[:3] - found.x[:3]).max() < 1e-5
    assert abs(fit.order_effect - found.x[3]) < 1e-5
    assert abs(width - found.x[4]) < 1e-5
    assert abs(fit.log_likelihood + found.fun) < 1e-6


def test_planted_ties_and_side_are_found_again():
    fit = thurstone(simulated(2, 40_000), ties=True, order=True)
    assert np.abs(fit.scale - [0.6, 0.2, -0.1, -0.7]).max() < 0.04
    assert abs(fit.order_effect - 0.2) < 0.03
    assert abs(fit.tie_threshold - 0.3) < 0.02


@pytest.mark.parametrize("model", [thurstone, bradley_terry])
def test_outcomes_of_each_row_add_to_one_and_to_the_counts(model):
    answers = simulated(3)
    fit = model(answers, ties=True, order=True)
    table, counts = fit.outcomes(), fit.comparisons
    assert np.abs(table.sum(axis=1) - 1).max() < 1e-14
    if model is bradley_terry:  # an exponential family: fitted totals are the counted ones
        total = counts.left_wins + counts.right_wins + counts.ties
        assert abs((total * table[:, 2]).sum() - counts.ties.sum()) < 1e-8
        difference = counts.left_wins - counts.right_wins
        assert abs((total * (table[:, 0] - table[:, 1])).sum() - difference.sum()) < 1e-8
    assert np.abs(fit.proportions + fit.proportions.T - 1).max() < 1e-14


def test_a_unit_changes_numbers_and_nothing_else():
    fit = thurstone(simulated(4), ties=True, order=True)
    other = fit.to("JOD")
    assert np.abs(other.outcomes() - fit.outcomes()).max() < 1e-14
    assert np.abs(other.proportions - fit.proportions).max() < 1e-14
    assert np.abs(other.to("z").scale - fit.scale).max() < 1e-15
    assert np.abs(other.se / fit.se - other.scale / fit.scale).max() < 1e-12
    one = bradley_terry([("a", "b")] * 3 + [("b", "a")]).to("JOD")
    assert abs(one.scale[0] - one.scale[1] - 1) < 1e-12  # 75 % prefer a


def test_halved_ties_are_half_an_answer_each():
    answers = simulated(5)
    counts = answers.comparisons()
    doubled = Answers(
        answers.stimuli,
        np.concatenate((answers.left, answers.left)),
        np.concatenate((answers.right, answers.right)),
        np.concatenate(
            (
                np.where(answers.outcome == 0, 1, answers.outcome),
                np.where(answers.outcome == 0, -1, answers.outcome),
            )
        ).astype(np.int8),
    )
    assert counts.ties.sum() > 0
    assert np.abs(thurstone(answers, ties=False).scale - thurstone(doubled).scale).max() < 1e-12


def test_effects_that_the_answers_cannot_tell_are_refused():
    with pytest.raises(InputError, match="no sides here"):
        thurstone([("a", "b"), ("b", "a")], order=True)
    left, right = np.zeros(4, np.int64), np.ones(4, np.int64)
    one_way = Answers(("a", "b"), left, right, np.array([1, 1, -1, 1], np.int8))
    with pytest.raises(InputError, match="order=True"):
        thurstone(one_way, order=True)
    with pytest.raises(InputError, match="ties is"):
        thurstone(one_way, ties="half")


def test_without_a_tie_the_threshold_is_none_at_all():
    answers = [("a", "b"), ("b", "a"), ("a", "b")]
    fit = thurstone(answers, ties=True)
    assert fit.tie_threshold == 0
    assert np.abs(fit.scale - thurstone(answers).scale).max() == 0
    assert fit.outcomes()[:, 2].max() == 0

"""Ties as answers of their own: where that is the default, and what halves would hide."""

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import bradley_terry, compare_groups, goodness, simulate, thurstone
from nacreous.scaling.report.settings import Settings

VALUES = np.linspace(1, -1, 7)


@pytest.mark.parametrize("model", [thurstone, bradley_terry])
def test_ties_are_fitted_by_default_where_they_are_more_than_a_few(model):
    many = simulate(VALUES, 30, tie=0.3, seed=1)
    few = simulate(VALUES, 30, tie=0.02, seed=1)
    assert 0 < (few.outcome == 0).mean() < 0.05 < (many.outcome == 0).mean()
    assert model(many).tie_threshold == model(many, ties=True).tie_threshold
    assert model(many, ties=False).tie_threshold is None
    assert model(few).tie_threshold is None


def test_ties_alone_have_no_threshold_and_count_half():
    fit = thurstone(nc.scaling.Comparisons.of_counts(np.zeros((2, 2)), [[0, 5], [5, 0]]))
    assert fit.tie_threshold is None
    assert fit.scale.tolist() == [0.0, 0.0]


def test_groups_are_fitted_alike_though_one_has_few_ties():
    groups = {"a": simulate(VALUES, 30, tie=0.4, seed=1), "b": simulate(VALUES, 30, tie=0.03)}
    found = compare_groups(groups, same_people=False, permutations=99)
    assert all(fit.tie_threshold is not None for fit in found.fits.values())


def test_a_misfit_is_found_that_halves_would_hide():
    # A bent pair among 20 % ties, 24 studies.
    own, halves = 0, 0
    for seed in range(24):
        answers = simulate(VALUES, 60, tie=0.35, seed=seed)
        turned = (np.minimum(answers.left, answers.right) == 2) & (
            np.maximum(answers.left, answers.right) == 3
        )
        won = np.where(answers.left[turned] == 3, 1, -1)
        outcome = answers.outcome.copy()
        outcome[turned] = np.where(np.arange(won.size) % 3 > 0, won, -won)
        bent = nc.scaling.Answers(answers.stimuli, answers.left, answers.right, outcome)
        own += goodness(thurstone(bent)).describes is False
        halves += goodness(thurstone(bent, ties=False)).describes is False
    assert own > halves


def test_the_command_that_a_report_gives_fits_ties_as_it_did():
    assert Settings().options("en") == ""
    assert Settings(ties=False).options("en") == "--no-ties"
    assert Settings(ties=True).options("en") == "--ties"

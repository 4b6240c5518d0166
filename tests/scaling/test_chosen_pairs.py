"""Pairs chosen by earlier answers do not stretch the scale: a sample of the benchmark."""

import pytest

from tests.scaling.chosen_pairs import Figures, figures

#: Of 20 stimuli with ten answers each; chance moves slopes by 0.03 and coverage by 0.015.
SAMPLE = range(16)


@pytest.fixture(scope="module")
def greedy() -> dict[str, Figures]:
    fits = ("hierarchical", "bias-reduced")
    return figures("greedy", fits, 20, 19, 10, SAMPLE, known=False)


def test_the_same_prior_in_choosing_and_fitting_keeps_the_scale(greedy) -> None:
    found = greedy["hierarchical"]
    assert found.truth_on_estimate == pytest.approx(1.015, abs=0.12)
    assert 0.90 < found.coverage < 0.99


def test_bias_reduction_alone_leaves_it_stretched(greedy) -> None:
    assert greedy["bias-reduced"].estimate_on_truth > 1.12
    assert greedy["bias-reduced"].coverage < greedy["hierarchical"].coverage


def test_pairs_by_lot_leave_more_error_with_the_same_fit(greedy) -> None:
    lots = figures("lots", ("hierarchical",), 20, 19, 10, SAMPLE, known=False)["hierarchical"]
    assert greedy["hierarchical"].squared_error < 0.95 * lots.squared_error


def test_drawn_pairs_with_bias_reduction_are_as_wide_as_the_truth() -> None:
    found = figures("drawn", ("bias-reduced",), 20, 19, 10, SAMPLE, known=False)["bias-reduced"]
    assert found.estimate_on_truth == pytest.approx(1.02, abs=0.1)
    assert found.coverage > 0.91

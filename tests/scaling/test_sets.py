"""Laws of comparing two sets: agreement as defined elsewhere, and movers found where planted."""

import numpy as np
import pytest
from scipy.stats import kendalltau, pearsonr, spearmanr

from nacreous.problem import InputError
from nacreous.scaling import paper, thurstone
from nacreous.scaling.compare.alignment import align, shifts
from nacreous.scaling.compare.sets import compare_sets
from nacreous.scaling.planning.simulation import simulate

TRUTH = np.array([0.9, 0.6, 0.3, 0.0, -0.3, -0.6, -0.9])


@pytest.fixture(scope="module")
def unlike():
    """Two sets with little in common."""
    one = simulate(TRUTH, 40, seed=1)
    two = simulate(TRUTH[[2, 0, 5, 1, 6, 4, 3]], 40, seed=2)
    return compare_sets(one, two, same_people=False)


def test_coefficients_are_scipys(unlike):
    scales = unlike.first.scale, unlike.second.scale
    assert unlike.kendall.value == pytest.approx(kendalltau(*scales).statistic)
    assert unlike.spearman.value == pytest.approx(spearmanr(*scales).statistic)
    assert unlike.pearson.value == pytest.approx(pearsonr(*scales).statistic)


def test_every_interval_holds_its_value_and_is_within_bounds(unlike):
    for found in (unlike.kendall, unlike.spearman, unlike.pearson):
        assert -1 <= found.low <= found.value <= found.high <= 1
    assert unlike.slope.low < unlike.slope.value


def test_slope_is_demings_where_errors_are_alike():
    """Deming's closed form (1943), which holds for the same independent errors everywhere."""
    random = np.random.default_rng(3)
    x = TRUTH + random.normal(0, 0.1, 7)
    y = 1.7 * TRUTH + 0.2 + random.normal(0, 0.15, 7)
    ratio = 0.15**2 / 0.1**2
    (xx, xy), (_, yy) = np.cov(x, y)
    lead = yy - ratio * xx
    found = align(x, y, np.diag(np.repeat([0.1**2, 0.15**2], 7)), 0.95)
    assert found.value == pytest.approx((lead + np.hypot(lead, 2 * xy * ratio**0.5)) / (2 * xy))
    assert found.df == 5


def test_a_set_agrees_with_itself():
    found = compare_sets(paper(), paper())
    assert found.kendall.value == found.spearman.value == found.pearson.value == pytest.approx(1)
    assert found.slope.value == pytest.approx(1, abs=1e-6)
    assert found.statistic == pytest.approx(0, abs=1e-9)
    assert found.moved == ()
    assert all(move.places == 0 for move in found.moves)


def test_another_unit_is_no_move():
    found = compare_sets(
        simulate(TRUTH, 300, seed=1), simulate(2 * TRUTH, 300, seed=2), same_people=False
    )
    assert found.slope.low < 2 < found.slope.high
    assert found.moved == ()
    assert found.p_value > 0.01


def test_one_planted_mover_is_found_alone_with_its_places():
    moved = TRUTH.copy()
    moved[1] -= 0.75  # from the second place to the fourth
    found = compare_sets(
        simulate(TRUTH, 400, seed=1), simulate(moved, 400, seed=2), same_people=False
    )
    assert found.moved == ("2",)
    move = found.moves[1]
    assert (move.first_place, move.second_place, move.places) == (2, 4, -2)
    assert move.low < -0.75 < move.high
    assert move.places_low <= -2 <= move.places_high


def test_values_in_moves_are_the_scales(unlike):
    assert [move.first for move in unlike.moves] == pytest.approx(unlike.first.scale)
    assert [move.second for move in unlike.moves] == pytest.approx(unlike.second.scale)


def test_more_answers_make_narrower_intervals():
    few, many = (
        compare_sets(simulate(TRUTH, n, seed=1), simulate(TRUTH, n, seed=2), same_people=False)
        for n in (30, 1000)
    )
    for name in ("kendall", "spearman", "pearson", "slope"):
        wide, narrow = getattr(few, name), getattr(many, name)
        assert narrow.high - narrow.low < wide.high - wide.low


def test_same_seed_same_intervals():
    one, two = (compare_sets(paper(), paper(), seed=4).kendall for _ in range(2))
    assert one == two


def test_sets_that_cannot_be_compared_are_refused():
    three = thurstone(paper()).comparisons.matrix[:3, :3]
    with pytest.raises(InputError, match=r"3 stimuli; allowed: 4 or more"):
        compare_sets(three, three)
    with pytest.raises(InputError, match=r'group "second" has other stimuli'):
        compare_sets(paper(), three)
    flat = np.full((4, 4), 5) - 5 * np.eye(4, dtype=int)
    with pytest.raises(InputError, match=r"alike; no order to compare"):
        compare_sets(flat, flat)


def test_offsets_are_those_from_the_line_without_the_stimulus():
    """All at once, against each line laid anew; errors everywhere alike."""
    random = np.random.default_rng(8)
    x, y = (TRUTH + random.normal(0, 0.1, 7) for _ in range(2))
    joint = np.diag(np.full(14, 0.1**2))
    found = shifts(x, y, joint, align(x, y, joint, 0.95).value, 0.95, np.inf)
    for k in range(7):
        others = np.arange(7) != k
        both = np.diag(np.full(12, 0.1**2))
        slope = align(x[others], y[others], both, 0.95).value
        off = y - slope * x
        assert found.value[k] == pytest.approx(off[k] - off[others].mean(), abs=0.03)


def test_more_stimuli_than_people_give_finite_answers():
    truth = np.random.default_rng(2).normal(0, 0.7, 40)
    one, two = (simulate(truth, 15, seed=seed) for seed in (1, 2))
    found = compare_sets(one, two, same_people=False)
    assert found.slope.low < 1 < found.slope.high
    assert found.p_value > 0.001
    assert len(found.moved) <= 1
    assert all(np.isfinite(move.se) for move in found.moves)


def test_a_set_without_a_scale_leaves_the_slope_unbounded_or_wide():
    flat = simulate(np.zeros(4), 10, seed=2)
    found = compare_sets(simulate([0.05, 0.0, 0.0, 0.0], 10, seed=1), flat, same_people=False)
    assert found.slope.low is None or found.slope.high is None

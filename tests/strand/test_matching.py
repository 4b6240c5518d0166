"""A strand's score: laws of what matches."""

from __future__ import annotations

import numpy as np
import pytest

import nacreous as nc
from nacreous.strand import AKOYA, Form, Lot, Matching, Population, matching
from nacreous.strand.matching import looks_apart
from nacreous.strand.order import ordered

PEARL = [7.2, 94.0, 0.5, 4.0, 0.035]


def strand(*changes: dict[int, float]) -> Lot:
    values = np.tile(PEARL, (len(changes), 1))
    for row, change in enumerate(changes):
        for column, value in change.items():
            values[row, column] = value
    return Lot(tuple(map(str, range(len(changes)))), values)


def test_pearls_that_are_all_alike_score_zero() -> None:
    assert matching(strand({}, {}, {}), np.full(3, 7.0)) == Matching(0.0, 0.0)
    assert matching(strand({}), np.full(1, 7.0)).score == 0.0


def test_each_difference_counts_by_its_stated_weight() -> None:
    flat = np.full(2, 7.2)
    lab = np.array([PEARL[1:4], [93.0, 0.5, 4.0]])
    assert matching(strand({}, {1: 93.0}), flat).score == nc.colour.delta_e_2000(*lab)
    assert matching(strand({}, {0: 7.3}), flat).score == pytest.approx(1.0)
    assert matching(strand({}, {4: 0.035 * np.e}), flat).score == pytest.approx(5.0)


def test_neighbours_are_those_side_by_side_and_overall_are_all_pairs() -> None:
    found = matching(strand({}, {0: 7.3}, {0: 7.4}), np.full(3, 7.2))
    assert found.neighbours == pytest.approx(1.0)
    assert found.overall == pytest.approx(4 / 3)
    assert found.score == pytest.approx(7 / 6)


def test_neither_names_nor_direction_change_the_score() -> None:
    lot = AKOYA.draw(30, seed=3)
    flat = np.full(30, 7.0)
    renamed = Lot(lot.names[::-1], lot.values)
    assert matching(renamed, flat) == matching(lot, flat)
    back = matching(lot.take(np.arange(30)[::-1]), flat)
    assert back.score == pytest.approx(matching(lot, flat).score)


def test_a_strand_of_exactly_its_form_loses_nothing_by_being_graduated() -> None:
    form = Form(7, 0.9)
    sizes = 6.0 + form.above_ends_mm
    values = np.tile(PEARL, (7, 1))
    values[:, 0] = sizes
    lot = Lot(tuple("abcdefg"), values)
    assert matching(lot, sizes + 0.3).score == pytest.approx(0)
    assert matching(lot, np.full(7, 6.0)).score > 3


def test_an_even_order_has_less_between_neighbours_than_chance() -> None:
    lot = AKOYA.draw(40, seed=5)
    apart = looks_apart(lot)
    order = ordered(apart, lot.size_mm, Form(40))
    assert sorted(order) == list(range(40))
    by_chance = np.diagonal(apart, 1).mean()
    assert np.diagonal(apart[np.ix_(order, order)], 1).mean() < 0.7 * by_chance


def test_a_graduated_order_is_the_best_of_all_that_grow_to_the_centre() -> None:
    lot = AKOYA.draw(9, seed=8)
    apart, by_size = looks_apart(lot), np.argsort(lot.size_mm)
    order = ordered(apart, lot.size_mm, Form(9, 0.5))
    sums = []
    for swaps in range(16):
        left, right = [], []
        for step in range(4):
            pair = by_size[2 * step : 2 * step + 2][:: -1 if swaps >> step & 1 else 1]
            left.append(pair[0])
            right.append(pair[1])
        chain = [*left, by_size[8], *right[::-1]]
        sums.append(apart[chain[:-1], chain[1:]].sum())
    # The centre's pearl meets the same two, on whichever side they hang.
    assert apart[order[:-1], order[1:]].sum() == pytest.approx(min(sums))


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ([[31, 94, 0, 4, 0.03]], "pearl a: size_mm is 31; allowed: 1 to 30"),
        ([[7, 94, 0, 4, float("nan")]], "pearl a: facet_spread_rad is nan; allowed: 0.005 to 0.6"),
        ([[7, 94, 0, 4]], r"values has shape \[1, 4\]; allowed: \[1, 5\]"),
    ],
)
def test_a_bad_pearl_is_told_by_its_name(values: list[list[float]], said: str) -> None:
    with pytest.raises(nc.InputError, match=said):
        Lot(("a",), values)


def test_a_lot_has_a_name_for_each_pearl() -> None:
    with pytest.raises(nc.InputError, match="2 pearls are called 'a'; allowed: a name each"):
        Lot(("a", "a"), [PEARL, PEARL])


def test_a_population_has_its_means_and_spreads() -> None:
    lot = AKOYA.draw(5000, seed=2)
    mean, spread = lot.values.mean(axis=0), lot.values.std(axis=0)
    assert mean[:4] == pytest.approx([7.25, 94, 0.5, 4], abs=0.12)
    assert spread[:4] == pytest.approx([0.25, 1.5, 1.0, 2.0], rel=0.05)
    assert np.log(lot.facet_spread_rad).std() == pytest.approx(0.25, rel=0.05)
    assert np.median(lot.facet_spread_rad) == pytest.approx(0.035, rel=0.03)
    assert lot == AKOYA.draw(5000, seed=2) != AKOYA.draw(5000, seed=3)
    with pytest.raises(nc.InputError, match='"sise_mm" is no quantity of a lot; did you mean size'):
        AKOYA.replace({"sise_mm": 7}, {})
    with pytest.raises(nc.InputError, match="deviation has nothing; allowed: size_mm, L, a, b"):
        Population(AKOYA.mean, {})
    with pytest.raises(nc.InputError, match="spread L is -1; allowed: 0 to 100"):
        AKOYA.replace({}, {"L": -1})

"""Lots sorted into strands: whole, better than sorting and cutting, true to their form."""

from __future__ import annotations

import numpy as np
import pytest

import nacreous as nc
from nacreous.strand import AKOYA, Form, Lot, Sorting, cut_lot, sort_lot
from nacreous.strand.share import shares

LOT = AKOYA.draw(300, seed=1)
EVEN, GRADUATED = Form(30), Form(29, 0.6)


@pytest.fixture(scope="module", params=[EVEN, GRADUATED], ids=["even", "graduated"])
def form(request: pytest.FixtureRequest) -> Form:
    return request.param


@pytest.fixture(scope="module")
def sorting(form: Form) -> Sorting:
    return sort_lot(LOT, form)


def test_every_pearl_is_in_one_strand_or_left_over(form: Form, sorting: Sorting) -> None:
    placed = np.concatenate([*(one.pearls for one in sorting.strands), sorting.spare])
    assert sorted(placed) == list(range(len(LOT)))
    assert {len(one.pearls) for one in sorting.strands} == {form.length}
    assert len(sorting.strands) == 10


def test_sorting_beats_sorting_and_cutting(form: Form, sorting: Sorting) -> None:
    least = {0.0: 0.05, 0.6: 0.15}[form.graduation_mm]  # found: 7 %, and 22 %
    assert sorting.score < (1 - least) * cut_lot(LOT, form).score


def test_names_do_not_matter(form: Form, sorting: Sorting) -> None:
    renamed = sort_lot(Lot(LOT.names[::-1], LOT.values), form)
    assert renamed == sorting


def test_the_order_of_a_lot_hardly_matters(form: Form, sorting: Sorting) -> None:
    shuffled = LOT.take(np.random.default_rng(4).permutation(len(LOT)))
    assert sort_lot(shuffled, form).score == pytest.approx(sorting.score, rel=0.03)


def test_sizes_grow_from_both_ends_to_the_centre() -> None:
    for strand in sort_lot(LOT, GRADUATED).strands:
        size_mm = LOT.size_mm[strand.pearls]
        assert (np.diff(size_mm[:15]) >= 0).all()
        assert (np.diff(size_mm[14:]) <= 0).all()


def test_graduated_strands_that_were_mixed_are_found_again() -> None:
    form = Form(15, 0.7)
    values = np.tile([7.2, 94.0, 0.5, 4.0, 0.035], (30, 1))
    values[:, 0] = np.concatenate([6.0 + form.above_ends_mm, 6.1 + form.above_ends_mm])
    values[15:, 3] += 3.0
    mixed = np.random.default_rng(6).permutation(30)
    sorting = sort_lot(Lot(tuple(map(str, mixed)), values[mixed]), form)
    assert sorting.score == pytest.approx(0, abs=1e-9)


def test_two_kinds_of_pearl_are_told_apart() -> None:
    """By size, by colour or by luster: whatever differs, no strand mixes the two."""
    for column, other in ((0, 8.5), (3, 9.0), (4, 0.1)):
        values = np.tile([7.2, 94.0, 0.5, 4.0, 0.035], (40, 1))
        values[::2, column] = other
        lot = Lot(tuple(map(str, range(40))), values)
        sorting = sort_lot(lot, Form(20))
        assert sorting.score == pytest.approx(0, abs=1e-9)


def test_what_matches_nothing_is_left_over() -> None:
    values = np.tile([7.2, 94.0, 0.5, 4.0, 0.035], (22, 1))
    values[5, 3], values[11, 0] = 25.0, 5.0
    lot = Lot(tuple(map(str, range(22))), values)
    assert sort_lot(lot, Form(20)).spare.tolist() == [5, 11]


def test_shares_are_fair_and_their_sum_is_least() -> None:
    random = np.random.default_rng(3)
    costs = random.random((9, 2, 1))
    first, second = shares(costs, Form(4))
    assert len(first) == len(second) == 4
    assert not set(first) & set(second)
    found = costs[first, 0, 0].sum() + costs[second, 1, 0].sum()
    from itertools import combinations

    least = min(
        costs[list(one), 0, 0].sum() + np.sort(costs[np.setdiff1d(range(9), one), 1, 0])[:4].sum()
        for one in combinations(range(9), 4)
    )
    assert found == pytest.approx(least)


def test_progress_grows_to_the_end() -> None:
    told: list[float] = []
    sort_lot(LOT, EVEN, show=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0


def test_what_cannot_be_sorted_is_refused() -> None:
    with pytest.raises(nc.InputError, match="length is 301; allowed: up to 300, the lot's pearls"):
        sort_lot(LOT, Form(301))
    with pytest.raises(nc.InputError, match="length is 1; allowed: a whole number, 2 to 400"):
        Form(1)
    with pytest.raises(nc.InputError, match="graduation_mm is -1; allowed: 0 to 29"):
        Form(56, -1)
    with pytest.raises(nc.InputError, match="strands is 11; allowed: a whole number, 1 to 10"):
        sort_lot(LOT, EVEN, strands=11)


def test_a_graduation_that_the_lots_sizes_do_not_have_is_refused() -> None:
    lot = LOT.take(np.argsort(LOT.size_mm)[-40:])
    range_mm = float(np.ptp(lot.size_mm))
    sort_lot(lot, Form(20, range_mm))
    for way in (sort_lot, cut_lot):
        with pytest.raises(nc.InputError, match=r"graduation_mm is 20; allowed: 0 to [01]\."):
            way(lot, Form(20, 20))


def test_a_strand_wants_no_size_beyond_the_lots() -> None:
    values = np.tile([1.5, 94.0, 0.5, 4.0, 0.035], (30, 1))
    values[0, 0] = 20.0  # so that the median alone would want ends of -7 mm
    sorting = sort_lot(Lot(tuple(map(str, range(30))), values), Form(15, 18.5))
    for strand in sorting.strands:
        assert strand.target_mm.min() >= 1.5
        assert strand.target_mm.max() <= 20.0

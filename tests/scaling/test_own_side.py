"""How the side draws people is no part of their scales, and is said apart."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from nacreous.commands.scale_lines import told
from nacreous.scaling import analyse, compare_groups, person_covariates, shared_scale, simulate
from nacreous.scaling.fit.blocks import blocks_of
from nacreous.scaling.fit.own_side import OwnSides, drawn_by_side, with_own_sides
from tests.scaling.test_covariate import with_columns
from tests.scaling.test_shared import together

TRUTH = [1.0, 0.5, 0.0, -0.5, -1.0]


def drawn(seed, first=1.2, second=0.0, each=25, **more):
    """Two groups of people of one scale, told apart by how the left side draws them."""
    study = together(
        simulate(TRUTH, each, order=first, seed=2 * seed, **more),
        simulate(TRUTH, each, order=second, seed=2 * seed + 1, **more),
    )
    return with_columns(study, g=["x"] * each + ["y"] * each)


def test_a_column_that_goes_with_the_side_alone_tells_no_other_scales():
    """5 % of 40 exceeds 7 once in 1000 runs; with the side as part of the shares it was 32."""
    found = [person_covariates(drawn(seed), permutations=99)[0] for seed in range(40)]
    assert sum(one.p_value <= 0.05 for one in found) <= 7
    assert sum(one.side_p_value <= 0.05 for one in found) >= 38


def test_a_number_that_goes_with_the_side_alone_tells_no_other_scales():
    found = []
    for seed in range(20):
        study = together(*(simulate(TRUTH, 1, order=k / 20, seed=99 * seed + k) for k in range(40)))
        aged = with_columns(study, age=[str(20 + k) for k in range(40)])
        found.append(person_covariates(aged, permutations=99)[0])
    assert sum(one.p_value <= 0.05 for one in found) <= 4
    assert sum(one.side_p_value <= 0.05 for one in found) >= 18


def test_whom_the_side_draws_is_not_called_less_sharp():
    found = [shared_scale(drawn(seed, 2.0, repeats=2), permutations=99) for seed in range(25)]
    assert sum(one.p_value <= 0.05 for one in found) <= 5
    assert sum(one.sharper_p_value <= 0.05 for one in found) <= 5


def test_other_scales_are_found_beside_another_side_and_without_one():
    other = [0.1, 1.2, 0.0, -1.0, -0.3]
    for side in (1.0, 0.0):
        study = together(
            simulate(TRUTH, 25, order=side, repeats=2, seed=1),
            simulate(other, 25, repeats=2, seed=2),
        )
        found = person_covariates(with_columns(study, g=["x"] * 25 + ["y"] * 25))[0]
        assert found.p_value < 0.01
        assert shared_scale(study).order_p_value < 0.01


def test_pulls_are_those_of_people_who_answer_often():
    """Of people with 2000 answers the pull is known, and what is expected follows the sides."""
    study = together(
        simulate(TRUTH, 1, order=1.0, repeats=400, seed=1),
        simulate(TRUTH, 1, order=-0.5, repeats=400, seed=2),
    )
    sides = OwnSides.of(blocks_of(study))
    assert sides.likelihood.argmax(axis=1).tolist() == [10, 7]  # of -4 to 4 in halves
    apart = sides.leads - np.subtract(*np.array(TRUTH)[[sides.blocks.first, sides.blocks.second]])
    assert np.abs(apart).max() < 0.15
    held = sides.held()
    assert np.bincount(held.pair, held.residual) == pytest.approx(0, abs=1e-9)
    assert np.abs(held.residual / np.sqrt(held.answers)).max() < 3


def test_who_is_drawn_to_the_left_chooses_more_of_the_left():
    study = drawn(3)
    by_person = drawn_by_side(blocks_of(study))
    assert by_person[:25].mean() > 2 > 1 > abs(by_person[25:].mean())


def test_sides_that_are_not_known_or_not_exchanged_change_nothing():
    study = drawn(1)
    unknown = blocks_of(replace(study, sided=False))
    assert with_own_sides(unknown) is unknown
    turned = study.left > study.right
    still = replace(
        study,
        left=np.minimum(study.left, study.right),
        right=np.maximum(study.left, study.right),
        outcome=np.where(turned, -study.outcome, study.outcome).astype(np.int8),
    )
    blocks = blocks_of(still)
    assert with_own_sides(blocks) is blocks
    assert person_covariates(still, permutations=99)[0].side_p_value is None


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "The left side draws people who differ in g differently"),
        ("ja", "左側が選ばれる傾向は、「g」で分けた人々の間で異なります"),
    ],
)
def test_the_side_is_said_apart_and_does_not_lead(language, said):
    found = analyse(drawn(1, each=30), bootstrap=0)
    assert found.apart_by == ()
    assert said in re.sub("<[^>]*>", "", found.text("a.html", language))
    assert "the side draws people who differ in g differently, which is no other" in told(found, 0)
    column = json.loads(found.text("scale.json"))["one_scale_for_all_people"]["columns"][0]
    assert column["side_p_adjusted"] <= 0.05 < column["p_adjusted"]


def test_column_and_groups_say_the_same():
    study = drawn(1, each=30)
    found = analyse(study, bootstrap=0, group="g")
    assert not found.groups_differ
    assert found.apart_by == ()
    alone = compare_groups(study.split("g"), same_people=False)
    assert found.groups.found.tests == alone.tests
    assert "x is drawn more to the left than y" in told(found, 0.0)

"""Groups that answer in different ways, and see the same places: said, and no other scale."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from nacreous.commands.scale_lines import told
from nacreous.scaling import analyse, compare_groups, goodness, simulate
from nacreous.scaling.compare.restricted import restricted
from tests.scaling.test_covariate import with_columns
from tests.scaling.test_shared import together

TRUTH = {"A": 1.0, "B": 0.4, "C": 0.0, "D": -0.4, "E": -1.0}


def two(people=25, seed=1, *, first, second):
    """Two simulated groups, whose ways of answering are given as `simulate` takes them."""
    return {
        "x": simulate(TRUTH, people, seed=2 * seed, **first),
        "y": simulate(TRUTH, people, seed=2 * seed + 1, **second),
    }


def rejected(studies, model="probit", order=None):
    """By test of the places, in how many studies it rejects."""
    found = [
        compare_groups(study, model, order=order, same_people=False, permutations=99)
        for study in studies
    ]
    names = [test.name for test in found[0].tests]
    return {name: np.mean([one.test(name).p_value <= 0.05 for one in found]) for name in names}


@pytest.mark.parametrize("model", ["probit", "logit"])
@pytest.mark.parametrize(
    ("first", "second"),
    [
        ({"tie": 0.5}, {"tie": 0.12}),
        ({"tie": 0.5}, {}),
        ({"tie": 0.3, "order": 0.5}, {"tie": 0.3, "order": -0.3}),
        ({"order": 1.2}, {}),
    ],
)
def test_ways_of_answering_are_no_other_places(first, second, model):
    """5 % of 40 exceeds 7 once in 1000 runs."""
    ways = {"first": first | {"model": model}, "second": second | {"model": model}}
    studies = [two(seed=seed, **ways) for seed in range(40)]
    found = rejected(studies, model)
    assert max(found.values()) <= 7 / 40


def test_other_places_are_found_whatever_the_ways_of_answering():
    studies = [two(seed=seed, first={"tie": 0.5}, second={"tie": 0.12}) for seed in range(20)]
    other = np.array([0.1, 1.2, 0.0, -1.0, -0.3])
    moved = [one | {"y": simulate(other, 25, tie=0.12, seed=at)} for at, one in enumerate(studies)]
    named = [{"x": replace(one["x"], stimuli=one["y"].stimuli), "y": one["y"]} for one in moved]
    assert min(rejected(named).values()) >= 0.9


def test_a_restriction_is_the_fit_with_its_parameters_alike():
    """Without ties and side nothing is free in a group: the likeliest are those of all answers."""
    groups = two(first={}, second={})
    shared = compare_groups(groups, order=False, same_people=False, permutations=99).shared
    alike = restricted(groups, shared, "places")
    assert alike.log_likelihood == pytest.approx(shared.log_likelihood, abs=1e-9)
    assert alike.free == 4


def test_a_group_that_ties_seldom_is_fitted_from_the_ties_of_all():
    """A first step from the width of all would make this group's width less than nothing."""
    groups = {
        "x": simulate(TRUTH, 40, seed=3, person_spread=0.5, tie=0.5),
        "y": simulate(TRUTH, 12, seed=4, person_spread=0.5, tie=0.12),
    }
    found = compare_groups(groups, same_people=False, permutations=99)
    assert found.styles[0].p_value <= 0.05


def test_ways_of_answering_have_p_values_of_their_own_corrected_for_their_number():
    ways = {"first": {"tie": 0.3, "order": 0.5}, "second": {"tie": 0.3, "order": -0.3}}
    found = compare_groups(two(**ways), order=True, same_people=False, permutations=999)
    ties, side = found.styles
    assert (ties.name, side.name) == ("ties", "side")
    assert side.differs()
    assert not ties.differs()
    assert side.p_adjusted == pytest.approx(2 * side.p_value)
    assert (side.most, side.least) == ("x", "y")
    assert side.shares["x"] > 0.5 > side.shares["y"]
    assert found.df == 4


def one_way_round(answers):
    """The same choices, each pair with its first stimulus on the left."""
    turned = answers.left > answers.right
    return replace(
        answers,
        left=np.minimum(answers.left, answers.right),
        right=np.maximum(answers.left, answers.right),
        outcome=np.where(turned, -answers.outcome, answers.outcome).astype(np.int8),
    )


def test_a_side_that_no_pair_tells_is_not_fitted_and_groups_may_differ_by_it():
    studies = [two(seed=seed, first={}, second={}) for seed in range(40)]
    still = [{name: one_way_round(one) for name, one in study.items()} for study in studies]
    assert rejected(still)["permutation"] <= 7 / 40
    found = [compare_groups(one, same_people=False, permutations=99) for one in still[:3]]
    assert all(one.side_untold and not one.styles for one in found)
    told = compare_groups(studies[0], same_people=False, permutations=99)
    assert (told.side_untold, [one.name for one in told.styles]) == (False, ["side"])


@pytest.mark.parametrize(
    ("language", "said"),
    [("en", "they may differ in that alone"), ("ja", "それだけによる可能性があります")],
)
def test_groups_that_differ_where_the_side_is_not_told_are_said_to(language, said):
    groups = two(first={}, second={}).values()
    other = simulate(dict.fromkeys(TRUTH, 0.0), 25, seed=9)
    still = one_way_round(together(next(iter(groups)), other))
    found = analyse(with_columns(still, g=["x"] * 25 + ["y"] * 25), bootstrap=0, group="g")
    assert found.groups_differ
    assert said in found.text("a.html", language)
    assert "groups may differ in that alone" in told(found, 0.0)


def test_counts_of_winners_have_no_side_to_tell():
    found = compare_groups({"x": [[0, 9], [5, 0]], "y": [[0, 5], [9, 0]]})
    assert not found.side_untold
    assert found.styles == ()


@pytest.fixture(scope="module")
def tying():
    groups = two(first={"tie": 0.5}, second={"tie": 0.12})
    return with_columns(together(*groups.values()), g=["x"] * 25 + ["y"] * 25)


@pytest.fixture(scope="module")
def tying_report(tying):
    return analyse(tying, bootstrap=0, group="g")


def test_one_answer_by_whichever_entrance(tying, tying_report):
    alone = compare_groups(tying.split("g"), same_people=False)
    assert tying_report.groups.found.tests == alone.tests
    assert tying_report.groups.found.styles == alone.styles
    written = json.loads(tying_report.text("scale.json"))["groups"]
    assert written["ways_of_answering"][0]["p_value"] == alone.styles[0].p_value
    assert f"p = {alone.p_value:.3g}" in told(tying_report, 0.0)


@pytest.mark.parametrize(
    ("language", "way", "leads"),
    [
        ("en", "x called two items equal more readily than y", "do not follow one scale"),
        ("ja", "xはyよりも「同じ」と答えやすく", "一つの尺度に従って"),
    ],
)
def test_a_way_of_answering_is_said_and_does_not_lead(tying_report, language, way, leads):
    assert not tying_report.groups_differ
    assert goodness(tying_report.fit).describes
    page = re.sub("<[^>]*>", "", tying_report.text("a.html", language))
    assert page.count(way) == 2  # in short, and in the chapter
    assert leads not in page[page.index(way) :]
    assert "x calls more things equal than y" in told(tying_report, 0.0)

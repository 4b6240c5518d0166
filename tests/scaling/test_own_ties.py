"""How readily people tie is no part of their scales, and ties alone tell nothing of an order."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from nacreous.commands.scale_lines import told
from nacreous.scaling import (
    always_tied,
    analyse,
    person_covariates,
    shared_scale,
    simulate,
)
from nacreous.scaling.fit.blocks import blocks_of
from nacreous.scaling.fit.own_ties import with_own_ties
from tests.scaling.test_covariate import with_columns
from tests.scaling.test_shared import together

TRUTH = [1.0, 0.4, 0.0, -0.4, -1.0]


def tying(seed, first=0.8, second=0.0, each=25):
    """Two groups of people of one scale, told apart by how readily they tie; each pair twice."""
    study = together(
        simulate(TRUTH, each, tie=first, repeats=2, seed=2 * seed),
        simulate(TRUTH, each, tie=second, repeats=2, seed=2 * seed + 1),
    )
    return with_columns(study, g=["x"] * each + ["y"] * each)


def beside_one_who_ties(people, repeats=10):
    lazy = simulate(TRUTH, 1, repeats=repeats, seed=8)
    return together(people, replace(lazy, outcome=np.zeros_like(lazy.outcome)))


def test_a_column_that_goes_with_ties_alone_tells_no_other_scales():
    """5 % of 40 exceeds 7 once in 1000 runs; with ties as plain halves it was 28."""
    found = [person_covariates(tying(seed), permutations=99)[0].p_value for seed in range(40)]
    assert sum(p <= 0.05 for p in found) <= 7


def test_who_ties_more_is_not_called_less_sharp():
    found = [shared_scale(tying(seed), permutations=99) for seed in range(40)]
    assert sum(one.p_value <= 0.05 for one in found) <= 7
    assert sum(one.sharper_p_value <= 0.05 for one in found) <= 7


def test_other_scales_are_found_beside_other_ties():
    other = [0.1, 1.2, 0.0, -1.0, -0.3]
    study = together(simulate(TRUTH, 25, tie=0.5, seed=1), simulate(other, 25, tie=0.12, seed=2))
    marked = with_columns(study, g=["x"] * 25 + ["y"] * 25)
    assert person_covariates(marked)[0].p_value < 0.01
    assert shared_scale(study).order_p_value < 0.01


def test_without_ties_nobody_has_a_width():
    blocks = blocks_of(simulate(TRUTH, 20, seed=1))
    assert with_own_ties(blocks) is blocks


def test_widths_are_those_of_people_who_answer_often():
    blocks = blocks_of(
        together(
            simulate(TRUTH, 1, tie=0.6, repeats=2000, seed=1),
            simulate(TRUTH, 1, tie=0.2, repeats=2000, seed=2),
        )
    )
    for drawn_in in (False, True):
        found = with_own_ties(blocks, drawn_in=drawn_in)
        assert found.width == pytest.approx([0.6, 0.2], abs=0.03)
        assert np.bincount(found.pair, found.residual) == pytest.approx(0, abs=1e-2)


def test_one_who_never_chose_changes_nothing_in_the_test_of_people():
    people = simulate(TRUTH, 19, repeats=2, seed=5)
    alone, beside = shared_scale(people), shared_scale(beside_one_who_ties(people))
    assert beside == replace(alone, reversed=beside.reversed)


def test_detectable_is_found_by_most_studies():
    """80 of 100 by its meaning; 40 studies have 32 with an error of 2.5."""
    study = beside_one_who_ties(simulate(TRUTH, 19, repeats=2, seed=5))
    own = shared_scale(study).detectable
    found = [
        shared_scale(
            beside_one_who_ties(simulate(TRUTH, 19, repeats=2, person_spread=own, seed=100 + seed)),
            permutations=99,
        ).differ()
        for seed in range(40)
    ]
    assert 23 <= sum(found) <= 39


@pytest.mark.parametrize("language", ["en", "ja"])
def test_who_never_chose_is_named_with_the_number_of_ties(language):
    study = beside_one_who_ties(simulate(TRUTH, 19, repeats=2, seed=5))
    assert [(one.ties, one.of) for one in always_tied(study)] == [(100, 100)]
    found = analyse(study, bootstrap=0)
    assert "person 1 simulated 1 always said tie (100 of the 100 ties)" in told(found, 0.0)
    said = {"en": "always said tie (100 of the 100 ties)", "ja": "100回のうち100回"}[language]
    assert said in found.text("a.html", language)


def test_ties_alone_name_nobody_where_all_tie_often_or_answer_little():
    assert always_tied(simulate([0.0, 0.0], 200, tie=2.0, seed=1)) == ()
    assert always_tied(beside_one_who_ties(simulate(TRUTH, 9, tie=2.5, seed=1), 1)) == ()

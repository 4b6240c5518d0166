"""Laws of covariates: what goes with the differences is found, what does not is left alone."""

from dataclasses import replace

import numpy as np
import pytest

from nacreous.scaling import Answers, person_covariates, simulate
from nacreous.scaling.data.column import Grouping
from nacreous.scaling.fit.covariate import untested_columns
from tests.scaling.test_shared import together

TRUTH = np.linspace(0.8, -0.8, 6)


def with_columns(study, **columns):
    """The answers with columns of one value a person, None where empty."""
    groups = {}
    for name, values in columns.items():
        levels = tuple(sorted({str(value) for value in values if value is not None}))
        code = [-1 if value is None else levels.index(str(value)) for value in values]
        groups[name] = Grouping(levels, np.array(code)[study.person])
    return replace(study, groups=groups)


def two_ages(seed):
    """40 young and 40 old people, who place two stimuli the other way round."""
    other = TRUTH[[1, 0, 3, 2, 4, 5]]
    study = together(simulate(TRUTH, 40, seed=seed), simulate(1.4 * other, 40, seed=100 + seed))
    random = np.random.default_rng(seed)
    age = np.where(np.arange(80) < 40, random.integers(20, 45, 80), random.integers(46, 80, 80))
    return with_columns(
        study, age=age, lens=random.choice(["a", "b", "c"], 80), shoe=random.integers(36, 47, 80)
    )


def test_a_number_that_goes_with_other_scales_is_found_with_its_split():
    age, lens, shoe = person_covariates(two_ages(1))
    assert (age.column, age.kind) == ("age", "number")
    assert age.p_adjusted < 0.01
    assert age.split == pytest.approx(45, abs=6)
    assert (lens.kind, lens.split) == ("groups", None)
    assert min(lens.p_value, shoe.p_value) > 0.01


def test_holm_corrects_for_all_columns():
    found = person_covariates(two_ages(1))
    smallest = min(found, key=lambda one: one.p_value)
    assert smallest.p_adjusted == pytest.approx(3 * smallest.p_value)
    assert all(one.p_adjusted >= one.p_value for one in found)


def test_columns_that_go_with_nothing_are_found_in_few_of_100_studies():
    random, p_values = np.random.default_rng(3), []
    for seed in range(60):
        study = simulate(TRUTH, 30, person_spread=0.5, seed=seed)
        study = with_columns(
            study, age=random.random(30).round(2), eye=random.choice(["l", "r"], 30)
        )
        p_values.append([one.p_value for one in person_covariates(study, 99)])
    assert (np.array(p_values) < 0.05).mean(axis=0) == pytest.approx([0.05, 0.05], abs=0.085)


def test_only_columns_of_a_person_are_tested():
    study = simulate(TRUTH, 20, seed=1)
    random = np.random.default_rng(1)
    of_answer = Grouping(("x", "y"), random.integers(0, 2, len(study)))
    own = with_columns(study, name=[f"n{k}" for k in range(20)], one=["same"] * 20)
    assert person_covariates(replace(own, groups={**own.groups, "trial": of_answer})) == ()


def test_people_whose_column_is_empty_are_left_out():
    study = simulate(TRUTH, 20, seed=1)
    found = person_covariates(with_columns(study, eye=["l", "r"] * 8 + [None] * 4))
    assert found[0].people == 16


def aged(*ages: object) -> Answers:
    """Twenty people with a column age as a file has it, in a row each of their answers."""
    study = simulate(TRUTH, 20, seed=1)
    sides = zip(study.left, study.right, study.outcome, study.person, strict=True)
    rows = [
        (study.people[p], study.stimuli[a], study.stimuli[b], "left" if o > 0 else "right", p)
        for a, b, o, p in sides
    ]
    person, left, right, chosen, at = zip(*rows, strict=True)
    cells = [ages[p] if p < len(ages) else str(20 + p) for p in at]
    columns = {"person": person, "left": left, "right": right, "chosen": chosen, "age": cells}
    return Answers.of_table({name: list(column) for name, column in columns.items()}, repeats=True)


@pytest.mark.parametrize("word", ["NA", "n/a", "NaN", ".", "null", "None", "none", "-", "#N/A", ""])
def test_a_word_for_nothing_is_an_empty_cell_of_a_covariate(word):
    answers = aged(word)
    (found,) = person_covariates(answers, 99)
    assert (found.kind, found.people) == ("number", 19)
    assert answers.groups["age"].nothing == ((word,) if word else ())
    assert untested_columns(answers) == ()


@pytest.mark.parametrize(
    ("ages", "reason", "cells"),
    [
        (["?"], "no numbers", ("?",)),
        (["inf", "1e400"], "no numbers", ("1e400", "inf")),
        ([f"{k} years" for k in range(20)], "many values", ()),
        ([f"1,{100 + k}" for k in range(20)], "unclear marks", ()),
        ([*range(20, 24), *[""] * 16], "few people", ()),
    ],
)
def test_a_column_that_cannot_be_compared_is_told_with_the_reason(ages, reason, cells):
    answers = aged(*ages)
    assert person_covariates(answers, 99) == ()
    (told,) = untested_columns(answers)
    assert (told.column, told.reason, told.cells) == ("age", reason, cells)


def test_decimal_commas_are_numbers_and_none_beside_words_is_one():
    (found,) = person_covariates(aged(*[f"{20 + k},5" for k in range(20)]), 99)
    assert (found.kind, found.people) == ("number", 20)
    (found,) = person_covariates(aged(*["none", "near"] * 10), 99)
    assert (found.kind, found.people) == ("groups", 20)
    (found,) = person_covariates(aged(*["+", "-"] * 10), 99)
    assert (found.kind, found.people) == ("groups", 20)


def test_a_person_whose_age_stands_in_one_row_has_it():
    study = two_ages(1)
    code = study.groups["age"].code.copy()
    seen = np.unique(study.person, return_index=True)[1]
    once = np.full_like(code, -1)
    once[seen] = code[seen]
    few = replace(study, groups={"age": replace(study.groups["age"], code=once)})
    full = replace(study, groups={"age": study.groups["age"]})
    assert person_covariates(few) == person_covariates(full)


def test_numbers_are_the_same_in_other_units():
    study = two_ages(2)
    levels = study.groups["age"].levels
    days = Grouping(tuple(str(365 * int(level)) for level in levels), study.groups["age"].code)
    one = person_covariates(replace(study, groups={"age": study.groups["age"]}))[0]
    other = person_covariates(replace(study, groups={"age": days}))[0]
    assert (other.p_value, other.split) == (one.p_value, 365 * one.split)


def test_a_table_with_columns_of_people_is_enough():
    table = {"person": [], "left": [], "right": [], "chosen": [], "eye": []}
    study = simulate(TRUTH, 12, seed=1)
    for row in range(len(study)):
        values = (
            study.people[study.person[row]],
            study.stimuli[study.left[row]],
            study.stimuli[study.right[row]],
            "left" if study.outcome[row] > 0 else "right",
            "lr"[study.person[row] % 2],
        )
        for name, value in zip(table, values, strict=True):
            table[name].append(value)
    assert [one.column for one in person_covariates(Answers.of_table(table))] == ["eye"]

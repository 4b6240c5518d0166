"""Labels are compared in one Unicode form wherever a caller names them."""

import pytest

from nacreous.problem import InputError
from nacreous.scaling import (
    Answers,
    Plan,
    cluster_ratio,
    compare_ratios,
    fit_attributes,
    simulate,
    thurstone,
)

COMPOSED, APART = "caf\u00e9", "cafe\u0301"


def test_plans_take_either_form():
    plan = Plan({APART: 0.5, "b": 0.0}, people=8, pairs=[(COMPOSED, "b")])
    one, other = (plan.power(label, "b", studies=20) for label in (APART, COMPOSED))
    assert one == other


def test_bootstraps_take_either_form():
    samples = thurstone([(COMPOSED, "b")] * 6 + [("b", COMPOSED)] * 3).bootstrap(50)
    assert samples.difference(APART, "b") == samples.difference(COMPOSED, "b")


def test_two_forms_of_one_label_are_no_two_stimuli():
    with pytest.raises(InputError, match="again; allowed: each label once"):
        simulate({APART: 0.5, COMPOSED: 0.0}, people=3)


def test_clusters_take_either_form():
    answers = simulate({COMPOSED: 1.0, "b": 0.9, "c": -0.9, "d": -1.0}, people=20)
    one, other = (cluster_ratio(answers, [label, "b"], ["c", "d"]) for label in (APART, COMPOSED))
    assert one.first == other.first == (COMPOSED, "b")
    assert one.ratio == other.ratio
    both = {"x": answers, "y": answers}
    found = compare_ratios(both, [APART, "b"], ["c", "d"], same_people=False)
    assert found.first.first == (COMPOSED, "b")


def test_attributes_take_either_form():
    answers = simulate({"a": 1.0, COMPOSED: 0.3, "c": -0.4, "d": -1.0}, people=30)
    values = {"a": 1.0, APART: 0.2, "c": -0.3, "d": -1.0}
    rows = {label: {APART: value} for label, value in values.items()}
    fit = fit_attributes(answers, rows, [COMPOSED])
    assert fit.predict({COMPOSED: 0.5}).value == fit.predict({APART: 0.5}).value
    table = {APART: list(values), "lustre": list(values.values())}
    column = fit_attributes(answers, table, stimulus=COMPOSED)
    assert column.weights[0].value == fit.weights[0].value


def test_columns_and_words_take_either_form(tmp_path):
    path = tmp_path / "answers.csv"
    rows = f"{APART},right,chosen,eye\na,b,{APART},l\nb,a,right,{COMPOSED}\n"
    path.write_text(rows, encoding="utf-8")
    answers = Answers.read(path, left=COMPOSED, tie=COMPOSED)
    assert answers.outcome.tolist() == [0, -1]
    assert set(answers.split("eye")) == {"l", COMPOSED}

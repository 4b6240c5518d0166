"""Labels are compared in one Unicode form wherever a caller names them."""

import pytest

from nacreous.problem import InputError
from nacreous.scaling import Plan, simulate, thurstone

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

"""Laws of simulated observers: they answer as the model says, and are never taken for people."""

import numpy as np
import pytest
from scipy.special import expit, ndtr

from nacreous.problem import InputError
from nacreous.scaling.planning.simulation import simulate


def shares(answers):
    """Share of left, right and tie of the pair (1 on the left, 2 on the right)."""
    rows = answers.left == 0
    return [float(np.mean(answers.outcome[rows] == sign)) for sign in (1, -1, 0)]


def test_every_observer_is_called_simulated():
    assert all(label.startswith("simulated ") for label in simulate([0, 1], people=5).people)


def test_same_seed_same_answers_and_another_seed_others():
    one, same, other = (simulate([0, 1, 2], people=40, seed=seed) for seed in (3, 3, 4))
    assert (one.outcome == same.outcome).all()
    assert (one.left == same.left).all()
    assert (one.outcome != other.outcome).any()


@pytest.mark.parametrize(("model", "chance"), [("probit", ndtr), ("logit", expit)])
def test_a_lead_is_chosen_as_often_as_the_model_says(model, chance):
    answers = simulate([0.5, -0.2], people=40_000, model=model, order=0.3, seed=2)
    # Left is 0.7 ahead by itself and 0.3 by its side.
    assert shares(answers)[0] == pytest.approx(chance(1.0), abs=0.01)


def test_probit_ties_are_leads_within_the_threshold():
    left, right, tie = shares(simulate([0.4, 0.0], people=60_000, tie=0.5, seed=3))
    assert left == pytest.approx(ndtr(0.4 - 0.5), abs=0.01)
    assert right == pytest.approx(ndtr(-0.4 - 0.5), abs=0.01)
    assert tie == pytest.approx(ndtr(0.1) - ndtr(-0.9), abs=0.01)


def test_logit_ties_are_davidsons():
    left, right, tie = shares(simulate([0.8, 0.0], 60_000, model="logit", tie=0.7, seed=4))
    assert tie / np.sqrt(left * right) == pytest.approx(0.7, abs=0.03)
    assert np.log(left / right) == pytest.approx(0.8, abs=0.04)


def test_a_lapse_is_a_coin():
    left, right, tie = shares(simulate([9.0, -9.0], people=40_000, lapse=0.3, tie=0.1, seed=5))
    assert (left, right, tie) == pytest.approx((0.85, 0.15, 0.0), abs=0.01)


def test_people_who_differ_shrink_the_scale_of_all_by_the_known_factor():
    # A lead plus noise of people: P = Phi(lead / sqrt(1 + 2 spread^2)).
    left, *_ = shares(simulate([1.0, 0.0], people=60_000, person_spread=0.8, seed=6))
    assert left == pytest.approx(ndtr(1 / np.sqrt(1 + 2 * 0.64)), abs=0.01)


def test_each_person_answers_each_pair_of_the_design_as_often_as_asked():
    answers = simulate({"a": 0, "b": 1, "c": 2}, 7, pairs=[("a", "b"), ("c", "b")], repeats=3)
    assert len(answers) == 7 * 2 * 3
    asked = {frozenset(pair) for pair in zip(answers.left, answers.right, strict=True)}
    assert asked == {frozenset((0, 1)), frozenset((1, 2))}
    assert (np.bincount(answers.person) == 6).all()


def test_half_of_the_pairs_stand_the_other_way_round():
    answers = simulate([0, 0], people=10_000, seed=8)
    assert np.mean(answers.left == 0) == pytest.approx(0.5, abs=0.02)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"scale": [1.0]}, "scale: 1 stimuli"),
        ({"scale": [1.0, np.nan]}, 'scale["2"] is nan'),
        ({"scale": {"a": "high", "b": 1}}, "scale"),
        ({"people": 0}, "people is 0"),
        ({"people": True}, "people is True"),
        ({"repeats": 1.5}, "repeats is 1.5"),
        ({"model": "cauchy"}, "model is 'cauchy'"),
        ({"lapse": 2}, "lapse is 2"),
        ({"person_spread": -1}, "person_spread is -1"),
        ({"pairs": [("1", "9")]}, 'pairs[0] names "9"'),
        ({"pairs": [("1", "1")]}, 'pairs[0] is "1" twice'),
        ({"pairs": []}, "pairs is empty"),
        ({"pairs": ["12"]}, "pairs[0] is '12'"),
        ({"seed": -1}, "seed is -1"),
        ({"people": 1_000_000, "repeats": 100}, "answers to simulate"),
    ],
)
def test_bad_values_are_refused_in_one_line(arguments, message):
    with pytest.raises(InputError) as refusal:
        simulate(**{"scale": [0.0, 1.0], **arguments})
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)

"""Laws of describing people: planted classes and spreads come back, and the right one is chosen."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import multivariate_normal

from nacreous.problem import InputError
from nacreous.scaling import Answers, population, simulate, thurstone
from nacreous.scaling.check.classes import fit_classes
from nacreous.scaling.check.link import slopes_at
from nacreous.scaling.check.own_values import Marginal, fit_own_values
from nacreous.scaling.fit.blocks import blocks_of
from tests.scaling.test_shared import together

TRUTH = np.linspace(0.8, -0.8, 7)
CAMPS = Path(__file__).with_name("camps.csv")


@pytest.fixture(scope="module")
def camps():
    """30 made-up people of one scale and 30 of its exact reverse, 21 pairs each."""
    return Answers.read(CAMPS)


def test_two_opposite_camps_are_two_equal_classes(camps):
    found = population(camps)
    assert found.kind == "classes"
    assert [one.share for one in found.classes] == pytest.approx([0.5, 0.5], abs=0.001)
    assert found.classes[1].correlation < -0.98
    assert sum(len(one.people) for one in found.classes) == 60


def test_bic_of_the_camps_is_that_of_an_independent_program(camps):
    """By a prototype written apart from this code, with the same ridge."""
    bic = {one.name: round(one.bic) for one in population(camps).candidates}
    assert [bic[name] for name in ("one scale", "2 classes", "3 classes", "4 classes")] == [
        1770,
        1153,
        1168,
        1188,
    ]


@pytest.mark.parametrize("spread", [0.5, 1.0])
def test_a_spread_is_not_taken_for_classes(spread):
    found = population(simulate(TRUTH, 104, person_spread=spread, seed=2))
    assert found.kind == "spread"
    assert found.classes == ()
    assert found.spread == pytest.approx(spread, abs=0.12)
    bic = {one.name: one.bic for one in found.candidates}
    assert bic["2 classes"] < bic["one scale"]  # without the spread beside, classes would be taken


def test_people_of_one_scale_are_described_by_one_scale():
    kinds = [population(simulate(TRUTH, 30, seed=seed), most=2).kind for seed in range(8)]
    assert kinds.count("one scale") >= 7


def test_spread_and_camps_are_told_apart_at_30_people():
    for seed in range(4):
        spread = simulate(TRUTH, 30, person_spread=0.6, seed=seed)
        assert population(spread, most=2).kind == "spread"
        halves = together(simulate(TRUTH, 15, seed=seed), simulate(-TRUTH, 15, seed=99 + seed))
        assert population(halves, most=2).kind == "classes"


@pytest.mark.parametrize("people", [6, 8, 10])
def test_few_people_who_vary_continuously_are_not_said_to_be_classes(people):
    # By BIC alone 15, 7 and 9 of the first 40 of such studies were.
    studies = [simulate(TRUTH, people, person_spread=0.5, seed=seed) for seed in range(1, 9)]
    kinds = [population(study).kind for study in studies]
    assert "classes" not in kinds
    assert "spread or classes" in kinds


def test_halves_of_ten_people_who_hold_the_reverse_are_classes():
    for seed in range(4):
        halves = together(simulate(TRUTH, 5, seed=seed), simulate(-TRUTH, 5, seed=99 + seed))
        found = population(halves)
        assert found.kind == "classes"
        assert found.classes[1].correlation < -0.6


@pytest.mark.parametrize("model", ["probit", "logit"])
def test_slopes_of_the_curves_are_their_differences(model):
    lead, step = np.linspace(-6, 6, 33), 1e-5
    above, below, at = (slopes_at(lead + shift, model) for shift in (step, -step, 0.0))
    for order in range(3):
        assert at[order + 1] == pytest.approx((above[order] - below[order]) / 2 / step, abs=1e-6)


@pytest.mark.parametrize("model", ["probit", "logit"])
def test_slopes_of_the_marginal_likelihood_are_its_differences(model):
    study = simulate(TRUTH[:5], 8, person_spread=0.7, repeats=2, seed=2, tie=0.1)
    likelihood = Marginal(blocks_of(study), model)
    at, step = np.array([0.5, 0.2, 0.0, -0.1, -0.6, np.log(0.6)]), 1e-5
    numeric = [
        (likelihood.loss(at + shift)[0] - likelihood.loss(at - shift)[0]) / 2 / step
        for shift in step * np.eye(6)
    ]
    assert likelihood.loss(at)[1] == pytest.approx(np.array(numeric), abs=1e-6)


def test_marginal_likelihood_is_the_integral_over_peoples_values():
    """Two stimuli and four answers of each person: by quadrature, to Laplace's error."""
    from scipy.special import log_ndtr

    study = simulate([0.4, -0.4], 12, person_spread=0.5, repeats=4, seed=3)
    blocks = blocks_of(study)
    lead = np.linspace(-6, 6, 4001)
    prior = multivariate_normal(0.8, 2 * 0.5**2).pdf(lead)
    passed = blocks.answers - blocks.chosen
    total = 0.0
    for chosen, other in zip(blocks.chosen, passed, strict=True):
        own = np.exp(chosen * log_ndtr(lead) + other * log_ndtr(-lead))
        total += np.log(np.trapezoid(own * prior, lead))
    loss, _ = Marginal(blocks, "probit").loss(np.array([0.4, -0.4, np.log(0.5)]))
    assert -loss == pytest.approx(total, abs=0.01 * 12)


def test_one_class_is_the_scale_of_all_people():
    study = simulate(TRUTH, 200, seed=1)
    fit = thurstone(study)
    one = fit_classes(blocks_of(study), 1)
    assert one.values[0] == pytest.approx(fit.scale, abs=0.002)  # the ridge
    assert one.log_likelihood == pytest.approx(fit.log_likelihood, abs=0.01)


def test_without_spread_between_people_the_spread_is_the_one_scale():
    study = simulate(TRUTH, 200, seed=1)
    own = fit_own_values(blocks_of(study))
    assert own.spread < 0.2
    assert own.log_likelihood == pytest.approx(thurstone(study).log_likelihood, abs=2)


def test_people_in_another_order_are_the_same_classes(camps):
    order = np.argsort(np.random.default_rng(3).random(60))
    rank = np.argsort(order)
    moved = replace(
        camps, people=tuple(camps.people[at] for at in order), person=rank[camps.person]
    )
    one, other = population(camps, most=2), population(moved, most=2)
    sets = [{frozenset(each.people) for each in found.classes} for found in (one, other)]
    assert sets[0] == sets[1]
    assert one.candidates[2].bic == pytest.approx(other.candidates[2].bic, abs=1e-3)


def test_too_few_people_are_refused():
    with pytest.raises(InputError, match="5 people; allowed: 6 or more"):
        population(simulate(TRUTH, 5))
    with pytest.raises(InputError, match="most is 1; allowed: a whole number, 2 to 10"):
        population(simulate(TRUTH, 30), most=1)

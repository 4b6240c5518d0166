"""Laws of the test by persons: it holds its size, finds who differs, and says in which way."""

from dataclasses import replace

import numpy as np
import pytest

from nacreous.problem import InputError
from nacreous.scaling import Answers, shared_scale, simulate

TRUTH = np.linspace(0.8, -0.8, 7)


def together(*parts):
    """Answers of several sets of people as one; nobody is in two."""
    names = [f"{number} {label}" for number, part in enumerate(parts) for label in part.people]
    starts = np.cumsum([0, *(len(part.people) for part in parts[:-1])])
    rows = {
        name: np.concatenate([getattr(part, name) for part in parts])
        for name in ("left", "right", "outcome")
    }
    person = np.concatenate(
        [part.person + start for part, start in zip(parts, starts, strict=True)]
    )
    return replace(parts[0], people=tuple(names), person=person, **rows)


def rejected(studies, **known):
    """The share of studies whose people are found to differ."""
    return np.mean([shared_scale(study, 99, **known).differ() for study in studies])


def test_sixty_people_who_share_one_scale_are_called_different_in_few_of_100_studies():
    found = rejected(simulate(TRUTH, 60, seed=seed) for seed in range(100))
    assert found <= 0.11  # 5 % of 100 exceeds this once in 200 runs


def test_p_values_of_people_who_share_one_scale_are_uniform_and_few_are_small():
    found = [shared_scale(simulate(TRUTH, 20, seed=seed), 99) for seed in range(150)]
    assert np.mean([one.differ() for one in found]) <= 0.11  # exceeded once in 2000 runs
    p_values = np.array([one.p_value for one in found])
    assert p_values.mean() == pytest.approx(0.505, abs=0.1)
    assert p_values.min() >= 0.01


def test_own_values_of_half_a_unit_are_found_at_20_people():
    studies = (simulate(TRUTH, 20, person_spread=0.5, seed=seed) for seed in range(40))
    assert rejected(studies) >= 0.85


def test_a_tenth_of_reversed_people_is_found_at_60():
    studies = (
        together(simulate(TRUTH, 54, seed=seed), simulate(-TRUTH, 6, seed=1000 + seed))
        for seed in range(40)
    )
    assert rejected(studies) >= 0.85


def test_repeats_that_people_remember_are_no_scale_of_their_own():
    studies = []
    for seed in range(80):
        study = simulate(TRUTH, 20, seed=seed)
        studies.append(study.take(np.tile(np.arange(len(study)), 2)))
    assert rejected(studies) <= 0.12


def test_pairs_of_ones_own_are_tested_too():
    random = np.random.default_rng(5)

    def some(study):
        return study.take(random.random(len(study)) < 0.3 + 0.7 * (study.person % 2))

    assert rejected(some(simulate(TRUTH, 30, seed=seed)) for seed in range(80)) <= 0.12
    differing = (some(simulate(TRUTH, 30, person_spread=0.8, seed=seed)) for seed in range(20))
    assert rejected(differing) >= 0.85


def test_sharper_people_differ_along_the_scale_and_not_across():
    study = together(simulate(0.4 * TRUTH, 60, seed=1), simulate(2.5 * TRUTH, 60, seed=2))
    found = shared_scale(study)
    assert found.differ()
    assert found.sharper_p_value < 0.01
    assert found.order_p_value > 0.05
    assert found.reversed == ()


def test_people_of_other_orders_differ_across_the_scale():
    found = shared_scale(simulate(TRUTH, 104, person_spread=0.5, seed=1))
    assert found.order_p_value < 0.01


def test_the_other_way_round_lies_along_the_scale_and_is_told_by_name():
    study = together(simulate(TRUTH, 54, seed=1), simulate(-1.5 * TRUTH, 6, seed=2))
    found = shared_scale(study)
    assert found.sharper_p_value < 0.01
    assert set(found.reversed) <= {f"1 simulated {number}" for number in range(1, 7)}
    assert len(found.reversed) >= 4


def test_naming_people_and_sides_otherwise_changes_nothing():
    study = simulate(TRUTH, 30, person_spread=0.3, seed=4)
    order = np.random.default_rng(1).permutation(30)
    renamed = replace(study, people=tuple(study.people[k] for k in order))
    assert replace(shared_scale(renamed), reversed=()) == replace(shared_scale(study), reversed=())
    turned = replace(study, left=study.right, right=study.left, outcome=-study.outcome)
    found, again = shared_scale(study), shared_scale(turned)
    assert again == replace(found, z=again.z)
    assert again.z == pytest.approx(found.z, abs=1e-9)


def test_adding_the_same_answers_by_all_adds_no_difference():
    """A pair on which everyone agrees says nothing about how people differ."""
    study = simulate(TRUTH, 30, person_spread=0.3, seed=4)
    seventh = np.flatnonzero((study.left != 6) & (study.right != 6))
    without = study.take(seventh)
    agreed = Answers(
        study.stimuli,
        np.concatenate([without.left, np.zeros(30, np.int64)]),
        np.concatenate([without.right, np.full(30, 6)]),
        np.concatenate([without.outcome, np.ones(30, np.int8)]),
        study.people,
        np.concatenate([without.person, np.arange(30)]),
    )
    one, other = shared_scale(without, seed=2), shared_scale(agreed, seed=2)
    assert other.p_value == pytest.approx(one.p_value, abs=0.02)
    assert other.z == pytest.approx(one.z, abs=0.3)


def test_same_seed_same_test():
    study = simulate(TRUTH, 30, seed=4)
    assert shared_scale(study, seed=7) == shared_scale(study, seed=7)


def test_what_cannot_be_tested_is_refused():
    with pytest.raises(InputError, match="column person"):
        shared_scale(Answers.of_pairs([("a", "b"), ("b", "a")]))
    with pytest.raises(InputError, match="no two people answered the same pair"):
        shared_scale(simulate([0.0, 1.0], 1))
    with pytest.raises(InputError, match=r"permutations is 5; allowed: a whole number, 99 to"):
        shared_scale(simulate([0.0, 1.0], 9), 5)

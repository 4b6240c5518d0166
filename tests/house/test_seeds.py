"""A seed that is none is refused before anything is computed, with the range."""

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous import texture
from nacreous.problem import InputError

SCALE = [0.6, 0.2, -0.2, -0.6]
#: Answers on which nothing can be computed: two people, who agree.
RANKED = nc.scaling.simulate_rankings(SCALE, 3)
ALIKE = {"left": ["a", "a"], "right": ["b", "b"], "chosen": ["a", "a"], "person": ["x", "y"]}
PLAN = nc.scaling.Plan(SCALE, people=20)
DIFFERENCES = nc.scaling.difference_scale(nc.scaling.simulate_quadruples([0, 1, 2, 3, 4], 20))
ASKED: dict[str, Callable[[Any], Any]] = {
    "Bootstrap": lambda seed: nc.scaling.thurstone(nc.scaling.paper()).bootstrap(100, seed=seed),
    "Plan.answers": lambda seed: PLAN.answers(seed=seed),
    "Plan.group_power": lambda seed: PLAN.group_power(SCALE[::-1], seed=seed),
    "Plan.people_needed": lambda seed: PLAN.people_needed("1", "2", seed=seed),
    "Plan.power": lambda seed: PLAN.power("1", "2", seed=seed),
    "Plan.precision": lambda seed: PLAN.precision(seed=seed),
    "analyse": lambda seed: nc.scaling.analyse(ALIKE, bootstrap=0, seed=seed),
    "compare_groups": lambda seed: nc.scaling.compare_groups({"x": ALIKE, "y": ALIKE}, seed=seed),
    "compare_sets": lambda seed: nc.scaling.compare_sets(ALIKE, ALIKE, seed=seed),
    "concordance": lambda seed: nc.scaling.concordance(RANKED, 99, seed=seed),
    "cyclic_design": lambda seed: nc.scaling.cyclic_design(6, 2, seed=seed),
    "difference_goodness": lambda seed: nc.scaling.difference_goodness(DIFFERENCES, seed=seed),
    "ensemble": lambda seed: nc.optics.ensemble("akoya-rg", 0.0, 550.0, seed=seed),
    "full_design": lambda seed: nc.scaling.full_design(6, seed=seed),
    "full_quadruples": lambda seed: nc.scaling.full_quadruples(6, seed=seed),
    "grow": lambda seed: nc.grow(seed=seed),
    "next_pairs": lambda seed: nc.scaling.next_pairs(stimuli=["a", "b"], seed=seed),
    "person_covariates": lambda seed: nc.scaling.person_covariates(ALIKE, seed=seed),
    "population": lambda seed: nc.scaling.population(ALIKE, seed=seed),
    "random_design": lambda seed: nc.scaling.random_design(6, 8, seed=seed),
    "random_quadruples": lambda seed: nc.scaling.random_quadruples(6, 12, seed=seed),
    "shared_scale": lambda seed: nc.scaling.shared_scale(ALIKE, seed=seed),
    "simulate": lambda seed: nc.scaling.simulate(SCALE, 10, seed=seed),
    "simulate_quadruples": lambda seed: nc.scaling.simulate_quadruples(SCALE, seed=seed),
    "six_points": lambda seed: nc.scaling.six_points(DIFFERENCES, seed=seed),
    "simulate_rankings": lambda seed: nc.scaling.simulate_rankings(SCALE, 10, seed=seed),
    "synthesise": lambda seed: texture.synthesise(
        texture.GrainSpectrum([1, 2, 3], np.ones((3, 3))), 4.0, seed=seed
    ),
    "transitivity": lambda seed: nc.scaling.transitivity(ALIKE, seed=seed),
}


@pytest.mark.parametrize("name", ASKED)
@pytest.mark.parametrize("seed", [-1, 0.5, 1.0, 2**64, True, "1", None, np.nan])
def test_a_seed_that_is_none_is_refused_at_once_with_the_range(name: str, seed: Any) -> None:
    with pytest.raises(InputError, match=r"seed is .*; allowed: (a whole number, )?0 to [0-9]+$"):
        ASKED[name](seed)


def test_every_public_function_with_a_seed_is_asked() -> None:
    with_seed = {"Bootstrap", "grow", "synthesise"}  # methods, other keys, a module's own
    for room in (nc, nc.colour, nc.medium, nc.optics, nc.scaling):
        for name in room.__all__:
            made = getattr(room, name)
            if inspect.isfunction(made) and "seed" in inspect.signature(made).parameters:
                with_seed.add(name)
    with_seed |= {
        f"Plan.{name}"
        for name, made in vars(nc.scaling.Plan).items()
        if inspect.isfunction(made) and "seed" in inspect.signature(made).parameters
    }
    assert {*ASKED} == with_seed | {"analyse"}


def test_the_largest_seed_is_a_seed() -> None:
    needed = nc.scaling.Plan([2.0, 0.0], people=10).people_needed(
        "1", "2", studies=10, seed=2**63 - 1
    )
    assert needed.people > 0

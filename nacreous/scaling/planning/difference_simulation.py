"""Simulated observers of differences, for a scale that is known. Never data of people.

Whoever judges is called "simulated 1", "simulated 2" and so on, as in
`nacreous.scaling.planning.simulation`.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from nacreous.number import said, seed_of, whole_of, within
from nacreous.problem import InputError
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.label import label_of
from nacreous.scaling.data.quadruples import Quadruples
from nacreous.scaling.fit.unit import check_model
from nacreous.scaling.planning.quadruple_design import QuadrupleDesign, full_quadruples
from nacreous.scaling.planning.simulation import truth_of

__all__ = ["simulate_quadruples"]

_WIDEST = 50.0
_MOST_JUDGEMENTS = 5_000_000


def simulate_quadruples(
    scale: Mapping[str, float] | ArrayLike,
    people: int = 1,
    *,
    design: QuadrupleDesign | None = None,
    model: str = "probit",
    noise: float = 1.0,
    person_spread: float = 0.0,
    lapse: float = 0.0,
    seed: int = 1,
) -> Quadruples:
    """Judgements of simulated observers of a known scale: which of two pairs differs more.

    scale          the truth, in the order of the stimuli: label -> value, or values of "1", "2" ...
    people         how many simulated observers; each judges the whole design.
    design         of `full_quadruples` or `random_quadruples`; by default all non-overlapping
                   quadruples once.
    model, noise   what is judged is how much larger one size of a difference, whatever its
                   direction, is than the other's, plus normal ("probit", noise is its standard
                   deviation) or logistic noise ("logit", its scale), 0 to 50.
    person_spread  everyone has a scale of their own, the truth plus normal noise of this standard
                   deviation on each stimulus.
    lapse          share of judgements, 0 to 1, given by tossing a coin.
    seed           same arguments and seed, same judgements.

    Raises `InputError` for values that cannot be used.

    >>> judged = simulate_quadruples([0, 1, 3, 4, 6], people=2, seed=3)
    >>> judged, judged.people
    (Quadruples(10 judgements, 5 stimuli, 2 people), ('simulated 1', 'simulated 2'))
    """
    stimuli, truth = _truth(scale)
    people = whole_of("people", people, 1, 100_000)
    check_model(model)
    noise, lapse = within("noise", noise, 0, _WIDEST), within("lapse", lapse, 0, 1)
    person_spread = within("person_spread", person_spread, 0, _WIDEST)
    random = np.random.default_rng(seed_of(seed))
    shown = _shown(design, stimuli)
    if len(shown) * people > _MOST_JUDGEMENTS:
        raise InputError(
            f"{len(shown) * people} judgements to simulate; allowed: {_MOST_JUDGEMENTS}"
        )
    own = truth + person_spread * random.standard_normal((people, len(truth)))
    person = np.repeat(np.arange(people), len(shown))
    asked = np.tile(shown, (people, 1))
    a, b, c, d = (own[person, each] for each in asked.T)
    drawn = random.standard_normal if model == "probit" else partial(random.logistic, 0.0, 1.0)
    felt = np.asarray(drawn(len(person)))
    lead = np.abs(b - a) - np.abs(d - c) + noise * felt
    careless = (random.random(len(person)) < lapse) | (lead == 0)
    lead[careless] = random.random(int(careless.sum())) - 0.5
    return Quadruples(
        stimuli=stimuli,
        shown=asked,
        outcome=np.where(lead > 0, 1, -1).astype(np.int8),
        people=tuple(f"simulated {number + 1}" for number in range(people)),
        person=person,
    )


def _truth(scale: Mapping[str, float] | ArrayLike) -> tuple[tuple[str, ...], np.ndarray]:
    """Labels in the order that was given, which is that of the scale, and their values."""
    stimuli, truth = truth_of(scale)
    if not isinstance(scale, Mapping):
        return stimuli, truth
    given = tuple(label_of(str(label)) for label in scale)
    return given, truth[[stimuli.index(label) for label in given]]


def _shown(design: QuadrupleDesign | None, stimuli: tuple[str, ...]) -> np.ndarray:
    """int64 [trial, 4], indices into stimuli."""
    if design is None:
        return full_quadruples(stimuli).shown
    if not isinstance(design, QuadrupleDesign):
        raise InputError(f"design is {said(design)}; allowed: a QuadrupleDesign, or None")
    if design.stimuli != stimuli:
        raise InputError(
            f"design is of {listed(design.stimuli)}; allowed: those of scale, {listed(stimuli)}"
        )
    return design.shown

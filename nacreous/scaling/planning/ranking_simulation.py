"""Simulated observers who rank trays: drawn for a scale that is known. Never data of people."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.number import said, seed_of, truth_of, whole_of, within
from nacreous.problem import InputError
from nacreous.scaling.data.rankings import Rankings
from nacreous.scaling.planning.simulation import truth_of as scale_of

__all__ = ["simulate_rankings"]

_MOST_PLACED, _WIDEST = 20_000_000, 50.0


def simulate_rankings(
    scale: Mapping[str, float] | ArrayLike,
    people: int = 30,
    *,
    trays: Iterable[Sequence[object]] | None = None,
    first: int | None = None,
    best_worst: bool = False,
    person_spread: float = 0.0,
    seed: int = 1,
) -> Rankings:
    """Rankings by simulated observers, for a known scale, by the model that `plackett_luce` fits.

    scale          the truth in logit: label -> value, or values of stimuli "1", "2", ...
    people         how many simulated observers, 1 to 1 000 000; each ranks every tray.
    trays          lists of labels; by default one tray of all stimuli.
    first          only so many of a tray are put in order; by default all.
    best_worst     only the best and the worst of a tray are named, by the maxdiff model.
    person_spread  everyone has a scale of their own, the truth plus normal noise of this standard
                   deviation on each stimulus, 0 to 50.
    seed           same arguments and seed, same rankings.

    Raises `InputError` for values that cannot be used.

    >>> rankings = simulate_rankings({"dull": -1.0, "fair": 0.0, "bright": 1.0}, people=20, seed=7)
    >>> rankings, rankings.people[:2]
    (Rankings(20 trays of 3, 3 stimuli, 20 people), ('simulated 1', 'simulated 2'))
    """
    stimuli, truth = scale_of(scale)
    people, seed = whole_of("people", people, 1, 1_000_000), seed_of(seed)
    spread = within("person_spread", person_spread, 0.0, _WIDEST)
    if truth_of("best_worst", best_worst) and first is not None:
        raise InputError(f"first is {said(first)}; allowed with best_worst=True: None")
    if first is not None:
        whole_of("first", first, 1, len(stimuli))
    plan = _trays_of(trays, stimuli)
    placed = people * int(plan.sizes.sum())
    if placed > _MOST_PLACED:
        raise InputError(f"{placed} places on trays to simulate; allowed: {_MOST_PLACED}")
    random = np.random.default_rng(seed)
    own = truth + spread * random.standard_normal((people, len(truth)))
    drawn = [
        _best_worst(random, own[:, items]) if best_worst else _order(random, own[:, items])
        for items in np.split(plan.items, plan.starts[1:])
    ]
    labels = [
        [np.array(tray)[order].tolist() for order in each]
        for tray, each in zip(plan.lists(), drawn, strict=True)
    ]
    orders = [labels[tray][who] for who in range(people) for tray in range(len(plan))]
    names = [f"simulated {who + 1}" for who in range(people) for _ in range(len(plan))]
    if best_worst:
        answers = [(order, order[0], order[-1]) for order in orders]
        return Rankings.of_best_worst(answers, person=names, stimuli=stimuli)
    return Rankings.of_lists(
        [order[:first] for order in orders], shown=orders, person=names, stimuli=stimuli
    )


def _trays_of(trays: Iterable[Sequence[object]] | None, stimuli: tuple[str, ...]) -> Rankings:
    """The trays as whole rankings, checked."""
    if trays is None:
        return Rankings.of_lists([stimuli], stimuli=stimuli)
    if isinstance(trays, str | bytes) or not isinstance(trays, Iterable):
        raise InputError(f"trays is {said(trays)}; allowed: lists of labels")
    return Rankings.of_lists(trays, stimuli=stimuli)


def _order(random: np.random.Generator, values: NDArray[np.float64]) -> NDArray[np.int64]:
    """Places of a tray, the best first, int64 [person, place].

    With noise of Gumbel's distribution the order of sums is Plackett and Luce's (J. I. Yellott, J.
    Math. Psychology 15 (1977), 109).
    """
    return np.argsort(-(values + random.gumbel(size=values.shape)), axis=1)


def _best_worst(random: np.random.Generator, values: NDArray[np.float64]) -> NDArray[np.int64]:
    """Places of a tray, the best first and the worst last: the pair with the greatest sum."""
    people, size = values.shape
    lead = values[:, :, None] - values[:, None, :] + random.gumbel(size=(people, size, size))
    lead[:, np.arange(size), np.arange(size)] = -np.inf
    pair = lead.reshape(people, -1).argmax(axis=1)
    best, worst = pair // size, pair % size
    place = np.tile(np.arange(size), (people, 1))
    key = np.where(place == best[:, None], -1, np.where(place == worst[:, None], size, place))
    return np.argsort(key, axis=1)

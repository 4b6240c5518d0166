"""Simulated observers: answers drawn for a scale that is known. Never data of people.

What they are for: planning a study, and proving that intervals cover and tests hold their size.
Whoever answers is called "simulated 1", "simulated 2" and so on, so that no table of such answers
can be taken for a study with people.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.number import number_of, row_of, said, seed_of, whole_of, within
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.fault import listed, quoted
from nacreous.scaling.data.label import check_number, check_visible, label_of, natural, numbered
from nacreous.scaling.data.likeness import check_alike
from nacreous.scaling.fit.unit import check_model
from nacreous.scaling.planning.design import PairDesign

__all__ = ["simulate"]

Pairs = Sequence[tuple[object, object]] | PairDesign

#: Beyond, a unanimous pair is unanimous among all people who ever lived.
_WIDEST = 50.0
_MOST_ANSWERS = 20_000_000


def simulate(
    scale: Mapping[str, float] | ArrayLike,
    people: int = 30,
    *,
    model: str = "probit",
    pairs: Pairs | None = None,
    repeats: int = 1,
    person_spread: float = 0.0,
    order: float = 0.0,
    tie: float = 0.0,
    lapse: float = 0.0,
    seed: int = 1,
) -> Answers:
    """Answers of simulated observers to a design, for a known scale.

    scale          the truth: label -> value, or values of stimuli "1", "2", ... In the model's own
                   unit, in which a lead of x is chosen with probability F(x): z for "probit" (F
                   normal), logit for "logit" (F logistic).
    people         how many simulated observers; each answers every pair of `pairs` `repeats` times.
    pairs          a `PairDesign`, or (label, label) each; by default each pair of stimuli once.
                   Which one stands on the left is tossed for every answer.
    person_spread  people differ: everyone has a scale of their own, the truth plus normal noise of
                   this standard deviation on each stimulus. 0: all alike, answers independent.
    order          added to the lead of whatever stands on the left.
    tie            width of ties: with "probit" a lead within +- tie of zero is no choice (Glenn and
                   David 1960); with "logit" Davidson's nu (1970), tie : win = nu at equal values.
    lapse          share of answers, 0 to 1, given by tossing a coin.
    seed           same arguments and seed, same answers.

    Raises `InputError` for values that cannot be used.

    >>> answers = simulate({"dull": -1.0, "fair": 0.0, "bright": 1.0}, people=20, seed=7)
    >>> len(answers.outcome), answers.people[:2], answers.stimuli
    (60, ('simulated 1', 'simulated 2'), ('bright', 'dull', 'fair'))
    """
    stimuli, truth = truth_of(scale)
    _check(people, repeats, model, person_spread, order, tie, lapse)
    first, second = pairs_of(pairs, stimuli)
    each = np.tile(np.arange(len(first)), repeats)
    if len(each) * people > _MOST_ANSWERS:
        raise InputError(f"{len(each) * people} answers to simulate; allowed: {_MOST_ANSWERS}")
    random = np.random.default_rng(seed_of(seed))
    person = np.repeat(np.arange(people), len(each))
    swapped = random.random(len(person)) < 0.5
    pair = np.tile(each, people)
    left = np.where(swapped, second[pair], first[pair])
    right = np.where(swapped, first[pair], second[pair])
    own = truth + person_spread * random.standard_normal((people, len(truth)))
    lead = own[person, left] - own[person, right] + order
    outcome = _answered(random, lead, model, tie)
    careless = random.random(len(person)) < lapse
    outcome[careless] = np.where(random.random(int(careless.sum())) < 0.5, 1, -1)
    return Answers(
        stimuli=stimuli,
        left=left,
        right=right,
        outcome=outcome,
        people=tuple(f"simulated {k + 1}" for k in range(people)),
        person=person,
        groups={},
        response_s=None,
        time=None,
        sided=True,
    )


def truth_of(scale: Mapping[str, float] | ArrayLike) -> tuple[tuple[str, ...], NDArray[np.float64]]:
    """Labels in natural order and finite values of a scale that a caller states."""
    if isinstance(scale, Mapping):
        names = [label_of(str(label)) for label in scale]
        again = next((label for k, label in enumerate(names) if label in names[:k]), None)
        if again is not None:
            raise InputError(f"scale has {quoted(again)} again; allowed: each label once")
        check_visible(names, "scale")
        check_alike(names, "scale")
        stimuli = tuple(natural(names))
        values = [number_of(f'scale["{label}"]', value) for label, value in scale.items()]
        by_label = dict(zip(names, values, strict=True))
        truth = np.array([by_label[label] for label in stimuli])
    else:
        truth = row_of("scale", scale)
        stimuli = numbered(len(truth))
    check_number(stimuli, "scale")
    for label, value in zip(stimuli, truth.tolist(), strict=True):
        if not abs(value) <= _WIDEST:
            raise InputError(f'scale["{label}"] is {value:g}; allowed: {-_WIDEST:g} to {_WIDEST:g}')
    return stimuli, truth


def pairs_of(
    pairs: Pairs | None, stimuli: Sequence[str]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Indices of the pairs of a design, by default all pairs once."""
    if pairs is None:
        first, second = np.triu_indices(len(stimuli), 1)
        return first.astype(np.int64), second.astype(np.int64)
    pairs = getattr(pairs, "pairs", pairs)  # of a design
    if isinstance(pairs, str) or not isinstance(pairs, Sequence):
        raise InputError(f"pairs is {said(pairs)}; allowed: a design, or a list of two labels each")
    index = {label: k for k, label in enumerate(stimuli)}
    found = []
    for row, pair in enumerate(pairs):
        if isinstance(pair, str) or not isinstance(pair, Sequence) or len(pair) != 2:
            raise InputError(f"pairs[{row}] is {said(pair)}; allowed: two labels")
        left, right = (label_of(str(label)) for label in pair)
        for label in (left, right):
            if label not in index:
                raise InputError(f"pairs[{row}] names {quoted(label)}; allowed: {listed(stimuli)}")
        if left == right:
            raise InputError(f"pairs[{row}] is {quoted(left)} twice; allowed: two stimuli")
        found.append((index[left], index[right]))
    if not found:
        raise InputError("pairs is empty; allowed: one pair or more")
    both = np.array(found, np.int64)
    return both[:, 0], both[:, 1]


def _check(
    people: object,
    repeats: object,
    model: object,
    person_spread: object,
    order: object,
    tie: object,
    lapse: object,
) -> None:
    whole_of("people", people, 1, 1_000_000)
    whole_of("repeats", repeats, 1, 10_000)
    check_model(model)
    within("person_spread", person_spread, 0, _WIDEST)
    within("order", order, -_WIDEST, _WIDEST)
    within("tie", tie, 0, _WIDEST)
    within("lapse", lapse, 0, 1)


def _answered(
    random: np.random.Generator, lead: NDArray[np.float64], model: str, tie: float
) -> NDArray[np.int8]:
    """1, -1 or 0 for each lead of the left one."""
    if model == "probit":  # the lead that this very moment's noise leaves (Thurstone 1927)
        felt = lead + random.standard_normal(len(lead))
        return np.where(np.abs(felt) < tie, 0, np.where(felt > 0, 1, -1)).astype(np.int8)
    low = np.exp(-np.abs(lead))  # the weaker of the two, the stronger being 1
    better, worse = np.where(lead >= 0, 1.0, low), np.where(lead >= 0, low, 1.0)
    neither = tie * np.sqrt(low)
    drawn = random.random(len(lead)) * (better + worse + neither)
    return np.where(drawn < better, 1, np.where(drawn < better + worse, -1, 0)).astype(np.int8)

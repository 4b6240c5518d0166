"""What people who differ are like: of one scale, of scales spread about one, or in classes."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.check.classes import Mixture, fit_classes
from nacreous.scaling.check.own_values import fit_own_values, spread_ends
from nacreous.scaling.data.given import answers_of
from nacreous.scaling.fit.blocks import Array, Blocks, blocks_of
from nacreous.scaling.fit.unit import check_model
from nacreous.value import value_class

__all__ = ["Candidate", "PersonClass", "Population", "population"]

#: People x stimuli² up to which the models are fitted, and people from which on.
_MOST_NUMBERS = 2_000_000
_LEAST_PEOPLE = 6
#: A class of fewer is a person.
_LEAST_IN_CLASS = 2
#: With fewer people, and where classes are not ahead of the spread by this difference of BIC ("very
#: strong" evidence, R. E. Kass and A. E. Raftery, JASA 90, 1995), people who vary continuously are
#: taken for classes too often (benchmarks/persons.py).
_LEAST_TOLD = 8
_VERY_STRONG = 10.0


Kind = Literal["one scale", "spread", "classes", "spread or classes"]


@value_class
class Candidate:
    """One description of the people: `name` is "one scale", "spread", "2 classes" and so on.

    `parameters`: free ones; `bic`: parameters x ln(people) - 2 log-likelihood, the smaller the
    better. `lone`: one of its classes is a single person or nobody, so that it was not chosen.
    """

    name: str
    parameters: int
    log_likelihood: float
    bic: float
    lone: bool = False


@value_class
class PersonClass:
    """A class of people: its `share` of all, `people` who are most likely in it, its `scale`.

    `scale`: float64 [stimulus], mean 0, in the model's own unit. `correlation`: with the scale of
    the first, largest class.
    """

    share: float
    people: tuple[str, ...]
    scale: Array
    correlation: float


@value_class
class Population:
    """The description of the people with the smallest BIC, and those it was chosen from.

    - `kind`: "one scale", "spread" (everyone has values of their own, of which `spread` is the
      standard deviation), "classes", or "spread or classes" where these answers do not tell which
    - `spread`: in the model's own unit; None unless it was chosen and these answers tell how large
      it is; `spread_low`, `spread_high`: its interval, None unless chosen, and the upper end None
      where the spread is larger than these answers can tell
    - `classes`: the largest first; () unless they were chosen
    - `candidates`: all that were fitted
    """

    model: str
    stimuli: tuple[str, ...]
    kind: Kind
    spread: float | None
    spread_low: float | None
    spread_high: float | None
    classes: tuple[PersonClass, ...]
    candidates: tuple[Candidate, ...]


def population(
    answers: Any,
    model: str = "probit",
    most: int = 4,
    starts: int = 20,
    seed: int = 1,
    level: float = 0.95,
) -> Population:
    """Choose between one scale, a continuous spread and 2 to `most` classes by BIC.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.
    A spread looks like classes to any criterion that is not offered the spread as well, so it
    always competes. BIC counts people, not answers, for people are what is drawn (G. Schwarz,
    Annals of Statistics 6, 1978). A class of one person is a person: classes of which fewer than
    two people are most likely members are not chosen. Ties count half. starts: of EM, for each
    number of classes. level: of the spread's interval.

    most: 2 to 10, starts: 1 to 1000. Raises `InputError` where people are unknown, with fewer than
    6 of them, and where people x stimuli² is more than 2 000 000.

    >>> import nacreous as nc
    >>> spread = nc.scaling.simulate([0.8, 0.3, -0.3, -0.8], people=60, person_spread=0.8)
    >>> population(spread).kind
    'spread'
    """
    check_model(model)
    whole_of("most", most, 2, 10)
    whole_of("starts", starts, 1, 1000)
    seed = seed_of(seed)
    answers = answers_of(answers)
    blocks = blocks_of(answers)
    _require_size(blocks)
    each = len(blocks.stimuli) - 1
    spread = fit_own_values(blocks, model)
    mixtures = [fit_classes(blocks, count, model, starts, seed) for count in range(1, most + 1)]
    found = [_candidate("spread", each + 1, spread.log_likelihood, blocks)]
    for count, mixture in enumerate(mixtures, 1):
        name = "one scale" if count == 1 else f"{count} classes"
        free = count * each + count - 1
        lone = min(map(len, _members(mixture))) < _LEAST_IN_CLASS
        found.append(_candidate(name, free, mixture.log_likelihood, blocks, lone))
    best = min((at for at, one in enumerate(found) if not one.lone), key=lambda at: found[at].bic)
    kind = _kind(found, best, len(blocks.people))
    ends = spread_ends(blocks, spread, model, level) if kind == "spread" else (None, None)
    classes = _classes(blocks, mixtures[best - 1]) if kind == "classes" else ()
    return Population(
        model=model,
        stimuli=blocks.stimuli,
        kind=kind,
        spread=None if ends[1] is None else spread.spread,
        spread_low=ends[0],
        spread_high=ends[1],
        classes=classes,
        candidates=tuple(found),
    )


def _require_size(blocks: Blocks) -> None:
    people, stimuli = len(blocks.people), len(blocks.stimuli)
    if people < _LEAST_PEOPLE:
        raise InputError(f"{people} people; allowed: {_LEAST_PEOPLE} or more")
    if people * stimuli**2 > _MOST_NUMBERS:
        raise InputError(
            f"{people} people with {stimuli} stimuli; "
            f"allowed: people x stimuli² up to {_MOST_NUMBERS}"
        )


def _candidate(
    name: str, parameters: int, log_likelihood: float, blocks: Blocks, lone: bool = False
) -> Candidate:
    bic = parameters * float(np.log(len(blocks.people))) - 2 * log_likelihood
    return Candidate(name, parameters, log_likelihood, bic, lone)


def _members(mixture: Mixture) -> list[NDArray[np.int64]]:
    """By class, the indices of the people who are most likely in it."""
    likely = mixture.belonging.argmax(axis=1)
    return [np.flatnonzero(likely == at) for at in range(len(mixture.shares))]


def _kind(found: list[Candidate], best: int, people: int) -> Kind:
    """What the best candidate is, if it can be told from the others; spread and one scale lead."""
    if best == 1:
        return "one scale"
    if people < _LEAST_TOLD:
        return "spread or classes"
    if best == 0:
        return "spread"
    ahead = found[0].bic - found[best].bic
    return "classes" if ahead >= _VERY_STRONG else "spread or classes"


def _classes(blocks: Blocks, mixture: Mixture) -> tuple[PersonClass, ...]:
    first = mixture.values[0]
    found = []
    rows = zip(mixture.shares, mixture.values, _members(mixture), strict=True)
    for share, scale, members in rows:
        size = float(np.linalg.norm(scale) * np.linalg.norm(first))
        found.append(
            PersonClass(
                share=float(share),
                people=tuple(blocks.people[index] for index in members),
                scale=scale,
                correlation=float(scale @ first) / size if size > 0 else 0.0,
            )
        )
    return tuple(found)

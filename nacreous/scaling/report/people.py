"""How the people differ, as far as their answers tell."""

from __future__ import annotations

from math import ceil

from nacreous.problem import InputError
from nacreous.scaling.check.population import Population, population
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.fit.covariate import (
    Covariate,
    Untested,
    person_covariates,
    untested_columns,
)
from nacreous.scaling.fit.shared import Progress, SharedScale, shared_scale
from nacreous.scaling.report.settings import Settings
from nacreous.value import value_class

__all__ = ["People", "people_of"]

#: Answers x permutations that nobody minds to wait for, some seconds.
_MOST_DEALT = 200_000_000


@value_class
class People:
    """The test whether people share one scale, and what follows where they do not.

    `differ`: the test of single people finds that they do not, at the level asked for.
    `population`: what describes them; None where they do not differ, and where they are too few or
    too many for that. `covariates`: columns of people, tested in any case; `apart_by`: those by
    which they judge differently; `untested`: those that cannot be tested, and why.
    """

    shared: SharedScale
    differ: bool
    population: Population | None
    covariates: tuple[Covariate, ...]
    apart_by: tuple[str, ...]
    untested: tuple[Untested, ...]

    @property
    def spread_told(self) -> bool:
        """Whether people have values of their own whose standard deviation is known."""
        return self.population is not None and self.population.spread is not None


def people_of(
    answers: Answers | None, settings: Settings, progress: Progress | None = None
) -> People | None:
    """None where people are unknown, or answered nothing in which they could differ."""
    if answers is None or answers.person is None:
        return None
    permutations = _permutations(len(answers), settings.level)
    try:
        shared = shared_scale(answers, permutations, settings.seed, progress)
    except InputError:  # no pair was answered by two, all agree, or nobody answered two pairs
        return None
    differ = shared.differ(settings.level)
    described = _population(answers, settings) if differ else None
    covariates = person_covariates(answers, permutations, settings.seed)
    apart_by = tuple(one.column for one in covariates if one.differs(settings.level))
    return People(shared, differ, described, covariates, apart_by, untested_columns(answers))


def _permutations(answers: int, level: float) -> int:
    """999, fewer for very many answers; enough that p can be below 1 - level."""
    return max(99, ceil(2 / (1 - level)), min(999, _MOST_DEALT // answers))


def _population(answers: Answers, settings: Settings) -> Population | None:
    try:
        return population(answers, settings.model, seed=settings.seed, level=settings.level)
    except InputError:  # too few people, or too many numbers
        return None

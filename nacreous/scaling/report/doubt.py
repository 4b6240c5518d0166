"""How sure the places and the distances are, and which things are told apart."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.fit.bootstrap import resampled
from nacreous.scaling.fit.errors import Errors, endless, errors_of, kind_of
from nacreous.scaling.fit.judges import LEAST_DRAWN, judges_of
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.uncertainty import differences, holm, intervals, root_of_diagonal
from nacreous.scaling.report.settings import Settings
from nacreous.value import value_class

__all__ = [
    "FEW_PEOPLE",
    "Doubt",
    "Pair",
    "doubt_of",
    "ends_apart",
    "neighbours_of",
    "pairs_of",
]

#: From fewer people a bootstrap is too narrow (B. Efron and R. Tibshirani, 1993, chapter 19).
FEW_PEOPLE = 20
#: A spread below this share of the expected one is none at all.
_NOTHING = 1e-6

Progress = Callable[[float], None]


@value_class
class Doubt:
    """Margins of a scale, in its unit.

    `by`: what was resampled, "people" or "answers"; where nothing was, "clusters" (people by their
    scores), "jackknife" (people left out one by one) or "information". `samples`: how often
    something was drawn; `without_maximum`: how many samples had no scale of their own, with more
    than 2 of 100 the reason why none is used.
    `intervals` [n, 2] of the places. `errors`: what differences are tested by.
    `too_few`: people are known, but they tell nothing of how people differ. `endless`: sets, the
    highest first, between which the answers put no end to the distance: there the intervals are
    those of the prior or of reduced bias.
    """

    by: str
    samples: int
    without_maximum: int
    intervals: NDArray[np.float64]
    errors: Errors
    too_few: bool
    endless: tuple[tuple[str, ...], ...] = ()

    def is_endless(self, first: str, second: str) -> bool:
        """Whether the answers put no end to the distance of two things."""
        return any((first in each) != (second in each) for each in self.endless)

    def open_ends(self, stimuli: Sequence[str]) -> NDArray[np.bool_]:
        """Which ends, bool [n, 2], of the intervals the answers do not set, lower first.

        Of three sets or more those between have neither: the middle of the scale moves too.
        """
        last = len(self.endless) - 1
        rank = {label: at for at, each in enumerate(self.endless) for label in each}
        ends = [(rank.get(label, -1) > 0, 0 <= rank.get(label, -1) < last) for label in stimuli]
        return np.array(ends, np.bool_)

    @property
    def covariance(self) -> NDArray[np.float64]:
        """float64 [n, n] of the places."""
        return self.errors.covariance

    @property
    def se(self) -> NDArray[np.float64]:
        """float64 [n], standard errors of the places."""
        return root_of_diagonal(self.covariance)


@value_class
class Pair:
    """Two things, the higher one first.

    `p_value` is Holm's over all pairs that were looked at; `apart`: it is below 1 - level.
    `expected`: the share that should choose the first. `endless`: the answers put no end to the
    difference, and `high` is what draws the scale together.
    """

    first: str
    second: str
    difference: float
    low: float
    high: float
    p_value: float
    apart: bool
    expected: float
    endless: bool = False


def doubt_of(fit: Scale, settings: Settings, progress: Progress | None = None) -> Doubt:
    """Over people wherever three or more are known, else over answers.

    Where many samples of a bootstrap have no scale of their own, their spread is that of the prior
    that holds them, and no interval: the model's errors stand in, people as clusters where known.
    """
    known = kind_of(fit, None) == "people"
    over_people = _over_people(fit) if known else None
    # The row means of 1996 and the fractions of printed tables give nothing to draw from.
    counts = np.stack([fit.comparisons.left_wins, fit.comparisons.right_wins, fit.comparisons.ties])
    drawable = fit.method == "maximum-likelihood" and fit.posterior is None
    sets = endless(fit)
    if sets:  # samples stay as near as what draws the scale together
        alike = known and len(sets) == len(fit.stimuli)  # every answer goes with one order
        return replace(_over_answers(fit, settings, True, alike, progress), endless=sets)
    fixed = settings.bootstrap == 0 or not drawable or bool(np.any(counts % 1))
    if over_people is None:
        return _over_answers(fit, settings, fixed, known, progress)
    samples = missing = 0
    if not fixed and _many(fit):
        drawn = resampled(
            fit, settings.bootstrap, "people", settings.seed, progress, errors=over_people
        )
        samples, missing = settings.bootstrap, drawn.without_maximum
        if drawn.tells:
            bounds = drawn.intervals(settings.level)
            return Doubt("people", samples, missing, bounds, over_people, too_few=False)
        # Samples that do not differ tell nothing either, and need no word.
        samples, missing = (0, 0) if drawn.placed else (samples, missing)
    bounds = intervals(fit.scale, over_people, settings.level)
    by = "jackknife" if fit.method == "least-squares" else "clusters"
    return Doubt(by, samples, missing, bounds, over_people, too_few=False)


def _many(fit: Scale) -> bool:
    """Whether enough people answered, and judged each stimulus, to be drawn."""
    answers = fit.answers
    if answers is None or answers.person is None:
        return False
    people = len(np.unique(answers.person))
    return people >= FEW_PEOPLE and int(judges_of(answers).min()) >= LEAST_DRAWN


def _over_answers(
    fit: Scale, settings: Settings, fixed: bool, known: bool, progress: Progress | None
) -> Doubt:
    """As if each answer stood alone."""
    alone = errors_of(fit, "expected")
    samples = missing = 0
    if not fixed:
        drawn = fit.bootstrap(settings.bootstrap, "answers", settings.seed, progress)
        samples, missing = settings.bootstrap, drawn.without_maximum
        if drawn.tells and _spreads(drawn.covariance, alone.covariance):
            found = Errors(drawn.covariance, None, alone.values)
            return Doubt("answers", samples, missing, drawn.intervals(settings.level), found, known)
        samples = 0 if drawn.placed else samples  # as over people
    bounds = intervals(fit.scale, alone, settings.level)
    return Doubt("information", samples, missing if samples else 0, bounds, alone, known)


def _over_people(fit: Scale) -> Errors | None:
    """Errors over people, None where these tell nothing of how people differ."""
    try:
        return errors_of(fit, "people")
    except InputError:
        return None


def _spreads(drawn: NDArray[np.float64], expected: NDArray[np.float64]) -> bool:
    """Whether samples differ at all: those of nothing but ties, or of one answer each, do not."""
    own, alone = (np.add.outer(np.diag(t), np.diag(t)) - 2 * t for t in (drawn, expected))
    return bool((own >= _NOTHING * alone).all())


def neighbours_of(fit: Scale, doubt: Doubt, level: float) -> tuple[Pair, ...]:
    """Each thing with the next one down, from the top."""
    return _compared(fit, doubt, level, list(pairwise(_order(fit))))


def pairs_of(fit: Scale, doubt: Doubt, level: float) -> tuple[Pair, ...]:
    """Each thing with all that are further down, from the top."""
    order = _order(fit)
    below = [(one, other) for at, one in enumerate(order) for other in order[at + 1 :]]
    return _compared(fit, doubt, level, below)


def ends_apart(fit: Scale, doubt: Doubt, level: float) -> bool:
    """Whether the first and the last are told apart, had all pairs been looked at (Bonferroni)."""
    order, count = _order(fit), len(fit.stimuli)
    ends = [(order[0], order[-1])]
    found = differences(fit.stimuli, fit.scale, doubt.errors, fit.unit, level, "none", ends)[0]
    return bool(found.p_value * count * (count - 1) / 2 < 1 - level)


def _order(fit: Scale) -> list[int]:
    return [int(at) for at in np.argsort(-fit.scale, kind="stable")]


def _compared(
    fit: Scale, doubt: Doubt, level: float, pairs: Sequence[tuple[int, int]]
) -> tuple[Pair, ...]:
    found = differences(fit.stimuli, fit.scale, doubt.errors, fit.unit, level, "none", list(pairs))
    p_values = holm(np.array([one.p_value for one in found]))
    shares = fit.proportions
    return tuple(
        Pair(
            one.first,
            one.second,
            one.value,
            one.low,
            one.high,
            p_value=float(p_value),
            apart=bool(p_value < 1 - level),
            expected=float(shares[i, j]),
            endless=doubt.is_endless(one.first, one.second),
        )
        for one, p_value, (i, j) in zip(found, p_values, pairs, strict=True)
    )

"""Two sets of pictures of the same things, photographs and synthesised ones: do they share a scale.

Both scales are estimates, and both errors count. Agreement of the two is measured four ways; which
stimuli moved is asked after the scales are brought to one unit, for the unit of case V is the noise
of one judgement, which need not be the same in both sets.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of, whole_of, within
from nacreous.problem import InputError
from nacreous.scaling.compare.alignment import Alignment, Shifts, align, shifts
from nacreous.scaling.compare.estimate import estimates, firm_spread_over, shared_people
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.unit import check_model
from nacreous.scaling.rank import ranks
from nacreous.value import value_class

__all__ = ["Coefficient", "Move", "SetComparison", "compare_sets"]

Array = NDArray[np.float64]

#: Values at a time, 32 MB of them.
_AT_ONCE = 1 << 22


@value_class
class Coefficient:
    """A measure of agreement with its interval."""

    value: float
    low: float
    high: float


@value_class
class Move:
    """Where one stimulus stands in the second set, seen from the first.

    first, second   its values, each in its own set's unit, mean 0
    shift           second less what the first and the other stimuli let expect, in the second
                    set's unit, with standard error, its own interval (low, high), p, and Holm's p
    moved           whether Holm's p is below 1 - level: then it has no part in the alignment
    first_place, second_place   places from the top, 1 the highest
    places          places won (positive) or lost in the second set, and their interval
    """

    stimulus: str
    first: float
    second: float
    shift: float
    se: float
    low: float
    high: float
    p_value: float
    p_adjusted: float
    moved: bool
    first_place: int
    second_place: int
    places: int
    places_low: int
    places_high: int


@value_class
class SetComparison:
    """What `compare_sets` found.

    first, second            the fitted scales
    kendall, spearman        agreement of the orders, -1 to 1
    pearson                  correlation of the scales, -1 to 1
    slope                    unit of the second in that of the first: the slope of Deming's line,
                             which has errors on both sides; `low` or `high` is None where the data
                             set no bound
    statistic, df, p_value   chi-squared test that both sets have one scale up to its unit
    moves                    stimulus by stimulus
    clustered                whether people were known, and errors take them as clusters
    """

    first: Scale
    second: Scale
    kendall: Coefficient
    spearman: Coefficient
    pearson: Coefficient
    slope: Alignment
    statistic: float
    df: int
    p_value: float
    moves: tuple[Move, ...]
    clustered: bool

    @property
    def moved(self) -> tuple[str, ...]:
        """Labels of the stimuli that moved."""
        return tuple(move.stimulus for move in self.moves if move.moved)


def compare_sets(
    first: Any,
    second: Any,
    model: str = "probit",
    *,
    ties: bool | None = None,
    order: bool | None = None,
    same_people: bool | None = None,
    level: float = 0.95,
    samples: int = 2000,
    seed: int = 1,
) -> SetComparison:
    """Compare two sets of the same stimuli: agreement, and which stimuli moved how far.

    first, second  answers or counts with the same four or more labels.
    ties, order    as for `compare_groups`.
    same_people    whether a person's label in both sets is one person; needed where labels are in
                   both.
    samples        draws from the normal distribution of both scales' errors, for the intervals of
                   Kendall's, Spearman's and Pearson's coefficients and of places.

    The intervals of coefficients reach over both the percentiles of the draws and their mirror
    image about the value found: noise lowers every measure of agreement, draws twice. In
    simulations with 7 and 20 stimuli they covered 93 to 100 %, except where errors are more than
    twice the steps between stimuli, where Kendall's fell to 83 %. Raises `InputError` for sets that
    cannot be fitted or have other stimuli.

    >>> from nacreous.scaling.planning.simulation import simulate
    >>> photographs = simulate({"a": 1.5, "b": 0.5, "c": 0.0, "d": -2.0}, people=200, seed=1)
    >>> renderings = simulate({"a": 1.5, "b": -0.7, "c": 0.0, "d": -2.0}, people=200, seed=2)
    >>> found = compare_sets(photographs, renderings, same_people=False)
    >>> found.moved, found.moves[1].places
    (('b',), -1)
    """
    check_model(model)
    within("level", level, 0.5, 0.9999)
    whole_of("samples", samples, 100, 1_000_000)
    seed = seed_of(seed)
    found = estimates({"first": first, "second": second}, model, ties=ties, order=order)
    same = shared_people(found, same_people)
    one, two = (each.fit for each in found.values())
    if len(one.stimuli) < 4:
        raise InputError(f"the sets have {len(one.stimuli)} stimuli; allowed: 4 or more")
    for name, fit in (("first", one), ("second", two)):
        if np.ptp(fit.scale) < 1e-9:
            raise InputError(
                f"{name}: all stimuli of {quoted(name)} are alike; no order to compare"
            )
    joint = firm_spread_over(found, same)
    freedom = min(each.freedom for each in found.values())
    whole_set = align(one.scale, two.scale, joint, level)
    offsets = shifts(one.scale, two.scale, joint, whole_set.value, level, freedom)
    draws = _draws(np.concatenate([one.scale, two.scale]), joint, samples, seed)

    def agreement(measure: Callable[[Array, Array], Array]) -> Coefficient:
        return _coefficient(measure, one.scale, two.scale, draws, level)

    return SetComparison(
        one,
        two,
        agreement(_kendall),
        agreement(_spearman),
        agreement(_pearson),
        slope=whole_set,
        statistic=whole_set.misfit,
        df=whole_set.df,
        p_value=whole_set.p_value,
        moves=_moves(one, two, offsets, draws, level),
        clustered=all(each.people for each in found.values()),
    )


def _draws(mean: Array, covariance: Array, samples: int, seed: int) -> tuple[Array, Array]:
    """Scales as they may be, float64 [sample, stimulus] of the first and of the second set."""
    values, vectors = np.linalg.eigh(covariance)
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    noise = np.random.default_rng(seed).standard_normal((samples, len(mean)))
    both = mean + noise @ root.T
    half = len(mean) // 2
    return both[:, :half], both[:, half:]


def _coefficient(
    measure: Callable[[Array, Array], Array],
    one: Array,
    two: Array,
    draws: tuple[Array, Array],
    level: float,
) -> Coefficient:
    value = float(measure(one, two))
    at_once = max(1, _AT_ONCE // len(one) ** 2)  # pairs of stimuli, for Kendall's
    parts = [
        measure(draws[0][start : start + at_once], draws[1][start : start + at_once])
        for start in range(0, len(draws[0]), at_once)
    ]
    ends = np.quantile(np.concatenate(parts), [(1 - level) / 2, (1 + level) / 2])
    low, high = min(ends[0], 2 * value - ends[1]), max(ends[1], 2 * value - ends[0])
    return Coefficient(value, float(max(low, -1.0)), float(min(high, 1.0)))


def _moves(
    one: Scale,
    two: Scale,
    shift: Shifts,
    draws: tuple[Array, Array],
    level: float,
) -> tuple[Move, ...]:
    first_place, second_place = _places(one.scale), _places(two.scale)
    won = _places(draws[0]) - _places(draws[1])
    ends = np.quantile(won, [(1 - level) / 2, (1 + level) / 2], axis=0, method="nearest")
    return tuple(
        Move(
            stimulus=label,
            first=float(one.scale[k]),
            second=float(two.scale[k]),
            shift=float(shift.value[k]),
            se=float(shift.se[k]),
            low=float(shift.value[k] - shift.reach * shift.se[k]),
            high=float(shift.value[k] + shift.reach * shift.se[k]),
            p_value=float(shift.p_value[k]),
            p_adjusted=float(shift.p_adjusted[k]),
            moved=bool(shift.moved[k]),
            first_place=int(first_place[k]),
            second_place=int(second_place[k]),
            places=int(first_place[k] - second_place[k]),
            places_low=int(ends[0, k]),
            places_high=int(ends[1, k]),
        )
        for k, label in enumerate(one.stimuli)
    )


def _places(scale: Array) -> NDArray[np.int64]:
    """Places from the top along the last axis, 1 the highest."""
    return np.argsort(np.argsort(-scale, axis=-1, kind="stable"), axis=-1, kind="stable") + 1


def _kendall(one: Array, two: Array) -> Array:
    """Kendall's tau-b: agreement of all pairs' orders, along the last axis."""
    first, second = np.triu_indices(one.shape[-1], 1)
    x, y = (np.sign(s[..., first] - s[..., second]) for s in (one, two))
    return _cosine(x, y)


def _spearman(one: Array, two: Array) -> Array:
    """Correlation of ranks, along the last axis; equal values share their mean rank."""
    if one.ndim == 1:
        return _pearson(ranks(one), ranks(two))
    return _pearson(_places(one).astype(float), _places(two).astype(float))


def _pearson(one: Array, two: Array) -> Array:
    """Correlation, along the last axis."""
    return _cosine(one - one.mean(axis=-1, keepdims=True), two - two.mean(axis=-1, keepdims=True))


def _cosine(x: Array, y: Array) -> Array:
    lengths = np.sqrt((x * x).sum(axis=-1) * (y * y).sum(axis=-1))
    return np.asarray(np.clip((x * y).sum(axis=-1) / lengths, -1.0, 1.0))

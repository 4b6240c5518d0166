"""A fitted scale with the errors one may rely on: people as clusters wherever they are known."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.given import comparisons_of
from nacreous.scaling.distribution import chi2, f
from nacreous.scaling.fit.bradley import bradley_terry
from nacreous.scaling.fit.case_v import thurstone
from nacreous.scaling.fit.errors import errors_of
from nacreous.scaling.fit.existence import REMEDY, require_choices
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.side import fits_side
from nacreous.scaling.fit.tie import fits_ties
from nacreous.scaling.fit.unit import check_model
from nacreous.value import value_class

__all__ = [
    "Estimate",
    "estimate",
    "estimates",
    "fit_of",
    "hotelling",
    "shared_people",
    "spread_over",
]

Array = NDArray[np.float64]


@value_class
class Estimate:
    """A fit, and how far it may be off.

    fit         the fitted scale, in the model's own unit (z or logit), mean 0
    covariance  float64 [stimulus, stimulus]; from people as clusters where they are known, else
                from the expected information, which takes answers as independent
    people      labels of those who answered, or () where unknown
    influence   float64 [person, stimulus], by how much each person moved the scale; None without
                people. Its squares sum to the covariance.
    freedom     degrees of freedom of the errors: people less one, fewer where they answered
                different pairs; infinitely many without people
    """

    fit: Scale
    covariance: Array
    people: tuple[str, ...]
    influence: Array | None
    freedom: float


def estimate(
    data: Any,
    model: str = "probit",
    *,
    ties: bool | None = None,
    order: bool = False,
    prior: float | None = None,
) -> Estimate:
    """Fit a scale to answers or counts, with people as clusters where the answers name them.

    >>> from nacreous.scaling import paper
    >>> estimate(paper()).freedom
    inf
    """
    fit = fit_of(data, model, ties=ties, order=order, prior=prior)
    require_choices(fit.comparisons)
    if fit.answers is None or fit.answers.person is None:
        return Estimate(fit, fit.covariance("expected"), (), None, np.inf)
    errors = errors_of(fit, "people")
    if errors.clusters is None:
        raise InputError("the fit knows no people; allowed: answers with people")
    influence = errors.clusters.influence @ errors.values.T
    freedom = float(errors.freedom(np.eye(len(fit.stimuli))).min())
    return Estimate(fit, errors.covariance, names_of(fit.answers), influence, freedom)


def fit_of(data: Any, model: str, **options: Any) -> Scale:
    """The most likely scale of a model, "probit" or "logit", with the options of `thurstone`."""
    check_model(model)
    fitted: Callable[..., Scale] = thurstone if model == "probit" else bradley_terry
    try:
        return fitted(data, **options)
    except InputError as problem:
        if REMEDY not in str(problem) or options.get("prior") is not None:
            raise
        # What asks for this fit knows no prior: tests and intervals would not be theirs with one.
        raise InputError(str(problem).replace(REMEDY, "")) from problem


def names_of(answers: Answers) -> tuple[str, ...]:
    """Labels of the people who answered, () where unknown."""
    if answers.person is None:
        return ()
    return tuple(answers.people[k] for k in np.unique(answers.person))


def estimates(
    groups: dict[str, Any], model: str, *, ties: bool | None = None, order: bool | None = None
) -> dict[str, Estimate]:
    """One estimate a group, all of the same stimuli; messages name the group.

    ties, order: None has one answer for all groups, whose scales could not be compared otherwise.
    """
    found: dict[str, Estimate] = {}
    check_model(model)
    counted = [_counted(*group) for group in groups.items()]
    ties = fits_ties(ties, counted, model, order is True)
    order = fits_side(order, counted, model, ties)
    for name, data in groups.items():
        try:
            found[name] = estimate(data, model, ties=ties, order=order)
        except InputError as problem:
            raise InputError(f"group {quoted(name)}: {problem}") from problem
        first = next(iter(found))
        if found[name].fit.stimuli != found[first].fit.stimuli:
            raise InputError(
                f"group {quoted(name)} has other stimuli than group {quoted(first)}; "
                "allowed: the same stimuli in every group"
            )
    return found


def _counted(name: str, data: Any) -> Comparisons:
    try:
        return comparisons_of(data)
    except InputError as problem:
        raise InputError(f"group {quoted(name)}: {problem}") from problem


def hotelling(off: Array, covariance: Array, freedom: float) -> tuple[float, float] | None:
    """Values against 0: Hotelling's T squared and its p; None with fewer people than values.

    freedom: of the covariance; infinite makes it Wald's chi-squared.
    """
    size = np.sqrt(np.maximum(np.diag(covariance), 1e-300))
    off, covariance = off / size, covariance / np.outer(size, size)  # units cost no digits
    df = len(off)
    left = freedom - df + 1
    if left < 1 or np.linalg.matrix_rank(covariance, hermitian=True) < df:
        return None
    statistic = float(off @ np.linalg.solve(covariance, off))
    if np.isinf(freedom):
        return statistic, float(chi2.sf(statistic, df))
    return statistic, float(f.sf(statistic * left / (freedom * df), df, left))


def firm_spread_over(found: dict[str, Estimate], same_people: bool) -> Array:
    """The same as `spread_over`, made fit to be inverted where people are few.

    What few people tell of a covariance between many stimuli is too poor to be inverted. It is
    drawn towards that of independent answers, times how much larger people make variances in all,
    by the share stimuli / people: for 7 stimuli and 100 people 7 %, wholly from as many stimuli as
    people on **(ours**, after Ledoit and Wolf 2004).
    """
    from scipy.linalg import block_diag

    drawn, shares = [], []
    for one in found.values():
        alone = one.fit.covariance("expected")
        drawn.append(alone * np.trace(one.covariance) / np.trace(alone))
        shares.append(len(one.fit.scale) / len(one.people) if one.people else 0.0)
    share = min(1.0, max(shares))
    return np.asarray((1 - share) * spread_over(found, same_people) + share * block_diag(*drawn))


def spread_over(found: dict[str, Estimate], same_people: bool) -> Array:
    """Joint covariance of all groups' scales, one below the other, [group x stimulus] squared.

    Groups of different people are independent; where the same people are in several groups, what
    moved one scale also moved the others.
    """
    from scipy.linalg import block_diag

    if not same_people:
        apart: Array = block_diag(*(one.covariance for one in found.values()))
        return apart
    names = sorted({label for one in found.values() for label in one.people})
    row = {label: k for k, label in enumerate(names)}
    stacked = np.zeros((len(names), 0))
    for one in found.values():
        part = np.zeros((len(names), len(one.fit.scale)))
        if one.influence is not None:
            part[[row[label] for label in one.people]] = one.influence
        stacked = np.hstack([stacked, part])
    return stacked.T @ stacked


def shared_people(found: dict[str, Estimate], same_people: bool | None) -> bool:
    """Whether people are in several groups; refuses to guess where labels leave it open."""
    seen: dict[str, str] = {}
    known = all(one.people for one in found.values())
    for name, one in found.items():
        for label in one.people:
            if label in seen and same_people is None and known:
                raise InputError(
                    f"person {quoted(label)} is in the groups {quoted(seen[label])} and "
                    f"{quoted(name)}; say same_people=True (one person in both) or "
                    "same_people=False (two people of one name)"
                )
            seen[label] = name
    if same_people and not known:
        raise InputError("same_people is True; allowed where every group names its people")
    return bool(same_people)

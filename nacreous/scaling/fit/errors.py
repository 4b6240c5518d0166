"""The errors of a fitted scale: a covariance, and of how many degrees of freedom it is known."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.fault import listed, quoted
from nacreous.scaling.fit import clustering, judges, row_means, uncertainty
from nacreous.scaling.fit.clustering import Clusters
from nacreous.scaling.fit.existence import parts, require_joined
from nacreous.scaling.fit.jackknife import LeftOut, left_out
from nacreous.scaling.fit.unit import factor
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.scaling.fit.scale import Scale

__all__ = [
    "KINDS",
    "Errors",
    "chosen_kind",
    "clusters_of",
    "endless",
    "errors_of",
    "kind_of",
    "parameter_covariance",
    "require_difference",
    "require_ends",
]

Array = NDArray[np.float64]

KINDS = ("expected", "observed", "people")
#: A variance over people below this share of the expected one is none at all.
_NOTHING = 1e-12


@value_class
class Errors:
    """Of the values of a scale, in its unit.

    covariance  float64 [stimulus, stimulus], mean held at 0
    clusters    the people that it comes from, or None
    values      float64 [stimulus, parameter]: from parameters to values
    """

    covariance: Array
    clusters: Clusters | LeftOut | None
    values: Array

    def freedom(self, contrasts: Array) -> Array:
        """Degrees of freedom of contrasts of values [k, stimulus]; infinite without people."""
        if self.clusters is None:
            return np.full(len(contrasts), np.inf)
        return self.clusters.freedom(contrasts @ self.values)


def kind_of(fit: Scale, kind: str | None) -> str:
    """What errors are asked for: by default over people where a fit knows them."""
    known = fit.answers is not None and fit.answers.person is not None
    return chosen_kind(kind, "people" if known else "expected")


def chosen_kind(kind: str | None, default: str) -> str:
    """The kind that a caller named, or the default, or one clear message."""
    if kind is None:
        return default
    if kind not in KINDS:
        raise InputError(f"kind is {said(kind)}; allowed: {', '.join(KINDS)}")
    return kind


def errors_of(fit: Scale, kind: str | None) -> Errors:
    """Errors of a kind, None being the default."""
    chosen = kind_of(fit, kind)
    if fit.method == "least-squares":
        return _of_least_squares(fit, chosen)
    values = _values(fit)
    if chosen != "people":
        return Errors(_brought(fit, parameter_covariance(fit, chosen), values), None, values)
    if fit.design is None:
        require_joined(fit.comparisons)
    found = clusters_of(fit)
    covariance = _brought(fit, found.covariance + _beside_people(fit), values)
    # What a prior adds beside people would hide that they tell nothing.
    among = _brought(fit, found.covariance, values)
    alone = _brought(fit, _inverse(fit, expected=True), values)
    require_difference(fit.stimuli, among, alone)
    require_ends(fit)
    return Errors(covariance, found, values)


def parameter_covariance(fit: Scale, kind: str | None) -> Array:
    """Covariance of the parameters in the model's own unit: coefficients, side, ties."""
    chosen = kind_of(fit, kind)
    if fit.method == "least-squares":
        return _of_least_squares(fit, chosen).covariance * factor(fit.unit, "z") ** 2
    if chosen == "people":
        require_ends(fit)
        return np.asarray(clusters_of(fit).covariance + _beside_people(fit))
    within = _inverse(fit, chosen == "expected")
    return within if fit.posterior is None else within + fit.posterior.between


def _of_least_squares(fit: Scale, kind: str) -> Errors:
    """To first order, or over people by leaving each of them out."""
    own, values = fit.scale * factor(fit.unit, "z"), np.eye(len(fit.scale))
    times = factor("z", fit.unit) ** 2
    if kind != "people":
        return Errors(row_means.covariance(fit.comparisons, own, kind) * times, None, values)
    found = left_out(fit.answers)
    alone = row_means.covariance(fit.comparisons, own, "expected")
    require_difference(fit.stimuli, found.covariance, alone)
    require_ends(fit)
    return Errors(found.covariance * times, found, values)


def endless(fit: Scale) -> tuple[tuple[str, ...], ...]:
    """Sets of stimuli between which the answers put no end to the distance, the highest first.

    () where they put one to all, and for fits that nothing draws together, which then do not exist.
    Least squares does so by taking shares of 0 and 1 for others.
    """
    drawn_together = fit.prior is not None or fit.method != "maximum-likelihood"
    if fit.design is not None or not drawn_together:
        return ()
    sets = parts(fit.comparisons)
    return tuple(reversed(sets)) if len(sets) > 1 else ()


def require_ends(fit: Scale) -> None:
    """Refuse errors over people where all of them place a stimulus beyond others.

    That they agree says that it is far away; people who agree hardly move a scale that a prior or
    reduced bias holds, and errors from how they move it would make its guess a finding.
    """
    sets = endless(fit)
    if sets:
        named = " | ".join(listed(one) for one in sets[:4])
        raise InputError(
            f"all answers between {named} agree, so that how much farther apart these are cannot "
            f"be told; allowed: people who differ there, or {judges.INSTEAD}"
        )


def clusters_of(fit: Scale) -> Clusters:
    """The people behind a fit by the likelihood, three or more for each stimulus."""
    answers = judges.require_people(fit.answers)
    like = (
        fit.model,
        fit.tie_threshold is not None and bool(fit.comparisons.ties.any()),
        fit.order_effect is not None,
        fit.design,
    )
    inverses = (_inverse(fit, expected=False), _inverse(fit, expected=True))
    return clustering.clusters(fit.room, answers, fit.parameters, inverses, like)


def _beside_people(fit: Scale) -> Array:
    """What a prior over the spread leaves unknown whatever people answer, of the parameters.

    If people were independent answers, the sum with theirs were the posterior's covariance: of that
    their information I takes the part V I V, for V within a spread.
    """
    if fit.posterior is None:
        return np.zeros((len(fit.parameters),) * 2)
    within = fit.posterior.expected
    told = fit.room.information(fit.parameters, True)
    return np.asarray(within - within @ told @ within + fit.posterior.between)


def _inverse(fit: Scale, expected: bool) -> Array:
    if fit.posterior is not None:
        return fit.posterior.expected if expected else fit.posterior.observed
    floats = fit.design is None and fit.prior is None
    information = fit.room.information(fit.parameters, expected)
    return uncertainty.inverse(information, len(fit.stimuli) if floats else 0)


def _values(fit: Scale) -> Array:
    """From parameters to values with mean 0."""
    count = len(fit.stimuli)
    table = np.eye(count) if fit.design is None else fit.design
    found = np.zeros((count, len(fit.parameters)))
    found[:, : table.shape[1]] = table - table.mean(axis=0)
    return found


def _brought(fit: Scale, covariance: Array, values: Array) -> Array:
    """The covariance of parameters as that of values, in the scale's unit."""
    if fit.design is None:
        count = len(fit.stimuli)
        table = uncertainty.centred(covariance[:count, :count])
    else:
        table = values @ covariance @ values.T
    return np.asarray(table * factor(fit.own_unit, fit.unit) ** 2)


def require_difference(
    stimuli: tuple[str, ...],
    over_people: Array,
    expected: Array,
    instead: str = judges.INSTEAD,
) -> None:
    """Refuse people who all answered so alike that nothing tells how people differ.

    over_people, expected: covariances of the stimuli's values with their mean held at 0.
    """
    own, alone = (
        np.add.outer(np.diag(table), np.diag(table)) - 2 * table
        for table in (over_people, expected)
    )
    alike = (own <= _NOTHING * alone) & (alone > _NOTHING * alone.max())
    alike |= np.diag(np.diag(over_people) <= _NOTHING * np.diag(expected))
    if alike.any():
        about = dict.fromkeys(quoted(stimuli[int(at)]) for at in np.argwhere(alike)[0])
        raise InputError(
            f"all people answered alike about {' and '.join(about)}, so that it is not known how "
            f"people differ; allowed: people who differ, or {instead}"
        )

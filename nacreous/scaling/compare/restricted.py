"""Groups fitted together, some parameters alike in all of them and the others each group's own.

The hypothesis that groups share one scale says nothing of how readily they call two things equal,
nor of how the side draws them. So each hypothesis restricts one kind of parameters, and leaves the
others free in every group.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nacreous._core import PairModel
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.given import comparisons_of
from nacreous.scaling.fit.clustering import personal
from nacreous.scaling.fit.existence import pair_model
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.uncertainty import inverse

__all__ = ["Restricted", "Restriction", "restricted"]

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Restriction = Literal["places", "ties", "side"]

#: Of a step of Fisher scoring: twice what a further one would gain; the most steps; halvings.
_GAIN, _MOST_STEPS, _MOST_HALVINGS = 1e-10, 200, 40
#: By which leads and widths are moved to take slopes.
_SMALL = 1e-5


@dataclass(frozen=True, eq=False)
class _Part:
    """A group at some parameters: which of them all groups share, and which are its own."""

    comparisons: Comparisons
    room: PairModel
    parameters: Array
    shared: Index
    own: Index
    link: str
    with_side: bool
    with_ties: bool

    @property
    def log_likelihood(self) -> float:
        return self.room.log_likelihood(self.parameters)

    @property
    def stimuli(self) -> int:
        return len(self.comparisons.stimuli)

    def information(self) -> Array:
        """Expected, made such that it has an inverse: no slope points along a shift of all."""
        found = np.array(self.room.information(self.parameters, True))
        count = self.stimuli
        found[:count, :count] += np.diagonal(found)[:count].mean() / count
        return found

    def slopes(self) -> Array:
        """Of the log-likelihood, by central differences of each row's chances."""
        counts, count = self.comparisons, self.stimuli
        lead = self.parameters[counts.left] - self.parameters[counts.right]
        lead += self.parameters[count] if self.with_side else 0.0
        width = float(self.parameters[-1]) if self.with_ties else 0.0
        by_lead = (self._rows(lead + _SMALL, width) - self._rows(lead - _SMALL, width)) / 2 / _SMALL
        found = np.bincount(counts.left, by_lead, count) - np.bincount(counts.right, by_lead, count)
        found = np.append(found, [by_lead.sum()] if self.with_side else [])
        if self.with_ties:
            near = (width * (1 - _SMALL), width * (1 + _SMALL)) if width else (-_SMALL, _SMALL)
            less, more = (self._rows(lead, each).sum() for each in near)
            found = np.append(found, (more - less) / (near[1] - near[0]))
        return np.asarray(found, np.float64)

    def _rows(self, lead: Array, width: float) -> Array:
        """Log-likelihood of each row of the counts."""
        counts = self.comparisons
        log = np.log(np.maximum(self.room.probabilities(lead, width), 1e-300))
        return np.asarray(
            counts.left_wins * log[:, 0] + counts.right_wins * log[:, 1] + counts.ties * log[:, 2]
        )

    def followed(self, information: Array) -> Array:
        """By how much its own parameters follow the shared ones, [own, shared]."""
        own, shared = self.own, self.shared
        found = np.linalg.solve(information[np.ix_(own, own)], information[np.ix_(own, shared)])
        return np.asarray(found, np.float64)


@dataclass(frozen=True, eq=False)
class Restricted:
    """The most likely parameters under a restriction.

    `restriction`: what all groups share: "places" of the stimuli, "ties" (how wide they are) or
    "side" (its pull); `covariance`: float64 [shared, shared], of the shared parameters by expected
    information, whatever the groups' own ones are; `free`: how many numbers are shared.
    """

    restriction: Restriction
    parts: Mapping[str, _Part]
    log_likelihood: float
    covariance: Array
    free: int

    def slopes(self, name: str, answers: Answers) -> Array:
        """Efficient slopes of each person's answers by the shared parameters, [person, shared].

        From those by the shared parameters is taken what the group's own ones explain, so that who
        ties readily, or has a pull to a side, is not taken for having another scale.
        """
        part = self.parts[name]
        found = np.asarray(part.room.scores(personal(answers), part.parameters))
        return np.asarray(
            found[:, part.shared] - found[:, part.own] @ part.followed(part.information())
        )


def restricted(groups: Mapping[str, Any], pooled: Scale, restriction: Restriction) -> Restricted:
    """Fit groups that share what `restriction` names, from the fit of all answers together.

    Fisher scoring, the groups' own parameters eliminated (Schur). Raises `InputError` where the
    likelihood has no maximum.
    """
    parts = [_part(data, pooled, restriction) for data in groups.values()]
    for _ in range(_MOST_STEPS):
        steps, gain = _steps(parts)
        if gain < _GAIN:
            floating = len(pooled.stimuli) if restriction == "places" else 0
            total = sum(_efficient(part) for part in parts)
            return Restricted(
                restriction,
                dict(zip(groups, parts, strict=True)),
                sum(part.log_likelihood for part in parts),
                inverse(np.asarray(total), floating),
                floating - 1 if floating else 1,
            )
        parts = _moved(parts, steps)
    raise InputError(
        "groups that share one scale, each with ties and a side of its own, have no most likely "
        "one; allowed: more answers"
    )


def _part(data: Any, pooled: Scale, restriction: Restriction) -> _Part:
    comparisons = comparisons_of(data)
    with_side = pooled.order_effect is not None
    width = bool(pooled.tie_threshold)
    # Without a tie the most likely width of a group's own is 0, and no parameter.
    with_ties = width and (restriction == "ties" or bool(comparisons.ties.any()))
    count = len(pooled.stimuli)
    parameters = pooled.parameters if with_ties else pooled.parameters[: count + with_side]
    all_ = np.arange(len(parameters))
    kinds = {"places": all_[:count], "side": all_[count : count + with_side]}
    kinds["ties"] = all_[count + with_side :]
    shared = kinds[restriction]
    return _Part(
        comparisons,
        pair_model(comparisons, pooled.model, with_ties, with_side),
        parameters,
        shared,
        np.setdiff1d(all_, shared),
        pooled.model,
        with_side,
        with_ties,
    )


def _efficient(part: _Part) -> Array:
    """Information of the shared parameters, the shift of all places taken out again."""
    found = np.array(part.room.information(part.parameters, True))
    shared, own = part.shared, part.own
    across = found[np.ix_(shared, own)]
    return np.asarray(found[np.ix_(shared, shared)] - across @ part.followed(part.information()))


def _steps(parts: list[_Part]) -> tuple[list[Array], float]:
    """A step for each group, and by how much the log-likelihood should rise, twice."""
    size = len(parts[0].shared)
    total, slope = np.zeros((size, size)), np.zeros(size)
    told = []
    for part in parts:
        information, slopes = part.information(), part.slopes()
        followed = part.followed(information)
        across = information[np.ix_(part.shared, part.own)]
        total += information[np.ix_(part.shared, part.shared)] - across @ followed
        slope += slopes[part.shared] - followed.T @ slopes[part.own]
        alone = np.linalg.solve(information[np.ix_(part.own, part.own)], slopes[part.own])
        told.append((slopes, followed, alone))
    common = np.linalg.solve(total, slope)
    steps, gain = [], 0.0
    for part, (slopes, followed, alone) in zip(parts, told, strict=True):
        step = np.zeros(len(part.parameters))
        step[part.shared], step[part.own] = common, alone - followed @ common
        steps.append(step)
        gain += float(slopes @ step)
    return steps, gain


def _moved(parts: list[_Part], steps: list[Array]) -> list[_Part]:
    """The parts a step on, or so much of it that the answers become likelier."""
    before = sum(part.log_likelihood for part in parts)
    share = 1.0
    for _ in range(_MOST_HALVINGS):
        moved = [
            replace(part, parameters=part.parameters + share * step)
            for part, step in zip(parts, steps, strict=True)
        ]
        if all(map(_possible, moved)) and sum(part.log_likelihood for part in moved) >= before:
            return moved
        share /= 2
    return parts


def _possible(part: _Part) -> bool:
    """Whether ties have a chance: a threshold in z has to be above 0; ln(nu) may be any number."""
    return not part.with_ties or part.link == "logit" or bool(part.parameters[-1] > 0)

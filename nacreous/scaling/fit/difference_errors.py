"""How sure a difference scale is: by information, over people, and by drawing anew."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said, seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.quadruples import Quadruples
from nacreous.scaling.fit import difference_model as model_of
from nacreous.scaling.fit.blocks import numbered
from nacreous.scaling.fit.bootstrap import Bootstrap, Progress, require_drawable
from nacreous.scaling.fit.clustering import (
    Clusters,
    corrected_clusters,
    judges_among,
    require_judges,
)
from nacreous.scaling.fit.errors import KINDS, Errors, require_difference
from nacreous.scaling.fit.uncertainty import centred, inverse

if TYPE_CHECKING:
    from nacreous.scaling.fit.difference import DifferenceScale

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_INSTEAD = 'kind="expected", which takes judgements as independent'


def kind_of(data: Quadruples, kind: str | None) -> str:
    """What errors are asked for: by default over people where they are known."""
    if kind is None:
        return "people" if data.person is not None else "expected"
    if kind not in KINDS:
        raise InputError(f"kind is {said(kind)}; allowed: {', '.join(KINDS)}")
    return kind


def errors_of(fit: DifferenceScale, kind: str | None) -> Errors:
    """Errors of the values, the first of which is 0 and known."""
    chosen = kind_of(fit.quadruples, kind)
    values = np.vstack((np.zeros(len(fit.scale) - 1), np.eye(len(fit.scale) - 1)))
    both = {name: inverse(information(fit, name)) for name in ("observed", "expected")}
    if chosen != "people":
        return Errors(values @ both[chosen] @ values.T, None, values)
    found = _clusters(fit, both["observed"], both["expected"])
    over_people = values @ found.covariance @ values.T
    expected = values @ both["expected"] @ values.T
    require_difference(fit.stimuli, centred(over_people), centred(expected))
    return Errors(over_people, found, values)


def information(fit: DifferenceScale, kind: str) -> Array:
    """float64 [parameter, parameter]: "observed" or "expected"."""
    asked = fit.questions
    design, counts, lead = asked.design[:, 1:], asked.counts(), asked.design @ fit.scale
    if kind == "observed":
        weight = model_of.observed(lead, counts, fit.model)
    else:
        weight = counts.sum(axis=1) * model_of.expected_bend(lead, fit.model)
    return np.asarray((design.T * weight) @ design)


def _clusters(fit: DifferenceScale, observed: Array, expected: Array) -> Clusters:
    """Each person's pull on the parameters, and what their questions tell."""
    data, asked = fit.quadruples, fit.questions
    people, person = _people(data, _INSTEAD)
    require_judges(fit.stimuli, people, judges_among(len(fit.stimuli), person, [*data.shown.T]))
    design = asked.design[:, 1:]
    lead = asked.design @ fit.scale
    one = np.where(
        asked.upper,
        model_of.slope(lead, fit.model)[asked.question],
        -model_of.slope(-lead, fit.model)[asked.question],
    )
    told = model_of.expected_bend(lead, fit.model)
    size = design.shape[1]
    scores, seen = np.zeros((people, size)), np.zeros((people, size, size))
    np.add.at(scores, person, one[:, None] * design[asked.question])
    for at in range(people):
        times = np.bincount(asked.question[person == at], minlength=len(design))
        seen[at] = (design.T * (times * told)) @ design
    return corrected_clusters(scores, seen, (observed, expected))


def _people(data: Quadruples, instead: str) -> tuple[int, Index]:
    """How many people judged, and int64 [judgement], which of them."""
    if data.person is None:
        raise InputError(
            f"it is not known who judged; allowed: judgements with people, or {instead}"
        )
    here, person = numbered(data.person, len(data.people))
    return len(here), person


def resampled(
    fit: DifferenceScale, samples: int, by: str | None, seed: int, progress: Progress | None
) -> Bootstrap:
    """Scales of people, or of judgements, drawn anew; see `DifferenceScale.bootstrap`."""
    samples, seed = whole_of("samples", samples, 2, 1_000_000), seed_of(seed)
    if samples * len(fit.scale) > 1 << 27:
        most = (1 << 27) // len(fit.scale)
        raise InputError(f"samples is {samples}; allowed for so many stimuli: 2 to {most}")
    known = fit.quadruples.person is not None
    chosen = by if by is not None else ("people" if known else "answers")
    if chosen not in ("people", "answers"):
        raise InputError(f"by is {said(by)}; allowed: people, answers")
    asked, over_people = fit.questions, chosen == "people"
    table, design = _drawable(fit, asked, over_people), asked.design[:, 1:]
    draws, rest = np.random.default_rng(seed), 0
    found = np.zeros((samples, len(fit.scale)))
    total = len(table) if over_people else int(table.sum())
    chances = np.full(len(table), 1 / len(table)) if over_people else table / total
    for at in range(samples):
        times = draws.multinomial(total, chances)
        counts = times @ table if over_people else times.astype(np.float64)
        values, ended = sample_scale(fit, design, counts.reshape(-1, 2))
        found[at, 1:], rest = values, rest + (not ended)
        if progress is not None and at % 20 == 0:
            progress((at + 1) / samples)
    return Bootstrap(
        stimuli=fit.stimuli,
        unit=fit.unit,
        by="people" if over_people else "answers",
        scale=fit.scale,
        samples=found,
        without_maximum=rest,
    )


def sample_scale(fit: DifferenceScale, design: Array, counts: Array) -> tuple[Array, bool]:
    """The parameters of other counts of the same questions, and whether they have an end.

    design: float64 [question, parameter].
    Where they have none, a normal prior about the fit, 3 wider than the whole scale, holds them.
    """
    start = fit.scale[1:]
    found = model_of.maximum(design, counts, fit.model, start)
    if found is not None:
        return found, True
    spread = float(np.ptp(fit.scale)) + 3.0
    return model_of.held_maximum(design, counts, fit.model, start, spread), False


def _drawable(fit: DifferenceScale, asked: model_of.Questions, over_people: bool) -> Array:
    """Counts [person, 2 question], of each person; or [2 question] of all together."""
    if not over_people:
        return asked.counts().ravel()
    data = fit.quadruples
    people, person = _people(data, 'by="answers"')
    require_drawable(fit.stimuli, people, judges_among(len(fit.stimuli), person, [*data.shown.T]))
    cell = 2 * asked.question + np.where(asked.upper, 0, 1)
    size = 2 * len(asked.design)
    table = np.bincount(person * size + cell, minlength=people * size).reshape(people, size)
    return table.astype(np.float64)

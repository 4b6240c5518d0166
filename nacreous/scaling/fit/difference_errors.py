"""How sure a difference scale is: by information, over people, and by drawing anew."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of
from nacreous.problem import InputError
from nacreous.scaling.data.quadruples import Quadruples
from nacreous.scaling.fit import clustering
from nacreous.scaling.fit import difference_model as model_of
from nacreous.scaling.fit.blocks import numbered
from nacreous.scaling.fit.bootstrap import (
    Bootstrap,
    Progress,
    drawn_by,
    samples_of,
)
from nacreous.scaling.fit.clustering import Clusters
from nacreous.scaling.fit.errors import Errors, chosen_kind, require_difference
from nacreous.scaling.fit.judges import judges_among, require_judges, require_many
from nacreous.scaling.fit.uncertainty import centred, inverse

if TYPE_CHECKING:
    from nacreous.scaling.fit.difference import DifferenceScale

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_INSTEAD = 'kind="expected", which takes judgements as independent'


def errors_of(fit: DifferenceScale, kind: str | None) -> Errors:
    """Errors of the values, the first of which is 0 and known."""
    chosen = chosen_kind(kind, "expected" if fit.quadruples.person is None else "people")
    values = np.vstack((np.zeros(len(fit.scale) - 1), np.eye(len(fit.scale) - 1)))
    both = {name: inverse(information(fit, name)) for name in ("observed", "expected")}
    if chosen != "people":
        return Errors(values @ both[chosen] @ values.T, None, values)
    found = _clusters(fit, both["observed"], both["expected"])
    over_people = values @ found.covariance @ values.T
    expected = values @ both["expected"] @ values.T
    require_difference(fit.stimuli, centred(over_people), centred(expected), _INSTEAD)
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
    from scipy.sparse import csr_array

    data, asked = fit.quadruples, fit.questions
    people, person = _people(data, _INSTEAD)
    require_judges(fit.stimuli, _judges(data, person), people, _INSTEAD)
    design, lead = asked.design[:, 1:], asked.design @ fit.scale
    one = np.where(
        asked.upper,
        model_of.slope(lead, fit.model)[asked.question],
        -model_of.slope(-lead, fit.model)[asked.question],
    )
    cells, shape = (person, asked.question), (people, len(design))
    scores = csr_array((one, cells), shape=shape) @ design
    degrees = clustering.common_degrees(*cells, people, design.shape[1])
    if degrees is not None:
        return clustering.of_scores(scores, (observed, expected), degrees, None, _INSTEAD)
    told = model_of.expected_bend(lead, fit.model)
    times = csr_array((np.ones(len(person)), cells), shape=shape)
    seen = np.stack(
        [(design.T * (times[[at]].toarray()[0] * told)) @ design for at in range(people)]
    )
    return clustering.of_scores(scores, (observed, expected), None, seen, _INSTEAD)


def _judges(data: Quadruples, person: Index) -> Index:
    """How many people judged each stimulus, int64 [stimulus]."""
    return judges_among(len(data.stimuli), person, [*data.shown.T])


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
    samples, seed = samples_of(samples, len(fit.scale)), seed_of(seed)
    chosen = drawn_by(by, fit.quadruples.person is not None)
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
        if progress is not None:
            progress((at + 1) / samples)
    return Bootstrap(
        stimuli=fit.stimuli,
        unit=fit.unit,
        by=chosen,
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
    require_many(fit.stimuli, _judges(data, person), people)
    cell = 2 * asked.question + np.where(asked.upper, 0, 1)
    size = 2 * len(asked.design)
    table = np.bincount(person * size + cell, minlength=people * size).reshape(people, size)
    return table.astype(np.float64)

"""Which attributes carry the scale: coefficients inside the likelihood of the answers themselves.

The value of a stimulus is a sum over terms of coefficient times attribute, and the coefficients are
fitted to the answers, not to a scale fitted before: every answer counts with its own weight (as in
Springall 1973 and Turner and Firth 2012).

How well attributes explain the scale is asked in two ways: may the free scale be such a sum, up to
the noise of the answers (misfit), and which share of its variance the sum has (explained)?
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import within
from nacreous.problem import InputError
from nacreous.scaling.compare.attribute_errors import weight_errors
from nacreous.scaling.compare.attribute_line import Line, Prediction
from nacreous.scaling.compare.attribute_table import AttributeTable, check_columns
from nacreous.scaling.compare.estimate import Estimate, estimate, fit_of, hotelling
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.given import answers_or_counts, comparisons_of
from nacreous.scaling.distribution import chi2, t
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.unit import check_model
from nacreous.value import value_class

__all__ = ["AttributeFit", "AttributeTest", "AttributeWeight", "Prediction", "fit_attributes"]

Array = NDArray[np.float64]

#: Spread of a prior, in the model's own unit, that places what the answers alone do not.
_WEAK = 2.0

#: Stimuli less terms less 1 up to which null weights are called significant too often: 0.076 of
#: 2200 with 8 or 9 stimuli and 4 or 6 terms (docs/scaling.md).
_FEW_LEFT = 3


@value_class
class AttributeWeight:
    """By how much the scale rises with a term, with its own interval and p.

    They hold for other people and other stimuli like these: people and stimuli are crossed random
    effects (`attribute_errors`). With as many terms as stimuli they hold for these stimuli alone.
    """

    term: str
    value: float
    se: float
    low: float
    high: float
    p_value: float


@value_class
class AttributeTest:
    """A test of a smaller model against a larger one.

    name: "likelihood-ratio", which trusts every answer to stand alone; "robust-wald", over people;
    "crossed-wald", over people and stimuli.
    """

    name: str
    statistic: float
    df: int
    p_value: float


@value_class
class AttributeFit:
    """A scale made of attributes, as `fit_attributes` fitted it.

    fit        the scale on the attributes' line; free: the scale of each stimulus by itself, None
               where the answers alone give none
    weights    one a term, in units of the scale per unit of the term
    misfit     whether the free scale is such a sum up to noise; None without a free scale or where
               as many terms as stimuli leave nothing to test. Small p: it is not.
    explained  share of the free scale's variance that the line has (squared correlation)
    aic, bic   -2 log-likelihood + 2 k, + k ln(answers), k all that was fitted; smaller is better
    clustered  whether people were known, and errors take them as clusters
    line       how columns were made of attributes, and what was fitted, for `predict`
    """

    terms: tuple[str, ...]
    weights: tuple[AttributeWeight, ...]
    fit: Scale
    free: Scale | None
    misfit: AttributeTest | None
    explained: float | None
    aic: float
    bic: float
    level: float
    clustered: bool
    line: Line = field(repr=False)

    @property
    def unexplained(self) -> float | None:
        """Standard deviation of stimuli off the line, in the model's own unit.

        Without the noise of the answers; part of the weights' errors. None with as many terms as
        stimuli.
        """
        return self.line.unexplained

    @property
    def caution(self) -> str | None:
        """What to keep in mind of the weights' p values, where stimuli are few; else None.

        >>> from nacreous.scaling import simulate
        >>> values = {str(k): {"lustre": k / 3, "grain": k % 3 - 1.0} for k in range(6)}
        >>> answers = simulate({label: row["lustre"] for label, row in values.items()})
        >>> fit_attributes(answers, values).caution
        '6 stimuli and 2 terms: up to 8 of 100 null weights have p < .05'
        """
        stimuli, terms = len(self.fit.stimuli), len(self.terms)
        if not self.clustered or not 0 < stimuli - terms - 1 <= _FEW_LEFT:
            return None
        return f"{stimuli} stimuli and {terms} terms: up to 8 of 100 null weights have p < .05"

    def against(self, smaller: AttributeFit) -> AttributeTest:
        """Whether this model says more than one with some of its terms, for the same answers.

        "crossed-wald", over people (where known) and stimuli. With as many terms as stimuli, which
        leaves nothing known of other stimuli, "robust-wald" or "likelihood-ratio".

        >>> from nacreous.scaling import simulate
        >>> lustre = {str(k): {"lustre": k / 3, "grain": k % 3 - 1.0} for k in range(8)}
        >>> answers = simulate({label: row["lustre"] for label, row in lustre.items()})
        >>> both = fit_attributes(answers, lustre)
        >>> both.against(fit_attributes(answers, lustre, ["lustre"])).name
        'crossed-wald'
        """
        return _nested(self, smaller)

    def predict(self, stimulus: Mapping[str, float]) -> Prediction:
        """Where a new stimulus with these attributes would stand, with an interval.

        >>> from nacreous.scaling import simulate
        >>> lustre = {str(k): {"lustre": k / 2} for k in range(6)}
        >>> answers = simulate({label: row["lustre"] for label, row in lustre.items()}, 200)
        >>> found = fit_attributes(answers, lustre).predict({"lustre": 1.75})
        >>> found.low < 1.75 - 1.25 < found.high
        True
        """
        return self.line.predict(stimulus, self.level)


def fit_attributes(
    data: Any,
    attributes: Any,
    terms: Sequence[str] | None = None,
    model: str = "probit",
    *,
    standardise: bool = False,
    ties: bool | None = None,
    order: bool = False,
    level: float = 0.95,
    stimulus: str = "stimulus",
) -> AttributeFit:
    """Explain the scale by attributes of the stimuli, inside the likelihood of the answers.

    attributes   label -> {attribute: number}; or a table with a column `stimulus` of labels, one
                 row a stimulus; or its .csv or .parquet file. May hold more stimuli than judged.
    terms        attributes to use, all by default; "lustre:grain" is the product of two.
    standardise  bring each attribute to mean 0 and standard deviation 1 over the stimuli judged
                 first, so that weights compare and products have less in common with their parts.
    level        of the intervals. Errors take people as clusters where they are known.

    Raises `InputError` for a stimulus without attributes, for a column that is constant or a sum of
    others (by name), and where the answers leave a coefficient without an end.

    >>> from nacreous.scaling import simulate
    >>> table = {"stimulus": ["a", "b", "c", "d"], "lustre": [0.0, 0.5, 1.0, 1.5]}
    >>> found = fit_attributes(simulate({"a": 0, "b": 0.5, "c": 1, "d": 1.5}, 200), table)
    >>> found.weights[0].low < 1 < found.weights[0].high, found.misfit.p_value > 0.05
    (True, True)
    """
    check_model(model)
    within("level", level, 0.5, 0.9999)
    table = AttributeTable.of(attributes, stimulus)
    parts = table.terms_of(terms)
    names = tuple(":".join(part) for part in parts)
    data = answers_or_counts(data)
    comparisons = comparisons_of(data)
    line = Line.through(table, parts, comparisons.stimuli, standardise)
    check_columns(line.columns, names)
    # In steps of each column's spread, so that units do not cost digits.
    fit = fit_of(data, model, ties=ties, order=order, design=line.columns / line.steps)
    free = _free(data, model, ties, order)
    clustered = fit.answers is not None and fit.answers.person is not None
    line = line.fitted(fit, weight_errors(fit), free or _held(data, model, ties, order))
    return AttributeFit(
        terms=names,
        weights=_weights(names, line, level),
        fit=fit,
        free=None if free is None else free.fit,
        misfit=_misfit(line, fit, free),
        explained=_explained(fit, free),
        aic=2 * fit.free_parameters - 2 * fit.log_likelihood,
        bic=fit.free_parameters * float(np.log(comparisons.total)) - 2 * fit.log_likelihood,
        level=level,
        clustered=clustered,
        line=line,
    )


def _free(data: Any, model: str, ties: bool | None, order: bool) -> Estimate | None:
    """The scale of each stimulus by itself, if the answers hold one."""
    try:
        return estimate(data, model, ties=ties, order=order)
    except InputError:
        return None


def _held(data: Any, model: str, ties: bool | None, order: bool) -> Estimate | None:
    """The same, held by a weak prior: how far stimuli are off the line, if rather too far.

    Over people nothing is known of a stimulus about which all agree, so answers stand alone here.
    """
    try:
        fit = fit_of(data, model, ties=ties, order=order, prior=_WEAK)
    except InputError:
        return None
    return Estimate(fit, fit.covariance("expected"), (), None, np.inf)


def _weights(names: tuple[str, ...], line: Line, level: float) -> tuple[AttributeWeight, ...]:
    se = np.sqrt(np.diag(line.crossed))
    reach = t.ppf((1 + level) / 2, line.freedoms) * se
    p_values = 2 * t.sf(np.abs(line.coefficients) / se, line.freedoms)
    rows = zip(names, line.coefficients, se, reach, p_values, strict=True)
    return tuple(
        AttributeWeight(name, float(b), float(s), float(b - r), float(b + r), float(p))
        for name, b, s, r, p in rows
    )


def _misfit(line: Line, fit: Scale, free: Estimate | None) -> AttributeTest | None:
    """The free scale against the line: by likelihood, or by Wald with people as clusters."""
    df = line.rest
    if free is None or df < 1:
        return None
    if not free.people:
        return _ratio(fit.log_likelihood, free.fit.log_likelihood, df)
    space = np.column_stack([np.ones(len(line.columns)), line.unit])
    across = np.linalg.svd(space)[0][
        :, space.shape[1] :
    ]  # contrasts of stimuli that the line lacks
    off = across.T @ free.fit.scale
    return _wald("robust-wald", off, across.T @ free.covariance @ across, free.freedom)


def _nested(larger: AttributeFit, smaller: AttributeFit) -> AttributeTest:
    big, small = ({frozenset(t.split(":")) for t in f.terms} for f in (larger, smaller))
    if not small < big:
        raise InputError(
            f"the smaller model has the terms {listed(smaller.terms)}; "
            f"allowed: some, not all, of {listed(larger.terms)}"
        )
    same = larger.fit.comparisons.total == smaller.fit.comparisons.total
    if not same or larger.fit.model != smaller.fit.model:
        raise InputError("the two models are not of the same answers; allowed: the same")
    extra = [k for k, t in enumerate(larger.terms) if frozenset(t.split(":")) not in small]
    line = larger.line
    if not larger.clustered and line.unexplained is None:
        return _ratio(smaller.fit.log_likelihood, larger.fit.log_likelihood, len(extra))
    freedom = float(line.freedoms[extra].min())
    name = "robust-wald" if line.unexplained is None else "crossed-wald"
    found = _wald(name, line.coefficients[extra], line.crossed[np.ix_(extra, extra)], freedom)
    if found is None:
        raise InputError(
            f"there are {len(extra)} terms to test and {freedom:.1f} degrees of freedom; allowed: "
            "fewer terms, or more people and stimuli"
        )
    return found


def _ratio(small: float, large: float, df: int) -> AttributeTest:
    statistic = max(0.0, 2 * (large - small))
    return AttributeTest("likelihood-ratio", statistic, df, float(chi2.sf(statistic, df)))


def _wald(name: str, off: Array, covariance: Array, freedom: float) -> AttributeTest | None:
    found = hotelling(off, covariance, freedom)
    return None if found is None else AttributeTest(name, found[0], len(off), found[1])


def _explained(fit: Scale, free: Estimate | None) -> float | None:
    if free is None or np.ptp(free.fit.scale) == 0 or np.ptp(fit.scale) == 0:
        return None
    return float(np.corrcoef(fit.scale, free.fit.scale)[0, 1] ** 2)

"""The line on which attributes place stimuli, and where it places new ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.compare.attribute_errors import WeightErrors, satterthwaite
from nacreous.scaling.compare.attribute_table import AttributeTable, products
from nacreous.scaling.compare.estimate import Estimate
from nacreous.scaling.data.fault import listed
from nacreous.scaling.distribution import t
from nacreous.scaling.fit.scale import Scale
from nacreous.value import value_class

__all__ = ["Line", "Prediction"]

Array = NDArray[np.float64]

#: Times the noise's variance over the distances' degrees of freedom: what variance about the line
#: is assumed at the least, so that benchmarks/attributes.py finds null weights in 3 to 7 %.
_LEAST = 2.5


@value_class
class Prediction:
    """Where a new stimulus would stand, in the model's own unit; 0 is the mean of those judged.

    se       of the value on the line of the attributes
    low, high  ends of its interval, with what attributes leave unexplained
    unexplained  standard deviation of stimuli about that line, freed of the noise of the answers;
             None where there are too few stimuli to know it, and the interval leaves it out
    beyond   attributes whose value is outside the range of the stimuli that were judged
    """

    value: float
    se: float
    low: float
    high: float
    unexplained: float | None
    beyond: tuple[str, ...]


@value_class
class Line:
    """The line of the attributes: how columns of terms are made, and what was fitted.

    raw           float64 [stimulus, attribute]; centre, step: taken from it, and divided by
    columns       float64 [stimulus, term]
    coefficients  float64 [term], of `columns`, with their covariance [term, term]
    crossed       their covariance over other people and other stimuli [term, term]
    unexplained   standard deviation of stimuli about the line; None where it cannot be known
    assumed       the same as errors take it: not as small as few stimuli make it look by chance
    freedom       degrees of freedom of the answers' errors; freedoms: of the crossed ones [term]
    """

    table: AttributeTable
    parts: tuple[tuple[str, ...], ...]
    raw: Array  # [stimulus, attribute]
    centre: Array  # [attribute]
    step: Array  # [attribute]
    columns: Array  # [stimulus, term]
    coefficients: Array = field(default_factory=lambda: np.zeros(0))
    covariance: Array = field(default_factory=lambda: np.zeros((0, 0)))
    crossed: Array = field(default_factory=lambda: np.zeros((0, 0)))
    freedoms: Array = field(default_factory=lambda: np.zeros(0))
    unexplained: float | None = None
    assumed: float | None = None
    freedom: float = np.inf

    @classmethod
    def through(
        cls,
        table: AttributeTable,
        parts: tuple[tuple[str, ...], ...],
        stimuli: tuple[str, ...],
        standardise: bool,
    ) -> Line:
        """The columns of the terms for stimuli, not yet fitted."""
        raw = table.rows_of(stimuli)
        centre, step = np.zeros(raw.shape[1]), np.ones(raw.shape[1])
        if standardise:
            centre, spread = raw.mean(axis=0), raw.std(axis=0, ddof=1)
            step = np.where(spread > 0, spread, 1.0)  # constant ones are refused by name later
        columns = products((raw - centre) / step, table.names, parts)
        return cls(table, parts, raw, centre, step, columns)

    @property
    def steps(self) -> Array:
        """Spread of each term's column."""
        return np.asarray(self.columns.std(axis=0))

    def fitted(self, fit: Scale, errors: WeightErrors, free: Estimate | None) -> Line:
        """The same line with what a fit to `columns / steps` says of it.

        free: the scale of each stimulus by itself, None where nothing is known of distances.
        """
        if fit.coefficients is None:
            raise InputError("the fit has no coefficients; allowed: a fit with a design")
        unexplained, assumed = (None, None) if free is None else self._unexplained(free)
        crossed, freedoms = errors.crossed(assumed, self.rest)
        return replace(
            self,
            coefficients=fit.coefficients / self.steps,
            covariance=errors.answers / np.outer(self.steps, self.steps),
            crossed=crossed / np.outer(self.steps, self.steps),
            unexplained=unexplained,
            assumed=assumed,
            freedom=float(errors.freedom.min()),
            freedoms=freedoms,
        )

    @property
    def rest(self) -> int:
        """Stimuli less terms and a mean: how many distances from the line are free."""
        return len(self.columns) - 1 - len(self.parts)

    def _unexplained(self, free: Estimate) -> tuple[float, float] | tuple[None, None]:
        """Standard deviation of the free scale about the line, and what errors take it for.

        The method of moments: the sum of squares about the line is the noise's part, tr(M C), plus
        variance times degrees of freedom (Raudenbush 1994, as in meta-regression).

        Few distances give 0 by chance where the truth is far from it: with 3 of them and an own sd
        as large as the noise in 1 of 7 studies, of which a third then call a null weight certain.
        Errors therefore take the variance to be no less than a share of the noise's **(ours)**.
        """
        if self.rest < 1:
            return None, None
        space = np.linalg.qr(np.column_stack([np.ones(len(self.columns)), self.unit]))[0]
        off = np.eye(len(space)) - space @ space.T
        scale = free.fit.scale
        noise = float(np.trace(off @ free.covariance)) / self.rest
        variance = max(0.0, float(scale @ off @ scale) / self.rest - noise)
        least = _LEAST * noise / self.rest
        return variance**0.5, max(variance, least) ** 0.5

    @property
    def unit(self) -> Array:
        """The columns with mean 0 and spread 1."""
        return np.asarray((self.columns - self.columns.mean(axis=0)) / self.steps)

    def predict(self, stimulus: Mapping[str, float], level: float) -> Prediction:
        """Where a stimulus with these attributes would stand."""
        row = self._row(stimulus)
        standard = ((row - self.centre) / self.step)[np.newaxis]
        away = products(standard, self.table.names, self.parts)[0] - self.columns.mean(axis=0)
        variance = float(away @ self.covariance @ away)
        # A new stimulus is off the line itself, and the others' being off it moves the line.
        leap = away / self.steps
        lever = float(leap @ np.linalg.solve(self.unit.T @ self.unit, leap))
        own = (self.assumed or 0.0) ** 2 * (1 + 1 / len(self.columns) + lever)
        freedom = satterthwaite(np.array([variance]), np.array([own]), self.freedom, self.rest)[0]
        reach = float(t.ppf((1 + level) / 2, freedom)) * (variance + own) ** 0.5
        value = float(away @ self.coefficients)
        return Prediction(
            value=value,
            se=variance**0.5,
            low=value - reach,
            high=value + reach,
            unexplained=self.unexplained,
            beyond=self._beyond(row),
        )

    @property
    def _used(self) -> list[int]:
        """Columns of the attributes that are in a term."""
        names = {name for part in self.parts for name in part}
        return [k for k, name in enumerate(self.table.names) if name in names]

    def _row(self, stimulus: Mapping[str, float]) -> Array:
        """Attributes of a new stimulus, float64 [attribute]; those in no term may be missing."""
        new = AttributeTable.of({"new stimulus": stimulus})
        given = dict(zip(new.names, new.values[0].tolist(), strict=True))
        used = [self.table.names[k] for k in self._used]
        missing = [name for name in used if name not in given]
        if missing:
            raise InputError(f"the new stimulus lacks {listed(missing)}; allowed: {listed(used)}")
        return np.array([given.get(name, 0.0) for name in self.table.names])

    def _beyond(self, row: Array) -> tuple[str, ...]:
        low, high = self.raw.min(axis=0), self.raw.max(axis=0)
        return tuple(self.table.names[k] for k in self._used if not low[k] <= row[k] <= high[k])

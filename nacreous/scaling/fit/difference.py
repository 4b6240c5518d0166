"""Difference scales: places of stimuli by which of two differences people judge to be larger.

L. T. Maloney, J. N. Yang, Maximum likelihood difference scaling, Journal of Vision 3 (2003) 573; as
a generalised linear model K. Knoblauch, L. T. Maloney, MLDS, J. Statistical Software 25 (2008) 2.

What the model takes for granted: the order of the stimuli is that in which the scale runs, each
difference being the later less the earlier one. That the values rise is not asked of them; where a
scale falls, differences there count below 0, which no eye judges so (`falling`). Turn the order
round, and the scale is turned round: which end is more the judgements do not say.
"""

from __future__ import annotations

from dataclasses import field
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.label import place_of
from nacreous.scaling.data.quadruples import Quadruples
from nacreous.scaling.fit import difference_errors, uncertainty
from nacreous.scaling.fit.bootstrap import Bootstrap, Progress
from nacreous.scaling.fit.difference_existence import require_end, require_placed
from nacreous.scaling.fit.difference_model import (
    Questions,
    log_likelihood,
    maximum,
    questions_of,
)
from nacreous.scaling.fit.errors import Errors
from nacreous.scaling.fit.unit import Model, check_model
from nacreous.value import value_class

Array = NDArray[np.float64]


@value_class
class DifferenceScale:
    """A scale of differences, as `difference_scale` fitted it.

    - `stimuli`, `scale`: labels and float64 [n], the first 0; a difference of two differences of 1
      is 1 standard deviation of the judgement's noise ("z", probit) or 1 logit
    - `log_likelihood`: natural logarithm
    - `quadruples`: the judgements behind it

    >>> from nacreous.scaling import difference_scale, simulate_quadruples
    >>> truth = {"1": 0.0, "2": 0.5, "3": 1.5, "4": 3.0, "5": 5.0}
    >>> fit = difference_scale(simulate_quadruples(truth, people=40, seed=2))
    >>> fit
    DifferenceScale(5 stimuli in z, probit, 200 judgements)
    """

    stimuli: tuple[str, ...]
    scale: Array
    unit: Literal["z", "logit"]
    model: Model
    log_likelihood: float
    quadruples: Quadruples = field(repr=False)

    def __repr__(self) -> str:
        """In one line what was fitted."""
        count = f"{len(self.stimuli)} stimuli in {self.unit}"
        return f"DifferenceScale({count}, {self.model}, {len(self.quadruples)} judgements)"

    def __str__(self) -> str:
        """A line for each stimulus, with standard errors where the judgements give them."""
        width = max(map(len, self.stimuli))
        try:
            errors = [f" +- {se:.3f}" for se in self.se]
            last = []
        except InputError as problem:
            errors, last = [""] * len(self.stimuli), [str(problem)]
        lines = [
            f"{label:<{width}}  {value:z6.3f}{error}"
            for label, value, error in zip(self.stimuli, self.scale, errors, strict=True)
        ]
        head = f"difference scale in {self.unit} ({self.model}, {len(self.quadruples)} judgements)"
        return "\n".join((head, *lines, *last))

    @property
    def questions(self) -> Questions:
        """What was asked, each question once."""
        return questions_of(self.quadruples)

    @property
    def falling(self) -> tuple[tuple[str, str], ...]:
        """Neighbours in the order of `stimuli` whose value falls from the first to the second.

        Little of it is noise; much of it says that the order is not that of the scale, and then
        signed differences are not the ones that were judged.
        """
        return tuple(
            (self.stimuli[at], self.stimuli[at + 1])
            for at, (here, there) in enumerate(pairwise(self.scale.tolist()))
            if there < here
        )

    @property
    def normalised(self) -> Array:
        """float64 [n]: the scale from 0 at the first to 1 at the last stimulus.

        Raises `InputError` where the last is not above the first.
        """
        return np.asarray(self.scale / self._length)

    @property
    def noise(self) -> float:
        """Of a judgement, as a share of the scale's length: its standard deviation where probit."""
        return 1 / self._length

    @property
    def se(self) -> Array:
        """float64 [n]: standard errors in `unit`, 0 at the first; as the default `covariance`."""
        return uncertainty.root_of_diagonal(self.covariance())

    def covariance(self, kind: str | None = None) -> Array:
        """float64 [n, n]: covariance of the scale with the first held at 0, in `unit` squared.

        kind: "people", the default where people are known (a sandwich with people as clusters, CR2
        by Bell and McCaffrey 2002), "expected", the default elsewhere, or "observed" information.
        Raises `InputError` where fewer than three people judged a stimulus, and where all judged
        alike.
        """
        return self._errors(kind).covariance

    def intervals(
        self, level: float = 0.95, simultaneous: str | bool = False, kind: str | None = None
    ) -> Array:
        """float64 [n, 2]: an interval for each value, in `unit`; the first is 0 and known.

        Arguments as in `Scale.intervals`; over people by Student's t.
        """
        return uncertainty.intervals(self.scale, self._errors(kind), level, simultaneous)

    def normalised_intervals(self, level: float = 0.95, kind: str | None = None) -> Array:
        """float64 [n, 2]: the same of `normalised`, to first order; both ends are known."""
        turn = (np.eye(len(self.scale)) - np.outer(self.normalised, self._last)) / self._length
        own = self._errors(kind)
        errors = Errors(turn @ own.covariance @ turn.T, own.clusters, turn @ own.values)
        return uncertainty.intervals(self.normalised, errors, level)

    def difference(
        self, first: str, second: str, level: float = 0.95, kind: str | None = None
    ) -> uncertainty.Difference:
        """How far `first` is above `second`, in `unit`; kind as in `covariance`."""
        pairs = [(place_of(first, self.stimuli), place_of(second, self.stimuli))]
        return uncertainty.differences(
            self.stimuli, self.scale, self._errors(kind), self.unit, level, "none", pairs
        )[0]

    def bootstrap(
        self,
        samples: int = 1000,
        by: str | None = None,
        seed: int = 1,
        progress: Progress | None = None,
    ) -> Bootstrap:
        """The scales of judgements drawn again, in `unit`, each with 0 at the first stimulus.

        by: "people", each with all judgements, the default where people are known, or "answers",
        judgement by judgement. samples: 2 to 1 000 000. Same seed, same samples. Intervals are
        "percentile" or "basic". Raises `InputError` where fewer than 8 people judged a stimulus.
        """
        return difference_errors.resampled(self, samples, by, seed, progress)

    @property
    def _last(self) -> Array:
        return np.asarray(np.eye(len(self.scale))[-1])

    @property
    def _length(self) -> float:
        length = float(self.scale[-1])
        if length <= 0:
            raise InputError(
                f"the last stimulus, {quoted(self.stimuli[-1])}, is {length:.3g}; allowed for a "
                "normalised scale: above the first, which is 0; turn the order of stimuli round"
            )
        return length

    def _errors(self, kind: str | None) -> Errors:
        return difference_errors.errors_of(self, kind)


def difference_scale(quadruples: Quadruples, *, model: Model = "probit") -> DifferenceScale:
    """The most likely scale of judged differences (MLDS), the first stimulus 0.

    quadruples: `Quadruples`. model: "probit", normal noise, or "logit". Where people are known,
    they are the unit of errors and of the bootstrap.
    Raises `InputError` naming the stimuli where judgements leave a distance open, or without an
    end.

    >>> from nacreous.scaling import difference_scale, simulate_quadruples
    >>> truth = {"1": 0.0, "2": 0.5, "3": 1.5, "4": 3.0, "5": 5.0}
    >>> fit = difference_scale(simulate_quadruples(truth, people=100, seed=2))
    >>> low, high = fit.intervals()[4]
    >>> bool(low < 5.0 < high)
    True
    """
    if not isinstance(quadruples, Quadruples):
        raise InputError(f"quadruples is {said(quadruples)}; allowed: Quadruples")
    check_model(model)
    asked = questions_of(quadruples)
    counts = asked.counts()
    require_placed(quadruples.stimuli, asked.design)
    require_end(quadruples.stimuli, asked.design, counts)
    found = maximum(asked.design[:, 1:], counts, model)
    if found is None:
        raise InputError(
            "the likelihood is so flat that its maximum was not found; allowed: more judgements"
        )
    values = np.concatenate((np.zeros(1), found))
    return DifferenceScale(
        stimuli=quadruples.stimuli,
        scale=values,
        unit="z" if model == "probit" else "logit",
        model=model,
        log_likelihood=log_likelihood(asked.design @ values, counts, model),
        quadruples=quadruples,
    )

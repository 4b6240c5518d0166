"""A fitted scale: where the stimuli are, in which unit, and how sure that is."""

from __future__ import annotations

from dataclasses import field, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from nacreous._core import PairModel
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.label import place_of
from nacreous.scaling.fit import bootstrap, frame, uncertainty
from nacreous.scaling.fit.bootstrap import Bootstrap, Progress
from nacreous.scaling.fit.errors import errors_of, parameter_covariance
from nacreous.scaling.fit.spread import Prior, SpreadPosterior
from nacreous.scaling.fit.summary import summary
from nacreous.scaling.fit.unit import Unit, factor, unit_of
from nacreous.value import value_class

if TYPE_CHECKING:
    from pandas import DataFrame

    from nacreous.scaling.data.answers import Answers

Array = NDArray[np.float64]


@value_class
class Scale:
    """A scale of stimuli, as `thurstone` or `bradley_terry` fitted it.

    - `stimuli`, `scale`: labels and float64 [n], mean 0, in `unit`
    - `unit`: "z", "d'", "JOD", "JND" or "logit", see `nacreous.scaling.fit.unit`
    - `model`: "probit" or "logit"; `method`: "maximum-likelihood", "bias-reduced" or
      "least-squares"
    - `log_likelihood`: natural logarithm, without constant terms and without the prior
    - `order_effect`: by how much being on the left helps, in `unit`; None where not fitted
    - `tie_threshold`: where not fitted None. Probit: a lead below it is a tie, in `unit`; logit:
      Davidson's nu, how many ties there are for each choice between equals, no unit
    - `prior`: spread of a normal prior on the values in the model's own unit, z or logit; or None;
      or "hierarchical", a prior over that spread, with `posterior`, what was learnt of it
    - `coefficients`: float64 [k], in the model's own unit, where a design matrix was given
    - `comparisons`: the counts; `answers`: the answers behind them where they are known

    >>> from nacreous.scaling import paper, thurstone
    >>> print(thurstone(paper()))
    scale in z (probit, maximum-likelihood, 2184 answers)
    1   0.289 +- 0.047
    2   0.858 +- 0.053
    3   0.320 +- 0.047
    4   0.380 +- 0.047
    5  -0.286 +- 0.047
    6  -0.618 +- 0.050
    7  -0.943 +- 0.055
    """

    stimuli: tuple[str, ...]
    scale: Array
    unit: Unit
    model: Literal["probit", "logit"]
    method: Literal["maximum-likelihood", "bias-reduced", "least-squares"]
    comparisons: Comparisons
    log_likelihood: float
    order_effect: float | None = None
    tie_threshold: float | None = None
    prior: Prior = None
    coefficients: Array | None = None
    design: Array | None = None
    answers: Answers | None = None
    parameters: Array = field(default_factory=lambda: np.zeros(0), repr=False)
    pair_model: PairModel | None = field(default=None, repr=False, compare=False)
    posterior: SpreadPosterior | None = field(default=None, repr=False)

    def __str__(self) -> str:
        """A line for each stimulus, with its unit above and standard errors beside.

        Where people are known a last line says whose errors these are, or why there are none, and
        a first one that people do not share one scale, where `shared_scale` finds so.
        """
        return summary(self)

    def __repr__(self) -> str:
        """In one line what was fitted."""
        return f"Scale({len(self.stimuli)} stimuli in {self.unit}, {self.model}, {self.method})"

    def _repr_html_(self) -> str:
        """The scale as notebooks show it: a table, from the most preferred on."""
        return frame.html_of(self)

    def to_frame(self) -> DataFrame:
        """A pandas DataFrame: by stimulus its value, se, and low and high of its 95 % interval.

        All are in `unit`, which is in `attrs`; se and interval are NaN where the answers give none.
        Raises `InputError` where pandas is not installed.

        >>> from nacreous.scaling import paper, thurstone
        >>> thurstone(paper()).to_frame().loc["2"].round(3).to_dict()
        {'value': 0.858, 'se': 0.053, 'low': 0.754, 'high': 0.962}
        """
        return frame.frame_of(self)

    @property
    def own_unit(self) -> Unit:
        """The unit of the model itself: z for probit, logit for logit."""
        return "z" if self.model == "probit" else "logit"

    def to(self, unit: str) -> Scale:
        """The same scale in another unit.

        >>> from nacreous.scaling import paper, thurstone
        >>> fit = thurstone(paper())
        >>> round(float(fit.to("JOD").scale[0] / fit.scale[0]), 4)
        1.4826
        """
        times = factor(self.unit, unit_of(unit))
        order = None if self.order_effect is None else self.order_effect * times
        ties = self.tie_threshold
        if ties is not None and self.model == "probit":
            ties *= times
        return replace(
            self,
            scale=self.scale * times,
            unit=unit_of(unit),
            order_effect=order,
            tie_threshold=ties,
        )

    # --- what the model says

    @property
    def ranking(self) -> tuple[str, ...]:
        """The labels from the most preferred on.

        >>> from nacreous.scaling import paper, thurstone
        >>> thurstone(paper()).ranking
        ('2', '4', '3', '1', '5', '6', '7')
        """
        return tuple(self.stimuli[index] for index in np.argsort(-self.scale, kind="stable"))

    @property
    def proportions(self) -> Array:
        """float64 [n, n]: how likely i is chosen over j, whatever the side; a tie counts half."""
        own = self.scale * factor(self.unit, self.own_unit)
        leads = (own[:, None] - own[None, :]).ravel()
        table = self.room.probabilities(leads, self._width)
        return (table[:, 0] + 0.5 * table[:, 2]).reshape(len(own), len(own))

    def outcomes(self) -> Array:
        """float64 [row, 3]: how likely left, right and a tie are in each row of `comparisons`."""
        own = self.scale * factor(self.unit, self.own_unit)
        leads = own[self.comparisons.left] - own[self.comparisons.right]
        if self.order_effect is not None:
            leads = leads + self.order_effect * factor(self.unit, self.own_unit)
        return self.room.probabilities(leads, self._width)

    @property
    def free_parameters(self) -> int:
        """How many numbers were fitted: values less one, or coefficients; side; ties."""
        values = len(self.stimuli) - 1 if self.design is None else self.design.shape[1]
        return values + (self.order_effect is not None) + (self.tie_threshold is not None)

    @property
    def se(self) -> Array:
        """float64 [n]: standard errors in `unit`, as the default `covariance` has them."""
        return uncertainty.root_of_diagonal(self.covariance())

    def covariance(self, kind: str | None = None) -> Array:
        """float64 [n, n]: covariance of the scale with mean held at 0, in `unit` squared.

        kind: "people", the default where people are known: the answers of one person may hang
        together and the model be wrong (a sandwich with people as clusters, CR2 by Bell and
        McCaffrey 2002; of least squares by leaving each person out); "expected", the default
        elsewhere, or "observed" information, which trust the model and every answer to stand alone.
        Raises `InputError` where fewer than three people judged a stimulus, and where all answered
        alike: that tells nothing of how people differ.

        >>> from nacreous.scaling import paper, thurstone
        >>> fit = thurstone(paper())
        >>> bool(abs(fit.covariance("observed").sum()) < 1e-15)
        True
        """
        return errors_of(self, kind).covariance

    def parameter_covariance(self, kind: str | None = None) -> Array:
        """Covariance of the parameters in the model's own unit: coefficients, side, ties.

        Without a design matrix the coefficients are the stimuli's values. Ties: the threshold in z,
        or ln nu. kind as in `covariance`.
        """
        return parameter_covariance(self, kind)

    def difference(
        self, first: str, second: str, level: float = 0.95, kind: str | None = None
    ) -> uncertainty.Difference:
        """How far `first` is above `second`, in `unit`; kind as in `covariance`.

        Over people, intervals and p values are those of Student's t with Satterthwaite's degrees of
        freedom: people less one where all answered the same pairs, fewer elsewhere.

        >>> from nacreous.scaling import paper, thurstone
        >>> thurstone(paper()).difference("2", "4")
        Difference(2 - 4: 0.478, 0.331 to 0.625 z)
        """
        pairs = [(place_of(first, self.stimuli), place_of(second, self.stimuli))]
        return uncertainty.differences(
            self.stimuli, self.scale, errors_of(self, kind), self.unit, level, "none", pairs
        )[0]

    def differences(
        self, level: float = 0.95, simultaneous: str = "holm", kind: str | None = None
    ) -> list[uncertainty.Difference]:
        """All n (n - 1) / 2 differences, with intervals and p values that hold for all together.

        simultaneous: "holm" (p values by Holm 1979, intervals by Bonferroni), "bonferroni", "tukey"
        (the largest of all differences, by the multivariate normal or t distribution) or "none".

        >>> from nacreous.scaling import paper, thurstone
        >>> len(thurstone(paper()).differences())
        21
        """
        return uncertainty.differences(
            self.stimuli, self.scale, errors_of(self, kind), self.unit, level, simultaneous
        )

    def neighbours(
        self, level: float = 0.95, simultaneous: str = "holm", kind: str | None = None
    ) -> list[uncertainty.Difference]:
        """The n - 1 differences of each stimulus from the next one down, from the top.

        Intervals and p values hold for all of them together, as in `differences`.

        >>> from nacreous.scaling import paper, thurstone
        >>> thurstone(paper()).neighbours()[0]
        Difference(2 - 4: 0.478, 0.280 to 0.676 z)
        """
        order = np.argsort(-self.scale, kind="stable").tolist()
        pairs = list(pairwise(order))
        return uncertainty.differences(
            self.stimuli, self.scale, errors_of(self, kind), self.unit, level, simultaneous, pairs
        )

    def intervals(
        self, level: float = 0.95, simultaneous: str | bool = False, kind: str | None = None
    ) -> Array:
        """float64 [n, 2]: an interval for each value, in `unit`.

        level: 0.5 to 0.9999. simultaneous: False (each by itself), "bonferroni", "holm" (the same
        intervals: Holm's are p values) or "tukey" (the multivariate normal or t distribution).
        Raises `InputError` for others.

        >>> from nacreous.scaling import paper, thurstone
        >>> thurstone(paper()).intervals().round(2)[0].tolist()
        [0.2, 0.38]
        """
        return uncertainty.intervals(self.scale, errors_of(self, kind), level, simultaneous)

    def bootstrap(
        self,
        samples: int = 1000,
        by: str | None = None,
        seed: int = 1,
        progress: Progress | None = None,
    ) -> Bootstrap:
        """The scales of answers drawn again, in `unit`; on all processors.

        by: "people", each with all answers, the default where people are known, or "answers".
        samples: 2 to 1 000 000. seed: 0 to 2^63 - 1; same seed, same bytes. progress: called
        with the finished share, 0 to 1, now and then. Ctrl-C interrupts.
        Raises `InputError` for what is out of range, for fits that are not of maximum likelihood or
        have a prior over the spread, for people that are not known or fewer than 8 of whom judged a
        stimulus, and for answers of counts that are not whole numbers.

        >>> from nacreous.scaling import paper, thurstone
        >>> fit = thurstone(paper())
        >>> bool(abs(fit.bootstrap(seed=2).se / fit.se - 1).max() < 0.1)
        True
        """
        return bootstrap.resampled(self, samples, by, seed, progress)

    @property
    def room(self) -> PairModel:
        """The compiled model behind the fit."""
        if self.pair_model is None:
            raise InputError("this Scale was not made by a fit; allowed: thurstone, bradley_terry")
        return self.pair_model

    @property
    def _width(self) -> float:
        """Of ties, as the compiled room has it."""
        if self.tie_threshold is None or self.tie_threshold == 0:
            return 0.0
        if self.model == "logit":
            return float(np.log(self.tie_threshold))
        return self.tie_threshold * factor(self.unit, "z")

"""Bootstraps: how the scale moves when people, or answers, are drawn again from those there are.

People are drawn with all their answers, which may hang together, so nothing is assumed about how
(Efron and Tibshirani 1993, 8). Samples whose answers have no finite maximum are not left out, which
would shorten the intervals on the open side: a normal prior about the fit to all answers, 3 z wider
than the whole scale, holds them. How many there were is said, and where they are many, so that
their spread is that of the prior, nothing is told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from nacreous._core import PairModel, PersonalAnswers
from nacreous.number import said, seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.label import place_of
from nacreous.scaling.fit.clustering import personal
from nacreous.scaling.fit.errors import Errors, errors_of, kind_of, require_ends
from nacreous.scaling.fit.existence import require_joined
from nacreous.scaling.fit.judges import DRAWN_INSTEAD, judges_of, require_many, require_people
from nacreous.scaling.fit.uncertainty import control_of, level_of, root_of_diagonal
from nacreous.scaling.fit.unit import factor
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.scaling.data.answers import Answers
    from nacreous.scaling.fit.scale import Scale

Array = NDArray[np.float64]
Progress = Callable[[float], None]

KINDS = ("studentised", "percentile", "basic")
#: A larger share of samples that have no scale of their own, or in which nobody differs, reaches
#: into the ends of 95 % intervals.
_MOST_UNTOLD = 0.02
#: A standard error below this share of that of the fit is none.
_NOTHING = 1e-6
#: Above, standard errors within samples cost more than the samples.
MOST_STUDENTISED = 150


@value_class
class Bootstrap:
    """The scales of samples drawn again from the answers.

    - `samples`: float64 [sample, n], in `unit`: each with mean 0, or of a difference scale with 0
      at the first stimulus
    - `scale`: float64 [n], the fit to all answers
    - `by`: "people" or "answers", what was drawn
    - `without_maximum`: how many samples had no finite scale of their own, see above

    Where more than 2 of 100 samples have none, or are of people who answered alike about a
    stimulus, `tells` is False, and `se`, `covariance`, `intervals` and `difference` raise
    `InputError`.

    - `order_effects`, `tie_thresholds`: float64 [sample], as in `Scale`; None where not fitted

    >>> from nacreous.scaling import paper, thurstone
    >>> fit = thurstone(paper())
    >>> fit.bootstrap(samples=200, seed=3)
    Bootstrap(200 samples by answers, 0 without a maximum, 7 stimuli in z)
    """

    stimuli: tuple[str, ...]
    unit: str
    by: Literal["people", "answers"]
    scale: Array
    samples: Array
    without_maximum: int
    order_effects: Array | None = None
    tie_thresholds: Array | None = None
    scale_se: Array | None = field(default=None, repr=False)
    sample_se: Array | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        """In one line what was drawn, and how many samples had no scale of their own."""
        count = f"{len(self.samples)} samples by {self.by}"
        scales = f"{len(self.stimuli)} stimuli in {self.unit}"
        return f"Bootstrap({count}, {self.without_maximum} without a maximum, {scales})"

    @property
    def tells(self) -> bool:
        """Whether the samples' spread is that of the answers, and hardly that of a prior."""
        alike = int(self._alike.any(axis=1).sum())
        return self.placed and alike <= _MOST_UNTOLD * len(self.samples)

    @property
    def placed(self) -> bool:
        """Whether nearly all samples, 98 of 100, had a scale of their own."""
        return self.without_maximum <= _MOST_UNTOLD * len(self.samples)

    @property
    def se(self) -> Array:
        """float64 [n]: the spread of the samples."""
        self._require_told()
        return np.asarray(self.samples.std(axis=0, ddof=1))

    @property
    def covariance(self) -> Array:
        """float64 [n, n]: how the samples vary together."""
        self._require_told()
        return np.atleast_2d(np.cov(self.samples, rowvar=False))

    def intervals(
        self, level: float = 0.95, kind: str | None = None, simultaneous: bool = False
    ) -> Array:
        """float64 [n, 2]: an interval for each value, in `unit`.

        kind: "studentised" (each sample measured in its own standard errors; where there are no
        more than 150 parameters the default, for it covers best), "percentile" (the middle of the
        samples) or "basic" (the same, mirrored about the fit).
        simultaneous: hold for all values together, by the largest deviation in each sample
        (studentised only).
        Raises `InputError` where the samples tell nothing (`tells`).

        >>> from nacreous.scaling import paper, thurstone
        >>> thurstone(paper()).bootstrap(seed=3).intervals().round(1)[1].tolist()
        [0.7, 1.0]
        """
        miss = 1 - level_of(level)
        self._require_told()
        chosen = self._kind(kind)
        if simultaneous and chosen != "studentised":
            raise InputError("simultaneous=True; allowed with it: kind='studentised'")
        if chosen == "studentised":
            return self._studentised(miss, control_of(simultaneous) != "none")
        low, high = np.quantile(self.samples, (miss / 2, 1 - miss / 2), axis=0)
        if chosen == "basic":
            low, high = 2 * self.scale - high, 2 * self.scale - low
        return np.column_stack((low, high))

    def difference(self, first: str, second: str, level: float = 0.95) -> tuple[float, float]:
        """The percentile interval of how far `first` is above `second`, in `unit`.

        >>> from nacreous.scaling import paper, thurstone
        >>> low, high = thurstone(paper()).bootstrap(seed=3).difference("2", "7")
        >>> low < 1.8 < high
        True
        """
        miss = 1 - level_of(level)
        self._require_told()
        i, j = (place_of(label, self.stimuli) for label in (first, second))
        found = self.samples[:, i] - self.samples[:, j]
        low, high = np.quantile(found, (miss / 2, 1 - miss / 2))
        return float(low), float(high)

    @property
    def _alike(self) -> NDArray[np.bool_]:
        """Whether nobody in a sample differs about a stimulus, bool [sample, n]."""
        if self.sample_se is None or self.scale_se is None:
            return np.zeros((len(self.samples), 1), np.bool_)
        return np.asarray(self.sample_se <= _NOTHING * self.scale_se)

    def _require_told(self) -> None:
        """Refuse samples whose spread is that of the prior which holds them, or of nobody."""
        if self.tells:
            return
        count, alike = len(self.samples), int(self._alike.any(axis=1).sum())
        of = f"{self.without_maximum} of {count} samples have no scale of their own"
        if self.placed:
            of = f"in {alike} of {count} samples all people answered alike about a stimulus"
        raise InputError(
            f"{of}, too many to draw intervals from; allowed: 2 of 100, or the fit's own intervals"
        )

    def _kind(self, kind: str | None) -> str:
        known = self.sample_se is not None
        if kind is None:
            return "studentised" if known else "percentile"
        if kind not in KINDS or (kind == "studentised" and not known):
            allowed = ", ".join(KINDS if known else KINDS[1:])
            raise InputError(f"kind is {said(kind)}; allowed: {allowed}")
        return kind

    def _studentised(self, miss: float, together: bool) -> Array:
        """Hall 1988: the deviations of samples in standard errors stand for those of the fit."""
        assert self.sample_se is not None  # noqa: S101, as _kind saw
        assert self.scale_se is not None  # noqa: S101
        deviation = self.samples - self.scale
        # Samples in which nobody differs, 2 of 100 at most, have no errors to be measured in.
        known = ~self._alike
        t = np.divide(deviation, self.sample_se, out=np.full_like(deviation, np.nan), where=known)
        if together:
            reach = np.quantile(np.abs(t[known.all(axis=1)]).max(axis=1), 1 - miss)
            low, high = np.full(len(self.scale), -reach), np.full(len(self.scale), reach)
        else:
            low, high = np.nanquantile(t, (miss / 2, 1 - miss / 2), axis=0)
        se = self.scale_se
        return np.column_stack((self.scale - high * se, self.scale - low * se))


def resampled(
    fit: Scale,
    samples: int,
    by: str | None,
    seed: int,
    progress: Progress | None,
    *,
    errors: Errors | None = None,
) -> Bootstrap:
    """The samples of a fit, in its unit; see `Scale.bootstrap`.

    errors: those of the fit, of what is drawn, where they are known already.
    """
    if fit.method != "maximum-likelihood":
        raise InputError(f"method is {said(fit.method)}; allowed here: maximum-likelihood")
    if fit.posterior is not None:
        raise InputError(
            "prior is 'hierarchical', whose intervals need no samples; allowed here: a spread, or "
            "None"
        )
    if fit.design is None:
        require_joined(fit.comparisons)
    chosen = drawn_by(by, kind_of(fit, None) == "people")
    over_people = chosen == "people"
    if over_people:
        require_ends(fit)
    people = None
    if over_people:
        people = personal(_require_many(require_people(fit.answers, DRAWN_INSTEAD)))
    values, se, effects, unplaced = drawn(fit.room, people, fit.parameters, samples, seed, progress)
    times = factor(fit.own_unit, fit.unit)
    errors = errors or errors_of(fit, chosen if over_people else "observed")
    ties = effects[:, 1] * (times if fit.model == "probit" else 1.0)
    return Bootstrap(
        stimuli=fit.stimuli,
        unit=fit.unit,
        by=chosen,
        scale=fit.scale,
        samples=values * times,
        without_maximum=unplaced,
        order_effects=None if fit.order_effect is None else effects[:, 0] * times,
        tie_thresholds=None if fit.tie_threshold is None else ties,
        scale_se=root_of_diagonal(errors.covariance),
        sample_se=None if se is None else se * times,
    )


def _require_many(answers: Answers) -> Answers:
    """The answers, if enough people judged each stimulus to be drawn."""
    people = len(np.unique(answers.person))  # type: ignore[arg-type]
    require_many(answers.stimuli, judges_of(answers), people)
    return answers


def drawn_by(by: str | None, known: bool) -> Literal["people", "answers"]:
    """What is drawn anew: people, where they are known, or answers, or what a caller says."""
    if by is None:
        return "people" if known else "answers"
    if by == "people":
        return "people"
    if by == "answers":
        return "answers"
    raise InputError(f"by is {said(by)}; allowed: people, answers")


def samples_of(samples: int, parameters: int) -> int:
    """How many samples of so many parameters, or one clear message."""
    samples = whole_of("samples", samples, 2, 1_000_000)
    if samples * parameters > 1 << 27:
        most = (1 << 27) // parameters
        raise InputError(f"samples is {samples}; allowed for so many stimuli: 2 to {most}")
    return samples


def drawn(
    model: PairModel,
    people: PersonalAnswers | None,
    parameters: Array,
    samples: int,
    seed: int,
    progress: Progress | None,
) -> tuple[Array, Array | None, Array, int]:
    """Samples, their standard errors, side and ties, and how many had no maximum.

    samples: 2 to 1 000 000, and 2^27 values in all. seed: 0 to 2^63 - 1. progress: called with the
    finished share, 0 to 1, now and then.
    """
    samples, seed = samples_of(samples, len(parameters)), seed_of(seed)
    report = None if progress is None else lambda done: progress(done / samples)
    studentised = len(parameters) <= MOST_STUDENTISED
    values, se, effects, unplaced = model.bootstrap(
        parameters, people, samples, seed, studentised, report
    )
    return values, se if studentised else None, effects, unplaced

"""A scale fitted to rankings: where the stimuli are, in logit, and how sure that is."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.label import place_of
from nacreous.scaling.data.rankings import Rankings
from nacreous.scaling.fit import ranking_bootstrap, uncertainty
from nacreous.scaling.fit.bootstrap import Bootstrap, Progress
from nacreous.scaling.fit.errors import Errors, chosen_kind
from nacreous.scaling.fit.ranking_errors import errors_of
from nacreous.value import value_class

__all__ = ["RankedScale"]

Array = NDArray[np.float64]


@value_class
class RankedScale:
    """A scale of stimuli, as `plackett_luce` fitted it to rankings.

    - `stimuli`, `scale`: labels and float64 [n], mean 0, in `unit`, logit
    - `rankings`: what it was fitted to
    - `log_likelihood`: natural logarithm

    >>> import nacreous as nc
    >>> print(nc.scaling.plackett_luce(nc.scaling.simulate_rankings([0.5, 0, -0.5], seed=2)))
    scale in logit (Plackett-Luce, 30 trays)
    1   0.520 +- 0.153
    2  -0.085 +- 0.230
    3  -0.435 +- 0.224
    +- is over people; the scale is that of their average answer
    """

    stimuli: tuple[str, ...]
    scale: Array
    rankings: Rankings
    log_likelihood: float

    def __str__(self) -> str:
        """A line for each stimulus with its standard error, and whose errors these are."""
        known = self.rankings.person is not None
        note = "+- is over people; the scale is that of their average answer" if known else ""
        width = max(map(len, self.stimuli))
        rows = zip(self.stimuli, self.scale, strict=True)
        lines = [f"{label:{width}}  {value:z6.3f}" for label, value in rows]
        try:
            lines = [f"{line} +- {se:.3f}" for line, se in zip(lines, self.se, strict=True)]
        except InputError as problem:
            note = f"no errors over people: {problem}"
        count = len(self.rankings)
        head = f"scale in {self.unit} ({self.model}, {count} {'tray' if count == 1 else 'trays'})"
        return "\n".join((head, *lines, *([note] if note else [])))

    def __repr__(self) -> str:
        """In one line what was fitted."""
        return f"RankedScale({len(self.stimuli)} stimuli in {self.unit}, {self.model})"

    @property
    def unit(self) -> Literal["logit"]:
        """Logit: of a difference of 1 the better one of two is put first by 73.1 %, e : 1.

        In the maxdiff model it is named best of two by 88.1 %, e² : 1.
        """
        return "logit"

    @property
    def model(self) -> str:
        """Plackett-Luce, or maxdiff of the best and the worst."""
        return "Plackett-Luce" if self.rankings.task == "ranking" else "maxdiff"

    @property
    def ranking(self) -> tuple[str, ...]:
        """The labels from the most preferred on."""
        return tuple(self.stimuli[index] for index in np.argsort(-self.scale, kind="stable"))

    @property
    def se(self) -> Array:
        """float64 [n]: standard errors, as the default `covariance` has them."""
        return uncertainty.root_of_diagonal(self.covariance())

    def covariance(self, kind: str | None = None) -> Array:
        """float64 [n, n]: covariance of the scale with mean held at 0, in logit squared.

        kind: "people", the default where people are known, a sandwich with people as clusters, CR2,
        as `Scale.covariance` has it; "observed", the default elsewhere, or "expected" information
        (exact, trays of up to 12 stimuli), which trust the model and every tray to stand alone.
        Raises `InputError` where fewer than three people judged a stimulus, and where all put some
        alike: that tells nothing of how people differ.
        """
        return self._errors(kind).covariance

    def difference(
        self, first: str, second: str, level: float = 0.95, kind: str | None = None
    ) -> uncertainty.Difference:
        """How far `first` is above `second`; level and kind as in `Scale.difference`.

        >>> import nacreous as nc
        >>> fit = nc.scaling.plackett_luce(nc.scaling.simulate_rankings([0.5, 0, -0.5], seed=2))
        >>> fit.difference("1", "3")
        Difference(1 - 3: 0.954, 0.325 to 1.584 logit)
        """
        pairs = [(place_of(first, self.stimuli), place_of(second, self.stimuli))]
        return uncertainty.differences(
            self.stimuli, self.scale, self._errors(kind), self.unit, level, "none", pairs
        )[0]

    def differences(
        self, level: float = 0.95, simultaneous: str = "holm", kind: str | None = None
    ) -> list[uncertainty.Difference]:
        """All n (n - 1) / 2 differences, as `Scale.differences` has them."""
        return uncertainty.differences(
            self.stimuli, self.scale, self._errors(kind), self.unit, level, simultaneous
        )

    def intervals(
        self, level: float = 0.95, simultaneous: str | bool = False, kind: str | None = None
    ) -> Array:
        """float64 [n, 2]: an interval for each value, as `Scale.intervals` has them."""
        return uncertainty.intervals(self.scale, self._errors(kind), level, simultaneous)

    def bootstrap(
        self,
        samples: int = 1000,
        by: str | None = None,
        seed: int = 1,
        progress: Progress | None = None,
    ) -> Bootstrap:
        """The scales of rankings drawn again.

        by: "people", each with all trays, the default where people are known, or "answers", which
        are trays. samples, seed, progress: as in `Scale.bootstrap`. Raises `InputError` for what is
        out of range, and for people that are not known or fewer than 8 of whom judged a stimulus.
        """
        return ranking_bootstrap.resampled(self, samples, by, seed, progress)

    def _errors(self, kind: str | None) -> Errors:
        default = "observed" if self.rankings.person is None else "people"
        return errors_of(self, chosen_kind(kind, default))

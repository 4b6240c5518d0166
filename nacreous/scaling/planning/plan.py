"""Planning a study before anybody is asked: power, precision, and how many people it takes.

Every answer here is simulated, of observers who follow the model and the assumptions stated in the
plan; real people may differ more. Each result says so, and how far its own number may be off for
being simulated a finite number of times (Monte-Carlo error).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.number import seed_of, whole_of, within
from nacreous.problem import InputError
from nacreous.scaling.compare.estimate import Estimate, estimate, fit_of
from nacreous.scaling.compare.permutation import permutation_test
from nacreous.scaling.compare.pool import pooled
from nacreous.scaling.compare.restricted import restricted
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.fault import listed, quoted
from nacreous.scaling.data.label import label_of
from nacreous.scaling.distribution import t
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.side import fits_side
from nacreous.scaling.planning.expectation import expected_comparisons, unanimous_chances
from nacreous.scaling.planning.forecast import Needed, Power, Precision
from nacreous.scaling.planning.simulation import Pairs, simulate, truth_of
from nacreous.value import value_class

__all__ = ["Plan"]

Array = NDArray[np.float64]
Progress = Callable[[float], None]

_MOST_PEOPLE = 100_000
#: People are dealt anew this often in a simulated test of groups: enough to know p at 5 %.
_DEALS = 399


@value_class
class Plan:
    """A study that is thought of: the truth one expects, the people, the pairs they see.

    Arguments as for `simulate`: scale (label -> value, or values of "1", "2", ...), people, model,
    pairs (a design, or (label, label) each), repeats, person_spread, order, tie, lapse. The fit has
    ties and an order effect where the truth has them, and groups a pull of the side wherever their
    answers tell it. Differences are tested by a t test with
    people as clusters, groups by dealing people anew, as `compare_groups` does.

    >>> plan = Plan({"dull": -0.4, "fair": 0.0, "bright": 0.4}, people=40, person_spread=0.3)
    >>> print(plan.power("bright", "fair", studies=200))
    power 0.555 +- 0.035 (40 people; simulated, 200 studies)
    """

    scale: Mapping[str, float] | ArrayLike
    people: int = 30
    model: str = "probit"
    pairs: Pairs | None = None
    repeats: int = 1
    person_spread: float = 0.0
    order: float = 0.0
    tie: float = 0.0
    lapse: float = 0.0

    def __post_init__(self) -> None:
        """Refuse at once what could not be simulated."""
        whole_of("people", self.people, 2, _MOST_PEOPLE)
        simulate(**{**self._settings, "people": 1})

    @property
    def stimuli(self) -> tuple[str, ...]:
        """Labels, in natural order."""
        return truth_of(self.scale)[0]

    def answers(self, seed: int = 1) -> Answers:
        """The answers of one simulated study."""
        return simulate(**self._settings, seed=seed)

    def power(
        self,
        first: object,
        second: object,
        *,
        alpha: float = 0.05,
        studies: int = 1000,
        seed: int = 1,
        progress: Progress | None = None,
    ) -> Power:
        """Share of studies in which two stimuli differ at the level alpha, either way.

        progress is called with the finished share, 0 to 1.
        """
        i, j = (self._place(label) for label in (first, second))
        within("alpha", alpha, 1e-6, 0.5)

        def finds(study: int) -> bool | None:
            found = self._estimate(study)
            return None if found is None else _differ(found, i, j, alpha)

        return _share(finds, studies, seed, self.people, progress)

    def group_power(
        self,
        other: Mapping[str, float] | ArrayLike,
        *,
        alpha: float = 0.05,
        studies: int = 500,
        seed: int = 1,
        progress: Progress | None = None,
    ) -> Power:
        """Share of studies that find a difference between two groups, the second of scale `other`.

        Each group has `people`. With `other` equal to `scale` this is the size of the test.
        """
        second = replace(self, scale=other)
        if second.stimuli != self.stimuli:
            raise InputError("other has other stimuli than scale; allowed: the same")
        within("alpha", alpha, 1e-6, 0.5)

        def finds(study: int) -> bool | None:
            groups = {"a": self.answers(2 * study), "b": second.answers(2 * study + 1)}
            fitted = self._fitted(partial(_pooled_fit, groups, self.model))
            if fitted is None:
                return None
            try:
                alike = restricted(groups, fitted, "places")
            except InputError:  # as for one scale that does not exist
                return None
            return permutation_test(groups, alike, _DEALS, False, study)[1] <= alpha

        return _share(finds, studies, seed, self.people, progress)

    def precision(
        self,
        *,
        level: float = 0.95,
        studies: int = 500,
        seed: int = 1,
        progress: Progress | None = None,
    ) -> Precision:
        """How far each value is off, and how wide its interval is."""
        within("level", level, 0.5, 0.9999)
        target = self.expected_scale
        off, half = [], []
        for study in _studies(studies, seed, progress):
            found = self._estimate(study)
            if found is not None:
                off.append(found.fit.scale - target)
                reach = float(t.ppf((1 + level) / 2, found.freedom))
                half.append(reach * np.sqrt(np.diag(found.covariance)))
        if not off:
            raise InputError("no simulated study gave a scale; allowed: more people or pairs")
        squares, widths = np.square(off), np.array(half)
        error = np.sqrt(squares.mean(axis=0))
        spread = squares.std(axis=0) / np.sqrt(len(squares))
        return Precision(
            stimuli=self.stimuli,
            error=error,
            error_se=spread / (2 * np.maximum(error, 1e-12)),
            half_width=widths.mean(axis=0),
            coverage=(np.abs(off) <= widths).mean(axis=0),
            level=level,
            studies=studies,
            people=self.people,
            unplaced=1 - len(off) / studies,
        )

    def people_needed(
        self,
        first: object,
        second: object,
        *,
        power: float = 0.8,
        alpha: float = 0.05,
        studies: int = 1000,
        seed: int = 1,
        progress: Progress | None = None,
    ) -> Needed:
        """How many people it takes to find that two stimuli differ.

        Power is tried at some numbers of people, each chosen by what the ones before say, until
        they lie together; studies is the number simulated for each. Raises `InputError` where
        100 000 people would not do, as for two stimuli that are alike.
        """
        from nacreous.scaling.planning.search import people_for

        within("power", power, 0.1, 0.99)
        report = progress or (lambda _: None)

        def tried(people: int, seed: int, done: float) -> Power:
            at = replace(self, people=people)
            report(done)
            seed %= 2**63  # beyond the largest seed come the first ones
            return at.power(first, second, alpha=alpha, studies=studies, seed=seed)

        seed = seed_of(seed)
        people, low, high = people_for(tried, self.people, power, alpha, _MOST_PEOPLE, seed)
        reached = tried(people, seed + 99, 0.85)
        report(1.0)
        return Needed(people, low, high, power, reached)

    @property
    def expected_scale(self) -> Array:
        """What endless answers would give, float64 [stimulus]: less spread where people differ."""
        comparisons = expected_comparisons(self)
        fit = self._fitted(lambda **more: fit_of(comparisons, self.model, **more))
        if fit is None:
            raise InputError("these pairs give no scale; allowed: pairs that connect all stimuli")
        return np.asarray(fit.scale)

    @property
    def unanimous_pairs(self) -> float:
        """Expected number of pairs on which all answers are the same. Computed, not simulated.

        Such pairs have proportions of 0 and 1, for which the least squares of 1996 have no z.

        >>> round(Plan([0.0, 1.0], people=5).unanimous_pairs, 4)  # Phi(1)^5 + Phi(-1)^5
        0.4217
        """
        return float(unanimous_chances(self).sum())

    @property
    def _settings(self) -> dict[str, Any]:
        names = ("scale", "people", "model", "pairs", "repeats", "person_spread", "order", "tie")
        return {name: getattr(self, name) for name in (*names, "lapse")}

    def _place(self, label: object) -> int:
        found = label_of(str(label))
        if found not in self.stimuli:
            raise InputError(
                f"there is no stimulus {quoted(label)}; allowed: {listed(self.stimuli)}"
            )
        return self.stimuli.index(found)

    def _estimate(self, study: int) -> Estimate | None:
        answers = self.answers(study)
        found: Estimate | None = self._fitted(lambda **more: estimate(answers, self.model, **more))
        return found

    def _fitted(self, fit: Callable[..., Any]) -> Any:
        """With ties and order as the truth has them; None where the answers give no scale."""
        try:
            return fit(ties=self.tie > 0, order=self.order != 0)
        except InputError:
            return None


def _pooled_fit(groups: dict[str, Answers], model: str, *, ties: bool, order: bool) -> Scale:
    """The scale of groups together, with a pull of the side wherever `compare_groups` fits it."""
    counted = [one.comparisons() for one in groups.values()]
    with_side = fits_side(order or None, counted, model, ties)
    return fit_of(pooled(groups), model, ties=ties, order=with_side)


def _differ(found: Estimate, i: int, j: int, alpha: float) -> bool:
    """Whether two stimuli differ, by a t test with people as clusters."""
    from scipy.special import stdtrit

    c = found.covariance
    lead = abs(float(found.fit.scale[i] - found.fit.scale[j]))
    se = float(c[i, i] + c[j, j] - 2 * c[i, j]) ** 0.5
    return bool(lead > stdtrit(found.freedom, 1 - alpha / 2) * se)


def _studies(studies: int, seed: int, progress: Progress | None) -> Iterator[int]:
    """Seeds of so many studies, unlike those of other seeds."""
    whole_of("studies", studies, 10, 1_000_000)
    start = np.random.SeedSequence(seed_of(seed)).generate_state(1, np.uint64)[0]
    first = int(start >> 3)  # room for two a study below 2^63
    for done in range(studies):
        if progress is not None and done % 10 == 0:
            progress(done / studies)
        yield first + done
    if progress is not None:
        progress(1.0)


def _share(
    finds: Callable[[int], bool | None],
    studies: int,
    seed: int,
    people: int,
    progress: Progress | None,
) -> Power:
    found = [finds(study) for study in _studies(studies, seed, progress)]
    power = sum(one is True for one in found) / studies
    # As if two more had found it and two more not: never 0 (Agresti and Coull 1998).
    near = (power * studies + 2) / (studies + 4)
    se = (near * (1 - near) / (studies + 4)) ** 0.5
    return Power(power, se, studies, people, sum(one is None for one in found) / studies)

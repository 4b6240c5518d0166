"""All that a report says, computed once, before a word is written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Any, Literal

import numpy as np

from nacreous import file
from nacreous.deprecation import keep_former_names
from nacreous.problem import InputError
from nacreous.scaling.check.checkup import Consistency, consistency
from nacreous.scaling.check.misfit import Goodness, goodness
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.given import counted
from nacreous.scaling.fit.bradley import bradley_terry
from nacreous.scaling.fit.case_v import thurstone
from nacreous.scaling.fit.existence import require_choices, require_joined
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.tie import FEW
from nacreous.scaling.report.called import Called
from nacreous.scaling.report.doubt import Doubt, Pair, doubt_of, ends_apart, neighbours_of, pairs_of
from nacreous.scaling.report.groups import Groups, groups_of
from nacreous.scaling.report.people import People, people_of
from nacreous.scaling.report.settings import MODELS, Settings
from nacreous.value import value_class

__all__ = ["SUFFIXES", "Analysis", "analyse"]

SUFFIXES = (".html", ".csv", ".json")
#: Beyond, there are more pairs than anybody reads, and each is tested against thousands.
MOST_PAIRED = 60
#: The share of the time that resampling takes.
_RESAMPLING = 0.6
#: And that of dealing answers anew to people.
_DEALING = 0.3
#: A scale narrower than this is printed as one value.
_LEVEL = 0.0005


@value_class
class Analysis:
    """Answers and all that was found in them.

    `answers` is None where only counts are known; `people` where who answered is not, or nothing
    in which people could differ; `groups` where no column was named; `example`: the data are the
    paper's, reconstructed from its table; `called`: words for things by their numbers, by label,
    which whoever knows the numbers puts here.
    """

    settings: Settings
    comparisons: Comparisons
    answers: Answers | None
    fit: Scale
    doubt: Doubt
    neighbours: tuple[Pair, ...]
    goodness: Goodness
    consistency: Consistency
    people: People | None
    groups: Groups | None
    example: bool
    called: Mapping[str, tuple[Called, ...]] = field(default_factory=dict)

    def __repr__(self) -> str:
        """How much was analysed."""
        found = self.comparisons
        return f"Analysis({found.total:g} answers, {len(found.stimuli)} stimuli)"

    @property
    def people_differ(self) -> bool:
        """Whether people, or groups of answers, were found not to share one scale, by any test."""
        return self.single_people_differ or bool(self.apart_by)

    @property
    def single_people_differ(self) -> bool:
        """Whether the test of single people found that they do not share one scale."""
        return self.people is not None and self.people.differ

    @property
    def apart_by(self) -> tuple[str, ...]:
        """The columns by which people, or groups of answers, were found to judge differently."""
        own = () if self.people is None else self.people.apart_by
        column = self.settings.group
        if column is None or column in own or not self.groups_differ:
            return own
        return (*own, column)

    @property
    def groups_differ(self) -> bool:
        """Whether the groups that were asked for do not share one scale."""
        return self.groups is not None and bool(self.groups.differ(self.settings.level))

    @property
    def people_apart_by(self) -> tuple[str, ...]:
        """Those of `apart_by` that say one thing about each person."""
        of_people = self.groups is not None and self.groups.of_people
        own = () if self.people is None else self.people.apart_by
        return self.apart_by if of_people else own

    @property
    def people_told(self) -> bool:
        """Whether these answers could tell that people do not share one scale."""
        return self.people is not None and self.people.shared.tells

    @property
    def side_draws(self) -> bool:
        """Whether a side drew choices, whatever stood there."""
        side = self.consistency.side
        risk = 1 - self.settings.level
        return side is not None and side.p_value is not None and side.p_value < risk

    @property
    def side_decides(self) -> bool:
        """Whether a side made most of the choices."""
        return (
            self.side_draws and self.consistency.side is not None and self.consistency.side.decides
        )

    @property
    def side_hides_fit(self) -> bool:
        """Whether the side made most choices and the fit knows nothing of it.

        Sums over both ways round then fit any scale.
        """
        return self.side_decides and self.fit.order_effect is None

    @property
    def ties_half(self) -> bool:
        """Whether ties are more than a few and count as half a choice for each."""
        return self.fit.tie_threshold is None and self.tied > FEW

    @property
    def ties_unfitted(self) -> bool:
        """Whether ties would have been answers of their own, but how wide they are is not told."""
        likely = self.settings.method == "maximum-likelihood"
        return self.ties_half and likely and self.settings.ties is None

    @property
    def encoding_guessed(self) -> str | None:
        """The encoding as which the file was read, where nothing in it says so."""
        data = self.comparisons if self.answers is None else self.answers
        return data.encoding_guessed

    @property
    def pairs(self) -> int:
        """How many pairs were compared."""
        return len(self.comparisons.unsided())

    @property
    def tied(self) -> float:
        """The share of ties."""
        return float(self.comparisons.ties.sum() / self.comparisons.total)

    @property
    def fit_hidden_by(self) -> Literal["side", "ties"] | None:
        """What would make any scale fit: a side that decided, or halves, without chance in them."""
        if not self.goodness.describes:
            return None
        if self.side_hides_fit:
            return "side"
        return "ties" if self.ties_half else None

    @property
    def is_level(self) -> bool:
        """Whether all things stand at one place, as far as three decimals show."""
        return bool(np.ptp(self.fit.scale) < _LEVEL)

    @property
    def anything_apart(self) -> bool:
        """Whether any two things are told apart; of more than 60 neighbours, or first and last."""
        if any(pair.apart for pair in self.neighbours):
            return True
        if len(self.fit.stimuli) > MOST_PAIRED:
            return ends_apart(self.fit, self.doubt, self.settings.level)
        return any(pair.apart for pair in self.differences)

    @property
    def order(self) -> list[int]:
        """Indices of the stimuli from the top of the scale."""
        return [int(at) for at in np.argsort(-self.fit.scale, kind="stable")]

    @property
    def ranking(self) -> list[str]:
        """Labels from the top of the scale."""
        return [self.fit.stimuli[at] for at in self.order]

    @cached_property
    def differences(self) -> tuple[Pair, ...]:
        """Each thing with all further down, p values by Holm over all; () beyond 60 things."""
        if len(self.fit.stimuli) > MOST_PAIRED:
            return ()
        return pairs_of(self.fit, self.doubt, self.settings.level)

    def save(self, path: str | PathLike[str], language: str = "en") -> None:
        """Write a report (.html, in "en" or "ja"), the scale (.csv) or every number (.json).

        Same analysis, same bytes. Raises `InputError` for other endings and languages, and where
        the file cannot be written; then there is no file.
        """
        file.check_output(path, SUFFIXES)
        text = self.text(path, language)
        with file.atomic(path) as temporary:
            temporary.write_text(text, encoding="utf-8", newline="\n")

    def text(self, path: str | PathLike[str], language: str = "en") -> str:
        """What `save` writes to a path of that ending."""
        import nacreous.scaling.report.page as page
        import nacreous.scaling.report.record as record

        kind = Path(path).suffix.lower()
        if kind == ".html":
            return page.html(self, language)
        return record.csv(self) if kind == ".csv" else record.json_text(self)


def analyse(
    data: Any,
    settings: Settings | None = None,
    *,
    example: bool = False,
    progress: Callable[[float], None] | None = None,
    **asked: Any,
) -> Analysis:
    """Fit a scale to answers or counts and look at it from all sides, as the report does.

    data: what `thurstone` takes. What is asked for comes as a `Settings`, or by its names:
    question, model, method, ties, order, prior, unit, level, bootstrap, seed, group, simulated.
    progress: called with the finished share. Raises `InputError` where there is no scale, where all
    answers are ties, and for bad settings.

    >>> import nacreous as nc
    >>> found = nc.scaling.analyse(nc.scaling.paper(), bootstrap=100)
    >>> found.ranking
    ['2', '4', '3', '1', '5', '6', '7']
    >>> [(pair.first, pair.second) for pair in found.neighbours if not pair.apart]
    [('4', '3'), ('3', '1')]
    """
    wanted = _settings(settings, asked)
    show = progress or (lambda _: None)
    answers, comparisons = counted(data)
    require_choices(comparisons)  # halves of ties would pass for a finding
    require_joined(comparisons)  # with a prior too, whose guess would pass for a finding
    if wanted.group is not None and answers is None:
        raise InputError(f"group is {wanted.group!r}; allowed: none, for the data are counts")
    if wanted.group is not None and answers is not None:
        answers.split(wanted.group)  # says at once if there is no such column
    own = _fitted(comparisons if answers is None else answers, wanted)
    fit = own.to(wanted.unit or MODELS[wanted.model])
    # Without anyone to show to, resampling need not stop to say how far it is.
    watch = None if progress is None else lambda share: show(_RESAMPLING * share)
    doubt = doubt_of(fit, wanted, watch)
    rest = None if progress is None else lambda share: show(_RESAMPLING + share * _DEALING)
    people = people_of(answers, wanted, rest)
    consistent = consistency(comparisons if answers is None else answers, own.scale)
    groups = None
    if wanted.group is not None and answers is not None:
        groups = groups_of(answers, wanted)
    show(1.0)
    return Analysis(
        settings=wanted,
        comparisons=comparisons,
        answers=answers,
        fit=fit,
        doubt=doubt,
        neighbours=neighbours_of(fit, doubt, wanted.level),
        goodness=goodness(own, wanted.level),
        consistency=consistent,
        people=people,
        groups=groups,
        example=example,
    )


def _settings(settings: Settings | None, asked: dict[str, Any]) -> Settings:
    known = set(Settings.__dataclass_fields__)
    unknown = sorted(set(asked) - known)
    if unknown:
        raise InputError(f"{unknown[0]} is no setting; allowed: {', '.join(sorted(known))}")
    return replace(settings or Settings(), **asked)


def _fitted(data: Any, wanted: Settings) -> Scale:
    fitted: Callable[..., Scale] = bradley_terry if wanted.model == "logit" else thurstone
    return fitted(
        data, method=wanted.method, ties=wanted.ties, order=wanted.order, prior=wanted.prior
    )


keep_former_names(__name__, {"Study": "Analysis", "study": "analyse"}, "nacreous.scaling")

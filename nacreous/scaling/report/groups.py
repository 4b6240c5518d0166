"""The groups of people that can be compared, and by name those that cannot."""

from __future__ import annotations

from dataclasses import replace

from nacreous.problem import InputError
from nacreous.scaling.compare.estimate import Estimate, estimate
from nacreous.scaling.compare.groups import PERMUTATIONS, GroupComparison, compared
from nacreous.scaling.compare.style import GroupStyle
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.fit.existence import pair_model
from nacreous.scaling.fit.judges import require_people
from nacreous.scaling.fit.side import fits_side
from nacreous.scaling.fit.tie import fits_ties
from nacreous.scaling.report.settings import Settings
from nacreous.value import value_class

__all__ = ["Groups", "LeftOut", "groups_of", "left_out_of"]


@value_class
class LeftOut:
    """A group that cannot be compared.

    reason: "few", of some stimulus fewer than 3 of its people judged; "unplaced", its own answers
    do not hold every stimulus in place.
    """

    name: str
    reason: str


@value_class
class Groups:
    """What a column of groups told.

    `found` is None where fewer than two groups can be compared. A group that cannot be is in
    `left_out`, and stops neither the comparison of the others nor the rest of the report.
    `of_people`: people are known, and nobody is in two of the groups that were compared.
    """

    found: GroupComparison | None
    left_out: tuple[LeftOut, ...]
    of_people: bool

    def differ(self, level: float) -> bool | None:
        """Whether groups were found not to share one scale; None where none were compared."""
        return None if self.found is None else self.found.p_value < 1 - level

    def may_be_side(self, level: float) -> bool:
        """Whether groups that differ may differ by a pull of the side alone, which is not told."""
        return self.found is not None and self.found.side_untold and self.found.p_value < 1 - level

    def styles(self, level: float) -> tuple[GroupStyle, ...]:
        """Ways of answering in which groups were found to differ, whatever places they see."""
        found = () if self.found is None else self.found.styles
        return tuple(one for one in found if one.differs(level))


def groups_of(answers: Answers, settings: Settings) -> Groups:
    """Compare the groups of `settings.group`, a column of the answers, as `compare_groups` does.

    Raises `InputError` where there is no such column.
    """
    # Neither time nor its length tells groups apart, and of millions of answers both are large.
    parts = replace(answers, response_s=None, time=None).split(settings.group or "")
    counted = [part.comparisons() for part in parts.values()]
    with_ties = fits_ties(settings.ties, counted, settings.model, settings.order)
    with_side = _with_side(parts, settings, with_ties)
    placed = {name: _placed(part, settings, with_ties, with_side) for name, part in parts.items()}
    left_out = _left_out(placed)
    found = {name: one for name, one in placed.items() if isinstance(one, Estimate)}
    if len(found) < 2:
        return Groups(None, left_out, of_people=False)
    held = {name: parts[name] for name in found}
    apart = _apart(held)
    same = None if apart else True
    comparison = compared(held, found, same, PERMUTATIONS, settings.level, settings.seed)
    # The report shows nothing of the answers of all once more.
    shared = replace(comparison.shared, answers=None)
    of_people = apart and answers.person is not None
    return Groups(replace(comparison, shared=shared), left_out, of_people)


def left_out_of(
    parts: dict[str, Answers], settings: Settings, with_ties: bool
) -> tuple[LeftOut, ...]:
    """Those of some groups that cannot be compared."""
    with_side = settings.order
    return _left_out(
        {name: _placed(part, settings, with_ties, with_side) for name, part in parts.items()}
    )


def _left_out(placed: dict[str, Estimate | str]) -> tuple[LeftOut, ...]:
    return tuple(LeftOut(name, why) for name, why in placed.items() if isinstance(why, str))


def _with_side(parts: dict[str, Answers], settings: Settings, with_ties: bool) -> bool:
    """Whether each group has a pull of the side: asked for, or told by all that are compared."""
    compared = [part.comparisons() for part in parts.values() if _judged(part)]
    held = [each for each in compared if pair_model(each, settings.model).existence() != "apart"]
    return fits_side(settings.order or None, held, settings.model, with_ties)


def _judged(part: Answers) -> bool:
    """Whether enough people judged every stimulus; so where people are unknown."""
    try:
        if part.person is not None:
            require_people(part)
    except InputError:
        return False
    return True


def _placed(part: Answers, settings: Settings, with_ties: bool, with_side: bool) -> Estimate | str:
    """A group's scale, or why it cannot be compared."""
    if not _judged(part):
        return "few"
    try:
        return estimate(part, settings.model, ties=with_ties, order=with_side)
    except InputError:
        return "unplaced"


def _apart(parts: dict[str, Answers]) -> bool:
    """Whether nobody is in two groups. Within one file a label is one person."""
    people = [label for part in parts.values() for label in part.people]
    return len(people) == len(set(people))

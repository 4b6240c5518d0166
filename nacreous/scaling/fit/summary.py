"""What `print` shows of a scale."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.fit.errors import kind_of
from nacreous.scaling.fit.existence import require_joined
from nacreous.scaling.fit.tie import FEW

if TYPE_CHECKING:
    from nacreous.scaling.fit.scale import Scale

__all__ = ["summary"]

#: Answers x permutations that are dealt before anybody waits, some tenths of a second.
_MOST_DEALT = 20_000_000


def summary(fit: Scale) -> str:
    """A line for each stimulus with its standard error, and before them whether people differ."""
    how = fit.method if fit.posterior is None else "prior over the spread"
    head = f"scale in {fit.unit} ({fit.model}, {how}, {fit.comparisons.total:g} answers)"
    width = max(map(len, fit.stimuli))
    rows = zip(fit.stimuli, fit.scale, strict=True)
    lines = [f"{label:{width}}  {value:z6.3f}" for label, value in rows]
    note = "+- is over people; the scale is that of their average answer"
    try:
        lines = [f"{line} +- {se:.3f}" for line, se in zip(lines, fit.se, strict=True)]
    except InputError as problem:
        note = f"no errors over people: {problem}"
    if kind_of(fit, None) == "people":
        lines.append(note)
    return "\n".join((*_apart(fit), *_ties(fit), *_people(fit), head, *lines))


def _apart(fit: Scale) -> list[str]:
    """Which stimuli a prior alone places against the others; with a design its columns do."""
    try:
        if fit.design is None:
            require_joined(fit.comparisons)
    except InputError as problem:
        return [f"{problem}; where these stand to each other is the prior's guess"]
    return []


def _ties(fit: Scale) -> list[str]:
    """That ties, more than a few, count half, or that there is nothing else."""
    tied = float(fit.comparisons.ties.sum() / fit.comparisons.total)
    if fit.tie_threshold is not None or tied <= FEW:
        return []
    if tied == 1:
        return ["nobody chose anything: all answers are ties, and all stimuli were called equal"]
    return [f"ties, {100 * tied:.0f} % of the answers, count as half a choice for each"]


def _people(fit: Scale) -> list[str]:
    """That people do not share one scale, or judge differently by a column of theirs, if so.

    Seed and number of permutations are fixed, so that a scale is printed alike each time. Of more
    answers than can be dealt at once it says which call tests them.
    """
    # Whoever fits a scale but prints none need not load it; and the test itself fits scales.
    from nacreous.scaling.fit.covariate import person_covariates
    from nacreous.scaling.fit.shared import MOST_STIMULI, shared_scale

    answers = fit.answers
    if answers is None or answers.person is None or len(fit.stimuli) > MOST_STIMULI:
        return []
    permutations = min(999, _MOST_DEALT // len(answers))
    if permutations < 99:
        return ["whether people share one scale was not tested here; shared_scale(answers) does"]
    columns = [
        f"people who differ in {quoted(one.column)} judge differently, p {one.p_adjusted:.3g}"
        for one in person_covariates(answers, permutations)
        if one.differs()
    ]
    try:
        found = shared_scale(answers, permutations)
    except InputError:  # no pair was answered by two, or all agree
        return columns
    return [found.verdict(), *columns] if found.differ() else columns

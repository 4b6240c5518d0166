"""What `nacreous scale` says in the terminal."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

from nacreous.commands.scale_cautions import cautions
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.uncounted import REASONS

if TYPE_CHECKING:
    from nacreous.scaling.check.population import Population
    from nacreous.scaling.compare.style import GroupStyle
    from nacreous.scaling.fit.scale import Scale
    from nacreous.scaling.report.analysis import Analysis

#: Of more columns nobody reads why they were not compared.
_MOST_UNTESTED = 10


def told(found: Analysis, seconds: float) -> str:
    """In a few lines what was found."""
    fit, doubt = found.fit, found.doubt
    width = max(len(label) for label in fit.stimuli)
    lines = _side_told(found) + _people_told(found)
    lines += [
        f"{found.comparisons.total:g} answers on {len(fit.stimuli)} stimuli, {fit.model}, "
        f"{_fit_told(fit)}, in {fit.unit}; {100 * found.settings.level:g} % intervals by "
        f"{_BY[doubt.by]}, {seconds:.1f} s"
    ]
    for at in found.order:
        low, high = doubt.intervals[at]
        lines.append(
            f"{fit.stimuli[at]:{width}}  {fit.scale[at]:z7.3f}  {low:z7.3f} to {high:z.3f}"
        )
    if doubt.samples:
        many = doubt.by in ("clusters", "information")
        lines.append(
            f"samples without a scale of their own: {doubt.without_maximum} of {doubt.samples}"
            + ("; too many to draw intervals from" if many else "")
        )
    if found.ties_unfitted:
        lines.append(
            f"ties, {100 * found.tied:.0f} % of the answers, count half: "
            "how wide they are cannot be told"
        )
    if doubt.endless:
        sets = " | ".join(", ".join(each) for each in doubt.endless)
        lines.append(f"all answers between {sets} agree: how much farther apart cannot be told")
    if doubt.too_few:
        lines.append(
            "these answers cannot tell how people differ; the intervals hold for these people alone"
        )
    lines += [
        f"person {one.person} always said tie ({one.ties} of the {one.of} ties)"
        for one in found.consistency.always_tied[:_MOST_UNTESTED]
    ]
    lines += _groups_told(found) + _drawn_told(found) + _left_out_told(found) + _times_told(found)
    lines += _read_told(found) + _untested_told(found) + cautions(found)
    return "\n".join([*lines, _fit_verdict(found)])


def _side_told(found: Analysis) -> list[str]:
    """Before the scale, that a side drew choices; nothing where it did not."""
    side = found.consistency.side
    if side is None or not found.side_draws:
        return []
    what = "decided most answers" if side.decides else "drew choices"
    return [f"the side {what}, whatever stood there: left chosen {side.left}"]


def _fit_verdict(found: Analysis) -> str:
    """What the test of fit says, where the sums can say anything."""
    if found.fit_hidden_by is not None:
        why = {"side": "the side decided most answers", "ties": "ties count half"}
        return "whether one scale describes these data cannot be told: " + why[found.fit_hidden_by]
    return ("all answers together: " if found.people_differ else "") + found.goodness.verdict


def _fit_told(fit: Scale) -> str:
    """How it was fitted."""
    if fit.posterior is None:
        return fit.method
    spread = fit.posterior.spread
    return f"prior over the spread ({spread:.2f} {fit.own_unit})"


def _groups_told(found: Analysis) -> list[str]:
    """Whether groups differ, and which could not be compared; nothing without a column."""
    groups = found.groups
    if groups is None:
        return []
    by = f"groups by {found.settings.group}"
    if groups.found is None:
        return [f"{by} cannot be compared: fewer than two have a scale of their own"]
    differ = groups.differ(found.settings.level)
    styles = groups.styles(found.settings.level)
    found_none = "no difference of places found" if styles else "no difference found"
    what = f"{by} differ" if differ else f"{by}: {found_none} beyond chance"
    lines = [f"{what}, p = {groups.found.p_value:.3g}", *map(_style_told, styles)]
    if groups.may_be_side(found.settings.level):
        lines.append(
            "how the side draws each group cannot be told, for pairs stood mostly one way round or "
            "the side decided: groups may differ in that alone"
        )
    if groups.left_out:
        names = listed(one.name for one in groups.left_out)
        lines.append(f"not compared, for they have no scale of their own: {names}")
    return lines


def _style_told(style: GroupStyle) -> str:
    """In which way groups answer apart, which is no other scale."""
    most, least = style.most, style.least
    more, less = (100 * style.shares[name] for name in (most, least))
    what = "calls more things equal" if style.name == "ties" else "is drawn more to the left"
    shares = f"{more:.0f} to {less:.0f} of 100"
    return f"{most} {what} than {least}, of two alike {shares}, p = {style.p_adjusted:.3g}"


def _drawn_told(found: Analysis) -> list[str]:
    """Columns of people whom the side draws differently; those of the groups are said there."""
    columns = () if found.people is None else found.people.covariates
    drawn = [one for one in columns if one.side_differs(found.settings.level)]
    return [
        f"the side draws people who differ in {one.column} differently, which is no other scale, "
        f"p = {one.side_p_adjusted:.3g}"
        for one in drawn[:_MOST_UNTESTED]
        if one.column != found.settings.group
    ]


def _left_out_told(found: Analysis) -> list[str]:
    """How many rows of the table are left out, and why."""
    if found.answers is None:
        return []
    unanswered = found.answers.unanswered
    rows = {"with no pair": found.answers.left_out - unanswered, "with no answer": unanswered}
    rows |= {REASONS[reason]: count for reason, count in found.answers.uncounted.items()}
    told = [f"{count} {what}" for what, count in rows.items() if count]
    return [f"rows left out: {_joined(told)}"] if told else []


def _joined(words: list[str]) -> str:
    """Words with commas between them, and "and" before the last."""
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))


def _read_told(found: Analysis) -> list[str]:
    """What was read by a guess, and words that were read as nothing."""
    lines = []
    if found.encoding_guessed:
        guess = found.encoding_guessed
        sure = "save it as UTF-8" if found.answers is None else "--encoding names this or another"
        lines.append(f"read as {guess}, a guess; {sure}")
    groups = {} if found.answers is None else found.answers.groups
    return lines + [
        f"read as empty: {listed(group.nothing)} in column {name}"
        for name, group in groups.items()
        if group.nothing
    ]


#: Why people were not compared by a column.
_UNTESTED = {
    "few people": "it is filled in for fewer than 6 people",
    "few apart": "too few people differ in it",
    "many values": "it is text, and has nearly as many values as there are people",
    "unclear marks": "its commas or points may part thousands or decimals",
    "no numbers": "beside numbers it holds {cells}",
}


def _untested_told(found: Analysis) -> list[str]:
    """Columns of people by which they could not be compared, and why."""
    untested = () if found.people is None else found.people.untested
    return [
        f"column {one.column} is not compared between people: "
        + _UNTESTED[one.reason].format(cells=listed(one.cells, 3))
        for one in untested[:_MOST_UNTESTED]
    ]


def _times_told(found: Analysis) -> list[str]:
    """That a column seems to hold response times and is not used, for its unit is unknown."""
    from nacreous.scaling.data.program import may_be_response_time

    if found.answers is None or found.answers.response_s is not None:
        return []
    names = [name for name in found.answers.groups if may_be_response_time(name)]
    return [
        f"column {name} is not used as response times; allowed: --column "
        f"{shlex.quote(f'response_ms={name}')}, or response_s="
        for name in names[:1]
    ]


def _people_told(found: Analysis) -> list[str]:
    """Before the scale, that it is not that of each of the people; nothing where it may be."""
    people, apart = found.people, []
    if found.apart_by:
        by = f"taken apart by {listed(found.apart_by)}, answers differ by more than chance"
        single = "" if found.single_people_differ else "the answers do not follow one scale: "
        apart = [single + by]
    if people is None or not people.differ:
        return apart
    lines = [people.shared.verdict(found.settings.level), *apart]
    described = people.population
    if described is None:
        return lines
    if described.kind == "classes":
        shares = ", ".join(f"{one.share:.2f}" for one in described.classes)
        said = f"{len(described.classes)} classes of people: {shares}"
        last = described.classes[1].correlation
        said += f"; correlation {last:z.2f}" if len(described.classes) == 2 else ""
    elif described.kind == "spread":
        said = _spread_told(described)
    elif described.kind == "spread or classes":
        said = "values of their own or classes of people: these answers cannot tell which"
    else:
        said = "too slightly to describe how"
    return [*lines, said]


def _spread_told(described: Population) -> str:
    """How much people's own values vary, or that it cannot be told."""
    own = "z" if described.model == "probit" else "logit"
    low, high = described.spread_low or 0.0, described.spread_high
    if described.spread is None or high is None:
        what = f"{low:.2f} {own} or more, how much more cannot be told"
    else:
        what = f"{described.spread:.2f} {own} ({low:.2f} to {high:.2f})"
    return f"values of their own, standard deviation {what}; classes describe them no better"


_BY = {
    "people": "resampling people",
    "answers": "resampling answers",
    "clusters": "people as clusters, Student's t",
    "jackknife": "people left out one by one, Student's t",
    "information": "the model",
}

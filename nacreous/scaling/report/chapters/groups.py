"""Groups of people side by side."""

from __future__ import annotations

from nacreous.scaling.compare.groups import GroupComparison
from nacreous.scaling.compare.style import GroupStyle
from nacreous.scaling.figure import interval_plot, scale_plot
from nacreous.scaling.fit.unit import factor
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.chapters.scale import MOST_ROWS
from nacreous.scaling.report.groups import Groups
from nacreous.scaling.report.picture import picture
from nacreous.scaling.report.table import table
from nacreous.scaling.report.translation import Html, Words, chance, number, percent

__all__ = ["chapter", "style_of"]

#: As many as the drawing has marks for.
_MOST_COLOURS = 6
_MOST_DIFFERENCES = 30
_MOST_SIZES = 30
#: What is said of a way of answering where groups differ in it, and where not.
_STYLES = {
    "ties": ("groups.ties_differ", "groups.ties_alike"),
    "side": ("groups.side_differ", "groups.side_alike"),
}


def chapter(analysis: Analysis, words: Words) -> Html:
    """Verdict, who is in which group, the scales below each other, what stands differently."""
    if analysis.groups is None:
        return Html("")
    found, level = analysis.groups.found, analysis.settings.level
    left_out = _left_out(analysis.groups, words)
    if found is None:
        return Html(words.paragraph("groups.untold") + _sizes(analysis, words) + left_out)
    apart = "groups.alike_places" if analysis.groups.styles(level) else "groups.alike"
    key = "groups.differ" if analysis.groups.differ(level) else apart
    verdict = words.sentences(
        words(key, p=words.equals(chance(found.p_value))),
        words(f"groups.method.{found.tests[0].name}"),
        *([words("groups.side_untold")] if analysis.groups.may_be_side(level) else []),
    )
    return Html(
        f"<p>{verdict}</p>\n"
        + _styles(found, level, words)
        + _sizes(analysis, words)
        + left_out
        + _plots(analysis, found, words)
        + _differences(analysis, found, words)
    )


def _styles(found: GroupComparison, level: float, words: Words) -> Html:
    """How readily groups tie and how the side draws them, apart from places."""
    if not found.styles:
        return Html("")
    said = [style_of(one, level, words) for one in found.styles]
    said += [words("groups.style_method")]
    said += [words("groups.style_corrected")] if len(found.styles) > 1 else []
    return Html(f"<p>{words.sentences(*said)}</p>\n")


def style_of(style: GroupStyle, level: float, words: Words) -> Html:
    """Whether groups differ in a way of answering, in a sentence."""
    p = words.equals(chance(style.p_adjusted))
    if not style.differs(level):
        return words(_STYLES[style.name][1], p=p)
    return words(
        _STYLES[style.name][0],
        most=words.name(style.most),
        least=words.name(style.least),
        more=percent(style.shares[style.most]),
        less=percent(style.shares[style.least]),
        p=p,
    )


def _left_out(groups: Groups, words: Words) -> Html:
    """A sentence for each reason why groups could not be compared."""
    said = Html("")
    for reason in ("few", "unplaced"):
        names = [one.name for one in groups.left_out if one.reason == reason]
        if names:
            said = Html(said + words.paragraph(f"groups.{reason}", names=words.names(names)))
    return said


def _sizes(analysis: Analysis, words: Words) -> Html:
    if analysis.answers is None or analysis.settings.group is None:
        return Html("")
    items = ""
    sizes = analysis.answers.sizes(analysis.settings.group)
    for name, (people, answers) in list(sizes.items())[:_MOST_SIZES]:
        said = words(
            "groups.size" if people else "groups.size_answers",
            name=words.name(name),
            people=words.count("person", people),
            answers=words.count("answer", answers),
        )
        items += f"<li>{said}</li>\n"
    if len(sizes) > _MOST_SIZES:
        items += f"<li>{words('list.more', n=len(sizes) - _MOST_SIZES)}</li>\n"
    return Html(f"<ul>\n{items}</ul>\n")


def _plots(analysis: Analysis, groups: GroupComparison, words: Words) -> Html:
    unit = words.unit(analysis.fit.unit)
    fits = {name: fit.to(analysis.fit.unit) for name, fit in groups.fits.items()}
    shown = picture(
        lambda path, width: scale_plot(fits, path, unit=unit, width_pt=width),
        "groups",
        words.alt("groups.alt"),
        words("groups.lead"),
    )
    if len(fits) > _MOST_COLOURS or len(analysis.fit.stimuli) > MOST_ROWS:
        return Html(shown + words.paragraph("groups.too_many"))
    kind = "people" if groups.clustered else "expected"
    bounds = {name: fit.intervals(analysis.settings.level, kind=kind) for name, fit in fits.items()}
    level = f"{100 * analysis.settings.level:g}"
    doubt = picture(
        lambda path, width: interval_plot(fits, path, intervals=bounds, unit=unit, width_pt=width),
        "groups-doubt",
        words.alt("groups.interval_alt"),
        words("scale.interval_caption", level=level),
    )
    return Html(shown + doubt)


def _differences(analysis: Analysis, groups: GroupComparison, words: Words) -> Html:
    times = factor("z" if groups.model == "probit" else "logit", analysis.fit.unit)
    beyond = [one for one in groups.differences if one.p_adjusted < 1 - analysis.settings.level]
    if not beyond:
        return words.paragraph("groups.stands_none")
    rows = []
    for one in sorted(beyond, key=lambda each: each.p_adjusted)[:_MOST_DIFFERENCES]:
        first, second, low, high = one.first, one.second, one.low, one.high
        if one.difference < 0:
            first, second, low, high = second, first, -high, -low
        span = words.span(low * times, high * times)
        rows.append(
            (
                words.name(one.stimulus),
                words.name(first),
                words.name(second),
                Html(f"{number(abs(one.difference) * times)} <small>{span}</small>"),
                chance(one.p_adjusted),
            )
        )
    heads = [
        words("scale.stimulus"),
        words("groups.first"),
        words("groups.second"),
        words("neighbours.difference"),
        words("neighbours.p"),
    ]
    return Html(words.paragraph("groups.stands") + table(heads, rows, ["", "", "", "n", "n"]))

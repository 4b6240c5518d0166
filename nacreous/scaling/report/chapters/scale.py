"""The scale: its drawings and its table."""

from __future__ import annotations

from math import erf, exp

import numpy as np

from nacreous.scaling.figure import interval_plot, scale_plot
from nacreous.scaling.fit.unit import factor
from nacreous.scaling.report import called
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.doubt import FEW_PEOPLE
from nacreous.scaling.report.picture import picture
from nacreous.scaling.report.table import table
from nacreous.scaling.report.translation import Html, Words, number, percent, thousands

__all__ = ["chapter", "doubt"]

#: Beyond, rows of dots are a wall; the table has them all.
MOST_ROWS = 60


def chapter(analysis: Analysis, words: Words) -> Html:
    """Line, intervals, how to read them, table."""
    fit, level = analysis.fit, analysis.settings.level
    ends = {"first": analysis.ranking[0], "last": analysis.ranking[-1]}
    unit = words.unit(fit.unit)
    line = picture(
        lambda path, width: scale_plot(fit, path, unit=unit, width_pt=width),
        "line",
        words.alt("scale.line_alt", **ends),
        words("scale.line_caption"),
    )
    parts = [words.paragraph("scale.lead"), line]
    if len(fit.stimuli) <= MOST_ROWS:
        bounds = analysis.doubt.intervals
        ends_open = analysis.doubt.open_ends(fit.stimuli)
        parts.append(
            picture(
                lambda path, width: interval_plot(
                    fit, path, intervals=bounds, open_ends=ends_open, unit=unit, width_pt=width
                ),
                "doubt",
                words.alt("scale.interval_alt", **ends),
                words("scale.endless_caption")
                if analysis.doubt.endless
                else words("scale.interval_caption", level=f"{100 * level:g}"),
            )
        )
    else:
        parts.append(words.paragraph("scale.too_many"))
    parts += [_example(analysis, words), doubt(analysis, words), _table(analysis, words)]
    parts.append(called.note(analysis, words))
    return Html("".join(parts))


def _example(analysis: Analysis, words: Words) -> Html:
    """A distance in words: from the first to the one in the middle; none where there is none."""
    if analysis.is_level:
        return Html("")
    order = analysis.order
    first, second = order[0], order[(len(order) + 1) // 2 if len(order) > 2 else 1]
    fit = analysis.fit
    return words.paragraph(
        "scale.example_ties" if analysis.comparisons.ties.any() else "scale.example",
        first=words.name(fit.stimuli[first]),
        second=words.name(fit.stimuli[second]),
        distance=number(fit.scale[first] - fit.scale[second]),
        percent=percent(float(fit.proportions[first, second])),
        one=_one(analysis, words),
    )


def _one(analysis: Analysis, words: Words) -> Html:
    """What one unit is; not said with ties, where it hangs on how many there are."""
    if analysis.fit.tie_threshold is not None:
        return Html("")
    own = analysis.fit.own_unit
    lead = factor(analysis.fit.unit, own)
    share = 0.5 * (1 + erf(lead / 2**0.5)) if own == "z" else 1 / (1 + exp(-lead))
    return words("scale.one", percent=percent(share))


def doubt(analysis: Analysis, words: Words) -> Html:
    """Where the margins come from, and when not to trust them."""
    people = () if analysis.answers is None else analysis.answers.people
    found = analysis.doubt
    sentences = [words("scale.zero")]
    if len(people) > 1:
        told = analysis.people is not None and analysis.people.spread_told
        probit = analysis.fit.model == "probit"
        sentences.append(words(f"scale.average.{'spread' if told and probit else 'wider'}"))
    sentences += [
        words(
            f"scale.doubt.{found.by}",
            samples=thousands(found.samples),
            people=words.count("person", len(people)),
        ),
    ]
    posterior = analysis.fit.posterior
    if posterior is not None:
        spread = posterior.spread * factor(analysis.fit.own_unit, analysis.fit.unit)
        sentences.append(words("scale.spread", spread=number(spread)))
    if analysis.fit.method == "bias-reduced":
        sentences.append(words("scale.reduced"))
    if found.samples:
        sentences.append(_unplaced(analysis, words))
    if found.endless:
        sets = Html(" | ").join(words.names(each, 12) for each in found.endless)
        sentences.append(words("scale.doubt.endless", sets=Html(sets)))
    if found.too_few:
        sentences.append(words("scale.doubt.too_few"))
    if found.by in ("people", "clusters", "jackknife") and len(people) < FEW_PEOPLE:
        sentences.append(words("scale.doubt.few", people=words.count("person", len(people))))
    if found.by in ("answers", "information") and analysis.goodness.describes is False:
        sentences.append(words("scale.doubt.misfit"))
    return Html(f'<p class="quiet">{words.sentences(*sentences)}</p>\n')


def _unplaced(analysis: Analysis, words: Words) -> Html:
    """How many samples had no scale of their own; with more than a few, none is used."""
    found = analysis.doubt
    many = found.by in ("clusters", "information")
    key = "many" if many else "few" if found.without_maximum else "none"
    return words(
        f"scale.unplaced.{key}",
        count=thousands(found.without_maximum),
        samples=thousands(found.samples),
    )


def _table(analysis: Analysis, words: Words) -> Html:
    fit, bounds = analysis.fit, analysis.doubt.intervals
    ends = analysis.doubt.open_ends(fit.stimuli)
    wins = analysis.comparisons.matrix.sum(axis=1)
    ties = analysis.comparisons.tie_matrix.sum(axis=1)
    total = wins + ties + analysis.comparisons.matrix.sum(axis=0)
    of = "scale.of_ties" if ties.any() else "scale.of"
    rows: list[tuple[object, ...]] = [
        (
            str(rank + 1),
            words.name(fit.stimuli[at]),
            number(fit.scale[at]),
            words.span(
                *(None if gone else end for end, gone in zip(bounds[at], ends[at], strict=True))
            ),
            words(of, wins=_count(wins[at]), ties=_count(ties[at]), total=_count(total[at])),
        )
        for rank, at in enumerate(analysis.order)
    ]
    level = f"{100 * analysis.settings.level:g}"
    heads = [
        words("scale.rank"),
        words("scale.stimulus"),
        words("scale.value"),
        words("scale.margin", level=level),
        words("scale.chosen"),
    ]
    kinds = ["n rank", "", "n", "n", "n"]
    cells = called.cells(analysis, words)
    if cells is not None:
        heads, kinds = [*heads, words("called.head")], [*kinds, ""]
        rows = [(*row, cells[label]) for row, label in zip(rows, analysis.ranking, strict=True)]
    return table(heads, rows, kinds)


def _count(value: float) -> str:
    return thousands(float(np.round(value, 6)))

"""Whether people share one scale, in which way they differ, and what goes with it."""

from __future__ import annotations

import numpy as np

from nacreous.scaling.check.population import Population
from nacreous.scaling.fit.unit import factor
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.people import People
from nacreous.scaling.report.table import facts, table
from nacreous.scaling.report.translation import Html, Words, chance, number, percent

__all__ = ["chapter", "described"]

_MOST_COVARIATES = 20
#: People from which on classes and spread are told apart in most studies (docs/people.md).
_MOSTLY_TOLD = 15
#: Correlation of two classes' scales below which one is called near the reverse of the other.
_OPPOSITE = -0.8


def chapter(analysis: Analysis, words: Words) -> Html:
    """Verdict, ways, description of the people, columns that go with it."""
    people = analysis.people
    if people is None:
        return words.paragraph("people.untested")
    p = words.equals(chance(people.shared.p_value))
    if not people.differ:
        parts = [_alike(analysis, people, p, words)]
    else:
        parts = [words.paragraph("people.differ", p=p), _ways(analysis, people, words)]
        if people.population is not None:
            parts.append(words.paragraph("people.chosen"))
            parts.append(Html(f"<p>{described(analysis, people.population, words)}</p>\n"))
            parts.append(_classes(people.population, words))
            parts.append(_candidates(people.population, words))
    parts.append(_covariates(analysis, people, words))
    parts.append(_untested(people, words))
    return Html("".join(parts))


def _alike(analysis: Analysis, people: People, p: Html, words: Words) -> Html:
    """That no single people stand out, whether columns tell them apart, and what may be unseen."""
    if analysis.people_apart_by:
        columns = words.names(analysis.people_apart_by)
        singly = "people.singly" if people.shared.tells else "people.singly_blind"
        found = words("people.apart_by", columns=columns)
        return Html(f"<p>{words.sentences(found, words(singly, p=p))}</p>\n")
    if not people.shared.tells:
        return words.paragraph("people.blind", p=p)
    own = people.shared.detectable * factor("z", analysis.fit.unit)
    found = words("people.detectable", spread=number(own, 1))
    return Html(f"<p>{words.sentences(words('people.alike', p=p), found)}</p>\n")


def described(analysis: Analysis, found: Population, words: Words) -> Html:
    """The people in a sentence: one scale, a spread, or classes."""
    if found.kind == "one scale":
        return words("people.one")
    if found.kind == "spread":
        return _spread(analysis, found, words)
    if found.kind == "spread or classes":
        few = analysis.answers is not None and len(analysis.answers.people) < _MOSTLY_TOLD
        more = words("people.untold_few" if few else "people.untold_more", least=_MOSTLY_TOLD)
        return words.sentences(words("people.untold"), more)
    shares = words.listed([percent(one.share) for one in found.classes])
    said = [words("people.classes", count=len(found.classes), shares=shares)]
    if len(found.classes) == 2:
        opposite = found.classes[1].correlation < _OPPOSITE
        key = "people.opposite" if opposite else "people.related"
        said.append(words(key, r=number(found.classes[1].correlation)))
    return words.sentences(*said)


def _spread(analysis: Analysis, found: Population, words: Words) -> Html:
    """How much people's own values vary, with its interval, or that it is not told."""
    times = factor(_own_unit(found), analysis.fit.unit)
    low = number((found.spread_low or 0.0) * times)
    if found.spread is None or found.spread_high is None:
        return words("people.spread_untold", low=low, unit=analysis.fit.unit)
    return words(
        "people.spread",
        spread=number(found.spread * times),
        low=low,
        high=number(found.spread_high * times),
        level=f"{100 * analysis.settings.level:g}",
    )


def _ways(analysis: Analysis, people: People, words: Words) -> Html:
    """Other orders apart from sharper, or the other way round."""
    shared, risk = people.shared, 1 - analysis.settings.level
    said = []
    if shared.order_p_value < risk:
        said.append(words("people.order", p=words.equals(chance(shared.order_p_value))))
    if shared.sharper_p_value < risk:
        said.append(words("people.sharper", p=words.equals(chance(shared.sharper_p_value))))
        # Of a sum of classes the direction means little, and the classes say more.
        if shared.reversed and (people.population is None or not people.population.classes):
            count = words.count("person", len(shared.reversed))
            said.append(words("people.reversed", people=count))
    if not said:
        said.append(words("people.unclear"))
    said.append(words("people.sides"))
    return Html(f"<p>{words.sentences(*said)}</p>\n")


def _classes(found: Population, words: Words) -> Html:
    """A row a class, with its own order."""
    rows = [
        (
            words("people.class", n=at + 1),
            percent(one.share),
            str(len(one.people)),
            words.row([found.stimuli[k] for k in np.argsort(-one.scale, kind="stable")]),
            number(one.correlation),
        )
        for at, one in enumerate(found.classes)
    ]
    if not rows:
        return Html("")
    heads = [
        words("people.class_head"),
        words("people.share"),
        words("people.members"),
        words("people.ranking"),
        words("people.correlation"),
    ]
    scales = [
        (
            words.name(label),
            *(number(one.scale[at]) for one in found.classes),
        )
        for at, label in enumerate(found.stimuli)
    ]
    columns = [words("people.class", n=at + 1) for at in range(len(rows))]
    own = table([words("scale.stimulus"), *columns], scales, ["", *["n"] * len(rows)])
    return Html(
        table(heads, rows, ["", "n", "n", "", "n"])
        + words.paragraph("people.scales", unit=words.unit(_own_unit(found)))
        + own
    )


def _own_unit(found: Population) -> str:
    return "z" if found.model == "probit" else "logit"


def _candidates(found: Population, words: Words) -> Html:
    items = [
        (
            _called(one.name, words),
            words("people.bic_lone" if one.lone else "people.bic", value=number(one.bic, 1)),
        )
        for one in found.candidates
    ]
    return Html(f'<p class="quiet">{words("people.candidates")}</p>\n' + facts(items))


def _called(name: str, words: Words) -> Html:
    if name == "one scale":
        return words("people.candidate.one_scale")
    if name == "spread":
        return words("people.candidate.spread")
    return words("people.candidate.classes", count=name.split()[0])


def _untested(people: People, words: Words) -> Html:
    """Columns that cannot be compared, and why."""
    if not people.untested:
        return Html("")
    columns = [
        words(
            f"people.not_compared_{one.reason.replace(' ', '_')}",
            column=words.name(one.column),
            cells=words.names(one.cells, 3),
        )
        for one in people.untested[:_MOST_COVARIATES]
    ]
    return words.paragraph("people.not_compared", columns=words.sentences(*columns))


def _covariates(analysis: Analysis, people: People, words: Words) -> Html:
    if not people.covariates:
        return Html("")
    rows = []
    for one in sorted(people.covariates, key=lambda each: each.p_adjusted)[:_MOST_COVARIATES]:
        found = one.differs(analysis.settings.level)
        split = "" if one.split is None else words("people.up_to", value=f"{one.split:g}")
        rows.append(
            (
                words.name(one.column),
                words("people.goes" if found else "people.stays"),
                split if found else "",
                chance(one.p_value),
                chance(one.p_adjusted),
            )
        )
    heads = [
        words("people.column"),
        words("people.verdict"),
        words("people.split"),
        words("people.p_value"),
        words("neighbours.p"),
    ]
    lead = words.paragraph("people.covariates")
    apart = table(heads, rows, ["", "", "", "n", "n"])
    return Html(lead + apart + _sides(analysis, people, words))


def _sides(analysis: Analysis, people: People, words: Words) -> Html:
    """Columns of people whom the side draws differently, which is no other judging."""
    said = [
        words(
            "people.side_by",
            column=words.name(one.column),
            p=words.equals(chance(one.side_p_adjusted)),
        )
        for one in people.covariates
        if one.side_p_adjusted is not None and one.side_differs(analysis.settings.level)
    ]
    return Html(f"<p>{words.sentences(*said[:_MOST_COVARIATES])}</p>\n") if said else Html("")

"""In short: the findings as plain sentences, before any number."""

from __future__ import annotations

from nacreous.scaling.check.worst import Misfit
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.chapters.groups import style_of
from nacreous.scaling.report.chapters.people import described
from nacreous.scaling.report.translation import Html, Words, number, percent, thousands

__all__ = ["chapter"]


def chapter(analysis: Analysis, words: Words) -> Html:
    """The findings, as a list."""
    found = [_side(analysis, words)] if analysis.side_decides else []
    found += [_people(analysis, words)] if analysis.people_differ else []
    if analysis.ties_unfitted:
        found.append(words("short.ties_unfitted", ties=percent(analysis.tied)))
    found.append(_places(analysis, words))
    found += [_apart(analysis, words)] if analysis.anything_apart else []
    found.append(_fit(analysis, words))
    found += [_side(analysis, words)] if analysis.side_draws and not analysis.side_decides else []
    agreed = _agreement(analysis, words)
    found += [agreed] if agreed else []
    found += _groups(analysis, words)
    items = "".join(f"<li>{sentence}</li>\n" for sentence in found)
    return Html(f'<ul class="short">\n{items}</ul>\n')


def _groups(analysis: Analysis, words: Words) -> list[Html]:
    """That groups have the same places as far as is told, and in which ways they answer apart."""
    groups, level = analysis.groups, analysis.settings.level
    if groups is None:
        return []
    column, styles = words.name(analysis.settings.group), groups.styles(level)
    said = [style_of(one, level, words) for one in styles]
    if not analysis.groups_differ:
        alike = "groups_places" if styles else "groups_alike"
        key = "groups_untold" if groups.differ(level) is None else alike
        said = [words(f"short.{key}", column=column), *said]
    elif groups.may_be_side(level):
        said.append(words("short.side_untold", column=column))
    return [words.sentences(*said)] if said else []


def _side(analysis: Analysis, words: Words) -> Html:
    side = analysis.consistency.side
    share = percent(0.0 if side is None else side.left.share)
    return words("short.side_decides" if analysis.side_decides else "short.side", share=share)


def _people(analysis: Analysis, words: Words) -> Html:
    people, columns = analysis.people, words.names(analysis.apart_by)
    if not analysis.single_people_differ:
        return words("short.parts_differ", columns=columns)
    said = [words("short.people_differ")]
    if people is not None and people.population is not None:
        said.append(described(analysis, people.population, words))
    if analysis.apart_by:
        said.append(words("short.apart_by", columns=columns))
    return words.sentences(*said)


def _places(analysis: Analysis, words: Words) -> Html:
    ranking, asked = analysis.ranking, words.question(analysis.settings.question, analysis.example)
    if not analysis.anything_apart:
        key = "short.level" if analysis.is_level else "short.open"
        return words(key, room=_room(analysis, words))
    sure = analysis.neighbours[0].apart
    key = ("first" if asked else "unasked") + ("" if sure else "_open")
    ends = words(
        f"short.{key}",
        question=None if asked is None else words.quoted(asked),
        first=words.name(ranking[0]),
        last=words.name(ranking[-1]),
        second=words.name(ranking[1]),
    )
    if len(ranking) < 3:
        return ends
    return words.sentences(ends, words("short.order", order=words.row(ranking)))


def _room(analysis: Analysis, words: Words) -> Html:
    """How large a difference the answers leave possible."""
    pairs = analysis.differences or analysis.neighbours
    if any(pair.endless for pair in pairs):
        return words("short.room_endless")
    most = max(max(abs(pair.low), abs(pair.high)) for pair in pairs)
    return words("short.room", most=number(most), level=f"{100 * analysis.settings.level:g}")


def _apart(analysis: Analysis, words: Words) -> Html:
    runs = _runs(analysis)
    if not runs:
        return words("short.all_apart")
    if len(runs) == 1 and len(runs[0]) == len(analysis.ranking):
        return words("short.none_apart_far")
    return words("short.some_apart", runs=words.listed([words.chain(run) for run in runs], 12))


def _runs(analysis: Analysis) -> list[list[str]]:
    """Things that follow each other without a step that is more than chance."""
    runs = [[analysis.ranking[0]]]
    for pair in analysis.neighbours:
        if pair.apart:
            runs.append([])
        runs[-1].append(pair.second)
    return [run for run in runs if len(run) > 1]


def _fit(analysis: Analysis, words: Words) -> Html:
    if analysis.goodness.describes is None:
        return words("short.unfit_few" if analysis.goodness.df else "short.unfit")
    if analysis.goodness.describes:
        if analysis.fit_hidden_by is not None:
            return words(f"short.fits_{analysis.fit_hidden_by}", ties=percent(analysis.tied))
        if analysis.single_people_differ:
            return words("short.fits_sums")
        if analysis.apart_by:
            return words("short.fits_parts", columns=words.names(analysis.apart_by))
        return words("short.fits" if analysis.people_told else "short.fits_counts")
    return _misfit(analysis.goodness.largest, words)


def _misfit(worst: Misfit, words: Words) -> Html:
    """The pair that strays farthest: by its choices, or by its ties."""
    first, second = words.name(worst.first), words.name(worst.second)
    if worst.by_ties and worst.ties_expected is not None:
        expected = percent(worst.ties_expected)
        ties = percent(worst.ties)
        said = words(
            "short.misfits_equal", first=first, second=second, ties=ties, expected=expected
        )
    else:
        fitted = worst.ties_expected is not None
        said = words(
            "short.misfits_chosen" if fitted else f"short.misfits{'_ties' if worst.ties else ''}",
            ties=percent(worst.ties),
            first=first,
            second=second,
            observed=percent(worst.observed),
            expected=percent(worst.expected),
        )
    if worst.left is None:
        return said
    return words.sentences(said, words("short.misfits_left", left=words.name(worst.left)))


def _agreement(analysis: Analysis, words: Words) -> Html | None:
    agreed = analysis.consistency.agreement
    if agreed is None:
        return None
    level = analysis.settings.level
    sure = agreed.p_value < 1 - level and agreed.u > 0
    few = agreed.least_p_value >= 1 - level
    people = 0 if analysis.answers is None else len(analysis.answers.people)
    # Of many people of whom few chose anything, it is the choices that are too few.
    scarce = "agree_few" if agreed.people == people else "agree_few_choices"
    key = "agree" if sure else scarce if few else "disagree"
    same = percent((1 + agreed.u) / 2)
    said = [words(f"short.{key}", same=same, choices=thousands(agreed.answers))]
    if agreed.ties:
        said.append(words("consistency.agreement_ties", ties=percent(agreed.ties)))
    return words.sentences(*said)

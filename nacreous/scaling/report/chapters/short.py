"""In short: the findings as plain sentences, before any number."""

from __future__ import annotations

from nacreous.scaling.report.analysis import Study
from nacreous.scaling.report.words import Html, Words, percent

__all__ = ["chapter"]


def chapter(study: Study, words: Words) -> Html:
    """The findings, as a list."""
    found = [_places(study, words), _apart(study, words), _fit(study, words)]
    agreed = _agreement(study, words)
    found += [agreed] if agreed else []
    if study.groups is not None:
        differ = study.groups.p_value < 1 - study.settings.level
        key = "short.groups_differ" if differ else "short.groups_alike"
        found.append(words(key, column=words.name(study.settings.group)))
    items = "".join(f"<li>{sentence}</li>\n" for sentence in found)
    return Html(f'<ul class="short">\n{items}</ul>\n')


def _places(study: Study, words: Words) -> Html:
    ranking, asked = study.ranking, words.question(study.settings.question, study.example)
    sure = study.neighbours[0].apart
    key = ("first" if asked else "unasked") + ("" if sure else "_open")
    ends = words(
        f"short.{key}",
        question=asked,
        first=words.name(ranking[0]),
        last=words.name(ranking[-1]),
        second=words.name(ranking[1]),
    )
    if len(ranking) < 3:
        return ends
    return words.sentences(ends, words("short.order", order=words.row(ranking)))


def _apart(study: Study, words: Words) -> Html:
    runs = _runs(study)
    if not runs:
        return words("short.all_apart")
    if len(runs) == 1 and len(runs[0]) == len(study.ranking):
        return words("short.none_apart")
    return words("short.some_apart", runs=words.listed([words.chain(run) for run in runs], 12))


def _runs(study: Study) -> list[list[str]]:
    """Things that follow each other without a step that is more than chance."""
    runs = [[study.ranking[0]]]
    for pair in study.neighbours:
        if pair.apart:
            runs.append([])
        runs[-1].append(pair.second)
    return [run for run in runs if len(run) > 1]


def _fit(study: Study, words: Words) -> Html:
    if study.goodness.describes is None:
        return words("short.unfit_few" if study.goodness.df else "short.unfit")
    if study.goodness.describes:
        return words("short.fits")
    worst = study.goodness.largest
    return words(
        "short.misfits",
        first=words.name(worst.first),
        second=words.name(worst.second),
        observed=percent(worst.observed),
        expected=percent(worst.expected),
    )


def _agreement(study: Study, words: Words) -> Html | None:
    agreed = study.consistency.agreement
    if agreed is None:
        return None
    sure = agreed.p_value < 1 - study.settings.level and agreed.u > 0
    key = "short.agree" if sure else "short.disagree"
    return words(key, same=percent((1 + agreed.u) / 2))

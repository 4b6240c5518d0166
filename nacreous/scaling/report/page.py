"""The report as one HTML page that needs nothing else: drawings inside, no script, no request."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.chapters import (
    consistency,
    fit,
    groups,
    method,
    neighbours,
    people,
    scale,
    short,
)
from nacreous.scaling.report.translation import Html, Words, apart, is_japanese, thousands

__all__ = ["html"]

_STYLE = Path(__file__).with_name("page.css")

_CHAPTERS: dict[str, Callable[[Analysis, Words], Html]] = {
    "scale": scale.chapter,
    "neighbours": neighbours.chapter,
    "fit": fit.chapter,
    "people": people.chapter,
    "groups": groups.chapter,
    "consistency": consistency.chapter,
    "method": method.chapter,
}


def html(analysis: Analysis, language: str = "en", screens: Mapping[str, int] | None = None) -> str:
    """The page in a language, "en" or "ja". Same analysis, same text.

    screens: how many of the people have each mark of a screen check, where there were any.
    """
    words = Words(language, _is_japanese(analysis))
    column = words.name(analysis.settings.group) if analysis.settings.group else ""
    title = {key: words(f"{key}.title", column=column) for key in _CHAPTERS}
    used = {key: _CHAPTERS[key] for key in _order(analysis)}
    chapters = "".join(
        f'<section id="{key}">\n<h2>{title[key]}</h2>\n{write(analysis, words)}</section>\n'
        for key, write in used.items()
    )
    links = "\n".join(f'<a href="#{key}">{title[key]}</a>' for key in used)
    return f"""<!DOCTYPE html>
<html lang="{language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{_title(analysis, words, apart)}</title>
<style>
{_STYLE.read_text(encoding="utf-8")}</style>
</head>
<body>
<header>
<h1>{_title(analysis, words, words.quoted)}</h1>
{_asked(analysis, words)}{_screens(screens or {}, words)}</header>
<main>
<section id="short">
<h2>{words("short.title")}</h2>
{short.chapter(analysis, words)}<nav aria-label="{words("page.contents")}">
{links}
</nav>
</section>
{chapters}</main>
</body>
</html>
"""


def _is_japanese(analysis: Analysis) -> bool:
    """Whether labels of kanji alone are Japanese: by question, other labels or encoding."""
    around = [analysis.settings.question or "", *analysis.fit.stimuli]
    if analysis.encoding_guessed == "Shift-JIS":
        around.append("かな")
    return is_japanese(around)


def _order(analysis: Analysis) -> list[str]:
    """The chapters; before the scale come people and groups that do not share it."""
    said = {"groups": analysis.groups is not None, "people": analysis.answers is not None}
    keys = [key for key in _CHAPTERS if said.get(key, True)]
    first = ["people"] if analysis.single_people_differ or analysis.people_apart_by else []
    first += ["groups"] if analysis.groups_differ else []
    return sorted(keys, key=lambda key: key not in first)


def _title(analysis: Analysis, words: Words, quoted: Callable[[str], Html]) -> Html:
    """quoted: how the question is set; a browser's tab shows text alone."""
    asked = words.question(analysis.settings.question, analysis.example)
    title = words("page.title") if asked is None else words("page.asked", question=quoted(asked))
    return words("page.simulated", title=title) if analysis.settings.simulated else title


def _asked(analysis: Analysis, words: Words) -> Html:
    asked = words.question(analysis.settings.question, analysis.example)
    said = [words("head.unasked" if asked is None else "head.asked")]
    counts = analysis.comparisons.unsided()
    each = counts.left_wins + counts.right_wins + counts.ties
    people = 0 if analysis.answers is None else len(analysis.answers.people)
    said.append(
        words(
            "head.answered" if people else "head.counted",
            people=words.count("person", people),
            stimuli=words.count("stimulus", len(counts.stimuli)),
            answers=words.count("answer", counts.total),
            pairs=words.count("pair", len(each)),
            each=_range(each, words),
        )
    )
    missing = len(counts.stimuli) * (len(counts.stimuli) - 1) // 2 - len(each)
    if missing:
        said.append(words("head.missing", pairs=words.count("pair", missing)))
    if counts.ties.any():
        said.append(words("head.ties", ties=thousands(float(counts.ties.sum()))))
    said += _left_out(analysis, words) + _as_read(analysis, words)
    shown = f"<p>{words.sentences(*said)}</p>\n"
    if analysis.settings.simulated:
        shown = f'<p class="note"><b>{words("head.simulated")}</b></p>\n' + shown
    if analysis.example:
        shown += f'<p class="note">{words("head.paper")}</p>\n'
    return Html(shown)


def _screens(marks: Mapping[str, int], words: Words) -> Html:
    """What fell short of screens, and how many people's."""
    if not marks:
        return Html("")
    found = [
        words(
            "head.screen",
            mark=words(f"screen.{mark}"),
            people=words.count("person", people),
        )
        for mark, people in marks.items()
    ]
    return words.paragraph("head.screens", marks=words.listed(found))


#: What is said of rows that do not count, by a key of `REASONS`.
_UNCOUNTED = {
    "question": "head.left_question",
    "practice": "head.left_practice",
    "catch": "head.left_catch",
    "simulated": "head.left_simulated",
    "people": "head.left_people",
    "excluded": "head.left_excluded",
    "marked": "head.left_marked",
}


def _left_out(analysis: Analysis, words: Words) -> list[Html]:
    """How many rows of the table are left out, and why."""
    if analysis.answers is None:
        return []
    unanswered = analysis.answers.unanswered
    unpaired = analysis.answers.left_out - unanswered
    found = {"head.unpaired": unpaired, "head.unanswered": unanswered}
    found |= {_UNCOUNTED[why]: rows for why, rows in analysis.answers.uncounted.items()}
    return [words(key, rows=words.count("row", count)) for key, count in found.items() if count]


def _as_read(analysis: Analysis, words: Words) -> list[Html]:
    """What of the file was read by a guess, and words that were read as nothing."""
    found = []
    if analysis.encoding_guessed:
        found.append(words("head.guessed", encoding=analysis.encoding_guessed))
    groups = {} if analysis.answers is None else analysis.answers.groups
    columns = [
        words("head.nothing_in", cells=words.names(group.nothing), column=words.name(name))
        for name, group in groups.items()
        if group.nothing
    ]
    return found + ([words("head.nothing", columns=words.listed(columns))] if columns else [])


def _range(each: np.typing.NDArray[np.float64], words: Words) -> Html:
    least, most = thousands(float(each.min())), thousands(float(each.max()))
    if least == most:
        return Html(least)
    return words("head.between", least=least, most=most)

"""What a table of words calls things by their numbers, beside their places on the scale."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from nacreous.scaling.report.translation import Html, Words, markup
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.scaling.report.analysis import Analysis

__all__ = ["Called", "cells", "note", "record"]


@value_class
class Called:
    """A word for a thing: of which factor, by which number, and what the word stands for.

    factor, word, source: in English and in Japanese; source: who says so.
    number: "facet_spread_rad 0.116 rad". bounds: the numbers that the word stands for,
    "facet_spread_rad 0.09 to 0.15 rad".
    """

    factor: tuple[str, str]
    word: tuple[str, str]
    number: str
    bounds: str
    source: tuple[str, str]


def cells(analysis: Analysis, words: Words) -> dict[str, Html] | None:
    """The words in which things differ, by label; None where there are none, or all share them."""
    shared = _shared(analysis)
    found = {
        label: [one for one in analysis.called.get(label, ()) if _word(one) not in shared]
        for label in analysis.fit.stimuli
    }
    if not any(found.values()):
        return None
    return {
        label: Html("".join(f"<div>{_said(one, words, one.number)}</div>" for one in each))
        for label, each in found.items()
    }


def note(analysis: Analysis, words: Words) -> Html:
    """Whose words these are, those that all things share, and what each stands for; or nothing."""
    each = _each(analysis)
    if not each:
        return Html("")
    said = [words("called.lead")]
    at = 1 if words.language == "ja" else 0
    shared = _shared(analysis)
    alike = {_word(one): _said(one, words) for one in each if _word(one) in shared}
    if alike:
        said.append(words("called.shared", words=words.listed([*alike.values()])))
    meaning = {
        _word(one): words(
            "called.meaning",
            word=_said(one, words),
            bounds=one.bounds,
            source=markup(one.source[at]),
        )
        for one in each
    }
    items = "".join(f"<li>{one}</li>\n" for one in meaning.values())
    summary = words("called.meanings")
    return Html(
        f'<p class="quiet">{words.sentences(*said)}</p>\n'
        f'<details class="quiet"><summary>{summary}</summary><ul>\n{items}</ul></details>\n'
    )


def _each(analysis: Analysis) -> list[Called]:
    """All words of things on the scale, from its top."""
    return [one for label in analysis.ranking for one in analysis.called.get(label, ())]


def _shared(analysis: Analysis) -> set[tuple[str, str]]:
    """Factors with their words that every thing on the scale has."""
    of = [{_word(one) for one in analysis.called.get(label, ())} for label in analysis.fit.stimuli]
    return set.intersection(*of)


def _word(one: Called) -> tuple[str, str]:
    return one.factor[0], one.word[0]


def _said(one: Called, words: Words, number: str = "") -> Html:
    """The word in the page's language, and the other language's behind it."""
    first, second = (1, 0) if words.language == "ja" else (0, 1)
    other = "en" if words.language == "ja" else "ja"
    behind = Html(f'<span lang="{other}">{_both(one, second)}</span>')
    shown = words("called.word", word=_both(one, first), other=behind)
    return Html(f"{shown} <small>{markup(number)}</small>") if number else shown


def _both(one: Called, language: int) -> Html:
    return markup(f"{one.factor[language]} {one.word[language]}")


def record(called: Iterable[Called]) -> list[dict[str, object]]:
    """The words for JSON."""
    return [
        {
            "factor": dict(zip(("en", "ja"), one.factor, strict=True)),
            "word": dict(zip(("en", "ja"), one.word, strict=True)),
            "number": one.number,
            "bounds": one.bounds,
            "source": dict(zip(("en", "ja"), one.source, strict=True)),
        }
        for one in called
    ]

"""What can be told apart, and what not."""

from __future__ import annotations

from collections.abc import Iterable

from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.doubt import Pair
from nacreous.scaling.report.table import table
from nacreous.scaling.report.translation import Html, Words, chance, number, percent

__all__ = ["MOST_LISTED", "chapter"]

#: All pairs of so many things are 105 rows; beyond, they are in the JSON record.
MOST_LISTED = 15


def chapter(analysis: Analysis, words: Words) -> Html:
    """Each thing against the next one down, then all pairs."""
    lead = words.paragraph("neighbours.lead", risk=words.risk(analysis.settings.level))
    level = f"{100 * analysis.settings.level:g}"
    said = [words("neighbours.note", level=level)]
    said += [words("fit.ties_half")] if analysis.comparisons.ties.any() else []
    note = f'<p class="quiet">{words.sentences(*said)}</p>\n'
    neighbours = _table(analysis.neighbours, "pair", words)
    return Html(lead + neighbours + note + _all(analysis, words))


def _all(analysis: Analysis, words: Words) -> Html:
    count = len(analysis.fit.stimuli)
    if count < 3:
        return Html("")
    head = f"<h3>{words('neighbours.all')}</h3>\n"
    if count > MOST_LISTED:
        return Html(head + words.paragraph("neighbours.all_many"))
    pairs = words.count("pair", count * (count - 1) // 2)
    lead = words.paragraph("neighbours.all_lead", pairs=pairs)
    return Html(head + lead + _table(analysis.differences, "pairs", words))


def _table(pairs: Iterable[Pair], first: str, words: Words) -> Html:
    rows = [
        (
            words("neighbours.over", first=words.name(pair.first), second=words.name(pair.second)),
            Html(words("neighbours.yes" if pair.apart else "neighbours.no")),
            percent(pair.expected),
            Html(f"{number(pair.difference)} <small>{_span(pair, words)}</small>"),
            chance(pair.p_value),
        )
        for pair in pairs
    ]
    heads = [
        words(f"neighbours.{key}") for key in (first, "verdict", "expected", "difference", "p")
    ]
    return table(heads, rows, ["", "verdict", "n", "n", "n"])


def _span(pair: Pair, words: Words) -> Html:
    return words.span(pair.low, None if pair.endless else pair.high)

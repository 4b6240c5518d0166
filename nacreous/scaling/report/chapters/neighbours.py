"""What can be told apart, and what not."""

from __future__ import annotations

from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.table import table
from nacreous.scaling.report.translation import Html, Words, chance, number, percent

__all__ = ["chapter"]


def chapter(analysis: Analysis, words: Words) -> Html:
    """Each thing against the next one down."""
    rows = [
        (
            words("neighbours.over", first=words.name(pair.first), second=words.name(pair.second)),
            Html(words("neighbours.yes" if pair.apart else "neighbours.no")),
            percent(pair.expected),
            Html(f"{number(pair.difference)} <small>{words.span(pair.low, pair.high)}</small>"),
            chance(pair.p_value),
        )
        for pair in analysis.neighbours
    ]
    keys = ("pair", "verdict", "expected", "difference", "p")
    heads = [words(f"neighbours.{key}") for key in keys]
    lead = words.paragraph("neighbours.lead", risk=words.risk(analysis.settings.level))
    level = f"{100 * analysis.settings.level:g}"
    note = f'<p class="quiet">{words("neighbours.note", level=level)}</p>\n'
    return Html(lead + table(heads, rows, ["", "", "n", "n", "n"]) + note)

"""Cards as one HTML page that needs nothing else: pictures inside, no script, no request."""

from __future__ import annotations

import base64
import re
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous.card.making import command, own_keys
from nacreous.card.translation import Texts
from nacreous.printable import printable_lines

if TYPE_CHECKING:
    from nacreous.card.card import Card
    from nacreous.card.factor import Factor

__all__ = ["html"]

_STYLE = Path(__file__).with_name("page.css")
_HEADS = ("factor", "word", "number", "bounds")


def html(cards: Sequence[Card], language: str = "en", output: str = "card.html") -> str:
    """The page in a language, "en" or "ja". Same cards, same text.

    output: the file's name, for the command that makes it again.
    """
    texts = Texts(language)
    many = len(cards) > 1
    title = _safe(texts("title_many", count=len(cards)) if many else texts("title"))
    shown = "".join(_card(card, number, texts) for number, card in enumerate(cards, 1))
    return f"""<!DOCTYPE html>
<html lang="{texts.language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
{_STYLE.read_text(encoding="utf-8")}</style>
</head>
<body>
<header>
<h1>{title}</h1>
<p class="note">{_safe(texts("virtual"))}<br>{_safe(texts("not_graded"))}</p>
{_again(cards, texts, output)}</header>
<main>
{_batch(cards, texts) if many else ""}{shown}</main>
</body>
</html>
"""


def _safe(text: str) -> str:
    return escape(printable_lines(text))


def _again(cards: Sequence[Card], texts: Texts, output: str) -> str:
    line = command(cards, texts.language, output)
    if line is None:
        return f"<p>{_safe(texts('no_command'))}</p>\n"
    return f"<p>{_safe(texts('again'))} {_code(line)}</p>\n"


def _code(line: str) -> str:
    """A command, whose options are broken between, and within only where one is too long."""
    parts = re.split(r" (?=--?[a-z])", line)
    return f"<code>{' '.join(f'<span>{_safe(part)}</span>' for part in parts)}</code>"


def _batch(cards: Sequence[Card], texts: Texts) -> str:
    """The words of all pearls, one a row."""
    heads = [texts("pearl"), *(texts.name(factor) for factor in cards[0].factors[:-1])]
    head = "".join(f'<th scope="col">{_safe(one)}</th>' for one in heads)
    rows = "".join(_row(card, number, texts) for number, card in enumerate(cards, 1))
    return (
        f"<section><h2>{_safe(texts('batch'))}</h2>\n"
        f'<div class="scroll"><table class="batch"><thead><tr>{head}</tr></thead>\n'
        f"<tbody>{rows}</tbody></table></div></section>\n"
    )


def _row(card: Card, number: int, texts: Texts) -> str:
    cells = "".join(
        f'<td data-head="{_safe(texts.name(factor))}">{_short(factor, texts)}</td>'
        for factor in card.factors[:-1]
    )
    name = f'<a href="#pearl-{number}">{_safe(card.pearl.name)}</a>'
    return f'<tr><th scope="row">{name}</th>{cells}</tr>\n'


def _short(factor: Factor, texts: Texts) -> str:
    number = "".join(
        f"<small>{_safe(texts.value(one))} {_safe(texts(f'unit.{one.unit}'))}</small>"
        for one in factor.figures[:1]
    )
    return _safe(texts.word(factor)) + number


def _card(card: Card, number: int, texts: Texts) -> str:
    data = base64.b64encode(card.png).decode("ascii")
    alt = _safe(texts("picture_of", name=card.pearl.name, scene=card.scene_name))
    caption = texts("scene", scene=card.scene_name, size=card.size, samples=card.samples)
    heads = "".join(f'<th scope="col">{_safe(texts(f"head.{one}"))}</th>' for one in _HEADS)
    rows = "".join(_factor(factor, texts) for factor in card.factors)
    own = "\n".join(own_keys(card.pearl)) or texts("defaults")
    return f"""<article id="pearl-{number}">
<h2>{_safe(card.pearl.name)}</h2>
<div class="card">
<figure>
<img src="data:image/png;base64,{data}" width="{card.size}" height="{card.size}" alt="{alt}">
<figcaption>{_safe(caption)}</figcaption></figure>
<div>
<table class="factors"><thead><tr>{heads}</tr></thead>
<tbody>{rows}</tbody></table>
<details open><summary>{_safe(texts("spec"))}</summary><pre>{_safe(own)}</pre></details>
<details><summary>{_safe(texts("complete"))}</summary><pre>{_safe(card.pearl.to_toml())}</pre></details>
</div>
</div>
</article>
"""


def _factor(factor: Factor, texts: Texts) -> str:
    numbers = "".join(
        f'<span class="line">{_safe(texts.number(one))}'
        f"<small>{_safe(texts.origin(one))}</small></span>"
        for one in factor.figures
    )
    note = texts.note(factor)
    noted = f"<small>{_safe(note)}</small>" if note else ""
    return (
        f'<tr><th scope="row">{_safe(texts.name(factor))}</th>'
        f'<td class="word">{_safe(texts.word(factor))}</td><td>{numbers}{noted}</td>'
        f"<td>{_bounds(factor, texts)}</td></tr>\n"
    )


def _bounds(factor: Factor, texts: Texts) -> str:
    """What the word stands for, and who says so."""
    here = {figure.quantity for figure in factor.figures}
    ranges = () if factor.word is None else factor.word.ranges
    sources = dict.fromkeys(one.said_by(texts.language) for one in ranges if one.quantity in here)
    said = "".join(f"<small>{_safe(one)}</small>" for one in sources)
    return _safe(texts.bounds(factor)) + said

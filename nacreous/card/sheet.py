"""Cards as one picture."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Any
from unicodedata import east_asian_width

from nacreous.card.making import command, own_keys
from nacreous.figure import sheet
from nacreous.printable import printable

if TYPE_CHECKING:
    from nacreous.card.card import Card
    from nacreous.card.factor import Factor
    from nacreous.card.translation import Texts

__all__ = ["draw"]

#: Points: the page, its margins, a picture, a line of text, a card.
_WIDTH, _MARGIN, _PICTURE, _LINE, _CARD = 720.0, 24.0, 216.0, 11.0, 354.0
_TABLE = _MARGIN + _PICTURE + 20
#: Where the columns of a card's table begin.
_COLUMNS = (_TABLE, _TABLE + 92, _TABLE + 178)
_INK, _QUIET, _RULE = "#24262b", "#686c75", "#dcdcd8"
_MOST_KEYS = 6
_TITLE = 82.0


def draw(path: Path, cards: Sequence[Card], texts: Texts, output: str) -> None:
    """Draw the page: what it is, of several pearls all their words, and each card."""
    batch = 0.0 if len(cards) == 1 else 34 + 2 * _LINE * len(cards)
    made = _wrapped(command(cards, texts.language, output) or texts("no_command"), 118)
    top = _TITLE + _LINE * len(made)
    height = top + batch + _CARD * len(cards)
    with sheet(path, _WIDTH, height) as axes:
        _head(axes, cards, texts, made)
        if batch:
            _batch(axes, cards, texts, top + 8)
        for number, card in enumerate(cards):
            _card(axes, card, texts, top + batch + _CARD * number)


def _head(axes: Any, cards: Sequence[Card], texts: Texts, made: Sequence[str]) -> None:
    many = len(cards) > 1
    title = texts("title_many", count=len(cards)) if many else texts("title")
    _say(axes, _MARGIN, 30, title, 15)
    _say(axes, _MARGIN, 47, texts("virtual"), 8, _QUIET)
    _say(axes, _MARGIN, 59, texts("not_graded"), 8, _QUIET)
    _say(axes, _MARGIN, 74, texts("again"), 8, _QUIET)
    for number, line in enumerate(made):
        _say(axes, _MARGIN, 85 + _LINE * number, line, 8)


def _batch(axes: Any, cards: Sequence[Card], texts: Texts, top: float) -> None:
    """The words of all pearls, each above its first number."""
    factors = [factor for factor in cards[0].factors if factor.name != "matching"]
    step = (_WIDTH - 2 * _MARGIN - 84) / len(factors)
    places = [_MARGIN + 84 + step * number for number in range(len(factors))]
    _say(axes, _MARGIN, top + 8, texts("pearl"), 7, _QUIET)
    for place, factor in zip(places, factors, strict=True):
        _say(axes, place, top + 8, texts(f"short.{factor.name}"), 7, _QUIET)
    for number, card in enumerate(cards):
        y = top + 22 + 2 * _LINE * number
        _rule(axes, _MARGIN, y - 9.5)
        _say(axes, _MARGIN, y, _cut(card.pearl.name, 18), 7.5)
        for place, factor in zip(places, card.factors, strict=False):
            _say(axes, place, y, texts.word(factor), 7)
            for figure in factor.figures[:1]:
                shown = f"{texts.value(figure)} {texts(f'unit.{figure.unit}')}"
                _say(axes, place, y + 8.5, shown, 6, _QUIET)


def _card(axes: Any, card: Card, texts: Texts, top: float) -> None:
    _rule(axes, _MARGIN, top + 6)
    _say(axes, _MARGIN, top + 26, _cut(card.pearl.name, 60), 12)
    left, upper = _MARGIN, top + 36
    axes.imshow(
        card.codes,
        extent=(left, left + _PICTURE, upper + _PICTURE, upper),
        interpolation="antialiased",
        aspect="auto",
    )
    axes.set_xlim(0, _WIDTH)
    axes.set_ylim(axes.figure.get_figheight() * 72, 0)
    below = upper + _PICTURE + 12
    caption = texts("scene", scene=card.scene_name, size=card.size, samples=card.samples)
    for number, line in enumerate([*_wrapped(caption, 50), *_own(card, texts)]):
        _say(axes, _MARGIN, below + 8.5 * number, line, 6.5, _QUIET)
    for place, head in zip(_COLUMNS, ("factor", "word", "number"), strict=True):
        _say(axes, place, upper + 6, texts(f"head.{head}"), 7, _QUIET)
    y = upper + 8
    for factor in card.factors:
        y = _factor(axes, factor, texts, y)


def _own(card: Card, texts: Texts) -> list[str]:
    """The first of the file's own keys."""
    keys = [one for one in own_keys(card.pearl) if not one.startswith("name = ")]
    left = len(keys) - _MOST_KEYS
    more = [texts("more", count=left)] if left > 0 else []
    return [_cut(one, 62) for one in keys[:_MOST_KEYS]] + more


def _factor(axes: Any, factor: Factor, texts: Texts, top: float) -> float:
    """A row of the table; gives back where the next begins."""
    _rule(axes, _TABLE, top + 5)
    y = top + 16
    _say(axes, _COLUMNS[0], y, texts(f"short.{factor.name}"), 8)
    _say(axes, _COLUMNS[1], y, texts.word(factor), 8.5)
    lines = [(f"{texts.number(one)}   ({texts.origin(one)})", _INK) for one in factor.figures]
    lines += [(line, _QUIET) for line in _wrapped(texts.note(factor), 70)]
    for number, (line, colour) in enumerate(lines):
        _say(axes, _COLUMNS[2], y + 9.5 * number, line, 7, colour)
    return y + 9.5 * max(len(lines) - 1, 0)


def _rule(axes: Any, left: float, y: float) -> None:
    axes.plot([left, _WIDTH - _MARGIN], [y, y], color=_RULE, linewidth=0.6)


def _say(axes: Any, x: float, y: float, text: str, size: float, colour: str = _INK) -> None:
    axes.text(x, y, printable(text), fontsize=size, color=colour)


def _wide(text: str) -> int:
    """Columns that a text takes: two for each sign of Japanese."""
    return sum(2 if east_asian_width(letter) in "FWA" else 1 for letter in text)


def _cut(text: str, most: int) -> str:
    """The text, shortened where it is wider than so many columns."""
    if _wide(text) <= most:
        return text
    while _wide(text) > most - 1:
        text = text[:-1]
    return text + "…"


def _wrapped(text: str, columns: int) -> list[str]:
    """Lines of at most so many columns; Japanese breaks between any two signs."""
    if _wide(text) == len(text):
        return wrap(text, columns, break_on_hyphens=False)
    lines: list[str] = []
    line = ""
    for letter in text:
        if _wide(line + letter) > columns:
            lines, line = [*lines, line], ""
        line += letter
    return [*lines, line] if line else lines

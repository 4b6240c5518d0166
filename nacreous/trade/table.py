"""The table of the trade's words, read once."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import groupby
from pathlib import Path

from nacreous.number import number_of
from nacreous.problem import InputError
from nacreous.spec.complaint import nearest, shown
from nacreous.trade.word import Factor, Range, Word

__all__ = ["factor_of", "factors", "range_of", "word_named", "word_of", "words"]

_Row = dict[str, str]

#: More words than these, as of sizes, are told by their ends.
_MOST_LISTED = 20


@cache
def factors() -> tuple[Factor, ...]:
    """Every factor of the table, in its order.

    >>> [factor.name for factor in factors()][:3]
    ['size', 'shape', 'bodycolour']
    """
    with Path(__file__).with_name("words.csv").open(encoding="utf-8", newline="") as table:
        rows = [one for row in csv.DictReader(table) for one in _classes(row)]
    by_factor = groupby(rows, lambda row: (row["factor"], row["factor_ja"]))
    return tuple(Factor(*names, _words(names[0], list(found))) for names, found in by_factor)


def words(factor: str) -> tuple[Word, ...]:
    """The words of a factor, in the order in which they are tried. Raises `InputError`.

    >>> [word.en for word in words("surface")]
    ['clean', 'lightly spotted', 'moderately spotted', 'heavily spotted']
    """
    return factor_of(factor).words


def factor_of(name: str) -> Factor:
    """The factor of that name, in either language; `InputError` names what was probably meant.

    >>> factor_of("テリ").name
    'luster'
    """
    by_name = {one: factor for factor in factors() for one in (factor.name, factor.ja)}
    if name in by_name:
        return by_name[name]
    listed = [factor.name for factor in factors()]
    near = nearest(name, list(by_name))
    hint = f"did you mean {near}?" if near else _meant(name, listed)
    raise InputError(f"{shown(name)} is no factor; {hint}")


def word_named(factor: str, name: str) -> Word:
    """The word of that name, in either language and in any capitals.

    >>> word_named("nacre-akoya", "厚巻き").en, word_named("size", "7.0-7.5").en
    ('thick', '7.0-7.5 mm')
    """
    by_name = {_plain(one): word for word in words(factor) for one in (word.en, word.ja)}
    if _plain(name) in by_name:
        return by_name[_plain(name)]
    listed = [word.en for word in words(factor)]
    raise InputError(f"{factor} is {shown(name)}; {_meant(name, listed)}")


def word_of(factor: str, value: float | Mapping[str, float]) -> Word:
    """The word for a value of a factor.

    value: of the factor's first quantity; or values by quantity: all of the factor's where its
    words bind different ones, as those for shape and colours do, else any. The first word in the
    table that holds is given. Raises `InputError` for values that no word holds.

    >>> word_of("luster", 0.1).en, word_of("luster", {"shininess": 0.9}).en
    ('Fair', 'Excellent')
    >>> word_of("bodycolour", {"lightness": 95, "chroma": 3, "hue_deg": 24}).en
    'pink'
    """
    found = factor_of(factor)
    given = value if isinstance(value, Mapping) else {found.quantities[0]: value}
    values = {name: number_of(name, one) for name, one in given.items()}
    unknown = [name for name in values if name not in found.quantities]
    missing = [name for name in found.quantities if name not in values]
    if unknown or not values or (missing and not found.is_told_by_each):
        wanted = (" or " if found.is_told_by_each else ", ").join(found.quantities)
        raise InputError(f"{factor} is told by {', '.join(values) or 'nothing'}; wanted: {wanted}")
    for word in found.words:
        if word.holds(values):
            return word
    told = ", ".join(f"{name} {number:g}" for name, number in values.items())
    raise InputError(f"{factor} has no word for {told}; allowed: {_span(found, values)}")


def range_of(factor: str, word: str, quantity: str | None = None) -> Range:
    """The range of a word: of a quantity, or of the first that the word binds.

    >>> range_of("luster", "Good", "half_width_deg")
    Range(6.7 to 12.1 degrees)
    """
    found = word_named(factor, word)
    by_quantity = {one.quantity: one for one in found.ranges}
    if quantity is None:
        return found.ranges[0]
    if quantity in by_quantity:
        return by_quantity[quantity]
    raise InputError(
        f"{factor} {found.en} binds no {shown(quantity)}; allowed: {', '.join(by_quantity)}"
    )


def _span(factor: Factor, values: Mapping[str, float]) -> str:
    """What the words hold of the quantities given, from the least to the most."""
    spans = []
    for name in values:
        ranges = [one for word in factor.words for one in word.ranges if one.quantity == name]
        least, most = min(one.lower for one in ranges), max(one.upper for one in ranges)
        below = "" if math.isinf(most) else f" to {most:g}"
        spans.append(f"{name} from {least:g}{below}")
    return ", ".join(spans)


def _plain(word: str) -> str:
    """A word as it is compared."""
    return word.strip().casefold().removesuffix("mm").strip().replace("～", "-")


def _meant(word: str, choices: list[str]) -> str:
    near = nearest(word, choices)
    if near:
        return f"did you mean {near}?"
    listed = choices if len(choices) <= _MOST_LISTED else [*choices[:2], "...", choices[-1]]
    return f"allowed: {', '.join(listed)}"


def _classes(row: _Row) -> Iterator[_Row]:
    """A row; of one with a step the rows of its classes, as of sizes by half a millimetre."""
    if not row["step"]:
        yield row
        return
    lower, upper, step = (float(row[name]) for name in ("lower", "upper", "step"))
    for place in range(round((upper - lower) / step)):
        ends = [f"{lower + step * (place + at):.1f}" for at in (0, 1)]
        bounds = dict(zip(("lower", "upper"), ends, strict=True))
        middle = str(lower + step * (place + 0.5))
        texts = {name: row[name].format(**bounds) for name in ("word", "word_ja")}
        yield {**row, **bounds, **texts, "sets": middle}


def _words(factor: str, rows: list[_Row]) -> tuple[Word, ...]:
    ends: dict[str, float] = {}
    for row in rows:
        ends[row["quantity"]] = max(ends.get(row["quantity"], 0.0), _upper(row))
    by_word = groupby(rows, lambda row: (row["word"], row["word_ja"]))
    return tuple(
        Word(factor, en, ja, tuple(_range(row, ends[row["quantity"]]) for row in found))
        for (en, ja), found in by_word
    )


def _upper(row: _Row) -> float:
    return float(row["upper"] or math.inf)


def _range(row: _Row, end: float) -> Range:
    lower, upper, sets = float(row["lower"]), _upper(row), float(row["sets"] or math.nan)
    names = row["quantity"], row["unit"], row["key"]
    return Range(
        *names,
        lower,
        upper,
        sets,
        row["source"],
        closed=upper == end,
        source_ja=row["source_ja"],
    )

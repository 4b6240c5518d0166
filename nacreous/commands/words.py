"""`nacreous words`: what the trade says of a pearl, and the numbers that it stands for."""

from __future__ import annotations

import argparse
import math
from typing import TYPE_CHECKING

from nacreous.commands.terminal import say

if TYPE_CHECKING:
    from nacreous.trade import Factor, Range, Word
    from nacreous.trade.word import Language

_EXAMPLES = """\
examples:
  nacreous words                          the whole table
  nacreous words luster                   of one factor
  nacreous words luster --language ja     in Japanese
  nacreous words --json                   for programs
  nacreous render akoya-rg --word luster=Fair   what a word looks like
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "words",
        help="show the trade's words and the numbers they stand for",
        description="Show what the trade calls a pearl's size, shape, colour, luster, surface, "
        "nacre and matching, with the numbers that each word stands for and where these come from.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("factor", nargs="?", help="only this factor, such as luster")
    parser.add_argument(
        "--language", choices=("en", "ja"), default="en", help="English or Japanese (en)"
    )
    parser.add_argument("--json", action="store_true", help="both languages, as JSON")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Print the table."""
    from nacreous.trade.table import factor_of, factors

    found = factors() if args.factor is None else (factor_of(args.factor),)
    if args.json:
        import json

        say(json.dumps([_record(factor) for factor in found], ensure_ascii=False, indent=2))
        return 0
    say("\n".join(line for factor in found for line in _lines(factor, args.language)))
    return 0


def _lines(factor: Factor, language: Language) -> list[str]:
    """A factor's name, and below it a line for each range of each word."""
    lines = [f"{factor.ja if language == 'ja' else factor.name}:"]
    for word in factor.words:
        for number, one in enumerate(word.ranges):
            name = word.text(language) if number == 0 else ""
            lines.append(f"  {_padded(name, 20)}  {_said(one)} [{one.said_by(language)}]")
    return lines


def _said(one: Range) -> str:
    """What a range holds and the key that its word sets; the latter alone where it holds all."""
    sets = f"sets {one.key}" if one.key else ""
    if one.is_free:
        return f"{sets} = {one.sets:g}"
    return f"{one.quantity} {one.text}" + (f"; {sets}" if sets else "")


def _padded(text: str, width: int) -> str:
    """The text and blanks: signs of Japanese take two columns of a terminal."""
    from unicodedata import east_asian_width

    taken = sum(2 if east_asian_width(letter) in "FW" else 1 for letter in text)
    return text + " " * (width - taken)


def _record(factor: Factor) -> dict[str, object]:
    words = [_word(word) for word in factor.words]
    return {"factor": factor.name, "ja": factor.ja, "words": words}


def _word(word: Word) -> dict[str, object]:
    return {"en": word.en, "ja": word.ja, "ranges": [_range(one) for one in word.ranges]}


def _range(one: Range) -> dict[str, object]:
    """A range; null stands for a bound, a key and a value that there is not."""
    return {
        "quantity": one.quantity,
        "unit": one.unit,
        "key": one.key or None,
        "lower": one.lower,
        "upper": None if math.isinf(one.upper) else one.upper,
        "sets": None if math.isnan(one.sets) else one.sets,
        "source": one.source.replace("**", ""),
    }

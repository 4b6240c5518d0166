"""`nacreous card`: pearls with their value factors in words and numbers, as a page."""

from __future__ import annotations

import argparse
import time
from typing import TYPE_CHECKING

from nacreous.commands.terminal import say

if TYPE_CHECKING:
    from nacreous.card import Card
    from nacreous.spec import Pearl

_EXAMPLES = """\
examples:
  nacreous card akoya-rg --type akoya              a page, card.html
  nacreous card tahitian --type tahitian -o card.png    the same as a picture
  nacreous card mine.toml --scene north-window-black --language ja
  nacreous card akoya-rg akoya-r akoya-g -o batch.html  a batch: a table, and a card each
  nacreous card akoya-rg --word luster=Fair --set camera.elevation_deg=60   one change each
  nacreous card akoya-rg --json card.json          all numbers for programs too
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "card",
        help="make a grade card: a pearl's picture and its value factors in words and numbers",
        description="Make a grade card of a pearl, or of several: picture, size, shape, colour, "
        "luster, surface and nacre in the trade's words and in numbers, each from the file or "
        "measured in the picture, and the file's keys. The words are those of one table (nacreous "
        "words) applied to numbers; they are not a laboratory's grade.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "pearl", nargs="+", help="a pearl file, or a preset's name; up to 48, each by itself"
    )
    parser.add_argument("--scene", default="booth", help="a scene file or a preset's name (booth)")
    parser.add_argument(
        "--type",
        choices=("akoya", "tahitian", "south-sea"),
        help="what the pearls are, which decides what thick nacre is (no word for nacre)",
    )
    parser.add_argument(
        "--language", choices=("en", "ja"), default="en", help="English or Japanese (en)"
    )
    parser.add_argument("--size", type=int, default=512, help="pixels a side, 1 to 8192 (512)")
    parser.add_argument(
        "--samples", type=int, default=16, help="samples a pixel at most, a square number (16)"
    )
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="change one key of a file"
    )
    parser.add_argument(
        "--word",
        action="append",
        default=[],
        metavar="FACTOR=WORD",
        help="set the keys that a word of the trade stands for, such as luster=Excellent; --set "
        "goes before it",
    )
    parser.add_argument("--json", metavar="OUT", help="all factors for programs, .json")
    parser.add_argument("-o", "--output", default="card.html", help=".html or .png (card.html)")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Check everything, render and measure, write, say what was made."""
    from nacreous import card, file
    from nacreous.card.card import check_letters, check_place
    from nacreous.commands import standard
    from nacreous.commands.progress import bar

    place = check_place(args.output, args.language)
    outputs = [args.output]
    if args.json is not None:
        file.check_output(args.json, [".json"])
        outputs.append(args.json)
    pearls, files = _loaded(args)
    standard.require_apart(outputs, [*args.pearl, args.scene, *files])
    check_letters(place, pearls, args.pearl)
    begin = time.monotonic()
    with bar("rendering") as show:
        how = (args.type, args.size, args.samples, show, args.word, args.set)
        cards = card.make(args.pearl, args.scene, *how)
    card.save(args.output, cards, args.language)
    written = [_report(args.output, cards, time.monotonic() - begin)]
    if note := _note(cards, args.set):
        written.append(note)
    if args.json is not None:
        held = card.record(cards, args.output, args.language)
        with file.atomic(args.json) as temporary:
            temporary.write_text(held, encoding="utf-8")
        written.append(f"{args.json}: all factors")
    say("\n".join(written))
    return 0


def _note(cards: list[Card], settings: list[str]) -> str:
    """What was set and changes nothing."""
    import json

    from nacreous.commands.idle import idle_note

    pearls = [card.pearl.model_dump(mode="json") for card in cards]
    return idle_note(json.dumps({"pearls": pearls}), settings)


def _loaded(args: argparse.Namespace) -> tuple[list[Pearl], list[str]]:
    """The pearls beside standard input; photographs, panoramas and spectra that all name."""
    from nacreous import image
    from nacreous.card.card import SCENE, loaded_with
    from nacreous.recipe import recipe
    from nacreous.stream import STREAM

    named = [one for one in dict.fromkeys(args.pearl) if one != STREAM]
    scene = SCENE if args.scene == STREAM else args.scene
    pearls, around = loaded_with(named, scene, args.word, args.set)
    files = [path for one in pearls for path in image.files_of(recipe(one, around, 1, 1))]
    return pearls, files


def _report(output: str, cards: list[Card], seconds: float) -> str:
    """One line: what was made, and where."""
    first = cards[0]
    shown = f"pearl {first.pearl.name}" if len(cards) == 1 else f"{len(cards)} pearls"
    return (
        f"{output}: grade {'card' if len(cards) == 1 else 'cards'} of {shown} in scene "
        f"{first.scene_name}, {seconds:.1f} s; the words are the table's, no laboratory's grade"
    )

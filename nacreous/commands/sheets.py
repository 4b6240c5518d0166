"""`nacreous sheets`: contact sheets of scenes, families, pigments and knobs."""

from __future__ import annotations

import argparse
import time

from nacreous.commands.terminal import say

_EXAMPLES = """\
examples:
  nacreous sheets out                      every sheet, in the folder out
  nacreous sheets out --only pigments      one of them
  nacreous sheets out --size 512           larger pictures
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "sheets",
        help="make contact sheets: scenes, families, pigments, knobs",
        description="Make contact sheets in a folder: the same pearl in every scene, the three "
        "colour families in four steps, the pigments, and each knob turned alone.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("out", help="a folder: missing, empty, or one that this command made")
    parser.add_argument(
        "--only", action="append", metavar="SHEET", help="one sheet; may be given more than once"
    )
    parser.add_argument("--size", type=int, default=256, help="pixels a side, 32 to 1024 (256)")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Make the sheets and say where they are."""
    from nacreous import sheets
    from nacreous.commands.progress import bar

    begin = time.monotonic()
    with bar("making contact sheets") as show:
        files = sheets.make(args.out, args.only or sheets.NAMES, args.size, show)
    say(f"{args.out}: {', '.join(files)}, {time.monotonic() - begin:.1f} s")
    return 0

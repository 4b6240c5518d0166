"""`nacreous paper`: the figures of the paper, made again and measured."""

from __future__ import annotations

import argparse
import time

from nacreous.commands.terminal import say

_EXAMPLES = """\
examples:
  nacreous paper out             figures 8 to 14, the crops of figure 2, and out/index.html
  nacreous paper out --size 1024 in more pixels
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "paper",
        help="make every figure of the paper again, measured",
        description="Make the paper's figures 8 to 14 and the seven crops of figure 2 in a folder, "
        "with one page, index.html, that shows each beside the sentence it must satisfy and the "
        "numbers measured on it. The page needs no network.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("out", help="a folder: missing, empty, or one that this command made")
    parser.add_argument("--size", type=int, default=512, help="pixels a side, 64 to 2048 (512)")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Make everything, say what was made and what holds."""
    from nacreous.commands.progress import bar
    from nacreous.paper.make import PAGE, make

    begin = time.monotonic()
    with bar("making the figures") as show:
        paper = make(args.out, args.size, show)
    asked = [measured for shown in paper.exhibits for measured in shown.asked]
    held = sum(bool(measured.holds) for measured in asked)
    say(
        f"{args.out}/{PAGE}: {len(paper.exhibits)} figures, {held} of {len(asked)} criteria hold, "
        f"{time.monotonic() - begin:.1f} s"
    )
    return 0

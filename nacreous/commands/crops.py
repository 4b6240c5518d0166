"""`nacreous crops`: the seven crops of figure 2 from a picture of a pearl."""

from __future__ import annotations

import argparse

from nacreous.commands.terminal import say

_EXAMPLES = """\
examples:
  nacreous crops pearl.png                     crops/crop-1.png to crop-7.png
  nacreous crops photograph.jpg -o parts       the pearl's outline is estimated
  nacreous crops photograph.tif --centre 1510 980 --radius 640 --bits 16
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "crops",
        help="cut the seven crops of figure 2 from a picture of a pearl",
        description="Cut seven crops, numbered from the centre outward, as in figure 2 of the "
        "paper: 1 the lamp's image, 2 that and interference colours, 3 and 4 interference colours "
        "only, 5 to 7 more and more of the outline. The pearl's outline comes from the options, or "
        "from the recipe in a picture that nacreous rendered, or is estimated.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("picture", help="PNG, JPEG or TIFF of one pearl")
    parser.add_argument(
        "-o",
        "--output",
        default="crops",
        help="a folder: missing, empty, or one that this command made (crops)",
    )
    parser.add_argument(
        "--centre", type=float, nargs=2, metavar=("X", "Y"), help="the pearl's centre, in pixels"
    )
    parser.add_argument("--radius", type=float, metavar="R", help="the pearl's radius, in pixels")
    parser.add_argument("--bits", type=int, choices=(8, 16), default=8, help="a channel (8)")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Find the pearl, cut, write, say how the pearl was found."""
    from nacreous.paper import cutting

    given = cutting.given_circle(args.centre, args.radius)
    cuts = cutting.cut_file(args.picture, args.output, given, args.bits)
    circle, side = cuts.circle, cuts.crops[0].side_px
    say(
        f"{args.output}: {len(cuts.crops)} crops, {side} x {side} pixels each; pearl's centre at "
        f"({circle.x_px:.1f}, {circle.y_px:.1f}), radius {circle.radius_px:.1f}, {cuts.found}"
    )
    return 0

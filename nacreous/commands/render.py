"""`nacreous render`: a pearl in a scene, as a picture file."""

from __future__ import annotations

import argparse
import json
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nacreous.recipe import Recipe

_EXAMPLES = """\
examples:
  nacreous render paper                            the pearl of 1996, as pearl.png
  nacreous render paper --set depth=0.8            one knob turned
  nacreous render a.toml b.toml --scene tray.toml  two pearls in the rows of a scene
  nacreous render my.toml --scene booth --size 1024  your pearl in another scene
  nacreous render paper --set nacre.seed=9 --set camera.elevation_deg=30 -o out.exr
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "render",
        help="make a picture of a pearl, or of several",
        description="Make a picture of a pearl, or of several, in a scene. The picture file "
        "carries everything that makes it again: pearls, scene, seeds and versions.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "pearl",
        nargs="+",
        help="a pearl file, or a preset's name; several take the scene's places in turn",
    )
    parser.add_argument("--scene", default="paper", help="a scene file, or a preset's name (paper)")
    parser.add_argument("--size", type=_whole, default=512, help="pixels a side, 1 to 8192 (512)")
    parser.add_argument(
        "--samples",
        type=_whole,
        default=16,
        help="samples a pixel at most, a square number up to 1024 (16); alike ones are spared",
    )
    parser.add_argument("-o", "--output", default="pearl.png", help=".png or .exr (pearl.png)")
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="change one key of a file"
    )
    parser.add_argument(
        "--bits", type=_whole, choices=(8, 16), default=8, help="a channel in PNG (8)"
    )
    parser.add_argument(
        "--space", choices=("srgb", "display-p3"), default="srgb", help="colour space of PNG (srgb)"
    )
    parser.add_argument(
        "--gamut",
        choices=("soft", "clip"),
        default="soft",
        help="colours that the screen cannot show: bent softly, or cut (soft)",
    )
    parser.set_defaults(run=run)


def _whole(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text[:40]!r} is not a whole number") from None


def run(args: argparse.Namespace) -> int:
    """Check everything, render, write, say what was made."""
    from nacreous import file, image
    from nacreous.commands.progress import bar

    made = _recipe(args)
    file.check_output(args.output, image.SUFFIXES)
    begin = time.monotonic()
    with bar("rendering") as show:
        picture = image.render_recipe(made, show)
    outside = picture.save(args.output, args.bits, args.space, args.gamut)
    print(_report(args, made, time.monotonic() - begin, outside))
    return 0


def _recipe(args: argparse.Namespace) -> Recipe:
    """Pearls and scene, with single keys changed."""
    from nacreous.recipe import recipe

    pearls, scene = args.pearl, args.scene
    if args.set:
        from nacreous.spec import Pearl, Scene
        from nacreous.spec.load import shared_out

        of_pearl, of_scene = shared_out(args.set)
        pearls = [Pearl.load(pearl, of_pearl) for pearl in pearls]
        scene = Scene.load(scene, of_scene)
    return recipe(pearls[0] if len(pearls) == 1 else pearls, scene, args.size, args.samples)


def _report(args: argparse.Namespace, made: Recipe, seconds: float, outside: float) -> str:
    """One line: what was made, where, and how far the screen falls short of it."""
    from nacreous import _core

    values = json.loads(made.json)
    pearl, *others = values["pearls"]
    shown = f"{1 + len(others)} different pearls"
    if not others:
        stack, _ = _core.stack_of_nacre(json.dumps(pearl["nacre"]))
        nacre = f"{len(stack)} layers, {stack.total_um():.0f} um of nacre"
        shown = f"pearl {pearl['name']} ({nacre})"
    line = (
        f"{args.output}: {shown} in scene {values['scene']['name']}, "
        f"{args.size} x {args.size}, {args.samples} samples a pixel, {seconds:.1f} s"
    )
    if outside:
        line += f"; {outside:.1%} of the pixels out of the screen's gamut, {_HANDLED[args.gamut]}"
    return line


_HANDLED = {"soft": "bent softly into it", "clip": "cut to it"}

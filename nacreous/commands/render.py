"""`nacreous render`: a pearl in a scene, as a picture file."""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous.problem import InputError

if TYPE_CHECKING:
    from nacreous.recipe import Recipe

_EXAMPLES = """\
examples:
  nacreous render paper                            the pearl of 1996, as pearl.png
  nacreous render paper --set depth=0.8            one knob turned
  nacreous render a.toml b.toml --scene tray.toml  two pearls in the rows of a scene
  nacreous render my.toml --scene booth --size 1024  your pearl in another scene
  nacreous render paper --set nacre.seed=9 --set camera.elevation_deg=30 -o out.exr
  nacreous render pearl.png --size 2048            a picture again, larger, as pearl-again.png
  nacreous render paper --alpha -o cut-out.png     the pearl alone
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
        help="a pearl file, or a preset's name; several take the scene's places in turn; or one "
        "picture of ours, .png or .exr, which is made again",
    )
    parser.add_argument("--scene", help="a scene file, or a preset's name (paper)")
    parser.add_argument("--size", type=_whole, help="pixels a side, 1 to 8192 (512)")
    parser.add_argument(
        "--samples",
        type=_whole,
        help="samples a pixel at most, a square number up to 1024 (16); alike ones are spared",
    )
    parser.add_argument("-o", "--output", help=".png or .exr (pearl.png)")
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="change one key of a file"
    )
    parser.add_argument("--bits", type=_whole, choices=(8, 16), help="a channel in PNG (8)")
    parser.add_argument(
        "--space", choices=("srgb", "display-p3"), help="colour space of PNG (srgb)"
    )
    parser.add_argument(
        "--gamut",
        choices=("soft", "clip"),
        help="colours that the screen cannot show: bent softly, or cut (soft)",
    )
    parser.add_argument(
        "--alpha",
        action=argparse.BooleanOptionalAction,
        help="the pearls alone, cut out by the share of each pixel that they cover (no)",
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

    recipe = _recipe(args)
    output = _output(args)
    file.check_output(output, image.SUFFIXES)
    begin = time.monotonic()
    with bar("rendering") as show:
        picture = image.render(recipe.pearls, recipe.scene, recipe.size, recipe.samples, show)
    how = recipe.developed
    outside = picture.save(output, how.bits, how.space, how.gamut, how.alpha)
    print(_report(output, recipe, time.monotonic() - begin, outside))
    return 0


def _recipe(args: argparse.Namespace) -> Recipe:
    """What to make: a picture's own recipe, or pearls and a scene, with what the caller changes."""
    from nacreous import __version__
    from nacreous.recipe import Developed, Recipe, read_recipe
    from nacreous.spec import Pearl, Scene
    from nacreous.spec.load import shared_out

    of_pearl, of_scene = shared_out(args.set)
    if _is_picture(args.pearl[0]):
        given_scene = None if args.scene is None else Scene.load(args.scene, of_scene)
        kept = of_scene if given_scene is None else ()
        recipe = read_recipe(args.pearl[0], of_pearl, kept)
        if given_scene is not None:
            recipe = recipe._replace(scene=given_scene)
    else:
        pearls = [Pearl.load(pearl, of_pearl) for pearl in args.pearl]
        scene = Scene.load(args.scene or "paper", of_scene)
        recipe = Recipe(pearls, scene, 512, 16, Developed(), __version__)
    names = ("bits", "space", "gamut", "alpha")
    given = {name: value for name in names if (value := getattr(args, name)) is not None}
    return recipe._replace(
        size=recipe.size if args.size is None else args.size,
        samples=recipe.samples if args.samples is None else args.samples,
        developed=recipe.developed._replace(**given),
    )


def _is_picture(name: str) -> bool:
    from nacreous.recipe import SUFFIXES

    return Path(name).suffix.lower() in SUFFIXES


def _output(args: argparse.Namespace) -> str:
    """Where the picture goes: beside the one whose recipe it is made from, never over it."""
    if len(args.pearl) > 1 and any(map(_is_picture, args.pearl)):
        raise InputError("pearl is a picture among others; allowed: one picture, or pearls")
    if args.output is not None:
        return str(args.output)
    if not _is_picture(args.pearl[0]):
        return "pearl.png"
    picture = Path(args.pearl[0])
    return f"{picture.stem}-again{picture.suffix}"


def _report(output: str, recipe: Recipe, seconds: float, outside: float) -> str:
    """One line: what was made, where, and how far the screen falls short of it."""
    from nacreous import __version__, _core

    pearls = recipe.pearls
    shown = f"{len(pearls)} pearls"
    if len(pearls) == 1:
        stack, _ = _core.stack_of_nacre(pearls[0].nacre.model_dump_json())
        nacre = f"{len(stack)} layers, {stack.total_um():.0f} um of nacre"
        shown = f"pearl {pearls[0].name} ({nacre})"
    line = (
        f"{output}: {shown} in scene {recipe.scene.name}, {recipe.size} x {recipe.size}, "
        f"{recipe.samples} samples a pixel, {seconds:.1f} s"
    )
    if recipe.version != __version__:
        line += f"; the picture was first made by nacreous {recipe.version}, this is {__version__}"
    if outside:
        handled = _HANDLED[recipe.developed.gamut]
        line += f"; {outside:.1%} of the pixels out of the screen's gamut, {handled}"
    return line


_HANDLED = {"soft": "bent softly into it", "clip": "cut to it"}

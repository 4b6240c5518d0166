"""`nacreous render`: a pearl in a scene, as a picture file."""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Literal, NamedTuple, TypeVar

from nacreous.commands.terminal import say
from nacreous.problem import InputError
from nacreous.stream import STREAM

if TYPE_CHECKING:
    from nacreous.embedded import Developed
    from nacreous.recipe import Recipe

Value = TypeVar("Value")

_EXAMPLES = """\
examples:
  nacreous render paper                            the pearl of 1996, as pearl.png
  nacreous render paper --set depth=0.8            one knob turned
  nacreous render a.toml b.toml --scene tray.toml  two pearls in the rows of a scene
  nacreous render akoya-rg --word luster=Fair      a word of the trade (nacreous words)
  nacreous render my.toml --scene booth --size 1024  your pearl in another scene
  nacreous render paper --set nacre.seed=9 --set camera.elevation_deg=30 -o out.exr
  nacreous render pearl.png --size 2048            a picture again, larger, as pearl-again.png
  nacreous render paper --alpha -o cut-out.png     the pearl alone
  sed s/0.6/0.9/ my.toml | nacreous render - -o -  a filter: pearl file in, PNG out
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
        help="a pearl file, a preset's name, or - for standard input; several take the scene's "
        "places in turn; or one picture of ours, .png or .exr, which is made again",
    )
    parser.add_argument("--scene", help="a scene file, or a preset's name (paper)")
    parser.add_argument("--size", type=int, help="pixels a side, 1 to 8192 (512)")
    parser.add_argument(
        "--samples",
        type=int,
        help="samples a pixel at most, a square number up to 1024 (16); alike ones are spared",
    )
    parser.add_argument(
        "-o", "--output", help=".png, .exr, or - for a PNG to standard output (pearl.png)"
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
    parser.add_argument("--bits", type=int, choices=(8, 16), help="a channel in PNG (8)")
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


def run(args: argparse.Namespace) -> int:
    """Check everything, render, write, say what was made."""
    from nacreous import image
    from nacreous.commands import standard
    from nacreous.commands.progress import bar

    output = _output(args)
    job = _again(args, output) if _is_picture(args.pearl[0]) else _first(args)
    standard.check_output(output, image.SUFFIXES)
    _check_options(args, output)
    scene = [] if args.scene is None else [args.scene]
    standard.require_apart([output], [*args.pearl, *scene, *image.files_of(job.made)])
    begin = time.monotonic()
    with bar("rendering") as show:
        picture = image.render_recipe(job.made, show)
    place = sys.stdout.buffer if output == STREAM else output
    outside = picture.save(place, job.bits, job.space, job.gamut, job.alpha)
    say(_report(output, job, time.monotonic() - begin, outside), [output])
    if args.set:  # a preset as it is needs no keys
        from nacreous.commands.idle import idle_note

        if note := idle_note(job.made.json, args.set):
            say(note, [output])
    return 0


class _Job(NamedTuple):
    """What to make, how to write it, and which version made it first; arguments of `Image.save`.

    left_out: of how a PNG was written, what another form has no place for.
    """

    made: Recipe
    bits: Literal[8, 16]
    space: str
    gamut: str
    alpha: bool
    version: str | None = None
    left_out: tuple[str, ...] = ()


def _first(args: argparse.Namespace) -> _Job:
    """Pearls and scene, with single keys changed."""
    from nacreous.recipe import recipe

    pearls, scene = args.pearl, args.scene or "paper"
    if settings := _settings(args):
        from nacreous.spec import Pearl, Scene
        from nacreous.spec.load import shared_out

        of_pearl, of_scene = shared_out(settings)
        pearls = [Pearl.load(pearl, of_pearl) for pearl in pearls]
        scene = Scene.load(scene, of_scene)
    size, samples = _either(args.size, 512), _either(args.samples, 16)
    made = recipe(pearls[0] if len(pearls) == 1 else pearls, scene, size, samples)
    bits: Literal[8, 16] = args.bits or 8
    return _Job(made, bits, args.space or "srgb", args.gamut or "soft", bool(args.alpha))


def _settings(args: argparse.Namespace) -> list[str]:
    """What --word and --set say, as key=value; where both set a key, the latter counts."""
    if not args.word and not args.set:
        return []
    if not args.word:
        from nacreous.spec.override import once

        return once(args.set)  # without reading the table
    from nacreous.trade import with_words

    return with_words(args.word, args.set)


def _again(args: argparse.Namespace, output: str) -> _Job:
    """A picture's own recipe, with what the caller changes."""
    from nacreous import __version__
    from nacreous.embedded import read_embedded
    from nacreous.recipe import recipe
    from nacreous.spec import Scene
    from nacreous.spec.load import shared_out

    of_pearl, of_scene = shared_out(_settings(args))
    scene = None if args.scene is None else Scene.load(args.scene, of_scene)
    kept = read_embedded(args.pearl[0], of_pearl, of_scene if scene is None else (), scene)
    size, samples = _either(args.size, kept.size), _either(args.samples, kept.samples)
    made = recipe(kept.pearls, kept.scene, size, samples)
    left_out: tuple[str, ...] = ()
    developed = kept.developed
    if Path(output).suffix.lower() == ".exr":
        developed, left_out = _of_light(developed)
    bits, space, gamut, alpha = developed
    return _Job(
        made,
        args.bits or bits,
        args.space or space,
        args.gamut or gamut,
        _either(args.alpha, alpha),
        None if kept.version == __version__ else kept.version,
        left_out,
    )


def _of_light(developed: Developed) -> tuple[Developed, tuple[str, ...]]:
    """How OpenEXR, which holds light, is written, and what of a PNG's way is left out."""
    from nacreous.embedded import Developed

    kept = Developed(alpha=developed.alpha)
    names = ("bits", "space", "gamut")
    left_out = (f"{name} {getattr(developed, name)}" for name in names)
    own = (f"{name} {getattr(kept, name)}" for name in names)
    return kept, tuple(one for one, other in zip(left_out, own, strict=True) if one != other)


def _either(given: Value | None, otherwise: Value) -> Value:
    return otherwise if given is None else given


def _is_picture(name: str) -> bool:
    from nacreous.image import SUFFIXES

    return Path(name).suffix.lower() in SUFFIXES and not Path(name).is_dir()


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


def _check_options(args: argparse.Namespace, output: str) -> None:
    """OpenEXR holds light as it is, which no option of PNG changes."""
    if Path(output).suffix.lower() == ".exr":
        for name in ("bits", "space", "gamut"):
            if getattr(args, name) is not None:
                raise InputError(f"--{name} is given for {output}; allowed: with a .png alone")


def _report(output: str, job: _Job, seconds: float, outside: float) -> str:
    """One line: what was made, where, and how far the screen falls short of it."""
    from nacreous import __version__, _core

    values = json.loads(job.made.json)
    pearl, *others = values["pearls"]
    shown = f"{1 + len(others)} different pearls"
    if not others:
        stack, _ = _core.stack_of_nacre(json.dumps(pearl["nacre"]))
        given_mm = pearl.get("body", {}).get("nacre_mm")
        nacre_um = stack.total_um() if given_mm is None else 1000 * given_mm
        nacre = f"{len(stack)} layers, {nacre_um:.0f} um of nacre"
        shown = f"pearl {pearl['name']} ({nacre})"
    line = (
        f"{output}: {shown} in scene {values['scene']['name']}, {values['size']} x "
        f"{values['size']}, {values['samples']} samples a pixel, {seconds:.1f} s"
    )
    if job.version is not None:
        line += f"; first made by nacreous {job.version}, this is {__version__}"
    if job.left_out:
        own = ", ".join(job.left_out)
        line += f"; without {own} of the picture file, which OpenEXR has no place for"
    if outside:
        line += f"; {outside:.1%} of the pixels out of the screen's gamut, {_HANDLED[job.gamut]}"
    return line


_HANDLED = {"soft": "bent softly into it", "clip": "cut to it"}

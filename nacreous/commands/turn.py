"""`nacreous turn`: a pearl on a turntable, or lamps or the camera that go round it."""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous.commands.terminal import say

if TYPE_CHECKING:
    from nacreous.spec import Pearl, Scene
    from nacreous.turn.plan import Plan

_EXAMPLES = """\
examples:
  nacreous turn tahitian                           a turntable, as turn.webp
  nacreous turn tahitian --what lamp --scene north-window-black -o lamp.gif
  nacreous turn akoya-rg --degrees 90 --frames 24 -o quarter.png
  nacreous turn tahitian --set coat.thickness_spread=0.06 -o frames   a folder of pictures
  nacreous turn akoya-rg --word shape=Drop         words of the trade (nacreous words)
  nacreous turn tahitian -o turn.mp4               a video:   pip install 'nacreous[video]'

A folder that was interrupted is gone on with by the same call.
"""


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "turn",
        help="turn a pearl, its lamps or the camera, as pictures, animation or video",
        description="Turn a pearl as on a turntable, or take lamps and windows or the camera round "
        "it: a folder of pictures, an animated picture, or a video.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("pearl", help="a pearl file or a preset's name")
    parser.add_argument("--scene", default="paper", help="a scene file or a preset's name (paper)")
    parser.add_argument("--size", type=int, default=512, help="pixels a side, 1 to 8192 (512)")
    parser.add_argument(
        "--samples", type=int, default=16, help="samples a pixel at most, a square number (16)"
    )
    parser.add_argument("--frames", type=int, default=48, help="how many, 2 to 2000 (48)")
    parser.add_argument(
        "--what",
        choices=("pearl", "lamp", "camera"),
        default="pearl",
        help="what goes round: pearl, lamp (lamps and windows) or camera (pearl)",
    )
    parser.add_argument("--degrees", type=float, default=360.0, help="how far, -3600 to 3600 (360)")
    parser.add_argument("--fps", type=int, default=24, help="frames a second, 1 to 60 (24)")
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
    parser.add_argument(
        "-o",
        "--output",
        default="turn.webp",
        help=".png, .gif, .webp, .mp4 or .webm, or a folder, without an ending (turn.webp)",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Check everything, render the frames, keep them, say what was made."""
    from nacreous.commands import standard
    from nacreous.commands.idle import idle_note
    from nacreous.commands.progress import bar
    from nacreous.named_files import files_needed
    from nacreous.problem import InputError
    from nacreous.stream import STREAM
    from nacreous.turn import turn
    from nacreous.turn.plan import plan

    if args.output == STREAM:
        raise InputError("- is given as the output; allowed: a file or a folder")
    place = turn.check_place(args.output, args.size, args.frames, args.fps)
    pearl, scene = _specs(args)
    laid = plan(pearl, scene, args.frames, args.what, args.degrees, args.size, args.samples)
    needed = files_needed(laid.recipes[0].json)
    standard.require_apart([args.output], [args.pearl, args.scene, *needed])
    begin = time.monotonic()
    try:
        with bar("turning") as show:
            rendered = turn.keep(place, laid, args.fps, show)
    except KeyboardInterrupt as stop:
        return _interrupted(place, laid, stop)
    say(_report(args.output, laid, rendered, time.monotonic() - begin))
    for note in (_note(pearl, args.what), idle_note(laid.recipes[0].json, args.set)):
        if note:
            say(note)
    return 0


def _specs(args: argparse.Namespace) -> tuple[Pearl, Scene]:
    """Pearl and scene, with single keys changed."""
    from nacreous.spec import Pearl, Scene
    from nacreous.spec.load import shared_out
    from nacreous.trade import with_words

    of_pearl, of_scene = shared_out(with_words(args.word, args.set))
    return Pearl.load(args.pearl, of_pearl), Scene.load(args.scene, of_scene)


def _interrupted(place: Path, laid: Plan, stop: KeyboardInterrupt) -> int:
    """Of a folder, say how far it came; files are left as they were."""
    from nacreous.stopping import code_of, how_stopped
    from nacreous.turn import series

    if not (series.is_folder(place) and (done := series.finished(place))):
        raise stop
    left = f"{done} of {len(laid.recipes)} frames are in {place}; the same call goes on"
    say(f"nacreous: {how_stopped(stop)}; {left}", ["-"])
    return code_of(stop)


def _report(output: str, laid: Plan, rendered: int, seconds: float) -> str:
    """One line: what was made, and where."""
    count = len(laid.recipes)
    line = (
        f"{output}: {count} frames of pearl {laid.pearl} in scene {laid.scene}, {laid.what} by "
        f"{laid.degrees:g} degrees, {laid.size} x {laid.size}, {laid.samples} samples a pixel, "
        f"{seconds:.1f} s"
    )
    return line if rendered == count else f"{line}; {count - rendered} of them were there"


def _note(pearl: Pearl, what: str) -> str:
    """What a turntable does not show."""
    from nacreous.turn import alike

    if what != "pearl" or not alike(pearl):
        return ""
    return (
        f"note: pearl {pearl.name} has no grain, coat or blemishes and looks the same from all "
        "sides, so that its frames are alike; try --what lamp, or --set coat.thickness_spread=0.05"
    )

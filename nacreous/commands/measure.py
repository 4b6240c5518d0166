"""`nacreous measure`: numbers from a picture of a pearl."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from nacreous.commands.terminal import say
from nacreous.problem import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_EXAMPLES = """\
examples:
  nacreous measure pearl.exr                        a table; scale from the picture's own recipe
  nacreous measure photograph.jpg --mm-per-pixel 0.02 --white 120,80,40
  nacreous measure photograph.tif --centre 1510 980 --radius 640 --white '#e8e6e1'
  nacreous measure pearl.png --json pearl.json --plot measured.png
"""

#: Linear light from which an 8-bit code, or a JPEG's beside it, no longer tells how bright (252).
_CLIPPED = 0.97
#: From here on highlights are bent in a picture of ours that was developed softly.
_BENT = 0.8
_LIGHT = (".exr", ".hdr")


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "measure",
        help="measure a pearl in a picture: size, colour by ring, lamp's image, blemishes",
        description="Measure the one pearl in a picture, rendered or taken by a camera: size and "
        "roundness, colour by ring, the lamp's image and blemishes, with standard errors. What "
        "cannot be measured is named, with the reason. It gives no grades.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("picture", help="PNG, JPEG, TIFF, OpenEXR or Radiance, of one pearl")
    parser.add_argument(
        "--centre",
        type=float,
        nargs=2,
        metavar=("X", "Y"),
        help="the pearl's centre, in pixels, roughly",
    )
    parser.add_argument("--radius", type=float, metavar="R", help="its radius, in pixels, roughly")
    parser.add_argument(
        "--white",
        metavar="CODES|PLACE",
        help="what is white: its codes, '#rrggbb', or X,Y,SIDE of a square that shows it, in "
        "pixels (the picture's own white)",
    )
    parser.add_argument(
        "--mm-per-pixel", type=float, metavar="MM", help="scale (of a picture of ours: its own)"
    )
    parser.add_argument("--json", metavar="OUT", help="all numbers for machines, .json")
    parser.add_argument("--plot", metavar="OUT", help="the picture with what was found, .png")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Read, measure, say, write."""
    from nacreous import file
    from nacreous.commands.measure_lines import table
    from nacreous.measure import RELATIVE_WHITE, measure

    circle = _circle(args.centre, args.radius)
    _check_outputs(args)
    linear = _light(args.picture)
    own = _own(args.picture, linear.shape)
    white = RELATIVE_WHITE if args.white is None else _white(args.white, linear)
    scale = own.mm_per_pixel if args.mm_per_pixel is None else args.mm_per_pixel
    try:
        found = measure(
            linear,
            white=white,
            circle=circle,
            mm_per_pixel=scale,
            clipped_at=own.clipped_at,
            opacity=_opacity(args.picture, linear.shape),
        )
    except InputError as problem:
        raise InputError(f"{args.picture}: {problem}") from None
    written = []
    if args.json is not None:
        with file.atomic(args.json) as temporary:
            temporary.write_text(found.to_json(), encoding="utf-8")
        written.append(f"{args.json}: all numbers")
    if args.plot is not None:
        from nacreous.commands.measure_plot import plot

        with file.atomic(args.plot) as temporary:
            plot(temporary, linear, found)
        written.append(f"{args.plot}: the picture with what was found")
    say("\n".join([*table(args.picture, found), *written]))
    return 0


class _Own(NamedTuple):
    """What a picture file says of itself."""

    mm_per_pixel: float | None
    clipped_at: float | None


def _circle(
    centre: tuple[float, float] | None, radius: float | None
) -> tuple[float, float, float] | None:
    if centre is None and radius is None:
        return None
    if centre is None or radius is None:
        one, other = ("--radius", "--centre") if centre is None else ("--centre", "--radius")
        raise InputError(f"{one} is given without {other}; wanted: both or none")
    for name, value in (("--centre x", centre[0]), ("--centre y", centre[1]), ("--radius", radius)):
        if not math.isfinite(value):
            raise InputError(f"{name} is {value:g}; allowed: finite pixels")
    return centre[0], centre[1], radius


def _check_outputs(args: argparse.Namespace) -> None:
    from nacreous import file

    outputs = []
    for output, ending in ((args.json, ".json"), (args.plot, ".png")):
        if output is not None:
            file.check_output(output, [ending])
            outputs.append(output)
    file.require_apart(outputs, [args.picture])


def _light(picture: str) -> NDArray[np.float32]:
    from nacreous import file

    reads_light = Path(picture).suffix.lower() in _LIGHT
    if reads_light:
        return file.read_panorama(picture)
    try:
        return file.read_photograph(picture)
    except InputError as problem:
        # Photographs are told by their content; files of light are read here too, by their ending.
        said = str(problem)
        more = ", OpenEXR (.exr), Radiance (.hdr)" if said.endswith("PNG, JPEG, TIFF") else ""
        raise InputError(said + more) from None


def _opacity(picture: str, shape: tuple[int, ...]) -> NDArray[np.float32] | None:
    """Alpha of a picture of which a part is clear: the pearl is what is opaque."""
    import numpy as np
    from PIL import Image, ImageOps

    if Path(picture).suffix.lower() in _LIGHT:
        return None
    try:
        with Image.open(picture) as opened:
            if not opened.has_transparency_data:
                return None
            turned = ImageOps.exif_transpose(opened).convert("RGBA")
            alpha = np.asarray(turned.getchannel("A")).astype(np.float32) / np.float32(255)
    except (OSError, ValueError):  # of a kind that Pillow does not read
        return None
    return alpha if alpha.shape == shape[:2] and alpha.min() < 0.5 else None


def _own(picture: str, shape: tuple[int, ...]) -> _Own:
    """Scale of a picture of ours that is as large as it was made, and where its codes end."""
    from nacreous.embedded import read_embedded
    from nacreous.image import field_mm

    suffix = Path(picture).suffix.lower()
    clipped_at = None if suffix in _LIGHT else _CLIPPED
    if suffix not in (".png", ".exr"):
        return _Own(None, clipped_at)
    try:
        kept = read_embedded(picture)
    except InputError:  # another program's, or changed since
        return _Own(None, clipped_at)
    if suffix == ".png" and kept.developed.gamut == "soft":
        clipped_at = _BENT
    if shape[:2] != (kept.size, kept.size):
        return _Own(None, clipped_at)
    return _Own(field_mm(kept.pearls, kept.scene) / kept.size, clipped_at)


def _white(given: str, linear: NDArray[np.float32]) -> tuple[float, float, float]:
    """Linear RGB of codes, or of a square of the picture."""
    import numpy as np

    from nacreous import colour

    allowed = f"--white is {given!r}; allowed: '#rrggbb', or X,Y,SIDE in pixels"
    if given.startswith("#"):
        try:
            return colour.linear_from_hex(given)
        except InputError:
            raise InputError(allowed) from None
    try:
        x, y, side = (float(part) for part in given.split(","))
        left, top, wide = round(x - side / 2), round(y - side / 2), round(side)
    except (ValueError, OverflowError):  # of no number, and of nan and inf
        raise InputError(allowed) from None
    height, width = linear.shape[:2]
    right, below = left + wide, top + wide
    if not (0 <= left < right <= width and 0 <= top < below <= height):
        raise InputError(
            f"--white is the square {given}, which leaves the picture of {width} x {height} pixels;"
            " allowed: X,Y,SIDE of one inside"
        )
    red, green, blue = linear[top:below, left:right].mean((0, 1), np.float64).tolist()
    return red, green, blue

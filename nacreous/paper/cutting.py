"""Seven crops from a picture file into a folder."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nacreous import _core, file, folder, json_text, named_files
from nacreous.paper.circle import Circle
from nacreous.paper.crop import COUNT, Crop, cut, seven
from nacreous.paper.outline import estimate
from nacreous.problem import InputError
from nacreous.recipe import PREFIX
from nacreous.spec import Pearl, Scene

__all__ = ["Cuts", "cut_file", "given_circle", "outline_of", "save"]

MAKER = "nacreous crops"
RECORD = "crops.json"
FILES = (*(f"crop-{number}.png" for number in range(1, COUNT + 1)), RECORD)


@dataclass(frozen=True)
class Cuts:
    """What was cut, and how the pearl was found."""

    crops: list[Crop]
    circle: Circle
    found: str


def given_circle(centre: Sequence[float] | None, radius: float | None) -> Circle | None:
    """The outline as given on the command line; both parts or none.

    >>> given_circle([10.0, 20.0], None)
    Traceback (most recent call last):
    nacreous.problem.InputError: --centre is given without --radius; wanted: both or none
    """
    if centre is None and radius is None:
        return None
    if centre is None or radius is None:
        one, other = ("--radius", "--centre") if centre is None else ("--centre", "--radius")
        raise InputError(f"{one} is given without {other}; wanted: both or none")
    if not (0 < radius < math.inf):
        raise InputError(f"--radius is {radius:g}; allowed: above 0 pixels")
    if not all(math.isfinite(place) for place in centre):
        raise InputError(f"--centre is {centre[0]:g} {centre[1]:g}; allowed: finite pixels")
    return Circle(centre[0], centre[1], radius)


def cut_file(
    picture: str | Path, output: str | Path, given: Circle | None = None, bits: Literal[8, 16] = 8
) -> Cuts:
    """Cut the seven crops of a PNG, JPEG or TIFF, and write them and a record, or nothing.

    given: the pearl's outline. Left out, it comes from the recipe of a picture that nacreous
    rendered, or is estimated (`outline.estimate`). Pixels keep their values where the file is sRGB
    and has no more than `bits` bits. Raises `InputError` for a picture or a folder that cannot
    be used.
    """
    file.require_apart([Path(output, name) for name in FILES], [picture])
    linear = file.read_photograph(picture)
    texts = _texts(picture)
    circle, found = _outline(str(picture), linear, texts, given)
    try:
        crops = seven(linear, circle)
    except InputError as problem:
        raise InputError(f"{picture}: {problem}") from None
    codes, _ = _core.develop(linear, "srgb", "clip", bits)
    with folder.whole(output, FILES, RECORD, MAKER) as temporary:
        save(temporary, codes, crops, _moved(texts, picture, output), "crop-")
        record = {
            "made_by": MAKER,
            "picture": Path(picture).name,
            "outline": {**asdict(circle), "found": found},
            "crops": [crop.record() for crop in crops],
        }
        (temporary / RECORD).write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    return Cuts(crops, circle, found)


def outline_of(picture: str | Path, linear: NDArray[np.float32]) -> Circle:
    """The pearl's outline in a picture file, by its recipe or estimated; `linear` is its light."""
    return _outline(str(picture), linear, _texts(picture), None)[0]


def save(
    place: Path,
    codes: NDArray[np.uint8] | NDArray[np.uint16],
    crops: list[Crop],
    texts: dict[str, str],
    stem: str,
) -> list[Path]:
    """Write the crops of an sRGB picture as PNGs; each carries `texts` and where it was cut."""
    paths = []
    for crop, pixels in zip(crops, cut(codes, crops), strict=True):
        path = place / f"{stem}{crop.number}.png"
        recipe = {**texts, "nacreous:crop": json.dumps(crop.record())}
        recipe.pop("nacreous:developed", None)  # said of the whole picture
        _core.write_png(path, pixels, "srgb", list(recipe.items()))
        paths.append(path)
    return paths


def _moved(texts: dict[str, str], picture: str | Path, output: str | Path) -> dict[str, str]:
    """The recipe with the files that it names seen from another folder."""
    come_from = Path(picture).parent
    bare = {key.removeprefix(PREFIX): text for key, text in texts.items()}
    placed = named_files.moved(bare, lambda path: named_files.absolute(str(come_from / path)))
    seen = named_files.moved(placed, named_files.relative_to(output))
    return {PREFIX + key: text for key, text in seen.items()}


def _texts(picture: str | Path) -> dict[str, str]:
    """The recipe in one of our PNGs; nothing in any other picture."""
    with Path(picture).open("rb") as stream:
        if stream.read(8) != b"\x89PNG\r\n\x1a\n":
            return {}
    texts = file.read_png_text(picture)
    return {key: text for key, text in texts.items() if key.startswith(PREFIX)}


def _outline(
    name: str, linear: NDArray[np.float32], texts: dict[str, str], given: Circle | None
) -> tuple[Circle, str]:
    if given is not None:
        return given, "as given"
    recorded = _recorded(linear.shape, texts)
    if recorded is not None:
        return recorded, "from the recipe in the file"
    try:
        circle, share = estimate(linear)
    except InputError as problem:
        raise InputError(f"{name}: {problem}") from None
    return circle, f"estimated, with an edge in {share:.0%} of all directions"


def _recorded(shape: tuple[int, ...], texts: dict[str, str]) -> Circle | None:
    """The outline by the recipe's geometry; None where the picture was cut or scaled since."""
    try:
        size = json_text.loads(texts["nacreous:settings"])["size"]
        pearl = Pearl.from_toml(texts["nacreous:pearl"])
        scene = Scene.from_toml(texts["nacreous:scene"])
        circle = Circle.of_view(pearl, scene, size)
    except (KeyError, TypeError, ValueError):  # no recipe, or one that someone has changed
        return None
    if shape[:2] != (size, size) or "nacreous:strip" in texts or "nacreous:crop" in texts:
        return None
    return circle

"""Contact sheets: many pearls side by side on one picture, as goods laid out to compare."""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nacreous import folder, image
from nacreous.figure import sheet
from nacreous.number import said, whole_of
from nacreous.problem import InputError
from nacreous.spec import Pearl, Scene, preset
from nacreous.spec.body import PIGMENTS
from nacreous.spec.complaint import nearest
from nacreous.trade.setting import overrides_of
from nacreous.trade.table import factor_of

__all__ = ["NAMES", "make"]

MAKER = "nacreous sheets"
RECORD = "sheets.json"

#: Steps of a master set, vivid to none, and of a knob.
_STEPS = ("1.0", "0.7", "0.4", "0.0")
_TURNS = (0.0, 0.25, 0.5, 0.75, 1.0)
_FAMILIES = ("r", "rg", "g")
_MODEL_PEARL = "akoya-rg-1.0"
_BLACK = "north-window-black"


class Tile(NamedTuple):
    """A pearl in a scene, and the words below it."""

    pearl: Pearl
    scene: str
    words: str


def _scenes() -> list[list[Tile]]:
    """Every scene with the same pearl."""
    pearl = Pearl.load(_MODEL_PEARL)
    tiles = [Tile(pearl, name, name) for name in preset.names("scene")]
    return [tiles[start : start + 3] for start in range(0, len(tiles), 3)]


def _families(scene: str) -> list[list[Tile]]:
    """The three families, each in the four steps of a master set."""
    return [
        [
            Tile(Pearl.load(f"akoya-{family}-{step}"), scene, f"{family.upper()} {step}")
            for step in _STEPS
        ]
        for family in _FAMILIES
    ]


def _pigments() -> list[list[Tile]]:
    """Every pigment under the same film, on white cloth and on black."""
    named = [name for name in PIGMENTS if name != "none"]
    return [
        [Tile(Pearl.load(_MODEL_PEARL, [("body.pigment", name)]), scene, name) for name in named]
        for scene in ("north-window-white", "north-window-black")
    ]


def _knobs() -> list[list[Tile]]:
    """Depth, shininess and grain, each turned alone."""
    return [
        [Tile(_turned(knob, turn), "north-window-white", f"{knob} {turn:g}") for turn in _TURNS]
        for knob in ("depth", "shininess", "grain")
    ]


def _turned(knob: str, turn: float) -> Pearl:
    given = [(knob, turn)]
    pearl = Pearl.load(_MODEL_PEARL, given)
    # The masters fix the film's depth, which would leave the knob half its work.
    return pearl.replace(film=pearl.film.replace(outer_um=None))


def _words() -> list[list[Tile]]:
    """Every word that sets keys, but sizes and shapes, on pearls of the kind that it is said of."""
    pearls = {"luster": "akoya-rg", "surface": "akoya-rg", "nacre-akoya": "akoya-thin"}
    pearls |= {"nacre-tahitian": "tahitian", "nacre-south-sea": "south-sea-gold"}
    return [
        [
            Tile(
                Pearl.load(name, overrides_of(f"{factor}={word.en}")), _BLACK, f"{factor} {word.en}"
            )
            for word in factor_of(factor).words
        ]
        for factor, name in pearls.items()
    ]


def _coats() -> list[list[Tile]]:
    """What differs from place to place: thickness, relief, kinds of blemishes."""
    none = [("coat.thickness_spread", "0"), ("coat.banding", "0")]
    patches = [("coat.thickness_spread", "0.05"), ("coat.banding", "0")]
    thickness = [("even", none), ("patches .05", patches)]
    thickness += [
        (
            f"bands {share}",
            [*patches, ("coat.banding", f"{share}"), ("coat.patch_mm", "1.5")],
        )
        for share in (0.5, 1.0)
    ]
    relief = [(f"dents {rad}", [("coat.hammering_rad", f"{rad}")]) for rad in (0.02, 0.06)]
    relief += [(f"terraces {um} um", [("coat.terrace_um", f"{um}")]) for um in (60, 150)]
    kinds = ("pits", "bumps", "scratches", "chalky_spots")
    large = [("blemishes.size_mm", "0.6"), ("blemishes.depth_um", "40")]
    blemished = [(kind.replace("_", " "), [(f"blemishes.{kind}", "25"), *large]) for kind in kinds]
    return [
        [
            Tile(Pearl.load(pearl, [*given, ("coat.seed", "3")]), _BLACK, words)
            for words, given in row
        ]
        for pearl, row in (
            ("tahitian", thickness),
            ("south-sea-gold", relief),
            ("akoya-rg", blemished),
        )
    ]


def _shapes() -> list[list[Tile]]:
    """Every word for a shape, white on white cloth and Tahitian on black, four in a row."""
    found = factor_of("shape").words
    seed = ("shape.seed", "3")
    by_word = {word.en: [*overrides_of(f"shape={word.en}"), seed] for word in found}
    order = ("round", "near-round", "oval", "button", "drop", "semi-baroque", "baroque", "circled")
    tiles = [
        Tile(Pearl.load(pearl, by_word[word]), scene, word)
        for pearl, scene in (("south-sea-white", "north-window-white"), ("tahitian", _BLACK))
        for word in order
    ]
    return [tiles[start : start + 4] for start in range(0, len(tiles), 4)]


#: What each sheet shows, by its name.
_SHEETS: dict[str, Callable[[], list[list[Tile]]]] = {
    "scenes": _scenes,
    "families-aurora": lambda: _families("aurora"),
    "families-black": lambda: _families("north-window-black"),
    "families-white": lambda: _families("north-window-white"),
    "pigments": _pigments,
    "knobs": _knobs,
    "words": _words,
    "coats": _coats,
    "shapes": _shapes,
}

#: The sheets there are.
NAMES = tuple(_SHEETS)


def make(
    path: str | Path,
    names: Sequence[str] = NAMES,
    size: int = 256,
    progress: Callable[[float], None] | None = None,
) -> list[str]:
    """Make contact sheets in the folder `path`, each a PNG, and give back the files' names.

    names: which, all by default. size: pixels a side of each pearl's picture, 32 to 1024. progress:
    called with the finished share. All files are made or none. Raises `InputError` for a name, a
    size or a folder that cannot be used. Same names and size, same bytes, on the same versions.
    """
    for name in names:
        if name not in _SHEETS:
            near = nearest(str(name), list(NAMES))
            hint = f"did you mean {near}?" if near else f"allowed: {', '.join(NAMES)}"
            raise InputError(f"sheet is {said(name)}; {hint}")
    names = tuple(dict.fromkeys(names))
    size = whole_of("size", size, 32, 1024)
    drawn = {name: _SHEETS[name]() for name in names}
    count = sum(len(row) for rows in drawn.values() for row in rows)
    show = progress or (lambda _: None)
    done = itertools.count(1)

    def picture(tile: Tile) -> NDArray[np.uint8]:
        codes, _ = image.render(tile.pearl, Scene.load(tile.scene), size).develop()
        show(next(done) / count)
        return codes.astype(np.uint8, copy=False)

    files = [f"{name}.png" for name in names]
    with folder.whole(path, [f"{name}.png" for name in NAMES] + [RECORD], RECORD, MAKER) as out:
        for file, rows in zip(files, drawn.values(), strict=True):
            _draw(out / file, rows, [[picture(tile) for tile in row] for row in rows], size)
        record = {"made_by": MAKER, "sheets": list(names), "size": size}
        (out / RECORD).write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    return files


#: Points to a pixel at figure's 160 dots an inch, and room for words below each picture.
_POINT = 72 / 160
_WORDS_PT = 12.0


def _draw(
    path: Path, rows: list[list[Tile]], pictures: list[list[NDArray[np.uint8]]], size: int
) -> None:
    side = size * _POINT
    columns = max(len(row) for row in rows)
    with sheet(path, columns * side, len(rows) * (side + _WORDS_PT)) as axes:
        for i, (row, shown) in enumerate(zip(rows, pictures, strict=True)):
            top = i * (side + _WORDS_PT)
            for j, (tile, codes) in enumerate(zip(row, shown, strict=True)):
                extent = (j * side, (j + 1) * side, top + side, top)
                axes.imshow(codes, extent=extent, interpolation="none", aspect="auto")
                axes.text((j + 0.5) * side, top + side + 8.5, tile.words, ha="center", fontsize=7)
        axes.set_xlim(0, columns * side)
        axes.set_ylim(len(rows) * (side + _WORDS_PT), 0)

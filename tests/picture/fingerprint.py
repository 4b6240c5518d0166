"""Fingerprints of pictures: 13 pearls in all scenes, small, by hash and mean of each part.

    python -m tests.picture.fingerprint      writes tests/golden/pictures.csv and recipes/ anew

A change of a shade that no law forbids shows here first. What changes a row says so in
CHANGELOG.md, under "Numbers that changed".
"""

from __future__ import annotations

import csv
import hashlib
from pathlib import Path
from typing import NamedTuple

from nacreous.image import Image, recipe_json, render
from nacreous.spec import Scene, preset

GOLDEN = Path(__file__).parents[1] / "golden" / "pictures.csv"
SIZE_PX = 24

#: Both models, every pigment, thin nacre, weak and strong families, satin and mirror.
PEARLS = (
    "paper",
    "paper-green",
    "paper-summer-harvest",
    "akoya-r",
    "akoya-rg",
    "akoya-g-0.4",
    "akoya-cream",
    "akoya-pink",
    "akoya-dyed-blue",
    "akoya-thin",
    "south-sea-gold",
    "south-sea-white",
    "tahitian",
)
SCENES = tuple(preset.names("scene"))

#: Of these the recipes lie beside, for the renderer's own tests, in Rust and in Node.js.
RECIPES = (
    ("paper", "paper"),
    ("akoya-rg", "north-window-white"),
    ("tahitian", "north-window-black"),
)

#: The rows of the trade's scene are too narrow for the largest pearls.
WIDER = {"two-tier": [("pitch_mm", "14"), ("row_gap_mm", "16")]}


class Fingerprint(NamedTuple):
    """What is kept of a picture: SHA-256 of its linear bytes, and the mean of each of its parts."""

    digest: str
    means: tuple[float, ...]


def recipe_file(pearl: str, scene: str) -> Path:
    """Where a recipe lies."""
    return GOLDEN.parent / "recipes" / f"{pearl}-{scene}.json"


def pictured(pearl: str, scene: str) -> Image:
    """One of the pictures."""
    return render(pearl, Scene.load(scene, WIDER.get(scene, [])), SIZE_PX)


def fingerprint(image: Image) -> Fingerprint:
    """Of the picture's linear light; the means go over all its pixels and channels."""
    digest = hashlib.sha256(image.linear.astype("<f4").tobytes()).hexdigest()
    # As texts, for a file that tells no more than it can hold.
    means = (float(f"{layer.mean(dtype=float):.9g}") for layer in image.layers.values())
    return Fingerprint(digest[:16], tuple(means))


def golden() -> dict[tuple[str, str], Fingerprint]:
    """The fingerprints on file, by pearl and scene."""
    with GOLDEN.open(encoding="utf-8", newline="") as file:
        _, *rows = csv.reader(file)
    return {
        (pearl, scene): Fingerprint(digest, tuple(map(float, means)))
        for pearl, scene, digest, *means in rows
    }


def _rewrite() -> None:
    found = {(p, s): fingerprint(pictured(p, s)) for s in SCENES for p in PEARLS}
    parts = pictured(PEARLS[0], SCENES[0]).layers
    with GOLDEN.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["pearl", "scene", "sha256_16", *(f"mean_{part}" for part in parts)])
        for (pearl, scene), (digest, means) in found.items():
            table.writerow([pearl, scene, digest, *(f"{mean:.9g}" for mean in means)])

    for pearl, scene in RECIPES:
        text = recipe_json(pearl, scene, SIZE_PX) + "\n"
        recipe_file(pearl, scene).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    _rewrite()

"""Native pictures for the tests in Node.js to compare theirs with.

    python -m tests.wasm.native FOLDER

writes for each golden recipe NAME.f32, the linear light of all parts as float32, and NAME.srgb and
NAME.display-p3, its 8-bit codes; and grain.f64, the grain on a photograph:
frequencies, density, correlation.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from nacreous import _core
from nacreous.image import Image
from tests.picture.fingerprint import RECIPES, recipe_file

#: The photograph, and how its grain is measured: side of the patches, mm per pixel, the band.
PHOTOGRAPH = Path(__file__).parents[2] / "docs/pictures/pearl.png"
MEASURING = (60, 0.012, None, None)


def write(folder: Path) -> None:
    """Write the pictures into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for pearl, scene in RECIPES:
        file = recipe_file(pearl, scene)
        picture = _core.render(file.read_text(encoding="utf-8"), [], [], [], None)
        pixels, parts = picture.parts()
        layers = {name: pixels[..., first:end] for name, first, end in parts}
        image = Image(sum(list(layers.values())[:4]), layers)
        (folder / f"{file.stem}.f32").write_bytes(pixels.astype("<f4").tobytes())
        for space in ("srgb", "display-p3"):
            codes, _ = image.develop(space=space)
            (folder / f"{file.stem}.{space}").write_bytes(codes.tobytes())
    grain = _core.measured_grain(_core.read_photograph(PHOTOGRAPH), MEASURING)
    content = np.concatenate([numbers.ravel() for numbers in grain])
    (folder / "grain.f64").write_bytes(content.astype("<f8").tobytes())


if __name__ == "__main__":
    write(Path(sys.argv[1]))

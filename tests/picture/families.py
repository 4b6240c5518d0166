"""Families in the Aurora viewer, in numbers: the tables of docs/families.md.

python -m tests.picture.families
"""

from __future__ import annotations

from collections.abc import Iterable
from types import SimpleNamespace

import numpy as np
from numpy.typing import NDArray

import nacreous as nc
from nacreous.image import Image
from nacreous.spec import Pearl
from tests.picture.rings import rings

FAMILIES = ("r", "rg", "g")
STEPS = ("1.0", "0.7", "0.4", "0.0")
#: Of 16 rings of equal width, the centre at 4 to 7 degrees and the rim at 61 to 70.
RINGS, CENTRE, RIM = 16, 1, 14


def _seen(pearl: str) -> Image:
    return nc.render(Pearl.load(pearl, [("grain", 0.0)]), "aurora", size=192)


def _words(hue_deg: float, chroma: float) -> str:
    """Munsell hue at Y = 1, Lab hue in degrees and chroma."""
    hue_rad = np.radians(hue_deg)
    lab = [100.0, chroma * np.cos(hue_rad), chroma * np.sin(hue_rad)]
    xyz = nc.colour.xyz_from_lab(lab, nc.colour.white_xyz("D65"))
    hvc = nc.colour.hvc_from_rgb(nc.colour.rgb_from_xyz(0.8 * xyz))
    munsell = str(nc.colour.munsell_notation(hvc)).split(" ")[0]
    return f"{munsell} {hue_deg:.0f}/{chroma:.0f}"


def _hues() -> Iterable[str]:
    for family in FAMILIES:
        for kind in ("1.0", "published"):
            halves = rings(_seen(f"akoya-{family}-{kind}"), RINGS)
            cells = [_words(*half[at, :2]) for half in halves for at in (CENTRE, RIM)]
            yield f"| `akoya-{family}-{kind}` | {' | '.join(cells)} |"


def _ab(half: NDArray[np.float64]) -> NDArray[np.float64]:
    hue_deg, chroma = half[CENTRE, :2]
    return chroma * np.array([np.cos(np.radians(hue_deg)), np.sin(np.radians(hue_deg))])


def _chromas() -> Iterable[str]:
    for family in FAMILIES:
        seen, against_body = [], []
        for step in STEPS:
            image = _seen(f"akoya-{family}-{step}")
            own = SimpleNamespace(linear=image.layers["diffuse"], layers=image.layers)
            whole, body = (_ab(rings(of, RINGS)[0]) for of in (image, own))
            seen.append(float(np.linalg.norm(whole)))
            against_body.append(float(np.linalg.norm(whole - body)))
        for name, chroma in (("as seen", seen), ("beside the body's own light", against_body)):
            steps = [f"{each:.1f} ({each / chroma[0]:.2f})" for each in chroma]
            yield f"| {family.upper()}, {name} | {' | '.join(steps)} |"


if __name__ == "__main__":
    for line in (*_hues(), *_chromas()):
        print(line)

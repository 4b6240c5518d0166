"""A strand's pearls as pearl files, laid in rows on a scene's cloth."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.body import PIGMENTS, reflectance_of_body
from nacreous.nacre import stack_of
from nacreous.problem import InputError
from nacreous.spec import Growth, Pearl, Row, Scene
from nacreous.strand.form import LONGEST
from nacreous.strand.lot import Lot
from nacreous.value import value_class

__all__ = ["Hung", "hung", "laid_out"]

Array = NDArray[np.float64]

#: Strengths of a pigment that are tried: fine enough for a CIEDE2000 of a few tenths.
_STRENGTHS = np.linspace(0, 4, 41)


@value_class
class Hung:
    """A strand's pearls, and how far their body colours are from the lot's, in mean CIEDE2000."""

    pearls: tuple[Pearl, ...]
    colour_off: float


def hung(strand: Lot, like: Pearl, seed: int = 1) -> Hung:
    """The pearls of a strand, in its order, as pearl files.

    like: what they share. Each has its own size, facets and seed of growth, and the pigment and
    strength whose body colour is nearest to its own: pearl files know a body colour by its pigment.
    seed: of the first pearl's growth; the next ones count up. Raises `InputError`.
    """
    if like.model != "transport" or not isinstance(like.nacre, Growth):
        raise InputError(
            f"pearl {like.name}: strands hang pearls of the transport model that grow; allowed: "
            'model = "transport", and no nacre.thickness_nm'
        )
    palette, lab = _palette(like)
    apart = colour.delta_e_2000(strand.lab[:, None], lab[None])
    nearest = apart.argmin(axis=1)
    pearls = []
    for at, (size_mm, *_, spread_rad) in enumerate(strand.values.tolist()):
        pigment, strength = palette[int(nearest[at])]
        pearls.append(
            like.replace(
                name=f"{like.name}-{at + 1}",
                diameter_mm=size_mm,
                nacre=like.nacre.replace(seed=seed + at),
                body=like.body.replace(pigment=pigment, pigment_strength=strength),
                surface=like.surface.replace(facet_spread_rad=spread_rad),
            )
        )
    return Hung(tuple(pearls), float(apart.min(axis=1).mean()))


#: Rows of folds lie so many of the largest diameters apart **(ours)**.
_ROWS = 1.5
#: How a strand may lie: in folds on cloth, or around a neck.
LAID: Final = ("folds", "neck")


def laid_out(
    count: int, scene: Scene, laid: str = "folds", widest_mm: float | None = None
) -> Scene:
    """The scene with so many pearls of a strand on its cloth, seen from above.

    laid: "folds", in rows of which every other runs back, so that neighbours stay side by side, or
    "neck", each touching the next around an open ellipse whose front is towards the viewer. Rays
    are parallel, so that the camera's distance holds for any number. Raises `InputError` for a
    scene with rows of its own. widest_mm: of the largest pearl, if all are balls: in folds they
    touch along the thread then, and rows lie apart.
    """
    if scene.rows:
        raise InputError(f"scene {scene.name}: has rows of its own; allowed: a scene for one pearl")
    if laid not in LAID:
        raise InputError(f'laid is "{laid}"; allowed: {" or ".join(LAID)}')
    if count > LONGEST:
        raise InputError(f"the strand has {count} pearls; allowed: up to {LONGEST} in a picture")
    camera = scene.camera.replace(projection="orthographic", elevation_deg=60.0)
    if laid == "neck":
        around = Row(pearls=tuple(f"*{number}" for number in range(count)), form="neck")
        return scene.replace(rows=(around,), camera=camera)
    across = math.ceil(math.sqrt(count))
    rows = []
    for line, begin in enumerate(range(0, count, across)):
        numbers = list(range(begin, min(begin + across, count)))
        if line % 2:
            numbers.reverse()
        rows.append(Row(pearls=tuple(f"*{number}" for number in numbers)))
    laid_so = scene.replace(rows=tuple(rows), camera=camera)
    if widest_mm is None:
        return laid_so
    return laid_so.replace(pitch_mm=widest_mm, row_gap_mm=_ROWS * widest_mm)


def _palette(like: Pearl) -> tuple[list[tuple[str, float]], Array]:
    """Pigments with strengths, and float64 [choice, 3], the body's L*, a*, b* with each."""
    nacre_mm = stack_of(like).total_um / 1000
    choices = [
        (pigment, round(float(strength), 3))
        for pigment in PIGMENTS
        for strength in (_STRENGTHS[1:] if pigment != "none" else [1.0])
    ]
    spectra = np.stack(
        [
            reflectance_of_body(
                like.replace(body=like.body.replace(pigment=name, pigment_strength=strength)),
                nacre_mm,
            )
            for name, strength in choices
        ]
    )
    return choices, colour.lab_from_xyz(colour.xyz_from_spectrum(spectra, "D65"))

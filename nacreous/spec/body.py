"""The [body] of a pearl: pigmented nacre that scatters, over a nucleus."""

from __future__ import annotations

from typing import Literal, get_args

from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section
from nacreous.spec.texts import COLOUR, Colour

#: The columns of data/pigments.csv, and none at all. A test compares the two: reading files needs
#: no compiled room.
Pigment = Literal["none", "white", "cream", "pink", "gold", "black-lip", "dyed-blue"]
PIGMENTS: tuple[str, ...] = get_args(Pigment)


class Body(Section):
    """What gives the pearl its body colour (the transport model).

    Light that has come through the film is scattered and absorbed by the nacre and by the nucleus
    below it, as Kubelka and Munk describe.
    """

    pigment: Pigment = key(
        "white",
        "The pigment of the nacre, by its absorption spectrum.",
        allowed=", ".join(f'"{name}"' for name in PIGMENTS),
        source="data/pigments.csv; bands of gold and black-lip as published, the rest **(ours)**",
    )
    pigment_strength: float = quantity(
        1.0,
        "How much of the pigment there is: a factor on its absorption.",
        least=0,
        most=10,
        source="**(ours)**; 1 is a usual pearl of that colour",
    )
    nacre_mm: float | None = quantity(
        None,
        "Thickness of the whole nacre; below about 0.3 mm the nucleus shows.",
        least=0.01,
        most=15,
        unit="mm",
        source="Pearl Science Laboratory, 0.4 mm and more is thick",
        left_out="the thickness of the layers",
    )
    scattering_per_mm: float = quantity(
        3.0,
        "Kubelka and Munk's scattering coefficient S of the nacre.",
        least=0,
        most=1000,
        unit="per mm",
        source="**(ours)**: the nucleus begins to show below 0.3 mm",
    )
    nucleus: Colour = key(
        "#fcfcfa",
        "Reflectance of the nucleus for light that is inside, as the sRGB of a matt surface.",
        allowed=COLOUR,
        source="**(ours)**; a bead of shell, 0.97: its own surface not counted",
    )
    nucleus_bands: float = quantity(
        0.0,
        "How much darker the dark bands of the nucleus are than its colour; they show through thin "
        "nacre, and blink as the pearl turns.",
        least=0,
        most=0.5,
        source="trade, nuclei of freshwater shell; the share is **(ours)**",
    )
    nucleus_band_mm: float = quantity(
        0.8,
        "From one dark band to the next.",
        least=0.1,
        most=10,
        unit="mm",
        source="**(ours)**",
    )

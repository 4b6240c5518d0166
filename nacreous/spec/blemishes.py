"""The [blemishes] of a pearl: pits, bumps and the like, in relief and film."""

from __future__ import annotations

from nacreous.spec.key import quantity
from nacreous.spec.section import Section

#: More of a kind than anyone would count.
MOST = 500


def _count(meaning: str) -> int:
    number: int = quantity(0, meaning, least=0, most=MOST, source="trade, kinds of blemishes")
    return number


class Blemishes(Section):
    """How many blemishes a pearl has, and how large they are (the transport model).

    Sizes and depths of single ones lie within 40 % of those stated.
    """

    seed: int | None = quantity(
        None,
        "Seed of their places.",
        least=0,
        most=2**63 - 1,
        source="**(ours)**",
        left_out="nacre.seed",
    )
    pits: int = _count("Round hollows, all over the pearl.")
    bumps: int = _count("Round rises.")
    scratches: int = _count("Narrow grooves, 6 times size_mm long and 0.15 wide.")
    wrinkles: int = _count("Long rises, 4 times size_mm long and 0.6 wide.")
    chalky_spots: int = _count(
        "Chalky spots without layers: they mirror nothing, and look darker where the pearl mirrors "
        "a window."
    )
    size_mm: float = quantity(
        0.3,
        "Mean diameter of what is round; what is long goes by it.",
        least=0.02,
        most=5,
        unit="mm",
        source="**(ours)**; pin pricks are 0.1 mm",
    )
    depth_um: float = quantity(
        20.0,
        "Mean depth or height.",
        least=0,
        most=200,
        unit="um",
        source="**(ours)**",
    )
    area: float | None = quantity(
        None,
        "Share of the pearl that all of them cover together: sizes and depths are multiplied "
        "until they do, if there are any.",
        least=0,
        most=0.25,
        source="trade, words for the surface",
        left_out="what size_mm gives",
    )

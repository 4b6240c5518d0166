"""The [shape] of a pearl: what makes it other than round."""

from __future__ import annotations

from nacreous.spec.key import quantity
from nacreous.spec.section import Section


class Shape(Section):
    """How far the surface is from the middle in every direction (the transport model)."""

    seed: int | None = quantity(
        None,
        "Seed of lumps and circles.",
        least=0,
        most=2**63 - 1,
        source="**(ours)**",
        left_out="nacre.seed",
    )
    length: float = quantity(
        1.0,
        "Length along the axis of growth over the width across it, which is diameter_mm: above 1 "
        "an oval, below 1 a button.",
        least=0.5,
        most=2.5,
        source="trade, sizes as width x length",
    )
    taper: float = quantity(
        0.0,
        "How much narrower one end is: a drop.",
        least=0,
        most=3,
        source="trade, drops; the form is **(ours)**",
    )
    flattening: float = quantity(
        0.0,
        "How much nearer to the middle one end is: a button's flat side.",
        least=0,
        most=1.5,
        source="trade, buttons; the form is **(ours)**",
    )
    out_of_round: float = quantity(
        0.0,
        "Difference of the widths across the axis, as a share of their mean.",
        least=0,
        most=0.3,
        source="trade: round under 2 %, near-round 2 to 5 %",
    )
    lumps: float = quantity(
        0.0,
        "Spread (standard deviation) of the lumps of a baroque pearl, as a share of the distance "
        "from its middle.",
        least=0,
        most=0.2,
        source="trade, baroque pearls; the form is **(ours)**",
    )
    lump_mm: float | None = quantity(
        None,
        "Size of the lumps, from top to foot.",
        least=0.5,
        most=20,
        unit="mm",
        source="**(ours)**",
        left_out="0.6 x diameter_mm",
    )
    circles: int = quantity(
        0,
        "Grooves about the axis: a circled pearl.",
        least=0,
        most=12,
        source="trade, circled pearls",
    )
    circle_depth: float = quantity(
        0.04,
        "Mean depth of a groove, as a share of the distance from the middle.",
        least=0,
        most=0.15,
        source="trade, circled pearls; the number is **(ours)**",
    )
    drill_mm: float = quantity(
        0.0,
        "Diameter of the hole along the axis, drilled through; 0 for none.",
        least=0,
        most=3,
        unit="mm",
        source="trade: 0.6 to 1 mm for strands",
    )
    drill_wear_mm: float = quantity(
        0.05,
        "Width of the hole's worn edge.",
        least=0,
        most=1,
        unit="mm",
        source="**(ours)**",
    )

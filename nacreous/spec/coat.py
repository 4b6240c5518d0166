"""The [coat] of a pearl: what differs from place to place."""

from __future__ import annotations

from nacreous.spec.key import quantity
from nacreous.spec.section import Section


class Coat(Section):
    """The outer layers from place to place (the transport model): their thickness and relief."""

    seed: int | None = quantity(
        None,
        "Seed of what differs from place to place.",
        least=0,
        most=2**63 - 1,
        source="**(ours)**",
        left_out="nacre.seed",
    )
    thickness_spread: float = quantity(
        0.0,
        "Spread (standard deviation) of the layers' thickness over the pearl, as a share of it: "
        "patches of other colours.",
        least=0,
        most=0.12,
        source="**(ours)**; mabe pearls show patches some 5 % apart (docs/coat.md)",
    )
    patch_mm: float = quantity(
        3.0,
        "Size of the patches: thickness is alike within it.",
        least=0.3,
        most=30,
        unit="mm",
        source="**(ours)**",
    )
    banding: float = quantity(
        0.0,
        "Share of what differs that lies in bands about the axis of growth.",
        least=0,
        most=1,
        source="trade, circled pearls; the share is **(ours)**",
    )
    liveliness: float = quantity(
        0.0,
        "Share of what differs beside the bands that changes with the angle it is seen at: patches "
        "that go over into others as the pearl turns.",
        least=0,
        most=1,
        source="paper 6 wishes for it, by chaos; the map is **(ours)** (docs/coat.md)",
    )
    hammering_rad: float = quantity(
        0.0,
        "Spread of the lean of a hammered surface: shallow dents that break the lamp's image.",
        least=0,
        most=0.2,
        unit="rad",
        source="trade, hammered pearls; the number is **(ours)**",
    )
    dent_mm: float = quantity(
        0.8,
        "Size of the dents.",
        least=0.3,
        most=10,
        unit="mm",
        source="**(ours)**",
    )
    grain_relief_rad: float | None = quantity(
        None,
        "Spread of the slopes of the grain, which tilts the surface where it is brighter or "
        "darker.",
        least=0,
        most=0.2,
        unit="rad",
        source="**(ours)**",
        left_out="from the knob grain",
    )
    terrace_um: float = quantity(
        0.0,
        "Spacing of the growth front's terraces, which look like fingerprints; 0 for none.",
        least=0,
        most=1000,
        unit="um",
        source="nacre's growth spirals; the spacing is **(ours)**",
    )
    terrace_step_nm: float = quantity(
        400.0,
        "Height of a terrace: a tablet's thickness.",
        least=50,
        most=2000,
        unit="nm",
        source="paper 3.2.3, tablets of 300 to 500 nm",
    )

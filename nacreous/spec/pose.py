"""The [pose] of a pearl: how it is turned in its place."""

from __future__ import annotations

from nacreous.spec.key import quantity
from nacreous.spec.section import Section


def _turn(meaning: str) -> float:
    degrees: float = quantity(
        0.0, meaning, least=-3600, most=3600, unit="degrees", source="**(ours)**"
    )
    return degrees


class Pose(Section):
    """How the pearl is turned: grain, coat and blemishes turn with it (the transport model)."""

    turn_deg: float = _turn("Turn about the upright, as on a turntable.")
    tilt_deg: float | None = quantity(
        None,
        "Lean of the axis of growth from the upright towards azimuth 0.",
        least=-3600,
        most=3600,
        unit="degrees",
        source="**(ours)**",
        left_out="0 for a round pearl; another lies at rest, its axis across the view",
    )
    spin_deg: float = _turn("Turn about the axis of growth, before both.")

"""The [camera] of a scene."""

from __future__ import annotations

from typing import Literal

from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section
from nacreous.spec.texts import WHITE, WHITE_EXAMPLES, White


class Camera(Section):
    """Where the picture is taken from, how wide it is and how bright."""

    projection: Literal["orthographic", "perspective"] = key(
        "orthographic",
        "Parallel rays, or rays that meet in the eye.",
        allowed='"orthographic" or "perspective"',
        source="**(ours)**; parallel rays make the view angle a function of the radius alone",
    )
    elevation_deg: float = quantity(
        12.0,
        "Height of the camera above the horizon, seen from the pearl.",
        least=-80,
        most=89,
        unit="degrees",
        source="**(ours)**",
    )
    azimuth_deg: float = quantity(
        0.0,
        "Direction of the camera around the pearl, to the right positive.",
        least=-360,
        most=360,
        unit="degrees",
        source="**(ours)**",
    )
    field_mm: float | None = quantity(
        None,
        "Width of the view at the pearl's centre.",
        least=0.1,
        most=10_000,
        unit="mm",
        source="**(ours)**",
        left_out="1.5 x the pearl's diameter, or as wide as the rows",
    )
    distance_mm: float = quantity(
        150.0,
        "Distance of the eye from the pearl's centre; parallel rays use it for glare alone.",
        least=20,
        most=100_000,
        unit="mm",
        source="**(ours)**",
    )
    exposure: float = quantity(
        1.0,
        "Factor on the linear picture.",
        least=0.001,
        most=1000,
        source="**(ours)**",
    )
    glare: float = quantity(
        0.0,
        "Share of the light that lens and eye spread around bright things.",
        least=0,
        most=0.5,
        source="Vos 1984, Spencer et al. 1995; the share is **(ours)**",
    )
    glare_deg: float = quantity(
        0.5,
        "Radius, seen from distance_mm, within which half of the spread light stays.",
        least=0.01,
        most=20,
        unit="degrees",
        source="**(ours)**; Vos 1984, Spencer et al. 1995 for how it falls off",
    )
    white: White = key(
        "auto",
        "The light shown as white; auto is the lamps' own.",
        allowed=WHITE,
        source="CIE illuminants",
        examples=WHITE_EXAMPLES,
    )

"""The [surface] of a pearl: what mirrors lamps and surroundings."""

from __future__ import annotations

from typing import Literal

from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section


class Surface(Section):
    """How the surface mirrors lamps and surroundings (paper 4.2)."""

    facet_spread_rad: float | None = quantity(
        None,
        "Spread of the microscopic facets' slopes; wider blurs the lamp's image.",
        least=0.005,
        most=0.6,
        unit="rad",
        source="paper 4.2, Torrance-Sparrow",
        left_out="from the knob shininess",
    )
    mirror_weight: float | None = quantity(
        None,
        "Share of the mirrored surroundings that the surface leaves clear.",
        least=0,
        most=1,
        source="paper 4.2; as a weight **(ours)**",
        left_out="from the knob shininess",
        model="illuminant",
    )
    layer_reflectance: float = quantity(
        0.1,
        "Share of the light entering the surface that the layers mirror in the same direction; "
        "0 leaves Fresnel's share alone, as in the paper.",
        least=0,
        most=0.9,
        source="exact reflectance of 100 bilayers: 0.09 isotropic, 0.24 uniaxial",
        model="illuminant",
    )
    falloff_mm: float = quantity(
        40.0,
        "Distance over which the mirrored image of a thing fades to 1/e of its contrast.",
        least=0.1,
        most=1_000_000,
        unit="mm",
        source="paper 4.2, attenuation by distance; the length is **(ours)**",
        model="illuminant",
    )
    facets: Literal["torrance-sparrow", "ggx"] = key(
        "torrance-sparrow",
        "How the microscopic facets lean: bell-shaped with grooves, or with GGX's long tails.",
        allowed='"torrance-sparrow" or "ggx"',
        source="paper 4.2, Torrance and Sparrow 1967; Walter and others 2007 (GGX)",
        model="transport",
    )
    waviness_rad: float = quantity(
        0.05,
        "Spread of the lean of the tablets below against the surface: what they mirror lies around "
        "the lamp's image, coloured; 0 leaves all in one image.",
        least=0,
        most=0.3,
        unit="rad",
        source="5 degrees to either side in mature nacre of Pinna, 7.5 in early nacre "
        "(Hovden and others 2015); of pearls nobody has measured it **(ours)**",
        model="transport",
    )

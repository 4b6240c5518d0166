"""The [interference] of a pearl, which the illuminant model alone has."""

from __future__ import annotations

from nacreous.spec.key import quantity
from nacreous.spec.section import Section


class Interference(Section):
    """How the interfering light is added up (the illuminant model, paper 3.2.4)."""

    coherence_nm: float = quantity(
        5000.0,
        "Optical path difference up to which reflected waves interfere; 0 leaves no fringes.",
        least=0,
        most=1_000_000,
        unit="nm",
        source="paper 3.2.4, 5 um",
    )
    threshold: float = quantity(
        0.05,
        "Share of the light going down at which the sum over start layers ends.",
        least=0,
        below=1,
        source="paper 3.2.4, 0.05",
    )
    diffuse_loss: float | None = quantity(
        None,
        "Share D of the light that each layer scatters, in T + R + D = 1.",
        least=0,
        most=0.9,
        source="paper 4.1, equation 4",
        left_out="from the knob depth",
    )
    mixing: float | None = quantity(
        None,
        "Share of the interference component beside the diffuse one: 0 all diffuse, 1 none.",
        least=0,
        most=1,
        source="paper 4.1, mixing ratio",
        left_out="from the knob depth",
    )

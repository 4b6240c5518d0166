"""The [display] of a study: how stimuli are made and shown."""

from __future__ import annotations

from collections.abc import Iterator
from math import isqrt

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import quantity
from nacreous.spec.section import Section


class Display(Section):
    """How large stimuli are, and on which grey."""

    width_mm: float = quantity(
        60.0,
        "Width of a stimulus on the participant's screen.",
        least=1,
        most=1000,
        unit="mm",
        source="**(ours)**",
    )
    size_px: int = quantity(
        512,
        "Pixels a side of a picture that is rendered, before crops are cut.",
        least=32,
        most=2048,
        source="**(ours)**",
    )
    samples: int = quantity(
        16,
        "Samples a pixel of a picture that is rendered, a square number.",
        least=1,
        most=1024,
        source="**(ours)**",
    )

    background_code: int = quantity(
        119,
        "The grey of all pages, around the pictures and between them, as the code of an sRGB "
        "grey; 119 has 18 % of white's luminance.",
        least=0,
        most=255,
        source="**(ours)**, the grey card of photography",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """Samples that do not fill a square."""
        if isqrt(self.samples) ** 2 != self.samples:
            verdict = f"is {shown(self.samples)}; allowed: a square number, 1 to 1024"
            yield Contradiction("samples", verdict)

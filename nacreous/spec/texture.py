"""The [texture] of a pearl: the grain of its surface."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from nacreous.spec.complaint import Contradiction
from nacreous.spec.key import FilePath, key, quantity
from nacreous.spec.section import Section
from nacreous.spec.texts import ending

_PHOTOGRAPHS = (".png", ".jpg", ".jpeg", ".tif", ".tiff")


class Texture(Section):
    """The grain of the surface, from a photograph or a stand-in (paper 4.3)."""

    source: Annotated[
        str, Field(pattern=f"^(procedural|{ending(*_PHOTOGRAPHS)})$"), FilePath(_PHOTOGRAPHS)
    ] = key(
        "procedural",
        "Photograph of a real pearl, its path relative to this file, or a procedural stand-in.",
        allowed=f'"procedural" or a path ending in {", ".join(_PHOTOGRAPHS)}',
        source="paper 4.3; the stand-in is **(ours)**",
        examples=["procedural"],
    )
    mm_per_pixel: float | None = quantity(
        None,
        "Size of the photograph's pixels on the pearl.",
        above=0,
        most=100,
        unit="mm",
        source="measured on the photograph",
        left_out="unknown, and limits are in cycles a patch",
    )
    side_px: int = quantity(
        64,
        "Side of the square patches whose spectrum is taken.",
        least=8,
        most=4096,
        unit="pixels",
        source="paper 4.3, 64 x 64",
    )
    low_per_mm: float | None = quantity(
        None,
        "Lower limit of the band-pass filter.",
        above=0,
        most=1000,
        unit="cycles per mm",
        source="paper 4.3, band-pass filter",
        left_out="the default band of the grain",
    )
    high_per_mm: float | None = quantity(
        None,
        "Upper limit of the band-pass filter.",
        above=0,
        most=1000,
        unit="cycles per mm",
        source="paper 4.3, band-pass filter",
        left_out="the default band of the grain",
    )
    seed: int | None = quantity(
        None,
        "Seed of the texture's random phases.",
        least=0,
        most=2**63 - 1,
        source="**(ours)**",
        left_out="nacre.seed",
    )
    hue_weight: float | None = quantity(
        None,
        "Weight of the hue texture on the diffuse component.",
        least=0,
        most=10,
        source="paper 4.4, weights found by trial",
        left_out="from the knob grain",
    )
    chroma_weight: float | None = quantity(
        None,
        "Weight of the chroma texture on the diffuse component.",
        least=0,
        most=10,
        source="paper 4.4, weights found by trial",
        left_out="from the knob grain",
    )
    value_weight: float | None = quantity(
        None,
        "Weight of the lightness texture on the mirrored component.",
        least=0,
        most=10,
        source="paper 4.4, weights found by trial",
        left_out="from the knob grain",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A band whose lower limit is above its upper one."""
        low, high = self.low_per_mm, self.high_per_mm
        if low is not None and high is not None and low >= high:
            yield Contradiction(
                "low_per_mm",
                f"is {low:g}; allowed: less than {{other}}, which is {high:g} cycles per mm",
                "high_per_mm",
            )

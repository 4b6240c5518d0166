"""The pearl: its structure, its body and its surface."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Field, Tag

from nacreous.spec.complaint import Contradiction
from nacreous.spec.growth import Growth
from nacreous.spec.key import FilePath, key, quantity, section
from nacreous.spec.nacre import Layers
from nacreous.spec.section import Section
from nacreous.spec.specfile import SpecFile
from nacreous.spec.words import COLOUR, NAME, Colour, Name, ending


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
    )
    layer_reflectance: float = quantity(
        0.1,
        "Share of the light entering the surface that the layers mirror in the same direction; "
        "0 leaves Fresnel's share alone, as in the paper.",
        least=0,
        most=0.9,
        source="exact reflectance of 100 bilayers: 0.09 isotropic, 0.24 uniaxial",
    )
    falloff_mm: float = quantity(
        40.0,
        "Distance over which the mirrored image of a thing fades to 1/e of its contrast.",
        least=0.1,
        most=1_000_000,
        unit="mm",
        source="paper 4.2, attenuation by distance; the length is **(ours)**",
    )


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


def _grown_or_listed(nacre: Any) -> str:
    listed = isinstance(nacre, Layers) or (isinstance(nacre, dict) and "thickness_nm" in nacre)
    return "layers" if listed else "growth"


class Pearl(SpecFile):
    """A pearl file: everything that belongs to the pearl and not to its surroundings.

    >>> pearl = Pearl.load("paper", overrides=[("nacre.seed", "9"), ("depth", "0.8")])
    >>> pearl.nacre.seed, pearl.depth, pearl.diameter_mm
    (9, 0.8, 8.0)
    """

    preset_kind: ClassVar[str] = "pearl"

    name: Name = key("pearl", "What the pearl is called.", allowed=NAME, source="free")
    model: Literal["illuminant"] = key(
        "illuminant",
        "The model of the interfering light: the paper's illuminant model.",
        allowed='"illuminant"',
        source="paper 3.1",
    )
    diameter_mm: float = quantity(
        8.0,
        "Diameter of the whole pearl.",
        least=1,
        most=30,
        unit="mm",
        source="**(ours)**; paper 3.1, a nucleus of 3 to 6 mm",
    )
    body_colour: Colour = key(
        "#f3ede4",
        "Body colour as sRGB: the colour of the diffuse component.",
        allowed=COLOUR,
        source="paper 4.1; the colour is **(ours)**",
    )
    depth: float = quantity(
        0.6,
        "Knob: strength of the interference colour against the body colour (fukami, maki).",
        least=0,
        most=1,
        source="paper 4.1",
    )
    shininess: float = quantity(
        0.7,
        "Knob: brightness and sharpness of what the surface mirrors (kagayaki, teri).",
        least=0,
        most=1,
        source="paper 4.2",
    )
    grain: float = quantity(
        0.5,
        "Knob: strength of the surface texture (kime).",
        least=0,
        most=1,
        source="paper 4.3",
    )
    nacre: Annotated[
        Annotated[Growth, Tag("growth")] | Annotated[Layers, Tag("layers")],
        Discriminator(_grown_or_listed),
    ] = section(Growth, "The layers: grown over a season, or listed in thickness_nm.")
    interference: Interference = section(Interference, "The sum of the interfering light.")
    surface: Surface = section(Surface, "The mirroring surface.")
    texture: Texture = section(Texture, "The grain of the surface.")

    @property
    def texture_seed(self) -> int:
        """The seed of the texture: its own, else the growth's, else 1 for listed layers."""
        if self.texture.seed is not None:
            return self.texture.seed
        return self.nacre.seed if isinstance(self.nacre, Growth) else 1

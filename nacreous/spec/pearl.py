"""The pearl: its structure, its body and its surface."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, SerializerFunctionWrapHandler, Tag, model_serializer

from nacreous.spec.blemishes import Blemishes
from nacreous.spec.body import Body
from nacreous.spec.coat import Coat
from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.film import Film
from nacreous.spec.growth import Growth
from nacreous.spec.inside import Inside
from nacreous.spec.interference import Interference
from nacreous.spec.key import key, quantity, section
from nacreous.spec.medium import is_isotropic, loss
from nacreous.spec.model import own_keys, strangers
from nacreous.spec.nacre import Layers
from nacreous.spec.pose import Pose
from nacreous.spec.shape import Shape
from nacreous.spec.specfile import SpecFile
from nacreous.spec.surface import Surface
from nacreous.spec.texts import COLOUR, NAME, Colour, Name
from nacreous.spec.texture import Texture


def _grown_or_listed(nacre: Any) -> str:
    listed = isinstance(nacre, Layers) or (isinstance(nacre, dict) and "thickness_nm" in nacre)
    return "layers" if listed else "growth"


#: Lumps are so many times as wide as they are high on average; steeper ones would be needles.
_LUMP = 5


class Pearl(SpecFile):
    """A pearl file: everything that belongs to the pearl and not to its surroundings.

    >>> pearl = Pearl.load("paper", overrides=[("nacre.seed", "9"), ("depth", "0.8")])
    >>> pearl.nacre.seed, pearl.depth, pearl.diameter_mm
    (9, 0.8, 8.0)
    """

    preset_kind: ClassVar[str] = "pearl"

    name: Name = key("pearl", "What the pearl is called.", allowed=NAME, source="free")
    model: Literal["transport", "illuminant"] = key(
        "transport",
        "The model of the light: through the pearl and out again, or the paper's illuminant model.",
        allowed='"transport" or "illuminant"',
        source="Ozaki and others 2021; paper 3.1",
    )
    diameter_mm: float = quantity(
        8.0,
        "Diameter of the whole pearl; of one that is not round, its width across the axis of "
        "growth.",
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
        model="illuminant",
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
    ] = section("The layers: grown over a season, or listed in thickness_nm.")
    film: Film = section("The outer layers, which interfere.", model="transport")
    body: Body = section("The scattering nacre and the nucleus.", model="transport")
    inside: Inside = section("The way of the light inside.", model="transport")
    interference: Interference = section("The sum of the interfering light.", model="illuminant")
    surface: Surface = section("The mirroring surface.")
    texture: Texture = section("The grain of the surface.")
    coat: Coat = section("What differs from place to place.", model="transport")
    blemishes: Blemishes = section("Pits, bumps and the like.", model="transport")
    shape: Shape = section("What makes the pearl other than round.", model="transport")
    pose: Pose = section("How the pearl is turned.", model="transport")

    def contradictions(self) -> Iterator[Contradiction]:
        """Keys and media that the model has not, nacre thicker and a hole wider than the pearl."""
        for path, home in strangers(self, self.model):
            verdict = f'is given while {{other}} is "{self.model}"; allowed: only with {{other}} = '
            yield Contradiction(path, f'{verdict}"{home}"', "model")
        yield from self._unfit_media()
        radius_mm = 0.5 * self.diameter_mm
        within = {"body.nacre_mm": self.body.nacre_mm, "shape.drill_mm": self.shape.drill_mm}
        for path, length_mm in within.items():
            if length_mm is not None and length_mm > radius_mm:
                yield Contradiction(
                    path,
                    f"is {length_mm:g}; allowed: up to half of {{other}}, "
                    f"which is {radius_mm:g} mm",
                    "diameter_mm",
                )
        lump_mm, least_mm = self.shape.lump_mm, _LUMP * self.shape.lumps * radius_mm
        if lump_mm is not None and lump_mm < least_mm:
            yield Contradiction(
                "shape.lump_mm",
                f"is {lump_mm:g}; allowed: at least {_LUMP} x {{other}} x half of diameter_mm, "
                f"{least_mm:g} mm",
                "shape.lumps",
            )

    def _unfit_media(self) -> Iterator[Contradiction]:
        """Absorbing layers, which neither model has, and crystals in the model of 1996."""
        for name in ("aragonite", "protein"):
            medium = getattr(self.nacre, name)
            if loss(medium) > 0:
                allowed = "k = 0; what absorbs is body.pigment"
            elif self.model == "illuminant" and not is_isotropic(medium):
                allowed = "an index that is the same in all directions, such as 1.53"
            else:
                continue
            verdict = f'is {shown(medium)} while {{other}} is "{self.model}"; allowed: {allowed}'
            yield Contradiction(f"nacre.{name}", verdict, "model")

    @model_serializer(mode="wrap")
    def _own_keys(self, dump: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Without the keys of the other model, which would be refused when read again."""
        return own_keys(self, dump(self), self.model)

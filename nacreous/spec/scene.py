"""The scene: camera, lamps and what stands around the pearl.

Directions and positions share one frame with the pearl's centre at the origin: y is up, z points
to where the camera stands at azimuth 0, x to that viewer's right. Of several pearls, the origin is
the middle of the rows, as high as the centre of the largest.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from nacreous.spec.camera import Camera
from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import FilePath, key, quantity, section
from nacreous.spec.lamp import Lamp
from nacreous.spec.row import GIVEN, MOST_PEARLS, Row
from nacreous.spec.section import Section
from nacreous.spec.specfile import SpecFile
from nacreous.spec.texts import COLOUR, NAME, Colour, Name, ending
from nacreous.spec.window import Window


class Table(Section):
    """The table that the pearl lies on."""

    kind: Literal["none", "plain", "checker", "cloth"] = key(
        "checker",
        "No table, one colour, squares of two colours, or woven cloth.",
        allowed='"none", "plain", "checker" or "cloth"',
        source="paper 4.2, figure 12, a table mirrored in the pearl; its pattern is **(ours)**",
    )
    colour: Colour = key(
        "#d8d4cc", "Colour of the table as sRGB.", allowed=COLOUR, source="**(ours)**"
    )
    second_colour: Colour = key(
        "#5a554d",
        "Colour of every other square, or of the gaps between the cloth's threads.",
        allowed=COLOUR,
        source="**(ours)**",
    )
    check_mm: float = quantity(
        4.0,
        "Side of a square of the checker.",
        least=0.1,
        most=1000,
        unit="mm",
        source="**(ours)**",
    )
    weave_mm: float = quantity(
        0.5,
        "Distance between the cloth's threads.",
        least=0.05,
        most=100,
        unit="mm",
        source="**(ours)**",
    )


class Walls(Section):
    """Four walls around the table; without this section there are none."""

    half_width_mm: float = quantity(
        150.0,
        "Distance of each wall from the pearl's centre.",
        least=20,
        most=100_000,
        unit="mm",
        source="**(ours)**",
    )
    height_mm: float = quantity(
        200.0,
        "Height of the walls above the table.",
        least=1,
        most=100_000,
        unit="mm",
        source="**(ours)**",
    )
    colour: Colour = key(
        "#b9b4ab", "Colour of the walls as sRGB.", allowed=COLOUR, source="**(ours)**"
    )


_PANORAMAS = (".hdr", ".exr")


class Sky(Section):
    """What lies beyond table and walls."""

    kind: Literal["constant", "gradient", "panorama"] = key(
        "constant",
        "The horizon's colour everywhere, a gradient up to the zenith, or a panorama.",
        allowed='"constant", "gradient" or "panorama"',
        source="**(ours)**",
    )
    horizon: Colour = key(
        "#ffffff", "Colour at the horizon as sRGB.", allowed=COLOUR, source="**(ours)**"
    )
    zenith: Colour = key("#ffffff", "Colour overhead as sRGB.", allowed=COLOUR, source="**(ours)**")
    intensity: float = quantity(
        0.2,
        "Irradiance of a whole white sky on a surface facing up, in the lamps' unit.",
        least=0,
        most=1_000_000,
        source="**(ours)**",
    )
    path: Annotated[str | None, Field(pattern=f"^{ending(*_PANORAMAS)}$"), FilePath(_PANORAMAS)] = (
        key(
            None,
            "High-range panorama in latitude and longitude; its path is relative to this file. Its "
            "middle lies at azimuth 180, straight ahead of a camera at azimuth 0.",
            allowed=f"a path ending in {' or '.join(_PANORAMAS)}",
            left_out="no panorama",
            source="**(ours)**",
        )
    )
    rotation_deg: float = quantity(
        0.0,
        "Turn of the panorama about the y axis; seen from above, counter-clockwise.",
        least=-360,
        most=360,
        unit="degrees",
        source="**(ours)**",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A panorama without its file, or a file that would not be used."""
        if (self.kind == "panorama") != (self.path is not None):
            yield Contradiction(
                "path",
                f"is {'missing' if self.path is None else shown(self.path)} while {{other}} is "
                f'"{self.kind}"; allowed: a path with "panorama", and only with it',
                "kind",
            )


class Scene(SpecFile):
    """A scene file: everything around the pearl.

    >>> Scene.load("paper").lamps[0].spectrum
    'E'
    """

    preset_kind: ClassVar[str] = "scene"

    name: Name = key("scene", "What the scene is called.", allowed=NAME, source="free")
    observer: Literal["1931-2", "1964-10"] = key(
        "1931-2",
        "CIE standard observer: of 1931 for 2 degrees, or of 1964 for 10.",
        allowed='"1931-2" or "1964-10"',
        source="CIE 015:2018",
    )
    pitch_mm: float | None = quantity(
        None,
        "Distance in a row from the middle of a pearl to that of the next.",
        least=1,
        most=1000,
        unit="mm",
        source="**(ours)**",
        left_out="1.1 x the largest pearl's diameter",
    )
    row_gap_mm: float | None = quantity(
        None,
        "Distance from the middle of a row to that of the next.",
        least=1,
        most=1000,
        unit="mm",
        source="**(ours)**",
        left_out="1.1 x the largest pearl's diameter",
    )
    camera: Camera = section("The camera.")
    lamps: Annotated[tuple[Lamp, ...], Field(max_length=256)] = key(
        (),
        "The lamps, each headed [[lamps]].",
        allowed="0 to 256 tables, each headed [[lamps]]",
        source="**(ours)**",
        strict=False,
    )
    windows: Annotated[tuple[Window, ...], Field(max_length=64)] = key(
        (),
        "Rectangles of light, each headed [[windows]].",
        allowed="0 to 64 tables, each headed [[windows]]",
        source="trade: north-window light, lit plates and panels",
        strict=False,
    )
    rows: Annotated[tuple[Row, ...], Field(max_length=MOST_PEARLS)] = key(
        (),
        "Rows of pearls, each headed [[rows]]; without them, the one pearl given.",
        allowed=f"0 to {MOST_PEARLS} tables, each headed [[rows]]",
        source="**(ours)**",
        strict=False,
    )
    table: Table = section("The table below the pearl.")
    walls: Walls | None = section("The walls around; none when left out.", optional=True)
    sky: Sky = section("What lies beyond.")

    def contradictions(self) -> Iterator[Contradiction]:
        """Rows that cannot be filled, or a lit plate below a table."""
        for number, window in enumerate(self.windows):
            if window.below_mm is not None and self.table.kind != "none":
                yield Contradiction(
                    f"windows.{number}.below_mm",
                    f"is {shown(window.below_mm)} while {{other}} is {shown(self.table.kind)}, "
                    'which hides it; allowed: only with "none"',
                    "table.kind",
                )
        names = [name for row in self.rows for name in row.pearls]
        if len(names) > MOST_PEARLS:
            yield Contradiction(
                "rows", f"hold {len(names)} pearls together; allowed: at most {MOST_PEARLS}"
            )
        if names and not any(name.startswith(GIVEN) for name in names):
            yield Contradiction("rows", f'have no "{GIVEN}"; wanted: a place for the pearl given')

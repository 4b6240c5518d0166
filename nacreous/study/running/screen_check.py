"""A screen check: what a participant's browser measured of the screen and of the eyes before it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, JsonValue

from nacreous.spec.key import key, quantity

__all__ = ["Card", "Monitor", "Plates", "ScreenCheck", "Vision", "Window"]

_BROWSER = "CSSOM View"


class Measured(BaseModel):
    """A table of measurements. Keys that this version does not know are kept as they came.

    A page that was loaded before the server was renewed, or is newer than it, may send other keys;
    what a participant took minutes to measure is not lost for that. Values that no screen has are
    refused.
    """

    model_config = ConfigDict(extra="allow", strict=True, frozen=True, allow_inf_nan=False)
    __pydantic_extra__: dict[str, JsonValue] = Field(init=False)


class Window(Measured):
    """The window that pictures are shown in."""

    width_px: float = quantity(
        ..., "Width inside, in CSS pixels.", least=0, most=1e6, source=_BROWSER, unit="px"
    )
    height_px: float = quantity(
        ..., "Height inside, in CSS pixels.", least=0, most=1e6, source=_BROWSER, unit="px"
    )
    device_pixel_ratio: float | None = quantity(
        None,
        "Pixels of the screen in a CSS pixel, across.",
        above=0,
        most=1000,
        source=_BROWSER,
        left_out="not known",
    )


class Monitor(Measured):
    """The whole screen."""

    width_px: float = quantity(
        ..., "Width, in CSS pixels.", least=0, most=1e6, source=_BROWSER, unit="px"
    )
    height_px: float = quantity(
        ..., "Height, in CSS pixels.", least=0, most=1e6, source=_BROWSER, unit="px"
    )
    colour_depth: int | None = quantity(
        None,
        "Bits of a pixel's colour, as the browser says.",
        least=0,
        most=1000,
        source=_BROWSER,
        unit="bits",
        left_out="not known",
    )


class Card(Measured):
    """The size of a pixel, by a bank card held against the screen."""

    px_per_mm: float = quantity(
        ..., "CSS pixels in a millimetre.", above=0, most=1e6, source="ISO/IEC 7810", unit="px/mm"
    )


class Plates(Measured):
    """How many of the plates of one test of the eyes were read right."""

    right: int = quantity(..., "Plates read right.", least=0, most=1e6, source="**(ours)**")
    of: int = quantity(..., "Plates shown.", least=0, most=1e6, source="**(ours)**")


class Vision(Measured):
    """The tests of the eyes that were made."""

    contrast: Plates | None = Field(None, description="Rings of low contrast.")
    colour: Plates | None = Field(None, description="Digits that colour alone tells.")


Distance = Annotated[float, Field(ge=0, le=1e6)]


class ScreenCheck(Measured):
    """What was found out about a screen; what nobody measured is None or left out.

    >>> ScreenCheck(card={"px_per_mm": 4.2}, gamma=None).card.px_per_mm
    4.2
    """

    window: Window | None = Field(None, description="The window that pictures are shown in.")
    full_screen: bool | None = Field(None, description="Whether the pages fill the screen.")
    screen: Monitor | None = Field(None, description="The whole screen.")
    card: Card | None = Field(None, description="The size of a pixel, by a bank card.")
    picture_width_mm: float | None = quantity(
        None,
        "Width of the widest picture as it is meant to be on the screen.",
        least=0,
        most=1e6,
        source="the study's display",
        unit="mm",
        left_out="the size of a pixel is not known",
    )
    distance_mm: float | None = quantity(
        None,
        "From the eyes to the screen; of the blind spot, the median of all tries.",
        least=0,
        most=1e6,
        source="Li et al. 2020, Virtual Chinrest",
        unit="mm",
        left_out="not known",
    )
    distance_by: Literal["blind-spot", "typed", "none"] | None = Field(
        None, description="How the distance was found."
    )
    distance_tries_mm: list[Distance] | None = key(
        None,
        "The distance by each try with the blind spot.",
        allowed="up to 100 numbers, 0 to 1000000 mm",
        source="Li et al. 2020, Virtual Chinrest",
        unit="mm",
        left_out="the blind spot was not tried",
        max_length=100,
    )
    gamma: float | None = quantity(
        None,
        "The exponent of the screen, matched by eye.",
        least=0,
        most=1e6,
        source="a grey as bright as stripes, half black and half white",
        left_out="not measured",
    )
    darkest_step: int | None = quantity(
        None,
        "The first grey code above black that is seen; 255 where none is.",
        least=0,
        most=255,
        source="**(ours)**",
        left_out="not measured",
    )
    gamut: Literal["less", "srgb", "p3", "rec2020"] | None = Field(
        None, description="The widest gamut that the screen shows, as the browser says."
    )
    hdr: bool | None = Field(
        None, description="Whether the screen has a high dynamic range, as the browser says."
    )
    vision: Vision | None = Field(None, description="The tests of the eyes that were made.")
    agent: Annotated[str, Field(max_length=200)] | None = Field(
        None, description="The browser's family and version."
    )
    simulated: bool | None = Field(
        None, description="Whether a simulated participant checked the screen."
    )

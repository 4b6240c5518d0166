"""Numbers from a picture of a pearl: size, roundness, colour by ring, the lamp's image, blemishes.

A render and a photograph are measured alike, from linear light and what is known of it. What
cannot be measured is refused by name. The definitions, with their sources: docs/measure.md.

>>> import nacreous as nc
>>> found = measure(nc.render("akoya-rg", size=128, samples=4), mm_per_pixel=12 / 128)
>>> round(found.size.mean.value, 1), found.size.unit, found.sphere
(8.0, 'mm', True)
"""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, TypeAlias

from nacreous import _core
from nacreous.linear_light import linear_of
from nacreous.number import array_of, number_of, row_of
from nacreous.problem import InputError
from nacreous.value import value_class

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "HUES",
    "RELATIVE_WHITE",
    "Blemishes",
    "Circle",
    "Colour",
    "Interference",
    "LampImage",
    "Measures",
    "Number",
    "Outline",
    "Ring",
    "Size",
    "measure",
]

#: The six regions of hue that interference is counted by; their middles lie 60 degrees apart in
#: CIELAB, from 30 degrees on.
HUES = ("red", "yellow", "green", "blue-green", "blue", "purple")
#: The white of a picture that is its own: linear RGB.
RELATIVE_WHITE = (1.0, 1.0, 1.0)

Places: TypeAlias = tuple[tuple[float, float], ...]


@value_class
class Number:
    """A measured number and its standard error, in the same unit; None where none can be had."""

    value: float
    error: float | None = None


@value_class
class Circle:
    """A circle in pixels; (0, 0) is the outer corner of the first pixel, y runs down."""

    x_px: float
    y_px: float
    radius_px: float


@value_class
class Outline:
    """Where the pearl is: the circle as large as it on average, and its outline."""

    circle: Circle
    given: bool
    """Whether a circle was given to start from."""
    share: float
    """In how large a share of all directions an edge is seen on it."""
    line: Places
    """Places on it, in pixels."""


@value_class
class Size:
    """Feret's diameters: distances of parallel tangents, over all directions in the picture."""

    unit: str
    """"mm", or "px" where no scale is given."""
    mean: Number
    least: Number
    greatest: Number


@value_class
class Colour:
    """A colour in CIELAB relative to the white."""

    lightness: Number
    chroma: Number
    hue_deg: Number | None
    """0 to 360 degrees; None of a grey."""


@value_class
class Ring:
    """The pearl's colour between two distances from its middle, in radii."""

    inner: float
    outer: float
    view_deg: float
    """View angle half-way."""
    share: float
    """Share of the ring that the lamp's image and clipped light leave."""
    colour: Colour | None


@value_class
class Interference:
    """How colour is spread over the pearl and over hues."""

    chroma: Number
    """Mean chroma."""
    orient: Number
    """Root mean square distance of its parts from their mean colour, in (a*, b*)."""
    by_hue: tuple[float, ...]
    """Area that is saturated, in percent, by `HUES`."""
    score: Number
    """Their sum."""


@value_class
class LampImage:
    """The lamp's image. Angles are those of the surface's normal: light turns by twice as much."""

    x_px: float
    y_px: float
    view_deg: float
    """View angle of its middle."""
    peak: float
    """Luminance at its brightest; the white has 1."""
    around: Number
    """Luminance around it."""
    half_width_deg: Number
    """From its middle to half of the peak above what is around."""
    contrast_gloss: Number
    """1 - around / peak, in percent (Hunter)."""
    haze: Number | None
    """Light 2.5 degrees beyond the half-level line, in percent of the peak above what is around."""
    distinctness: Number | None
    """Fall within a degree to both sides of that line, in percent of the same."""
    line: Places
    """Places of that line, in pixels."""


@value_class
class Blemishes:
    """Spots that differ from the pearl around them."""

    area: Number
    """Their area on the ball, in percent of what was looked at."""
    count: int
    looked_at: float
    """Share of the visible half of the ball."""
    threshold: float
    """The least difference that comes to count here, in L*: 0.7, or more in rough texture."""
    spots: tuple[Circle, ...]
    """Discs as large as they are on the ball, the largest first."""


@value_class
class Measures:
    """What `measure` finds in a picture; what is None is in `refused`, with the reason."""

    outline: Outline
    size: Size
    roundness: Number
    """(greatest - least) / mean diameter, in percent."""
    sphere: bool
    """Whether roundness is 5 % at the most, seen from here."""
    colour: Colour | None
    """Of the whole pearl, lamp's image and shadows left out."""
    rings: tuple[Ring, ...] | None
    interference: Interference | None
    lamp: LampImage | None
    blemishes: Blemishes | None
    refused: Mapping[str, str]
    """Why a part is None, or what is not told of it, by its name."""

    def to_json(self) -> str:
        """All of it for machines; numbers as {"value": ..., "error": ...}, null where refused."""
        return json.dumps(_plain(self), indent=1) + "\n"


def measure(
    picture: ArrayLike,
    *,
    white: Sequence[float] = RELATIVE_WHITE,
    circle: tuple[float, float, float] | None = None,
    mm_per_pixel: float | None = None,
    clipped_at: float | None = None,
    opacity: ArrayLike | None = None,
) -> Measures:
    """Measure the one pearl in a picture of linear RGB [row, column, 3] (`nacreous.Image` too).

    white: linear RGB that a white matt thing has in the picture's light. circle: x, y and radius
    of the pearl in pixels, roughly; left out, it is found. mm_per_pixel: on the plane through the
    pearl's middle; left out, sizes are in pixels. clipped_at: linear light from which a file's
    codes no longer follow, such as 0.97 of 8 bits. opacity: [row, column], from 0 beside the pearl
    to 1 on it, as a picture's alpha has it; the outline is looked for in it.

    Raises `InputError` for what is no such picture, numbers out of range, and a picture of no
    pearl, of several, or of one that is cut off, under 12 pixels in radius, or whose outline cannot
    be followed.

    >>> measure([[[0.2] * 3] * 64] * 64)
    Traceback (most recent call last):
    nacreous.problem.InputError: no pearl: no round outline stands out (an edge in 0 % of all \
directions; wanted: 40 %)
    """
    linear = linear_of(picture)
    found = _core.measure(
        linear,
        _three("white", white),
        None if circle is None else _circle(circle),
        None if mm_per_pixel is None else number_of("mm_per_pixel", mm_per_pixel),
        None if clipped_at is None else number_of("clipped_at", clipped_at),
        None if opacity is None else _opacity(opacity, linear),
    )
    return _measures(json.loads(found))


def _opacity(opacity: ArrayLike, linear: NDArray[np.float32]) -> NDArray[np.float32]:
    shares = array_of("opacity", opacity)
    if shares.shape != linear.shape[:2]:
        raise InputError(
            f"opacity has the shape {shares.shape}; allowed: {linear.shape[:2]}, as the picture"
        )
    if not ((shares >= 0) & (shares <= 1)).all():
        raise InputError("opacity has numbers outside 0 to 1; allowed: 0 to 1")
    return shares.astype("float32")


def _circle(values: Sequence[float]) -> tuple[float, float, float]:
    circle = _three("circle", values)
    for name, value in zip(("x", "y", "radius"), circle, strict=True):
        if not math.isfinite(value):
            raise InputError(f"the circle's {name} is {value:g}; allowed: finite pixels")
    return circle


def _three(name: str, values: Sequence[float]) -> tuple[float, float, float]:
    numbers = row_of(name, values)
    if len(numbers) != 3:
        raise InputError(f"{name} has {len(numbers)} numbers; allowed: 3")
    return float(numbers[0]), float(numbers[1]), float(numbers[2])


def _measures(found: _Record) -> Measures:
    place, size, rings = found["place"], found["size"], found["rings"]
    spots = found["blemishes"]
    return Measures(
        outline=Outline(
            Circle(**place["circle"]), place["given"], place["share"], _places(place["line"])
        ),
        size=Size(size["unit"], *(_known(size[name]) for name in ("mean", "least", "greatest"))),
        roundness=_known(found["roundness"], 100.0),
        sphere=found["sphere"],
        colour=_colour(found["colour"]),
        rings=None if rings is None else tuple(map(_ring, rings["rings"])),
        interference=None if rings is None else _interference(rings),
        lamp=None if found["lamp"] is None else _lamp(found["lamp"]),
        blemishes=None if spots is None else _blemishes(spots),
        refused={one["quantity"]: one["reason"] for one in found["refused"]},
    )


def _known(number: _Record, factor: float = 1.0) -> Number:
    error = number["error"]
    return Number(factor * number["value"], None if error is None else factor * error)


def _number(number: _Record | None) -> Number | None:
    return None if number is None else _known(number)


def _places(line: list[list[float]]) -> Places:
    return tuple((x, y) for x, y in line)


def _colour(colour: _Record | None) -> Colour | None:
    if colour is None:
        return None
    return Colour(_known(colour["lightness"]), _known(colour["chroma"]), _number(colour["hue_deg"]))


def _ring(ring: _Record) -> Ring:
    return Ring(ring["from"], ring["to"], ring["view_deg"], ring["share"], _colour(ring["colour"]))


def _interference(rings: _Record) -> Interference:
    return Interference(
        _known(rings["chroma"]),
        _known(rings["orient"]),
        tuple(rings["interference"]),
        _known(rings["interference_total"]),
    )


def _lamp(lamp: _Record) -> LampImage:
    return LampImage(
        x_px=lamp["x_px"],
        y_px=lamp["y_px"],
        view_deg=lamp["view_deg"],
        peak=lamp["peak"],
        around=_known(lamp["around"]),
        half_width_deg=_known(lamp["half_width_deg"]),
        contrast_gloss=_known(lamp["contrast_gloss"]),
        haze=_number(lamp["haze"]),
        distinctness=_number(lamp["distinctness"]),
        line=_places(lamp["line"]),
    )


def _blemishes(found: _Record) -> Blemishes:
    return Blemishes(
        _known(found["area"]),
        found["count"],
        found["looked_at"],
        found["threshold"],
        tuple(Circle(**spot) for spot in found["spots"]),
    )


def _plain(value: object) -> object:
    """A value as JSON has it."""
    if dataclasses.is_dataclass(value):
        names = (field.name for field in dataclasses.fields(value))
        return {name: _plain(getattr(value, name)) for name in names}
    if isinstance(value, Mapping):
        return {name: _plain(part) for name, part in value.items()}
    return [_plain(part) for part in value] if isinstance(value, tuple) else value


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__


if TYPE_CHECKING:
    from typing import Any

    _Record: TypeAlias = dict[str, Any]

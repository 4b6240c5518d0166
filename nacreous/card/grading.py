"""The trade's table, applied to a pearl's file and to what is measured in its picture."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING

from nacreous import _core
from nacreous.card.factor import Factor, Figure
from nacreous.trade import (
    Stated,
    dimensions_of,
    stated_luster,
    stated_size,
    stated_surface,
    word_of,
)

if TYPE_CHECKING:
    from nacreous.measure import Colour, Measures, Ring
    from nacreous.spec import Pearl

__all__ = ["CULTURES", "graded"]

#: Kinds of pearls that the table has words of nacre for.
CULTURES = ("akoya", "tahitian", "south-sea")

#: What the table tells shapes by, with units, in the order in which a card has it.
_DIMENSIONS = {
    "diameter_variation_percent": "%",
    "height_over_width": "",
    "taper_percent": "%",
    "asymmetry_percent": "%",
    "grooves": "",
}
_BALL = dict.fromkeys(_DIMENSIONS, 0.0) | {"height_over_width": 1.0}
#: Rings of less chroma have no hue that anybody sees: the table's bound of an overtone.
_LEAST_CHROMA = 2.0


#: Shapes of which the trade says the diameter alone.
_AS_WIDE_AS_LONG = ("round", "near-round")


def graded(
    pearl: Pearl, found: Measures | str | None, culture: str | None = None
) -> tuple[Factor, ...]:
    """The factors of a pearl, in the table's order.

    found: what was measured in its picture, or why nothing could be; None without one. culture:
    one of `CULTURES`; without it the nacre has a number and no word.

    >>> from nacreous.spec import Pearl
    >>> size, *_ = graded(Pearl(diameter_mm=7.2), None)
    >>> size.word.en, size.figures[0].key
    ('7.0-7.5 mm', 'diameter_mm')
    """
    body = _body_lab(pearl)
    found, reason = (None, found) if isinstance(found, str) else (found, "")
    shape = _shape(pearl, found)
    return (
        _size(pearl, shape),
        shape,
        _bodycolour(pearl, body),
        _overtone(found, body, reason),
        _orient(found, reason),
        _luster(pearl, found),
        _surface(pearl, found, reason),
        _nacre(pearl, culture),
        Factor("matching", None, (), "one_pearl"),
    )


def _size(pearl: Pearl, shape: Factor) -> Factor:
    """By the diameter; beside it width and length of what is not round."""
    found = stated_size(pearl)
    figures = [_figure(found, "mm")]
    if shape.word is not None and shape.word.en not in _AS_WIDE_AS_LONG:
        wide_mm, long_mm = pearl.diameter_mm, pearl.diameter_mm * pearl.shape.length
        figures.append(Figure("length_mm", long_mm, "mm", "file", "shape.length", across=wide_mm))
    return Factor("size", found.word, tuple(figures))


def _unmeasured(name: str, found: Measures | None, part: str, reason: str) -> Factor:
    """A factor without a number, and why: part is what `Measures.refused` has it under."""
    if reason and name != "overtone":  # of the whole picture: told once
        return Factor(name, None, (), "as_overtone")
    why = reason if found is None else found.refused.get(part, "")
    return Factor(name, None, (), "unmeasured", why)


def _figure(found: Stated, unit: str) -> Figure:
    return Figure(found.quantity, found.value, unit, "file", found.key)


def _shape(pearl: Pearl, found: Measures | None) -> Factor:
    """By the file's form, from all sides; and the outline as it is seen, which decides no word.

    A pearl of the model of 1996 is a ball.
    """
    is_ball = pearl.model == "illuminant"
    shape = _BALL if is_ball else dimensions_of(pearl)
    word, key = word_of("shape", shape), "model" if is_ball else "shape"
    bound = {one.quantity for one in word.bounds}
    figures = [
        Figure(name, shape[name], unit, "file", key)
        for name, unit in _DIMENSIONS.items()
        if name in bound
    ]
    if found is not None:
        seen = found.roundness
        figures.append(
            Figure("outline_variation_percent", seen.value, "%", "picture", error=seen.error)
        )
    return Factor("shape", word, tuple(figures))


def _body_lab(pearl: Pearl) -> tuple[float, float, float]:
    """L*, a* and b* of the body alone under D65."""
    from nacreous import colour
    from nacreous.body import reflectance_of_body

    if pearl.model == "illuminant":
        xyz = colour.xyz_from_rgb(colour.linear_from_hex(pearl.body_colour))
    else:
        xyz = colour.xyz_from_spectrum(reflectance_of_body(pearl, _layers_mm(pearl)), "D65")
    lightness, a, b = colour.lab_from_xyz(xyz).tolist()
    return lightness, a, b


def _bodycolour(pearl: Pearl, lab: tuple[float, float, float]) -> Factor:
    key = "body_colour" if pearl.model == "illuminant" else "body"
    chroma, hue_deg = _polar(lab[1], lab[2])
    figures = (
        Figure("lightness", min(lab[0], 100.0), "L*", "file", key),
        Figure("chroma", chroma, "C*", "file", key),
        Figure("hue_deg", hue_deg, "degrees", "file", key),
    )
    return _told("bodycolour", figures)


def _overtone(found: Measures | None, body: tuple[float, float, float], reason: str) -> Factor:
    """What is seen less the body, in (a*, b*), the body as light or dark as what is seen (ours).

    Of a thing under less light, a* and b* shrink as L* + 16 does (CIE 015, above L* = 8).
    """
    seen = None if found is None else found.colour
    if seen is None:
        return _unmeasured("overtone", found, "colour", reason)
    a, b = _rectangular(seen)
    share = (seen.lightness.value + 16) / (body[0] + 16)
    chroma, hue_deg = _polar(a - share * body[1], b - share * body[2])
    figures = (
        Figure("chroma", chroma, "C*", "picture"),
        Figure("hue_deg", hue_deg, "degrees", "picture"),
    )
    return _told("overtone", figures)


def _told(name: str, figures: tuple[Figure, ...]) -> Factor:
    return Factor(name, word_of(name, {one.quantity: one.value for one in figures}), figures)


def _orient(found: Measures | None, reason: str) -> Factor:
    """The least arc that holds the hues of all rings that have one."""
    if found is None or found.rings is None or found.interference is None:
        return _unmeasured("orient", found, "rings", reason)
    hue_range_deg = _arc_deg(found.rings)
    orient = found.interference.orient
    figures = (
        Figure("hue_range_deg", hue_range_deg, "degrees", "picture"),
        Figure("orient", orient.value, "C*", "picture", error=orient.error),
    )
    return Factor("orient", word_of("orient", hue_range_deg), figures)


def _arc_deg(rings: tuple[Ring, ...]) -> float:
    hues = sorted(
        ring.colour.hue_deg.value
        for ring in rings
        if ring.colour is not None
        and ring.colour.hue_deg is not None
        and ring.colour.chroma.value >= _LEAST_CHROMA
    )
    if len(hues) < 2:
        return 0.0
    gaps = [after - before for before, after in zip(hues, [*hues[1:], hues[0] + 360], strict=True)]
    return 360.0 - max(gaps)


def _luster(pearl: Pearl, found: Measures | None) -> Factor:
    """By the facets; and the image as it is seen."""
    luster = stated_luster(pearl)
    figures = [_figure(luster, "rad")]
    if found is not None and found.lamp is not None:
        width = found.lamp.half_width_deg
        figures.append(
            Figure("image_width_deg", width.value, "degrees", "picture", error=width.error)
        )
    return Factor("luster", luster.word, tuple(figures))


def _surface(pearl: Pearl, found: Measures | None, reason: str) -> Factor:
    """By the file where it states the area, or has no blemishes; else by the visible half."""
    if pearl.model == "illuminant":
        return Factor("surface", None, (), "no_blemishes_key")
    surface = stated_surface(pearl)
    if surface is not None:
        return Factor("surface", surface.word, (_figure(surface, "%"),))
    if found is None or found.blemishes is None:
        return _unmeasured("surface", found, "blemishes", reason)
    area = found.blemishes.area
    figure = Figure("blemished_percent", area.value, "%", "picture", error=area.error)
    return Factor("surface", word_of("surface", {figure.quantity: figure.value}), (figure,))


def _layers_mm(pearl: Pearl) -> float:
    """Thickness of the layers of a file."""
    stack, _ = _core.stack_of_nacre(json.dumps(pearl.model_dump(mode="json")["nacre"]))
    return stack.total_um() / 1000


def _nacre(pearl: Pearl, culture: str | None) -> Factor:
    given = None if pearl.model == "illuminant" else pearl.body.nacre_mm
    nacre_mm, key = (given, "body.nacre_mm") if given is not None else (_layers_mm(pearl), "nacre")
    figures = (Figure("nacre_mm", nacre_mm, "mm", "file", key),)
    if culture is None:
        return Factor("nacre", None, figures, "no_culture")
    return Factor("nacre", word_of(f"nacre-{culture}", nacre_mm), figures)


def _polar(a: float, b: float) -> tuple[float, float]:
    return math.hypot(a, b), math.degrees(math.atan2(b, a)) % 360


def _rectangular(seen: Colour) -> tuple[float, float]:
    hue = 0.0 if seen.hue_deg is None else math.radians(seen.hue_deg.value)
    return seen.chroma.value * math.cos(hue), seen.chroma.value * math.sin(hue)

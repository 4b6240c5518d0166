"""The table of `nacreous measure`: words, numbers, units."""

from __future__ import annotations

import math
from collections.abc import Iterator

from nacreous.measure import HUES, Colour, Measures, Number

__all__ = ["table"]

#: Parts of the result, as people call them.
_WORDS = {
    "colour": "colour",
    "rings": "rings",
    "lamp": "lamp's image",
    "lamp.haze": "haze",
    "lamp.distinctness": "distinctness of image",
    "blemishes": "blemishes",
    "blemishes.relief": "fainter blemishes",
}


def table(picture: str, found: Measures) -> list[str]:
    """Lines: a quantity, its number with its standard error, its unit."""
    circle = found.outline.circle
    how = "near the circle given" if found.outline.given else "found"
    lines = [
        f"{picture}: pearl {how} at ({circle.x_px:.1f}, {circle.y_px:.1f}), radius "
        f"{circle.radius_px:.1f} px; an edge in {found.outline.share:.0%} of all directions"
    ]
    rows = [*_shape(found), *_colours(found), *_lamp(found), *_blemishes(found)]
    lines += [f"{name:<22}{text}" for name, text in rows]
    lines += [f"{_WORDS[name]:<22}not measured: {reason}" for name, reason in found.refused.items()]
    return lines


def shown(number: Number, unit: str = "", least_digits: int = 0) -> str:
    """A number to the second digit of its error, with it, four behind the point at most.

    >>> shown(Number(8.01234, 0.0123), "mm"), shown(Number(0.5), "%", 1)
    ('8.012 ± 0.012 mm', '0.5 %')
    >>> shown(Number(0.0, 0.0), "%", 2)
    '0.00 ± 0.00 %'
    """
    behind = "°" if unit == "°" else f" {unit}" if unit else ""
    if number.error is None:
        return f"{number.value:.{max(1, least_digits)}f}{behind}"
    digits = 1 - math.floor(math.log10(number.error)) if number.error > 0 else 0
    digits = min(max(digits, least_digits, 1), 4)
    return f"{number.value:.{digits}f} ± {number.error:.{digits}f}{behind}"


def _shape(found: Measures) -> Iterator[tuple[str, str]]:
    size = found.size
    yield "diameter", shown(size.mean, size.unit)
    yield "least, greatest", f"{shown(size.least, size.unit)}, {shown(size.greatest, size.unit)}"
    yield "roundness", shown(found.roundness, "%")


def _colours(found: Measures) -> Iterator[tuple[str, str]]:
    if found.colour is not None:
        yield "colour", _in_words(found.colour)
    for number, ring in enumerate(found.rings or (), 1):
        colour = "covered by the lamp's image" if ring.colour is None else _in_words(ring.colour)
        yield f"ring {number}, {ring.view_deg:.0f}°", colour
    if found.interference is not None:
        spread = found.interference
        yield "mean chroma", shown(spread.chroma)
        yield "orient", shown(spread.orient)
        yield "interference score", f"{shown(spread.score, '%')} of the area saturated"
        parts = (f"{hue} {share:.1f}" for hue, share in zip(HUES, spread.by_hue, strict=True))
        yield "by hue, in %", ", ".join(parts)


def _in_words(colour: Colour) -> str:
    hue = "none (grey)" if colour.hue_deg is None else shown(colour.hue_deg, "°")
    return f"L* {shown(colour.lightness)}, C* {shown(colour.chroma)}, hue {hue}"


def _lamp(found: Measures) -> Iterator[tuple[str, str]]:
    lamp = found.lamp
    if lamp is None:
        return
    yield "lamp's image", f"at ({lamp.x_px:.1f}, {lamp.y_px:.1f}), {lamp.view_deg:.0f}° off middle"
    yield "its peak", f"{lamp.peak:.3f} times white; around it {shown(lamp.around, '', 3)}"
    yield "its half-width", shown(lamp.half_width_deg, "°")
    yield "contrast gloss", shown(lamp.contrast_gloss, "%")
    if lamp.haze is not None:
        yield "haze", shown(lamp.haze, "%")
    if lamp.distinctness is not None:
        yield "distinctness of image", shown(lamp.distinctness, "%")


def _blemishes(found: Measures) -> Iterator[tuple[str, str]]:
    if found.blemishes is None:
        return
    spots = found.blemishes
    yield (
        "blemished area",
        f"{shown(spots.area, '%', 2)} in {spots.count} spot{'' if spots.count == 1 else 's'}; "
        f"looked at {spots.looked_at:.0%} of the side seen",
    )

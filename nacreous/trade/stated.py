"""The words that the numbers of a pearl's own file fall under."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nacreous import _core
from nacreous.trade.table import word_of
from nacreous.trade.word import Word
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.spec import Pearl

__all__ = [
    "Stated",
    "dimensions_of",
    "stated",
    "stated_luster",
    "stated_shape",
    "stated_size",
    "stated_surface",
]

_FACETS = "surface.facet_spread_rad"
_BLEMISHES = ("pits", "bumps", "scratches", "wrinkles", "chalky_spots")


@value_class
class Stated:
    """A word, and the number of a pearl file that it follows from. key: the key that says it."""

    word: Word
    quantity: str
    value: float
    key: str


def stated(pearl: Pearl) -> tuple[Stated, ...]:
    """The words for all that a pearl file states and the table knows, in the table's order.

    What only a picture shows, such as the overtone, is not among them, nor is nacre, whose words
    hang on the kind of pearl.

    >>> from nacreous.spec import Pearl
    >>> {one.key: one.word.en for one in stated(Pearl(shininess=0.253))}
    {'diameter_mm': '8.0-8.5 mm', 'shape': 'round', 'shininess': 'Fair', 'blemishes': 'clean'}
    """
    found = (
        stated_size(pearl),
        stated_shape(pearl),
        stated_luster(pearl),
        stated_surface(pearl),
    )
    return tuple(one for one in found if one is not None)


def stated_size(pearl: Pearl) -> Stated:
    """By the diameter."""
    return _stated("size", "diameter_mm", pearl.diameter_mm, "diameter_mm")


def stated_shape(pearl: Pearl) -> Stated | None:
    """By its form; None of the model of 1996, which knows balls alone and has no `[shape]`.

    >>> from nacreous.spec import Pearl
    >>> stated_shape(Pearl(shape={"length": 1.2})).word.en
    'oval'
    """
    if pearl.model == "illuminant":
        return None
    found = dimensions_of(pearl)
    word = word_of("shape", found)
    name = word.bounds[0].quantity
    return Stated(word, name, found[name], "shape")


def dimensions_of(pearl: Pearl) -> dict[str, float]:
    """What the table tells shapes by, of a pearl of the transport model.

    >>> from nacreous.spec import Pearl
    >>> round(dimensions_of(Pearl(shape={"length": 1.2}))["height_over_width"], 2)
    1.2
    """
    variation, asymmetry, height, taper, grooves = _core.shape_dimensions(pearl.model_dump_json())
    return {
        "grooves": float(grooves),
        "diameter_variation_percent": 100 * variation,
        "asymmetry_percent": 100 * asymmetry,
        "height_over_width": height,
        "taper_percent": 100 * taper,
    }


def stated_luster(pearl: Pearl) -> Stated:
    """By the facets, which the knob sets where the file does not."""
    spread_rad, key = pearl.surface.facet_spread_rad, _FACETS
    if spread_rad is None:
        spread_rad, key = _core.resolved_keys(pearl.model_dump_json())[_FACETS], "shininess"
    return _stated("luster", "facet_spread_rad", spread_rad, key)


def stated_surface(pearl: Pearl) -> Stated | None:
    """By the blemished area: none, or as it is stated; None where only a picture shows it."""
    if pearl.model == "illuminant":
        return None
    if not any(getattr(pearl.blemishes, one) for one in _BLEMISHES):
        return _stated("surface", "blemished_percent", 0.0, "blemishes")
    area = pearl.blemishes.area
    if area is None:
        return None
    return _stated("surface", "blemished_percent", 100 * area, "blemishes.area")


def _stated(factor: str, quantity: str, value: float, key: str) -> Stated:
    return Stated(word_of(factor, {quantity: value}), quantity, value, key)

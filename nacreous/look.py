"""How a pearl looks, in numbers: knobs resolved, layers grown, for the renderer."""

from __future__ import annotations

from typing import Any

from nacreous import _core, body, colour
from nacreous.film import columns_of
from nacreous.nacre import stack_of
from nacreous.spec import Pearl

__all__ = ["GRAIN", "outer_um_of", "subject_of"]

#: Weights of the grain; it shows where one of them is above 0.
GRAIN = ("hue_weight", "chroma_weight", "value_weight")


def subject_of(pearl: Pearl) -> dict[str, Any]:
    """What the renderer needs of the pearl; knobs give what the file leaves open."""
    knobs = _core.parameters(pearl.depth, pearl.shininess, pearl.grain)
    common = {"facet_spread_rad": pearl.surface.facet_spread_rad}
    common |= {weight: getattr(pearl.texture, weight) for weight in GRAIN}
    transport = pearl.model == "transport"
    return {
        "diameter_mm": pearl.diameter_mm,
        **_resolved(common, knobs),
        "illuminant": None if transport else _illuminant(pearl, knobs),
        "transport": _transport(pearl, knobs) if transport else None,
    }


def outer_um_of(pearl: Pearl) -> float:
    """Depth of the film in um: the file's, or what the knob depth makes of it.

    >>> round(outer_um_of(Pearl(depth=0.6)))
    37
    """
    if pearl.film.outer_um is not None:
        return pearl.film.outer_um
    outer_um: float = _core.parameters(pearl.depth, pearl.shininess, pearl.grain)["outer_um"]
    return outer_um


def _illuminant(pearl: Pearl, knobs: dict[str, float]) -> dict[str, Any]:
    surface = pearl.surface
    given = {
        **{
            name: getattr(pearl.interference, name)
            for name in type(pearl.interference).model_fields
        },
        "mirror_weight": surface.mirror_weight,
        "layer_reflectance": surface.layer_reflectance,
        "falloff_mm": surface.falloff_mm,
    }
    return {
        **_resolved(given, knobs),
        "body_colour": colour.linear_from_hex(pearl.body_colour),
        "stack": stack_of(pearl)._core,
    }


def _transport(pearl: Pearl, knobs: dict[str, float]) -> dict[str, Any]:
    columns = columns_of(pearl, outer_um_of(pearl))
    spread = pearl.inside.spread
    return {
        "facets": pearl.surface.facets,
        "columns": [column._core for column in columns],
        "body_reflectance": body.reflectance_of_body(pearl, 1e-3 * stack_of(pearl).total_um),
        "spread": knobs["spread"] if spread is None else spread,
    }


def _resolved(given: dict[str, Any], knobs: dict[str, float]) -> dict[str, Any]:
    return {key: knobs[key] if value is None else value for key, value in given.items()}

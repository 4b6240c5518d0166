"""The two models of a pearl's light, and which keys belong to one of them alone.

A key or a section that is declared with `model=` (in key.py) means nothing to the other model.
Given there, it is refused; and a pearl that is written out leaves it away.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel
from pydantic.fields import FieldInfo


def only_with(field: FieldInfo) -> str:
    """The one model that a key belongs to; "" where both have it."""
    extra = field.json_schema_extra
    return str(extra.get("model", "")) if isinstance(extra, dict) else ""


def strangers(section: BaseModel, model: str) -> Iterator[tuple[str, str]]:
    """Keys given in a pearl of this model that belong to the other, each with the model it has.

    >>> from nacreous.spec.surface import Surface
    >>> list(strangers(Surface(falloff_mm=40.0, facet_spread_rad=0.1), "transport"))
    [('falloff_mm', 'illuminant')]
    """
    for name, field in type(section).model_fields.items():
        value = getattr(section, name)
        if name not in section.model_fields_set or value is None:
            continue
        home = only_with(field)
        if home not in ("", model):
            inside = list(_given(value)) if isinstance(value, BaseModel) else []
            yield from ((f"{name}.{key}", home) for key in inside)
            if not inside:
                yield name, home
        elif isinstance(value, BaseModel):
            yield from ((f"{name}.{key}", home) for key, home in strangers(value, model))


def _given(section: BaseModel) -> Iterator[str]:
    """The keys of a section that were given, in the order of their declaration."""
    for name in type(section).model_fields:
        if name in section.model_fields_set and getattr(section, name) is not None:
            yield name


def own_keys(section: BaseModel, values: dict[str, Any], model: str) -> dict[str, Any]:
    """What was dumped of a section, without the keys that belong to the other model.

    >>> from nacreous.spec.surface import Surface
    >>> surface = Surface()
    >>> sorted(own_keys(surface, surface.model_dump(), "transport"))
    ['facet_spread_rad', 'facets', 'waviness_rad']
    """
    fields = type(section).model_fields
    kept = {key: value for key, value in values.items() if only_with(fields[key]) in ("", model)}
    return {
        key: own_keys(inner, value, model)
        if isinstance(inner := getattr(section, key), BaseModel) and isinstance(value, dict)
        else value
        for key, value in kept.items()
    }

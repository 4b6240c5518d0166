"""Every key of pearl and scene files, and what a file says that has one of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from nacreous.problem import InputError
from nacreous.spec import (
    Lamp,
    Layers,
    Pearl,
    Row,
    Scene,
    Uniaxial,
    Window,
)
from nacreous.spec.key import Key, alternatives, every_key, sections_in
from nacreous.spec.model import only_with

ROOT = Path(__file__).parent.parent.parent


def kinds_of(key: Key) -> tuple[Any, ...]:
    return alternatives(key.field.annotation)


FILES = (Pearl, Scene)
LISTED = {"lamps": Lamp, "rows": Row, "windows": Window}
KEYS = [(model, key) for model in FILES for key in every_key(model)]
LEAVES = [(model, key) for model, key in KEYS if not all(map(sections_in, kinds_of(key)))]
NUMBERS = [
    (model, key) for model, key in LEAVES if set(alternatives(key.field.annotation)) <= {int, float}
]
MEDIA = [case for case in LEAVES if sections_in(case[1].field.annotation)]
MODELS = {"transport": "illuminant", "illuminant": "transport"}


def name_of(case: Any) -> str:
    return f"{case[0].__name__}-{case[1].owner.__name__}.{case[1].path}"


def problems(act: Callable[[], Any]) -> list[str]:
    with pytest.raises(InputError) as caught:
        act()
    lines = str(caught.value).splitlines()
    assert lines
    for line in lines:
        for jargon in ("pydantic", "http", "Input should", "validation", "type=", "Traceback"):
            assert jargon not in line
    return lines


def file_with(model: type, key: Key, value: Any) -> dict[str, Any]:
    """The smallest file that holds the key; lamps, windows and listed layers need company."""
    values: dict[str, Any] = {}
    target = values
    *steps, last = key.path.split(".")
    for step in steps:
        target = target.setdefault(step, {}) if step != "0" else target
    if key.owner is Layers:
        target["thickness_nm"] = [400.0]
    if key.owner is Lamp and last != "position_mm":
        target |= {"azimuth_deg": 0.0, "elevation_deg": 0.0}
    if key.owner is Uniaxial:
        target |= {"n_o": 1.6, "n_e": 1.5}
    if key.path == "body.nacre_mm":
        values["diameter_mm"] = 30.0
    if home(key):
        values["model"] = home(key)
    if key.owner is Window and last not in ("position_mm", "facing", "below_mm"):
        target |= {"azimuth_deg": 0.0, "elevation_deg": 0.0}
    if last == "facing":
        target["position_mm"] = [0.0, 0.0, 99.0]
    if last == "below_mm":
        values["table"] = {"kind": "none"}
    target[last] = value
    for name, owner in LISTED.items():
        if name in values and key.owner is owner:
            values[name] = [values[name]]
    return values


def home(key: Key) -> str:
    """The model that the key or its section belongs to; "" where both have it."""
    fields = Pearl.model_fields
    section = fields.get(key.path.partition(".")[0]) if key.owner is not Pearl else None
    return only_with(key.field) or (only_with(section) if section else "")


def refusal(model: type, key: Key, value: Any) -> str:
    (line,) = problems(lambda: model.check(file_with(model, key, value), "my.toml", Path()))
    assert line.startswith(f"my.toml: {key.path}")
    assert " is " in line
    return line


def bounds(key: Key) -> tuple[float, float, list[float]]:
    """Lowest and highest bound, and the bounds that are themselves outside."""
    marks = {type(mark).__name__: mark for mark in key.field.metadata}
    low = marks["Ge"].ge if "Ge" in marks else marks["Gt"].gt
    high = marks["Le"].le if "Le" in marks else marks["Lt"].lt
    outside = [low] if "Gt" in marks else []
    return low, high, outside + ([high] if "Lt" in marks else [])

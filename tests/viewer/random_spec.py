"""Random pearl and scene files, most of which are valid."""

from __future__ import annotations

import random
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel

from nacreous.spec import preset
from nacreous.spec.key import alternatives, is_list, sections_in
from nacreous.spec.medium import NAMES
from nacreous.spec.toml import to_toml

#: Words for keys whose texts have a form of their own.
WORDS: dict[str, tuple[Any, ...]] = {
    "name": ("pearl", "真珠 3", "  a b ", "e\u0301 one", 'a "quoted" \\ one', "x" * 120),
    "label": ("masters", "上", "goods below"),
    "preset": tuple(preset.names("nacre")),
    "seeding": ("04-15", "2023-05-01", "2024-02-29"),
    "harvest": ("12-15", "2024-12-15", "03-01"),
    "peak": ("08-01", "02-28"),
    "spectrum": ("D65", "A", "FL11", "FL7", "F3", "LED-RGB1", "2700K", "25000K", "lamp.csv"),
    "white": ("auto", "D50", "6500K"),
    "source": ("procedural", "./shell//wool.PNG", "wool.jpeg"),
    "path": ("studio.hdr", "a/../sky.EXR"),
    "pearls": ("*", "*0", "akoya-rg", "paper", "tahitian"),
}
MEDIA: tuple[Any, ...] = (1.5, 2, [1.43, 0], *NAMES, {"n_o": 1.683, "n_e": 1.53})


def random_file(model: type[BaseModel], chance: random.Random) -> str:
    """The text of a file with some of the model's keys; it may hold contradictions."""
    values = table(model, chance, chance.choice((0.05, 0.15, 0.3)))
    if not values:
        values["name"] = "plain"
    return to_toml(values)


def table(model: type[BaseModel], chance: random.Random, share: float) -> dict[str, Any]:
    """Some of the keys of a table."""
    made: dict[str, Any] = {}
    for name, field in model.model_fields.items():
        inner = sections_in(field.annotation)
        if is_list(field.annotation) and inner:
            if chance.random() < 0.5:
                made[name] = [entry(inner[0], chance, share) for _ in range(chance.randint(1, 3))]
        elif inner and name not in ("aragonite", "protein"):
            if chance.random() < 0.5:
                made[name] = table(chance.choice(inner), chance, share)
        elif field.is_required() or chance.random() < share:
            made[name] = value(name, field.annotation, field.metadata, chance)
    return made


def entry(model: type[BaseModel], chance: random.Random, share: float) -> dict[str, Any]:
    """A lamp, a window or a row, most of which stand in one place."""
    made = table(model, chance, share)
    if "azimuth_deg" in model.model_fields and chance.random() < 0.9:
        for name in ("position_mm", "below_mm", "facing", "distance_mm"):
            made.pop(name, None)
        if chance.random() < 0.5:
            made |= {"azimuth_deg": chance.uniform(-180, 180), "elevation_deg": 30}
        else:
            made = {k: v for k, v in made.items() if k not in ("azimuth_deg", "elevation_deg")}
            made["position_mm"] = [100, chance.uniform(-9, 900), -3.5]
    return made


def value(name: str, annotation: Any, metadata: list[Any], chance: random.Random) -> Any:
    """A value that the key may have."""
    if name in WORDS:
        words = WORDS[name]
        if is_list(annotation):
            return ["*", *(chance.choice(words) for _ in range(chance.randint(0, 4)))]
        return chance.choice(words)
    if name in ("aragonite", "protein"):
        return chance.choice(MEDIA)
    kind = alternatives(annotation)[0]
    if get_origin(kind) is Literal:
        return chance.choice(get_args(kind))
    if kind is str:
        return f"#{chance.randrange(16**6):06x}"
    if get_origin(kind) is tuple:
        fixed = get_args(kind)[-1] is not Ellipsis
        count = len(get_args(kind)) if fixed else chance.randint(1, 40)
        return [
            chance.choice((chance.uniform(10, 900), chance.randint(30, 500))) for _ in range(count)
        ]
    return number(kind, *bounds(metadata), chance)


def bounds(metadata: list[Any]) -> tuple[float, float]:
    """The lower and the upper bound of a number."""
    low = [getattr(mark, "ge", getattr(mark, "gt", None)) for mark in metadata]
    high = [getattr(mark, "le", getattr(mark, "lt", None)) for mark in metadata]
    return (
        next((one for one in low if one is not None), 0),
        next((one for one in high if one is not None), 1),
    )


def number(kind: Any, low: float, high: float, chance: random.Random) -> float | int:
    """A number in a range, now and then its end, small, or whole."""
    if kind is int:
        return chance.choice((int(low), int(high), chance.randint(int(low), int(high))))
    size = chance.choice((low, high, chance.uniform(low, high), low + (high - low) * 1e-7))
    return int(size) if size == int(size) and chance.random() < 0.5 else float(size)

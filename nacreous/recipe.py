"""Everything that makes a picture: JSON for the renderer, and texts for the picture's file."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from math import isqrt
from numbers import Integral
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, TypeVar

from nacreous import __version__, _core
from nacreous.number import alone, said
from nacreous.problem import InputError
from nacreous.ready import Json, ready

if TYPE_CHECKING:
    from nacreous.spec import Pearl, Scene

    Spec = TypeVar("Spec", Pearl, Scene)
    Given: TypeAlias = str | Path | Pearl

__all__ = ["PREFIX", "Recipe", "loaded", "recipe"]

#: What the keywords of a recipe's texts begin with in a picture file.
PREFIX = "nacreous:"


class Recipe(NamedTuple):
    """What a picture is made from.

    json: all of it, complete, as every renderer of ours takes it: each key of the pearls and of the
    scene, with null where it is left out and the renderer finds its value; rows name pearls by
    number. texts: what the picture's file keeps: "pearl" (of several different pearls "pearl.0",
    "pearl.1" and so on) and "scene" as TOML, "settings" and "versions" as JSON, and where files are
    named "files" (`nacreous.named_files`). size: pixels a side.
    """

    json: str
    texts: dict[str, str]
    size: int


class _Written(NamedTuple):
    """A pearl or a scene, complete, in both its spellings."""

    json: str
    toml: str


def recipe(
    pearl: Given | Sequence[Given], scene: str | Path | Scene, size: int, samples: int
) -> Recipe:
    """The recipe of a picture; arguments, and `InputError`, as for `nacreous.image.render`.

    >>> sorted(json.loads(recipe("akoya-rg", "booth", 64, 16).json))
    ['pearls', 'samples', 'scene', 'size']
    """
    presets = _presets(pearl, scene)
    pearls, written = presets or _read(pearl, scene)
    size, samples = _whole("size", size), _whole("samples", samples)
    listed = ", ".join(one.json for one in pearls)
    together = (
        f'{{"pearls": [{listed}], "scene": {written.json}, "size": {size}, "samples": {samples}}}'
    )
    one = len(pearls) == 1
    seeds = [json.loads(pearl.json)["nacre"].get("seed") for pearl in pearls]
    texture_seeds = [_core.texture_seed(pearl.json) for pearl in pearls]
    settings = {
        "size": size,
        "samples": samples,
        "seed": seeds[0] if one else seeds,
        "texture_seed": texture_seeds[0] if one else texture_seeds,
    }
    texts = {
        **{"pearl" if one else f"pearl.{i}": pearl.toml for i, pearl in enumerate(pearls)},
        "scene": written.toml,
        "settings": json.dumps(settings),
        "versions": json.dumps({"nacreous": __version__, "python": platform.python_version()}),
    }
    return Recipe(together, texts if presets else _with_files(texts), size)


def _with_files(texts: dict[str, str]) -> dict[str, str]:
    """The texts with absolute paths, and a place for what the files hold; where any is named."""
    from nacreous.named_files import FILES, absolute, moved

    named: list[str] = []

    def place(path: str) -> str:
        named.append(path)
        return absolute(path)

    placed = moved({**texts, FILES: "{}"}, place)
    return placed if named else texts


def _presets(pearl: object, scene: object) -> tuple[list[_Written], _Written] | None:
    """One preset in the only place of another, as they are; no key need be checked for it."""
    if not isinstance(pearl, str) or not isinstance(scene, str):
        return None
    if Path(pearl).is_file() or Path(scene).is_file():
        return None  # which wins over a preset of that name
    shown, around = ready()["pearl"].get(pearl), ready()["scene"].get(scene)
    if shown is None or around is None or around.get("pearls") != [None]:
        return None
    first, second = (_Written(_compact(one["values"]), one["toml"]) for one in (shown, around))
    return [first], second


def _compact(values: Json) -> str:
    """As pydantic writes it."""
    return json.dumps(values, ensure_ascii=False, separators=(",", ":"))


def _read(
    pearl: Given | Sequence[Given], scene: str | Path | Scene
) -> tuple[list[_Written], _Written]:
    """Models, files and presets in rows."""
    from nacreous.rows import fill
    from nacreous.spec import Scene

    filled = fill(_given(pearl), loaded(Scene, scene))
    pearls = [_Written(one.model_dump_json(), one.to_toml()) for one in filled.pearls]
    return pearls, _Written(filled.scene.model_dump_json(), filled.scene.to_toml())


def _given(pearl: Given | Sequence[Given]) -> list[Pearl]:
    from nacreous.spec import Pearl
    from nacreous.spec.row import MOST_PEARLS

    if isinstance(pearl, str | Path | Pearl) or not isinstance(pearl, Sequence):
        return [loaded(Pearl, pearl)]
    if not 1 <= len(pearl) <= MOST_PEARLS:
        raise InputError(f"pearl is a list of {len(pearl)}; allowed: 1 to {MOST_PEARLS} pearls")
    return [loaded(Pearl, one) for one in pearl]


def loaded(model: type[Spec], given: str | Path | Spec) -> Spec:
    """A model as it is; a file, or a preset's name, as a model. Raises `InputError`."""
    if isinstance(given, model):
        return given
    if isinstance(given, str | Path):
        return model.load(given)
    kind = model.preset_kind
    raise InputError(f"{kind} is {said(given)}; allowed: a {kind}, a file or a preset's name")


def _whole(name: str, value: int) -> int:
    """A whole number within its range; of samples a square."""
    most, allowed = _COUNTS[name]
    if type(value).__module__ == "numpy":
        value = alone(value)
    whole = isinstance(value, Integral) and not isinstance(value, bool) and 1 <= value <= most
    if whole and (name != "samples" or isqrt(value) ** 2 == value):
        return int(value)
    raise InputError(f"{name} is {said(value)}; allowed: {allowed}")


_COUNTS = {
    "size": (_core.MAX_SIZE_PX, f"a whole number from 1 to {_core.MAX_SIZE_PX}"),
    "samples": (_core.MAX_SAMPLES, f"a square number from 1 to {_core.MAX_SAMPLES}, such as 16"),
}

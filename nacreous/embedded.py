"""The recipe embedded in a picture file: what makes the picture again."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Literal, NamedTuple, TypeAlias, TypeVar

from pydantic import TypeAdapter

from nacreous import _core, file, json_text
from nacreous.named_files import FILES, absolute, check_unchanged
from nacreous.problem import InputError
from nacreous.recipe import PREFIX, recipe
from nacreous.spec import Pearl, Scene, document
from nacreous.spec.complaint import shown
from nacreous.spec.override import Override
from nacreous.spec.specfile import move_paths

__all__ = ["Developed", "Embedded", "read_embedded"]

Bits: TypeAlias = Literal[8, 16]
Seeds: TypeAlias = int | list[int | None] | None
Parsed = TypeVar("Parsed")


class Developed(NamedTuple):
    """How light became the codes of a PNG; arguments as of `Image.save`."""

    bits: Bits = 8
    space: Literal["srgb", "display-p3"] = "srgb"
    gamut: Literal["soft", "clip"] = "soft"
    alpha: bool = False


class Embedded(NamedTuple):
    """Everything that makes a picture file again.

    developed: of a PNG that says so. version: of the Nacreous that made it, "" where not said.
    """

    pearls: list[Pearl]
    scene: Scene
    size: int
    samples: int
    developed: Developed
    version: str


class _Settings(NamedTuple):
    size: int
    samples: int
    seed: Seeds = None
    texture_seed: Seeds = None


def read_embedded(
    path: str | Path,
    of_pearl: Iterable[Override] = (),
    of_scene: Iterable[Override] = (),
    scene: Scene | None = None,
) -> Embedded:
    """The recipe in a picture that `nacreous render` or `Image.save` made, .png or .exr.

    of_pearl, of_scene: single keys changed, as in `Pearl.load`; of several pearls, in each. scene:
    another scene in place of the picture's own. Paths in the recipe are relative to the picture.
    Raises `InputError` for a file without a whole recipe, and where a file that the recipe names is
    gone or holds something else than it did.

    >>> from tempfile import TemporaryDirectory
    >>> import nacreous as nc
    >>> with TemporaryDirectory() as folder:
    ...     _ = nc.render("akoya-rg", "booth", size=8, samples=1).save(f"{folder}/a.png", bits=16)
    ...     kept = read_embedded(f"{folder}/a.png")
    >>> kept.pearls[0].name, kept.scene.name, kept.size, kept.developed.bits
    ('akoya-rg', 'booth', 8, 16)
    """
    where = document.label(Path(path))
    found = _texts(path)
    names = ["pearl"] if "pearl" in found else _numbered(found)
    if not names or not {"scene", "settings"} <= found.keys():
        raise InputError(
            f"{where}: has no recipe; allowed: a picture that nacreous render made, unchanged"
        )
    changes, folder = list(of_pearl), Path(os.path.realpath(Path(path).parent))
    read = [*names, *(["scene"] if scene is None else [])]
    keys = {name: document.parse(found[name], f"{where}: {name}") for name in read}
    own: set[str] = set()
    for name, values in keys.items():
        move_paths(Scene if name == "scene" else Pearl, values, _collected(own, folder))
    pearls = [Pearl.check(keys[name], f"{where}: {name}", Path(), changes) for name in names]
    if scene is None:
        scene = Scene.check(keys["scene"], f"{where}: scene", Path(), of_scene)
    if own:
        held = _json(dict[str, str], found.get(FILES, "{}"), where)
        held = {_placed(name, folder): sha256 for name, sha256 in held.items()}
        check_unchanged(recipe(pearls, scene, 1, 1).json, own, held, where)
    settings = _json(_Settings, found["settings"], where)
    developed = _json(Developed, found.get("developed", "{}"), where)
    version = _json(dict[str, str], found.get("versions", "{}"), where).get("nacreous", "")
    return Embedded(pearls, scene, settings.size, settings.samples, developed, version)


def _placed(name: str, folder: Path) -> str:
    return absolute(str(folder / name))


def _collected(own: set[str], folder: Path) -> Callable[[str], str]:
    """What makes the paths in a recipe absolute, and keeps them."""

    def move(name: str) -> str:
        path = _placed(name, folder)
        own.add(path)
        return path

    return move


def _texts(path: str | Path) -> dict[str, str]:
    """The recipe's texts in a file, by keyword without `PREFIX`."""
    exr = Path(path).suffix.lower() == ".exr"
    texts = dict(_core.read_exr_text(path)) if exr else file.read_png_text(path)
    return {k.removeprefix(PREFIX): text for k, text in texts.items() if k.startswith(PREFIX)}


def _numbered(found: Mapping[str, str]) -> list[str]:
    """The keywords of several pearls, in their order; none where one is missing."""
    count = sum(name.startswith("pearl.") for name in found)
    names = [f"pearl.{number}" for number in range(count)]
    return names if all(name in found for name in names) else []


def _json(kind: type[Parsed], text: str, where: str) -> Parsed:
    try:
        json_text.loads(text)
        return TypeAdapter(kind).validate_json(text)
    except (ValueError, RecursionError):  # ValidationError is one
        raise InputError(f"{where}: its recipe is damaged: {shown(text, 60)}") from None

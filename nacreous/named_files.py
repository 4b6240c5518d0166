"""The files that a recipe names and does not hold: measured lights, panoramas, photographs.

A recipe in memory names them by absolute path, so that it means the same from every folder; in a
picture file they are named relative to the picture, so that both can be moved together. Beside
stands what each held, as its SHA-256.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from nacreous import _core
from nacreous.problem import InputError

__all__ = [
    "FILES",
    "absolute",
    "check_unchanged",
    "files_needed",
    "hashes",
    "hold_files",
    "moved",
    "relative_to",
]

#: The recipe's text of all files by path, as JSON with the SHA-256 of each.
FILES = "files"


def moved(texts: Mapping[str, str], move: Callable[[str], str]) -> dict[str, str]:
    """A recipe's texts with each path in them moved; the same texts where no file is named.

    >>> moved({"scene": 'name = "plain"'}, str.upper)
    {'scene': 'name = "plain"'}
    """
    if FILES not in texts:
        return dict(texts)
    from nacreous import toml_text
    from nacreous.spec import Pearl, Scene
    from nacreous.spec.specfile import move_paths
    from nacreous.spec.toml import to_toml

    changed = dict(texts)
    for name, text in texts.items():
        kind = name.partition(".")[0]
        if kind in ("pearl", "scene"):
            values = toml_text.loads(text)
            move_paths(Pearl if kind == "pearl" else Scene, values, move)
            changed[name] = to_toml(values)
    held = {move(path): sha256 for path, sha256 in json.loads(texts[FILES]).items()}
    return {**changed, FILES: json.dumps(held)}


def absolute(path: str) -> str:
    """The path from the root of the file system; a link to a file keeps the link's own name.

    >>> os.path.isabs(absolute("lamp.csv"))
    True
    """
    folder, name = os.path.split(path)
    return Path(os.path.realpath(folder or "."), name).as_posix()


def relative_to(folder: str | Path) -> Callable[[str], str]:
    """What names an absolute path from a folder; on another drive it stays absolute.

    >>> relative_to("/pearls/pictures")("/pearls/lamp.csv")
    '../lamp.csv'
    """
    start = os.path.realpath(folder)

    def relative(path: str) -> str:
        try:
            return Path(os.path.relpath(path, start)).as_posix()
        except ValueError:
            return path

    return relative


def hashes(recipe_json: str) -> dict[str, str]:
    """The SHA-256 of each file whose contents a recipe needs, by absolute path.

    >>> import nacreous as nc
    >>> hashes(nc.image.recipe_json("akoya-rg", "booth"))
    {}
    """
    return {absolute(path): _sha256(path) for path in files_needed(recipe_json)}


def hold_files(texts: Mapping[str, str], recipe_json: str) -> dict[str, str]:
    """A recipe's texts with what its files hold now; the same texts where no file is named."""
    if FILES not in texts:
        return dict(texts)
    return {**texts, FILES: json.dumps(hashes(recipe_json))}


def check_unchanged(
    recipe_json: str, named: Iterable[str], held: Mapping[str, str], where: str
) -> None:
    """Refuse a recipe whose own files are gone or hold something else than they did.

    named: absolute paths as the recipe inside a picture gives them; what was named anew may hold
    anything. held: their SHA-256.
    """
    own = set(named)
    for path in filter(own.__contains__, files_needed(recipe_json)):
        other = "allowed: the same file, or another one that is named anew"
        if not Path(path).exists():
            raise InputError(f"{where}: was made with {path}, which does not exist; {other}")
        if path not in held:
            raise InputError(f"{where}: does not say what {path} held; {other}")
        now = _sha256(path)
        if now != held[path]:
            raise InputError(
                f"{where}: was made with another {path}, of SHA-256 {held[path][:12]}..., and not "
                f"{now[:12]}...; {other}"
            )


def files_needed(recipe_json: str) -> list[str]:
    """The measured lights, panoramas and photographs whose contents a recipe needs.

    >>> import nacreous as nc
    >>> files_needed(nc.image.recipe_json("akoya-rg", "booth"))
    []
    """
    spectra, panoramas, photographed = _core.files_needed(recipe_json)
    if not photographed:
        return [*spectra, *panoramas]
    pearls = json.loads(recipe_json)["pearls"]
    photographs = {pearls[number]["texture"]["source"]: None for number in photographed}
    return [*spectra, *panoramas, *photographs]


def _sha256(path: str) -> str:
    import hashlib

    try:
        with Path(path).open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as problem:
        raise InputError(f"{path}: cannot be read: {problem.strerror}") from None


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

"""Loading a file without saying beforehand whether it is a pearl or a scene."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from nacreous.problem import InputError
from nacreous.spec import document, override
from nacreous.spec.complaint import nearest
from nacreous.spec.override import Override, Overrides
from nacreous.spec.pearl import Pearl
from nacreous.spec.scene import Scene
from nacreous.spec.specfile import find


def load(path_or_preset: str | Path, overrides: Overrides = ()) -> Pearl | Scene:
    """Read a pearl or scene file, or a preset; the keys show which of the two a file is.

    Where a pearl and a scene preset share a name, as "paper" does, this is the pearl; use
    `Scene.load` for the scene. Arguments and errors are those of `Pearl.load`.

    >>> type(load("akoya-rg")).__name__, type(load("booth")).__name__
    ('Pearl', 'Scene')
    """
    kind, path, where = find(path_or_preset, ("pearl", "scene"))
    values = document.read(path)
    presets: dict[str, type[Pearl] | type[Scene]] = {"pearl": Pearl, "scene": Scene}
    model = presets[kind] if kind else _kind_of(values, where)
    return model.check(values, where, path.parent, overrides)


def _kind_of(values: dict[str, Any], where: str) -> type[Pearl] | type[Scene]:
    """Whichever model knows more of the file's outermost keys."""
    as_pearl, as_scene = Pearl.known_keys(values), Scene.known_keys(values)
    if as_pearl == as_scene:
        raise InputError(
            f"{where}: the keys show neither a pearl nor a scene; wanted: a key such as nacre, "
            "diameter_mm or depth for a pearl, camera, lamps or table for a scene"
        )
    return Pearl if as_pearl > as_scene else Scene


def shared_out(settings: Iterable[str]) -> tuple[list[Override], list[Override]]:
    """Overrides `key=value` of a pearl and of a scene.

    Each goes to the file that knows the key's first word best, to the pearl in doubt.

    >>> shared_out(["depth=0.8", "table.kind=cloth"])
    ([('depth', '0.8')], [('table.kind', 'cloth')])
    """
    of_pearl: list[Override] = []
    of_scene: list[Override] = []
    words = [*Pearl.model_fields, *Scene.model_fields]
    for setting in settings:
        key, value = override.parse(setting)
        meant = nearest(key.partition(".")[0], words)
        scenic = meant in Scene.model_fields and meant not in Pearl.model_fields
        (of_scene if scenic else of_pearl).append((key, value))
    return of_pearl, of_scene

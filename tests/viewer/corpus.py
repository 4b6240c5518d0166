"""Pearl and scene files with what Python makes of them, for the viewer's own reading to be held to.

    python -m tests.viewer.corpus      prints it as JSON

Presets, random valid files, and damaged ones with the lines of their complaints; the same each
time.
"""

from __future__ import annotations

import base64
import json
import os
import random
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from nacreous.problem import InputError
from nacreous.recipe import recipe
from nacreous.spec import Pearl, Scene, preset
from nacreous.spec.specfile import SpecFile
from nacreous.viewer import fragment
from tests.viewer.damage import damaged
from tests.viewer.random_spec import random_file

VALID, DAMAGED = 200, 500
KINDS: dict[str, type[Pearl] | type[Scene]] = {"pearl": Pearl, "scene": Scene}


def corpus() -> dict[str, Any]:
    """All of it."""
    return {
        "presets": [_preset(kind, name) for kind in KINDS for name in preset.names(kind)],
        "recipes": list(_recipes()),
        "valid": list(_valid()),
        "damaged": list(_damaged()),
        "numbers": list(_numbers()),
    }


def _preset(kind: str, name: str) -> dict[str, str]:
    model = KINDS[kind].load(name)
    return {"name": name, **_case(kind, preset.text(kind, name), model)}


def _case(kind: str, text: str, model: SpecFile) -> dict[str, str]:
    """What a file is, complete: as JSON and as TOML."""
    return {"kind": kind, "text": text, "json": model.model_dump_json(), "toml": model.to_toml()}


def _recipes() -> Iterator[dict[str, Any]]:
    """Every scene, rows included, with a preset and with a pearl that no preset is."""
    for number, scene in enumerate(preset.names("scene")):
        for name in ("akoya-rg", preset.names("pearl")[number]):
            pearl = Pearl.load(name, {"nacre.seed": 7 + number})
            made = recipe(pearl, Scene.load(scene), 64, 4)
            around = Scene.load(scene).to_toml()
            yield {"pearl": pearl.to_toml(), "scene": around, "recipe": made.json}


def _valid() -> Iterator[dict[str, Any]]:
    for seed in range(VALID // 2):
        made = {kind: _random(kind, random.Random(f"{kind} {seed}")) for kind in KINDS}
        (pearl_text, pearl), (scene_text, scene) = made["pearl"], made["scene"]
        yield {
            "pearl": _case("pearl", pearl_text, pearl),
            "scene": _case("scene", scene_text, scene),
            "recipe": recipe(pearl, scene, 256, 16).json,
            "link": fragment(pearl, scene),
        }


def _random(kind: str, chance: random.Random) -> tuple[str, Any]:
    """A file that Python takes, among those that chance writes."""
    while True:
        text = random_file(KINDS[kind], chance)
        try:
            return text, KINDS[kind].from_toml(text)
        except InputError:
            continue


def _damaged() -> Iterator[dict[str, Any]]:
    """Files in a folder of their own, so that they have a plain name, as ones that are dropped."""
    seed = found = 0
    while found < DAMAGED:
        seed += 1
        chance = random.Random(f"damaged {seed}")
        kind = chance.choice(list(KINDS))
        how, content = damaged(kind, chance)
        path = Path(f"{kind}.toml")
        path.write_bytes(content)
        try:
            KINDS[kind].load(path)
        except InputError as problem:
            found += 1
            written = base64.b64encode(content).decode()
            yield {"how": how, "kind": kind, "bytes": written, "lines": str(problem).splitlines()}


def _numbers() -> Iterator[dict[str, Any]]:
    """Numbers as Python writes them, short ones, long ones and ones in the middle of two."""
    chance = random.Random("numbers")
    some = [
        0.0,
        1.0,
        0.5,
        1e16,
        1e15,
        1e-4,
        1e-5,
        123456.5,
        123457.5,
        0.00012345,
        5e-324,
        2.5,
        1e22,
    ]
    some += [chance.uniform(-1, 1) * 10 ** chance.randint(-9, 20) for _ in range(200)]
    some += [chance.randint(0, 10**7) + 0.5 for _ in range(100)]
    for number in some:
        short, shorter = f"{number:g}", f"{number:.3g}"
        yield {"number": number, "repr": repr(number), "g": short, "g3": shorter}


if __name__ == "__main__":
    with TemporaryDirectory() as folder:
        here = Path.cwd()
        os.chdir(folder)
        try:
            made = corpus()
        finally:
            os.chdir(here)
    json.dump(made, sys.stdout)

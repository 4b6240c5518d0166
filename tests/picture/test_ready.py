"""Presets ready to be rendered, against the files that they are made of."""

import json
from pathlib import Path

import pytest

from nacreous.complete import presets
from nacreous.ready import FILE, ready
from nacreous.recipe import Recipe, recipe
from nacreous.spec import Pearl, Scene


def test_presets_that_are_ready_are_those_in_the_files() -> None:
    """`./just types` makes the file again."""
    assert json.loads(FILE.read_text(encoding="utf-8")) == json.loads(json.dumps(presets()))


def same(one: Recipe, other: Recipe) -> bool:
    return (json.loads(one.json), one.texts) == (json.loads(other.json), other.texts)


@pytest.mark.parametrize("scene", sorted(ready()["scene"]))
def test_a_preset_by_name_has_the_recipe_of_its_file(scene: str) -> None:
    pearls = ["akoya-rg"] if scene == "two-tier" else sorted(ready()["pearl"])
    for pearl in pearls:
        read = recipe(Pearl.load(pearl), Scene.load(scene), 8, 4)
        assert same(recipe(pearl, scene, 8, 4), read), pearl


def test_a_file_hides_the_preset_of_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("paper").write_text(Pearl(name="mine").to_toml(), encoding="utf-8")
    assert json.loads(recipe("paper", "booth", 8, 4).json)["pearls"][0]["name"] == "mine"

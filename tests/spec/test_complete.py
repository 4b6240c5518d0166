"""Presets as complete JSON are the presets: the same pictures, the same layers."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous import _core, cli
from nacreous.complete import KINDS, complete
from nacreous.spec import preset

SIZE_PX = 8


@pytest.fixture(scope="module")
def presets() -> dict[str, dict[str, Any]]:
    """All of them, as a browser gets them: through text."""
    made = {kind: {name: complete(kind, name) for name in preset.names(kind)} for kind in KINDS}
    return json.loads(json.dumps(made))


def linear(presets: dict[str, dict[str, Any]], pearl: str, scene: str) -> Any:
    """The picture of a pearl in a scene, from the JSON alone."""
    shown, around = presets["pearl"][pearl]["values"], presets["scene"][scene]
    pearls = [shown if one is None else one for one in around["pearls"]]
    recipe = {"pearls": pearls, "scene": around["values"], "size": SIZE_PX, "samples": 1}
    pixels, parts = _core.render(json.dumps(recipe), [], [], [], None).parts()
    return sum(pixels[..., first:end] for _, first, end in parts[:4])


@pytest.mark.parametrize("pearl", preset.names("pearl"))
def test_a_pearl_by_its_json_is_the_pearl_by_its_file(presets: Any, pearl: str) -> None:
    expected = nc.render(pearl, "paper", SIZE_PX, 1).linear
    assert np.array_equal(linear(presets, pearl, "paper"), expected)


@pytest.mark.parametrize("scene", preset.names("scene"))
def test_a_scene_by_its_json_is_the_scene_by_its_file(presets: Any, scene: str) -> None:
    expected = nc.render("akoya-pink", scene, SIZE_PX, 1).linear
    assert np.array_equal(linear(presets, "akoya-pink", scene), expected)


@pytest.mark.parametrize("nacre", preset.names("nacre"))
def test_nacre_by_its_json_is_the_nacre_by_its_file(presets: Any, nacre: str) -> None:
    _, thickness_nm = _core.grow(json.dumps(presets["nacre"][nacre]["values"]))
    assert np.array_equal(thickness_nm, nc.grow(nacre).thickness_nm[::-1])


def test_the_command_prints_them_all_or_one(capsys: Any, presets: Any) -> None:
    assert cli.main(["presets", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == presets
    assert cli.main(["presets", "scene", "booth", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == presets["scene"]["booth"]


def test_a_study_has_no_json(capsys: Any) -> None:
    assert cli.main(["presets", "study", "--json"]) == 2
    message = "study presets have no JSON; allowed: pearl, scene, nacre"
    assert message in capsys.readouterr().err

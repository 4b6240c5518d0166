"""Single keys set from outside, and the paths in them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nacreous.problem import InputError
from nacreous.spec import (
    Pearl,
    Scene,
    load,
    override,
)
from tests.spec.keys import (
    problems,
)


def test_paths_of_a_file_are_relative_to_it_and_paths_of_overrides_are_not(tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(
        'lamps = [{azimuth_deg = 1, elevation_deg = 1, spectrum = "led.csv"},'
        ' {azimuth_deg = 1, elevation_deg = 1, spectrum = "A"}]\n'
        '[sky]\nkind = "panorama"\npath = "room.HDR"\n'
    )
    scene = Scene.load(tmp_path / "s.toml", [("lamps.1.spectrum", "mine.csv")])
    assert [lamp.spectrum for lamp in scene.lamps] == [str(tmp_path / "led.csv"), "mine.csv"]
    assert scene.sky.path == str(tmp_path / "room.HDR")
    (tmp_path / "p.toml").write_text('texture.source = "shell.jpg"\n')
    assert Pearl.load(tmp_path / "p.toml").texture.source == str(tmp_path / "shell.jpg")


@pytest.mark.parametrize(
    ("key", "value", "line"),
    [
        ("nacre.seed", "-1", "--set: nacre.seed is -1; allowed: 0 to 9223372036854775807"),
        ("nacre.sed", "1", "--set: nacre.sed is not a key here; did you mean seed?"),
        ("depth", "deep", '--set: depth is "deep"; wanted: a number; allowed: 0 to 1'),
        ("depth", "nan", "--set: depth is nan; allowed: 0 to 1"),
        ("depth", "1\ngrain = 0", "--set: depth is "),
        ("depth.x", "1", '--set "depth.x": depth is not a table'),
        ("nacre..seed", "1", '--set "nacre..seed": a part of the key is empty'),
        ("nacre.", "1", '--set "nacre.": a part of the key is empty'),
    ],
)
def test_a_bad_override_is_named_as_such(key: str, value: str, line: str) -> None:
    assert problems(lambda: Pearl.load("paper", [(key, value)]))[0].startswith(line)


@pytest.mark.parametrize("place", ["1", "-1", "x", "99999999999999999999"])
def test_an_override_reaches_only_lamps_that_are_there(place: str) -> None:
    (line,) = problems(lambda: Scene.load("paper", [(f"lamps.{place}.intensity", "2")]))
    assert line.endswith("lamps is a list; allowed: lamps.0 to lamps.0")


def test_a_setting_without_a_value_is_refused() -> None:
    assert problems(lambda: override.parse("depth"))
    assert problems(lambda: override.parse("=3"))
    assert override.parse("name = a=b ") == ("name", "a=b")


@pytest.mark.parametrize(
    "given",
    [
        {"depth": 0.7, "nacre.seed": 9},
        ["depth=0.7", "nacre.seed=9"],
        [("depth", 0.7), "nacre.seed = 9"],
        (["depth", "0.7"], ("nacre.seed", "9")),
    ],
    ids=str,
)
def test_overrides_may_be_pairs_a_dict_or_as_on_the_command_line(given: Any) -> None:
    for pearl in (Pearl.load("akoya-rg", given), load("akoya-rg", given)):
        assert (pearl.depth, pearl.nacre.seed) == (0.7, 9)
    assert Pearl.load("akoya-rg", "depth=0.7").depth == 0.7


@pytest.mark.parametrize("given", [("depth", 0.7), [3], 3, None, "depth", [("depth",)], [(1, 2)]])
def test_overrides_that_are_none_are_told_their_forms(given: Any) -> None:
    with pytest.raises(InputError, match=r'none; wanted: pairs such as \[\("depth", 0\.7\)\]'):
        load("akoya-rg", given)

"""Keys that are each right and contradict one another; and many problems at once."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nacreous.spec import (
    Layers,
    Pearl,
    Scene,
)
from tests.spec.keys import (
    problems,
)


@pytest.mark.parametrize(
    ("model", "values", "both"),
    [
        (Pearl, {"nacre": {"thickness_nm": [400.0], "seed": 2}}, "nacre.seed nacre.thickness_nm"),
        (
            Pearl,
            {"nacre": {"thickness_noise_nm": 400}},
            "nacre.thickness_noise_nm nacre.thickness_winter_nm",
        ),
        (Pearl, {"nacre": {"harvest": "2026-12-15"}}, "nacre.harvest nacre.seeding"),
        (
            Pearl,
            {"nacre": {"seeding": "2026-04-15", "harvest": "2026-04-15"}},
            "nacre.harvest nacre.seeding",
        ),
        (
            Pearl,
            {"nacre": {"seeding": "2000-01-01", "harvest": "2020-01-02"}},
            "nacre.harvest nacre.seeding",
        ),
        (
            Pearl,
            {"nacre": {"layers_winter": 0, "layers_summer": 0, "layers_noise": 0}},
            "nacre.layers_summer layers_winter layers_noise",
        ),
        (Pearl, {"body": {"nacre_mm": 4.1}}, "body.nacre_mm diameter_mm 4.1 mm"),
        (
            Pearl,
            {"texture": {"low_per_mm": 3.0, "high_per_mm": 3.0}},
            "texture.low_per_mm texture.high_per_mm",
        ),
        (Scene, {"lamps": [{}]}, "lamps.0.azimuth_deg lamps.0.elevation_deg position_mm"),
        (Scene, {"lamps": [{"azimuth_deg": 3.0}]}, "lamps.0.elevation_deg lamps.0.azimuth_deg"),
        (
            Scene,
            {"lamps": [{"azimuth_deg": 3.0, "position_mm": [0.0, 0.0, 99.0]}]},
            "lamps.0.azimuth_deg lamps.0.position_mm",
        ),
        (Scene, {"lamps": [{"position_mm": [0.0, 12.0, 16.0]}]}, "lamps.0.position_mm 20 mm"),
        (Scene, {"sky": {"kind": "panorama"}}, "sky.path sky.kind"),
        (Scene, {"sky": {"path": "a.hdr"}}, "sky.path sky.kind"),
        (Scene, {"lamps": [{"azimuth_deg": 0, "elevation_deg": 0}] * 257}, "lamps 0 to 256"),
        (Pearl, {"nacre": {"thickness_nm": []}}, "nacre.thickness_nm 1 to 5000"),
        (Pearl, {"nacre": {"thickness_nm": [400.0] * 5001}}, "nacre.thickness_nm 1 to 5000"),
    ],
)
def test_keys_that_disagree_are_both_named(model: Any, values: Any, both: str) -> None:
    (line,) = problems(lambda: model.check(values, "my.toml", Path()))
    assert line.startswith("my.toml: ")
    for word in both.split():
        assert word in line


def test_all_problems_of_a_file_come_at_once() -> None:
    values = {
        "model": "illuminant",
        "diameter_mm": -1,
        "deph": 1,
        "nacre": {"seed": 1.5, "protein_nm": True},
        "surface": {"mirror_weight": 2},
    }
    lines = problems(lambda: Pearl.check(values, "my.toml", Path()))
    named = ["diameter_mm", "nacre.protein_nm", "nacre.seed", "surface.mirror_weight", "deph"]
    assert [line.split()[1] for line in lines] == named


@pytest.mark.parametrize("given", [[], [1.0, 2.0], [1.0, 2.0, 3.0, 4.0]])
def test_a_position_of_another_count_of_numbers_is_not_called_missing(given: list[float]) -> None:
    values = {"lamps": [{"position_mm": given}]}
    (line,) = problems(lambda: Scene.check(values, "s.toml", Path()))
    assert line.startswith(f"s.toml: lamps.0.position_mm is {given}; allowed: three numbers")


def test_thousands_of_bad_numbers_are_not_thousands_of_lines() -> None:
    lines = problems(lambda: Layers(thickness_nm=[-1.0] * 5000))
    assert len(lines) == 21
    assert lines[0].startswith("Layers: thickness_nm.0 is -1")
    assert lines[-1] == "... and 4980 more problems"


@pytest.mark.parametrize("act", [lambda: Pearl(depth=2), lambda: Pearl(nacre={"seed": -1})])
def test_python_gets_the_same_plain_words_as_a_file(act: Any) -> None:
    assert problems(act)[0].startswith("Pearl: ")

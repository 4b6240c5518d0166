"""Presets, and which file or preset a name means."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from nacreous.spec import (
    Growth,
    Pearl,
    Scene,
    preset,
)
from nacreous.study.design import Design
from tests.spec.keys import (
    problems,
)


def test_a_folder_does_not_hide_the_preset_of_its_name(tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "paper-green").mkdir()
    assert Pearl.load("paper-green") == Pearl(name="paper-green", model="illuminant")


def test_an_existing_file_wins_over_the_preset_of_its_name(
    tmp_path: Path, monkeypatch: Any
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "paper").write_text("depth = 0.1\n")
    assert Pearl.load("paper").depth == 0.1


def test_a_mistyped_preset_is_offered_the_nearest() -> None:
    (line,) = problems(lambda: Pearl.load("akoya-rh"))
    assert "did you mean akoya-r" in line
    (line,) = problems(lambda: Growth(preset="akoia"))
    assert 'did you mean "akoya"?' in line


@pytest.mark.parametrize("kind", list(preset.FOLDERS))
def test_every_preset_is_valid_and_says_what_it_is(kind: str) -> None:
    model: Any = {"pearl": Pearl, "scene": Scene, "nacre": Growth, "study": Design}[kind]
    for name in preset.names(kind):
        made = model(preset=name) if kind == "nacre" else model.load(name)
        if kind != "study":  # whose name is a title that participants read
            assert name == (made.preset if kind == "nacre" else made.name)
        assert preset.text(kind, name).startswith("# ")
        assert 20 <= len(preset.summary(kind, name)) <= 100


def test_the_preset_paper_green_is_the_default_of_every_key() -> None:
    assert preset.values("nacre", "paper-green") == {
        key: value for key, value in Growth().model_dump().items() if key not in ("preset", "seed")
    }
    assert Pearl.load("paper-green") == Pearl(name="paper-green", model="illuminant")


def test_paper_and_paper_green_differ_in_their_growth_alone() -> None:
    green = Pearl.load("paper-green").replace(name="paper")
    assert Pearl.load("paper") == green.replace(nacre=Growth(preset="paper"))


def test_the_summer_harvest_is_paper_harvested_in_august() -> None:
    summer = Growth(preset="paper-summer-harvest").replace(preset="paper")
    assert summer == Growth(preset="paper", harvest="08-15")


def test_akoya_is_akoya_rg() -> None:
    assert preset.values("nacre", "akoya") == preset.values("nacre", "akoya-rg")


@pytest.mark.parametrize(
    ("name", "mean_nm"), [("akoya-r", 330), ("akoya-rg", 360), ("akoya-g", 440)]
)
def test_akoya_families_have_the_reported_tablets_in_the_outer_10_um(
    name: str, mean_nm: float
) -> None:
    nacre = Growth(preset=name)
    peak = (nacre.peak_date - nacre.seeding_date).days
    depth_nm = layers = total_nm = squares = 0.0
    for day in reversed(range(nacre.days)):  # expected growth, from the surface inward
        bell = math.exp(-((day - peak) ** 2) / (2 * nacre.season_days**2))
        count = nacre.layers_winter + (nacre.layers_summer - nacre.layers_winter) * bell
        rise_nm = nacre.thickness_summer_nm - nacre.thickness_winter_nm
        thickness_nm = nacre.thickness_winter_nm + rise_nm * bell
        layers += count
        total_nm += count * thickness_nm
        squares += count * thickness_nm**2
        depth_nm += count * (thickness_nm + nacre.protein_nm)
        if depth_nm >= 10_000:
            break
    mean = total_nm / layers
    spread = math.sqrt(squares / layers - mean**2 + nacre.thickness_noise_nm**2 / 3)
    assert mean == pytest.approx(mean_nm, abs=1.5)
    assert 10 <= spread <= 20


def test_the_paper_scene_has_its_lamp_at_45_degrees_to_the_line_of_sight() -> None:
    scene = Scene.load("paper")
    (lamp,) = scene.lamps

    def direction(azimuth_deg: float, elevation_deg: float) -> tuple[float, float, float]:
        a, e = math.radians(azimuth_deg), math.radians(elevation_deg)
        return math.sin(a) * math.cos(e), math.sin(e), math.cos(a) * math.cos(e)

    assert lamp.azimuth_deg is not None
    assert lamp.elevation_deg is not None
    cosine = sum(
        a * b
        for a, b in zip(
            direction(lamp.azimuth_deg, lamp.elevation_deg),
            direction(scene.camera.azimuth_deg, scene.camera.elevation_deg),
            strict=True,
        )
    )
    assert math.degrees(math.acos(cosine)) == pytest.approx(45, abs=0.01)
    assert (scene.table.kind, lamp.spectrum) == ("checker", "E")


def test_given_keys_win_over_the_nacre_preset() -> None:
    nacre = Growth(preset="akoya-g", thickness_summer_nm=500.0)
    assert nacre.thickness_summer_nm == 500.0
    assert nacre.thickness_winter_nm == Growth(preset="akoya-g").thickness_winter_nm

"""Scenes: rows of pearls, and what stands around them."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from stage import BLACK, LEFT, NO_TABLE, SUM, pearl, refusal

import nacreous as nc
from nacreous import cli
from nacreous.arrangement import arrange
from nacreous.spec import Camera, Lamp, Pearl, Row, Scene, Sky, Table, Walls

LARGE = pearl(name="large", diameter_mm=9.0)
SMALL = pearl(name="small", diameter_mm=6.0, depth=0.9)


def rows(*pearls: list[str], **keys: Any) -> Scene:
    keys = {"lamps": [LEFT], "table": Table(kind="plain"), **keys}
    return Scene(rows=[Row(pearls=row) for row in pearls], **keys)


# --- who lies where -----------------------------------------------------------------------------


def test_all_pearls_lie_on_one_table_around_the_middle_the_first_row_behind() -> None:
    made = arrange([LARGE, SMALL], rows(["*", "*"], ["*1"], pitch_mm=11, row_gap_mm=10))
    centres = [place.centre_mm for place in made.places]
    assert centres == [(-5.5, 0.0, -5.0), (5.5, -1.5, -5.0), (0.0, -1.5, 5.0)]
    assert {centre[1] - radius for centre, radius in made.balls()} == {-4.5}


def test_left_out_distances_leave_room_between_the_largest() -> None:
    made = arrange([LARGE], rows(["*"] * 3, ["*"] * 2))
    centres = [np.array(place.centre_mm) for place in made.places]
    nearest = min(math.dist(a, b) for i, a in enumerate(centres) for b in centres[:i])
    assert 9.0 < nearest < 1.2 * 9.0


def test_stars_take_the_given_pearls_in_turn_and_numbers_name_one() -> None:
    made = arrange([LARGE, SMALL], rows(["*", "paper", "*", "*"], ["*1", "*0"]))
    names = [made.pearls[place.pearl].name for place in made.places]
    assert names == ["large", "paper", "small", "large", "small", "large"]
    assert [p.name for p in made.pearls] == ["large", "paper", "small"]


@pytest.mark.parametrize(
    ("given", "scene", "message"),
    [
        ([LARGE, SMALL], Scene(), "scene scene: has a place for one pearl, not 2"),
        ([LARGE, SMALL], rows(["*"]), "scene scene: 2 pearls given, 1 of them without a place"),
        ([LARGE], rows(["*", "*3"]), 'scene scene: a row has "*3"; allowed: "*0" to "*0"'),
        ([LARGE], rows(["*"], pitch_mm=8.9), "scene scene: pitch_mm is 8.9; allowed: at least 9"),
        ([LARGE], rows(["*"], row_gap_mm=5), "scene scene: row_gap_mm is 5"),
        (
            [LARGE],
            rows(["*"] * 9, camera=Camera(projection="perspective", distance_mm=50)),
            "scene scene: camera.distance_mm is 50",
        ),
        (
            [LARGE],
            rows(["*"] * 9, walls=Walls(half_width_mm=30)),
            "scene scene: walls.half_width_mm is 30",
        ),
        (
            [LARGE],
            rows(["*"] * 6, pitch_mm=10, lamps=[Lamp(position_mm=(24, 1, 0))]),
            "scene scene: lamps.0.position_mm is [24.0, 1.0, 0.0]; allowed: outside of every pearl",
        ),
        ([LARGE], rows(["gone.toml", "*"]), "gone.toml: there is no such file"),
        ([], rows(["*"]), "pearl is a list of 0; allowed: 1 to 400 pearls"),
        ([LARGE] * 401, rows(["*"]), "pearl is a list of 401; allowed: 1 to 400 pearls"),
        ([LARGE, 5], rows(["*", "*"]), "pearl is 5; allowed: a pearl, a file or a preset's name"),
    ],
    ids=lambda case: str(case)[:30],
)
def test_rows_that_cannot_be_are_refused(given: Any, scene: Scene, message: str) -> None:
    assert refusal(lambda: nc.render(given, scene, 8, 1)).startswith(message)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ([["*"] * 200, ["*"] * 201], "Scene: rows hold 401 pearls together; allowed: at most 400"),
        ([["paper"]], 'Scene: rows have no "*"; wanted: a place for the pearl given'),
        ([["papre", "*"]], 'Scene: rows.0.pearls.0 is "papre"; allowed: '),
        ([["*1000"]], 'Scene: rows.0.pearls.0 is "*1000"; allowed: '),
        ([[]], "Scene: rows.0.pearls is []; allowed: "),
    ],
    ids=lambda case: str(case)[:30],
)
def test_rows_refuse_nonsense_in_one_line(values: Any, message: str) -> None:
    line = refusal(lambda: Scene(rows=[{"pearls": row} for row in values]))
    assert line.startswith(message)
    assert "papre" not in line or line.endswith('did you mean "paper"?')


def test_files_in_rows_are_relative_to_the_scene(tmp_path: Path) -> None:
    (tmp_path / "master.toml").write_text('name = "master"\n')
    (tmp_path / "s.toml").write_text('[[rows]]\npearls = ["master.toml", "*"]\n')
    made = arrange([SMALL], Scene.load(tmp_path / "s.toml"))
    assert [p.name for p in made.pearls] == ["master", "small"]


# --- the picture of several pearls --------------------------------------------------------------


def test_one_pearl_in_a_row_is_the_pearl_alone() -> None:
    field = Camera(field_mm=12.0, elevation_deg=25)
    alone, row = (
        nc.render(SMALL, Scene(lamps=[LEFT], camera=field, **keys), 48, 4)
        for keys in ({}, {"rows": [Row(pearls=["*"])]})
    )
    for name, part in alone.layers.items():
        np.testing.assert_array_equal(part, row.layers[name])


def test_the_four_parts_of_many_pearls_add_up_and_cover_their_discs() -> None:
    scene = rows(
        ["*", "*"], ["*", "*"], row_gap_mm=30, camera=Camera(elevation_deg=60, field_mm=60)
    )
    image = nc.render([pearl(grain=0.5, diameter_mm=9.0), SMALL], scene, 160, 16)
    total = sum(image.layers[name] for name in SUM)
    np.testing.assert_allclose(image.linear, total, atol=1e-6)
    area = image.layers["coverage"].mean() * 60.0**2
    assert area == pytest.approx(2 * math.pi * (4.5**2 + 3.0**2), rel=2e-3)


def test_a_pearl_behind_another_is_covered_by_it() -> None:
    """Seen from the horizon the row behind is hidden; its colours leave no trace but at the rim."""
    keys: dict[str, Any] = {"table": NO_TABLE, "sky": BLACK}
    scene = rows(["*0"], ["*1"], camera=Camera(elevation_deg=0, field_mm=12), **keys)
    black = LARGE.model_copy(update={"body_colour": "#000000"})
    white, dark = (nc.render([back, LARGE], scene, 48, 4) for back in (LARGE, black))
    inside = np.hypot(*np.meshgrid(*[np.arange(48) - 23.5] * 2)) < 17
    for name in ("diffuse", "mirror", "interference"):
        np.testing.assert_array_equal(white.layers[name][inside], dark.layers[name][inside])
    assert white.layers["coverage"].max() <= 1


def test_the_left_out_field_shows_every_pearl_whole() -> None:
    for keys in (
        {"elevation_deg": 35},
        {"elevation_deg": 35, "projection": "perspective", "distance_mm": 90},
        {"elevation_deg": 70, "azimuth_deg": 40, "projection": "perspective", "distance_mm": 60},
    ):
        scene = rows(["*"] * 5, ["*"] * 4, ["*"] * 5, camera=Camera(**keys))
        cover = nc.render(LARGE, scene, 96, 4).layers["coverage"][..., 0]
        assert not any(edge.any() for edge in (cover[0], cover[-1], cover[:, 0], cover[:, -1]))
        across = np.flatnonzero(cover.any(axis=0))
        down = np.flatnonzero(cover.any(axis=1))
        assert max(np.ptp(across), np.ptp(down)) > 0.6 * 96


def test_a_neighbour_takes_the_lamps_light_and_its_reflection() -> None:
    """A low lamp from the left: the right pearl lies in the left one's shadow."""
    low = Lamp(azimuth_deg=-90, elevation_deg=0, angular_radius_deg=2)
    keys: dict[str, Any] = {"lamps": [low], "sky": BLACK, "table": NO_TABLE}
    camera = Camera(elevation_deg=0, field_mm=24)
    both = nc.render(LARGE, rows(["*", "*"], pitch_mm=10, camera=camera, **keys), 64, 4)
    for name in ("diffuse", "mirror"):
        left, right = both.layers[name][:, :32].sum(), both.layers[name][:, 32:].sum()
        assert right < 0.2 * left


def test_equal_pearls_in_one_picture_have_equal_rings() -> None:
    camera = Camera(elevation_deg=89, field_mm=30)
    image = nc.render(LARGE, rows(["*", "*"], pitch_mm=15, camera=camera), 64, 4)
    part = image.layers["interference"]
    np.testing.assert_allclose(part[:, :32], part[:, 32:], atol=1e-5)


# --- recipe and command -------------------------------------------------------------------------


def again(recipe: dict[str, str]) -> nc.Image:
    texts = [text for key, text in recipe.items() if key == "pearl" or key.startswith("pearl.")]
    settings = json.loads(recipe["settings"])
    pearls = [Pearl.from_toml(text) for text in texts]
    scene = Scene.from_toml(recipe["scene"])
    return nc.render(pearls, scene, settings["size"], settings["samples"])


@pytest.mark.parametrize(
    ("given", "keys"),
    [
        ([LARGE, SMALL], ["pearl.0", "pearl.1", "pearl.2"]),
        ([LARGE, SMALL, LARGE.model_copy()], ["pearl.0", "pearl.1", "pearl.2"]),
        ([Pearl.load("paper")], ["pearl"]),
    ],
    ids=["two", "equal ones", "one"],
)
def test_the_recipe_of_many_pearls_makes_the_picture_again(
    tmp_path: Path, given: list[Pearl], keys: list[str]
) -> None:
    scene = rows(["*", "paper", "*"], ["*", "*"], sky=Sky(intensity=0.4))
    first = nc.render(given, scene, 24, 4)
    assert [key for key in first.recipe if key.startswith("pearl")] == keys
    second = again(dict(first.recipe))
    for image, name in ((first, "a"), (second, "b")):
        image.save(tmp_path / f"{name}.png")
        image.save(tmp_path / f"{name}.exr")
    for ending in ("png", "exr"):
        written = [(tmp_path / f"{name}.{ending}").read_bytes() for name in "ab"]
        assert written[0] == written[1]
    texts = nc.file.read_png_text(tmp_path / "a.png")
    assert texts[f"nacreous:{keys[-1]}"] == first.recipe[keys[-1]]


def test_the_command_takes_several_pearls(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.toml").write_text('name = "tray"\n[[rows]]\npearls = ["*", "*", "*"]\n')
    arguments = ["render", "akoya-r", "akoya-g", "--scene", "s.toml", "--size=16", "--samples=1"]
    assert cli.main(arguments) == 0
    assert capsys.readouterr().out.startswith("pearl.png: 2 pearls in scene tray, 16 x 16")
    texts = nc.file.read_png_text("pearl.png")
    assert 'name = "akoya-g"' in texts["nacreous:pearl.1"]
    assert cli.main([*arguments, "--scene", "paper"]) == 2
    assert "has a place for one pearl, not 2" in capsys.readouterr().err

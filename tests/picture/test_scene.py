"""Scenes: rows of pearls, and what stands around them."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous import cli
from nacreous.problem import InputError
from nacreous.rows import fill
from nacreous.spec import Camera, Lamp, Pearl, Row, Scene, Sky, Table, Walls, Window, preset
from tests.picture.stage import BLACK, LEFT, NO_TABLE, SUM, luminance, pearl, refusal

LARGE = pearl(name="large", diameter_mm=9.0)
SMALL = pearl(name="small", diameter_mm=6.0, depth=0.9)


def rows(*pearls: list[str], **keys: Any) -> Scene:
    keys = {"lamps": [LEFT], "table": Table(kind="plain"), **keys}
    return Scene(rows=[Row(pearls=row) for row in pearls], **keys)


# --- who lies where -----------------------------------------------------------------------------


def test_stars_take_the_given_pearls_in_turn_and_numbers_name_one() -> None:
    made = fill([LARGE, SMALL], rows(["*", "paper", "*", "*"], ["*1", "*0"]))
    assert [p.name for p in made.pearls] == ["large", "paper", "small"]
    assert [row.pearls for row in made.scene.rows] == [("*0", "*1", "*2", "*0"), ("*2", "*0")]


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
        ([LARGE], rows(["gone.toml", "*"]), "gone.toml: does not exist"),
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
    made = fill([SMALL], Scene.load(tmp_path / "s.toml"))
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
    """Seen from the horizon the row behind is hidden; its light on the front is all one sees."""
    keys: dict[str, Any] = {"table": NO_TABLE, "sky": BLACK}
    scene = rows(["*0"], ["*1"], camera=Camera(elevation_deg=0, field_mm=12), **keys)
    black = LARGE.replace(body_colour="#000000")
    white, dark = (nc.render([back, LARGE], scene, 48, 4) for back in (LARGE, black))
    inside = np.hypot(*np.meshgrid(*[np.arange(48) - 23.5] * 2)) < 17
    for name in ("diffuse", "mirror", "interference"):
        apart = np.abs(white.layers[name][inside] - dark.layers[name][inside])
        assert apart.max() < 0.01
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
    assert capsys.readouterr().out.startswith(
        "pearl.png: 2 different pearls in scene tray, 16 x 16"
    )
    texts = nc.file.read_png_text("pearl.png")
    assert 'name = "akoya-g"' in texts["nacreous:pearl.1"]
    elsewhere = [*arguments[:3], "--scene", "paper", *arguments[5:]]
    assert cli.main(elsewhere) == 2
    assert "has a place for one pearl, not 2" in capsys.readouterr().err


# --- windows ------------------------------------------------------------------------------------


def test_a_sky_of_windows_makes_white_paper_as_bright_as_itself() -> None:
    """A plate so wide that it fills the upper half: radiance 1 on a white table is 1."""
    ceiling = Window(
        position_mm=[0, 100, 0], width_mm=90_000, height_mm=90_000, luminance=1.0, spectrum="3000K"
    )
    table = Table(kind="plain", colour="#ffffff")
    # The camera looks through the window from behind.
    scene = Scene(windows=[ceiling], sky=BLACK, table=table, camera=Camera(elevation_deg=89))
    corner = nc.render(pearl(), scene, 32, 1).linear[0, 0]
    beside = 1 - (4 / math.dist((6, 6, 0), (0, 0, -4))) ** 3
    np.testing.assert_allclose(corner, beside, atol=0.02)


def test_a_window_counts_as_a_lamp_that_gives_as_much_light() -> None:
    """Interference and a matt body, by a window and by a round lamp of its size and light."""
    side_mm, distance_mm = 100.0, 1000.0
    factor = (side_mm / distance_mm) ** 2 / math.pi  # nearly: a small window
    window = Window(
        azimuth_deg=0, elevation_deg=50, width_mm=side_mm, height_mm=side_mm, luminance=1 / factor
    )
    lamp = Lamp(azimuth_deg=0, elevation_deg=50, angular_radius_deg=3.2)
    keys: dict[str, Any] = {"sky": BLACK, "table": NO_TABLE}
    by_window = nc.render(pearl(), Scene(windows=[window], **keys), 48, 4)
    by_lamp = nc.render(pearl(), Scene(lamps=[lamp], **keys), 48, 4)
    rings = [image.layers["interference"].sum() for image in (by_window, by_lamp)]
    assert rings[0] == pytest.approx(rings[1], rel=0.01)
    body = [image.layers["diffuse"].sum() for image in (by_window, by_lamp)]
    assert body[0] == pytest.approx(body[1], rel=0.03)


def test_the_camera_sees_a_window_sharp_and_the_pearl_mirrors_its_edges() -> None:
    window = Window(position_mm=[0, 0, -60], width_mm=20, height_mm=20, luminance=3.0)
    camera = Camera(elevation_deg=0, field_mm=40)
    keys: dict[str, Any] = {"sky": BLACK, "table": NO_TABLE, "camera": camera}
    image = nc.render(pearl(), Scene(windows=[window], **keys), 80, 4)
    behind = image.layers["surroundings"][..., 1]
    assert set(np.unique(behind[:15]).tolist()) == {0.0}
    np.testing.assert_allclose(behind[22:28, 22:58], 3.0, rtol=1e-5)
    front = Window(position_mm=[-30, 40, 50], width_mm=20, height_mm=20, luminance=3.0)
    close = Camera(elevation_deg=0, field_mm=9)
    scene = Scene(windows=[front], **keys | {"camera": close})
    mirror = nc.render(pearl(shininess=1.0), scene, 96, 4).layers["mirror"][..., 1]
    # In it or beside it, and little between: a sharp image.
    peak = np.quantile(mirror, 0.995)
    between = np.mean((mirror > 0.2 * peak) & (mirror < 0.6 * peak))
    assert 0 < between < 0.35 * np.mean(mirror > 0.2 * peak)


def test_a_lit_plate_lights_the_lower_half_of_the_pearl() -> None:
    plate = Window(below_mm=0.05, width_mm=200, height_mm=200)
    keys: dict[str, Any] = {"sky": BLACK, "table": NO_TABLE, "camera": Camera(elevation_deg=0)}
    image = nc.render(pearl(depth=0.0), Scene(windows=[plate], **keys), 48, 4)
    diffuse = image.layers["diffuse"][..., 1]
    assert diffuse[30:].sum() > 4 * diffuse[:18].sum()
    # From below, through the plate: a half-space of light makes a body as bright as (1 + cos) / 2.
    from_below = Scene(windows=[plate], **keys | {"camera": Camera(elevation_deg=-80)})
    bottom = nc.render(pearl(depth=0.0), from_below, 49, 4).layers["diffuse"][24, 24, 1]
    white = nc.colour.linear_from_hex(pearl().body_colour)[1]
    assert bottom == pytest.approx(white * (1 + math.sin(math.radians(80))) / 2, rel=0.02)


def test_a_window_switched_off_is_no_window_and_its_colour_is_white() -> None:
    off = Window(azimuth_deg=20, elevation_deg=20, spectrum="A", luminance=0.0)
    np.testing.assert_array_equal(
        nc.render(pearl(), Scene(lamps=[LEFT], windows=[off]), 16, 1).linear,
        nc.render(pearl(), Scene(lamps=[LEFT]), 16, 1).linear,
    )
    only = Window(azimuth_deg=180, elevation_deg=0, spectrum="A", luminance=1.0)
    scene = Scene(windows=[only], sky=BLACK, table=NO_TABLE, camera=Camera(elevation_deg=0))
    np.testing.assert_allclose(nc.render(pearl(), scene, 16, 1).linear[0, 0], 1.0, atol=1e-6)


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({}, "Window: azimuth_deg is missing: give it, or give position_mm or below_mm"),
        ({"azimuth_deg": 5}, "Window: elevation_deg is missing: give it together with azimuth_deg"),
        (
            {"azimuth_deg": 5, "elevation_deg": 5, "below_mm": 1},
            "Window: below_mm cannot stand beside azimuth_deg: a window has one place",
        ),
        (
            {"position_mm": [0, 50, 0], "distance_mm": 60},
            "Window: position_mm cannot stand beside distance_mm",
        ),
        (
            {"position_mm": [0, 9.0, 0]},
            "Window: position_mm is [0.0, 9.0, 0.0], 9 mm from the centre; ",
        ),
        (
            {"position_mm": [0, 50, 0], "facing": [0, 0, 0]},
            "Window: facing is [0.0, 0.0, 0.0]; allowed",
        ),
        ({"below_mm": 1, "facing": [0, 1, 0]}, "Window: facing is of use only with position_mm"),
    ],
    ids=str,
)
def test_a_window_in_no_place_or_two_is_refused(keys: dict[str, Any], message: str) -> None:
    assert refusal(lambda: Window(**keys)).startswith(message)


def test_a_window_through_a_pearl_and_a_plate_under_a_table_are_refused() -> None:
    through = Window(position_mm=[0, 25, 3], facing=[0, 0, -1], height_mm=60)
    line = refusal(lambda: nc.render(pearl(), Scene(windows=[through]), 8, 1))
    assert line.startswith("scene scene: windows.0 passes 3 mm from a pearl's centre; allowed: ")
    line = refusal(lambda: Scene(windows=[Window(below_mm=0.5)]))
    assert line.startswith('Scene: windows.0.below_mm is 0.5 while table.kind is "checker", which')


# --- glare --------------------------------------------------------------------------------------


def test_without_glare_its_width_changes_no_bit_and_with_it_no_light_is_lost() -> None:
    def scene(**keys: float) -> Scene:
        camera = Camera(field_mm=12, **keys)
        return Scene(lamps=[LEFT], sky=Sky(intensity=0.3), camera=camera)

    plain = nc.render(pearl(shininess=1.0), scene(), 64, 4)
    other = nc.render(pearl(shininess=1.0), scene(glare_deg=3.0), 64, 4)
    np.testing.assert_array_equal(plain.linear, other.linear)
    glaring = nc.render(pearl(shininess=1.0), scene(glare=0.2, glare_deg=0.3), 64, 4)
    for name in SUM:
        sums = [image.layers[name].sum(dtype=np.float64) for image in (plain, glaring)]
        assert sums[0] == pytest.approx(sums[1], rel=1e-5)
    total = sum(glaring.layers[name] for name in SUM)
    np.testing.assert_allclose(glaring.linear, total, atol=1e-6)
    for name in ("coverage", "texture"):
        np.testing.assert_array_equal(plain.layers[name], glaring.layers[name])


def test_half_of_the_glare_of_a_bright_point_falls_within_its_width() -> None:
    """A far, small window: its light before and after, within the stated angle of it."""
    window = Window(position_mm=[0, 0, -40], width_mm=1, height_mm=1, luminance=100)
    keys: dict[str, Any] = {"sky": BLACK, "table": NO_TABLE, "windows": [window]}

    def share(glare: float) -> float:
        camera = Camera(elevation_deg=20, field_mm=60, distance_mm=100, glare=glare, glare_deg=4)
        light = nc.render(pearl(), Scene(camera=camera, **keys), 121, 4).layers["surroundings"]
        row, column = np.unravel_index(np.argmax(light[..., 1]), (121, 121))
        away = np.hypot(np.arange(121)[:, None] - row, np.arange(121)[None, :] - column)
        within = away < 121 / 60 * 100 * math.tan(math.radians(4))
        return float(light[within].sum() / light.sum())

    assert share(0.0) == pytest.approx(1.0, abs=1e-6)
    assert share(0.4) == pytest.approx(0.8, abs=0.02)


# --- the scenes that come along -----------------------------------------------------------------


@pytest.mark.parametrize("name", preset.names("scene"))
def test_every_scene_renders_its_pearls_whole_and_has_its_page(name: str) -> None:
    image = nc.render("akoya-rg", name, 24, 4)
    cover = image.layers["coverage"][..., 0]
    assert cover.max() == 1
    # A pixel's filter reaches into its neighbours.
    assert max(edge.max() for edge in (cover[0], cover[-1], cover[:, 0], cover[:, -1])) < 0.1
    assert 0.05 < image.linear[cover > 0.5].mean() < 1.2
    page = Path(__file__).parent.parent.parent / "docs" / "scenes" / f"{name}.md"
    assert page.read_text(encoding="utf-8").startswith(f"# The scene `{name}`\n")


def test_on_black_cloth_a_pearl_stands_out_and_on_white_it_lies_in_light() -> None:
    white, black = (nc.render("akoya-rg", f"north-window-{c}", 48, 4) for c in ("white", "black"))
    corner = [float(image.linear[-1, :10].mean()) for image in (white, black)]
    assert corner[0] > 0.4
    assert corner[1] < 0.02
    lower = [image.layers["mirror"][30:].mean() for image in (white, black)]
    assert lower[0] > 3 * lower[1]


def test_in_the_aurora_viewer_the_halves_meet_at_the_waist_and_differ_in_hue() -> None:
    image = nc.render("akoya-g-1.0", "aurora", 64, 16)
    mirror = luminance(image.layers["mirror"])[:, 31:33].mean(axis=1)
    assert mirror[14:30].max() < 0.1 * mirror[35:38].min()
    upper, lower = image.linear[24:29, 28:36], image.linear[36:41, 28:36]
    white = nc.colour.xyz_from_rgb([1, 1, 1])
    lab = [nc.colour.lab_from_xyz(nc.colour.xyz_from_rgb(half), white) for half in (upper, lower)]
    hues = [np.degrees(np.arctan2(*half.reshape(-1, 3).mean(axis=0)[[2, 1]])) for half in lab]
    assert abs((hues[0] - hues[1] + 180) % 360 - 180) > 90


def test_the_booth_is_neutral_and_lit_evenly() -> None:
    image = nc.render(pearl(depth=0.0, grain=0.0), "booth", 48, 4)
    ground = image.linear[image.layers["coverage"][..., 0] == 0]
    assert np.ptp(ground, axis=1).max() < 1e-4
    assert ground.max() < 1.5 * np.median(ground)


def test_masters_lie_above_the_goods_in_the_order_of_their_steps() -> None:
    made = fill([SMALL], Scene.load("two-tier"))
    masters, goods = made.scene.rows
    names = [made.pearls[int(place[1:])].name for place in masters.pearls]
    assert names == [f"akoya-rg-{step}" for step in ("1.0", "0.7", "0.4", "0.0")]
    assert {made.pearls[int(place[1:])].name for place in goods.pearls} == {"small"}


# --- lights that give no white ------------------------------------------------------------------


def test_a_window_that_faces_away_leaves_the_white_to_the_sky() -> None:
    away = {"position_mm": (0, 50, 0), "facing": (0, 1, 0)}
    dark, lit = (nc.render(pearl(), Scene(windows=w), 12, 1).linear for w in ((), (away,)))
    assert lit.mean() == pytest.approx(dark.mean(), rel=0.2)


def test_a_light_that_cannot_be_is_refused_by_its_key(tmp_path: Path) -> None:
    (tmp_path / "dark.csv").write_text("380,0\n780,0\n")
    (tmp_path / "line.csv").write_text("380,0\n435,0\n436,1\n437,0\n780,0\n")
    good = {"azimuth_deg": 0, "elevation_deg": 40}
    for name, lamps, message in (
        ("dark", [good], r"lamps\.1\.spectrum is .*dark\.csv, which has luminance 0"),
        ("line", [], r'camera\.white is "auto", a light of XYZ .* such as "D65"'),
    ):
        bad = {**good, "spectrum": str(tmp_path / f"{name}.csv")}
        with pytest.raises(InputError, match=message):
            nc.render(pearl(), Scene(lamps=(*lamps, bad)), 8, 1)

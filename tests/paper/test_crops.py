"""The seven crops of figure 2 from any picture of a pearl."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image as Pillow

from nacreous import _core, cli, render
from nacreous.file import read_photograph, read_png_text
from nacreous.paper import cutting
from nacreous.paper.circle import Circle
from nacreous.paper.crop import seven
from nacreous.paper.outline import estimate
from nacreous.problem import InputError
from nacreous.spec import Camera, Pearl, Scene

SIZE_PX = 160


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: Any) -> Path:
    path = tmp_path_factory.mktemp("rendered") / "pearl.png"
    render("paper", size=SIZE_PX, samples=4).save(path)
    return path


@pytest.fixture(scope="module")
def truth() -> Circle:
    return Circle.of_view(Pearl.load("paper"), Scene.load("paper"), SIZE_PX)


def pixels(path: Path) -> np.ndarray:
    with Pillow.open(path) as picture:
        return np.asarray(picture)


def without_recipe(path: Path, to: Path) -> Path:
    Pillow.fromarray(pixels(path)).save(to)
    return to


def disc(circle: Circle, rows: int, columns: int) -> np.ndarray:
    """An evenly bright disc with a soft edge and a bright spot, on a darker ground."""
    y, x = np.mgrid[:rows, :columns] + 0.5
    away = np.hypot(x - circle.x_px, y - circle.y_px)
    light = 0.1 + 0.5 * np.clip(circle.radius_px - away + 0.5, 0, 1)
    spot = np.hypot(x - circle.x_px - 0.3 * circle.radius_px, y - circle.y_px) / circle.radius_px
    light += 0.4 * np.exp(-((spot / 0.08) ** 2))
    return np.repeat(light[..., None], 3, axis=-1).astype(np.float32)


def test_crops_are_the_pictures_own_pixels(rendered: Path, truth: Circle, tmp_path: Path) -> None:
    cuts = cutting.cut_file(rendered, tmp_path / "crops")
    assert cuts.circle == truth
    whole = pixels(rendered)
    side = round(0.36 * truth.radius_px)
    for cut in cuts.crops:
        path = tmp_path / "crops" / f"crop-{cut.number}.png"
        np.testing.assert_array_equal(pixels(path), cut.of(whole))
        assert pixels(path).shape == (side, side, 3)
        texts = read_png_text(path)
        assert json.loads(texts["nacreous:crop"]) == cut.record()
        assert Pearl.from_toml(texts["nacreous:pearl"]) == Pearl.load("paper")
    assert [cut.number for cut in cuts.crops] == [1, 2, 3, 4, 5, 6, 7]


def test_sixteen_bits_keep_what_eight_would_lose(tmp_path: Path) -> None:
    circle = Circle(70.0, 66.0, 40.0)
    codes = np.round(65535 * disc(circle, 130, 140)).astype(np.uint16)
    _core.write_png(tmp_path / "deep.png", codes, "srgb", [])
    cuts = cutting.cut_file(tmp_path / "deep.png", tmp_path / "crops", circle, 16)
    deep, whole = (read_photograph(tmp_path / p) for p in ("crops/crop-3.png", "deep.png"))
    np.testing.assert_allclose(deep, cuts.crops[2].of(whole), atol=2 / 65535)


def test_crops_lie_further_out_from_number_to_number(truth: Circle, rendered: Path) -> None:
    away = [cut.distance(truth) for cut in seven(read_photograph(rendered), truth)]
    assert away == sorted(away)


def test_crops_turn_with_the_picture(rendered: Path, truth: Circle) -> None:
    picture = read_photograph(rendered)
    upright, turned = seven(picture, truth), seven(np.rot90(picture), truth)
    for before, after in zip(upright, turned, strict=True):
        # A quarter turn against the clock takes (x, y) to (y, side - x).
        assert after.left_px == pytest.approx(before.top_px, abs=1)
        assert after.top_px == pytest.approx(SIZE_PX - before.left_px - before.side_px, abs=1)


def test_a_brighter_table_does_not_pull_the_crops_off_the_lamp(
    rendered: Path, truth: Circle
) -> None:
    picture = read_photograph(rendered)
    glaring = np.where((truth.distance(picture.shape) > 1.0)[..., None], 1.0, picture)
    assert seven(glaring, truth)[:2] == seven(picture, truth)[:2]


@pytest.mark.parametrize("scale", [1, 3])
def test_larger_pictures_have_their_crops_in_the_same_places(scale: int) -> None:
    small = Circle(200.0, 190.0, 130.0)
    large = Circle(*(scale * part for part in (small.x_px, small.y_px, small.radius_px)))
    picture = np.kron(disc(small, 400, 400), np.ones((scale, scale, 1), np.float32))
    for one, other in zip(seven(disc(small, 400, 400), small), seven(picture, large), strict=True):
        assert other.distance(large) == pytest.approx(one.distance(small), abs=0.02)


# --- finding the pearl


@pytest.mark.parametrize(
    "circle",
    [
        Circle(100.0, 100.0, 60.0),
        Circle(81.3, 120.8, 47.6),
        Circle(150.2, 66.0, 30.0),
        Circle(433.3, 610.0, 411.0),
    ],
)
def test_a_planted_outline_is_found_to_half_a_pixel(circle: Circle) -> None:
    found, share = estimate(disc(circle, *((200, 230) if circle.radius_px < 100 else (1100, 900))))
    assert share > 0.95
    assert abs(found.x_px - circle.x_px) < 0.5
    assert abs(found.y_px - circle.y_px) < 0.5
    assert abs(found.radius_px - circle.radius_px) < 0.7


@pytest.mark.parametrize("scene", ["paper", "north-window-black", "north-window-white"])
def test_a_pearls_outline_is_found_to_one_part_in_a_hundred(scene: str) -> None:
    # As many samples as the command takes: a white pearl on white cloth has a faint outline.
    picture = render("akoya-rg", scene, size=256, samples=16)
    codes, _ = picture.develop()
    linear = np.asarray(_core.decode_rgb(codes / 255.0))
    # Off the middle, so that a guess of the middle would not do.
    found, _ = estimate(np.pad(linear, ((0, 30), (70, 0), (0, 0)), mode="reflect"))
    true = Circle.of_view(Pearl.load("akoya-rg"), Scene.load(scene), 256)
    assert np.hypot(found.x_px - 70 - true.x_px, found.y_px - true.y_px) < 0.01 * true.radius_px
    assert found.radius_px == pytest.approx(true.radius_px, rel=0.01)


def board(rows: int, columns: int) -> np.ndarray:
    y, x = np.mgrid[:rows, :columns] // 20
    return np.repeat((0.2 + 0.6 * ((x + y) % 2))[..., None], 3, axis=-1)


@pytest.mark.parametrize(
    "picture",
    [
        np.full((120, 120, 3), 0.5),
        np.random.default_rng(0).random((120, 150, 3)),
        np.random.default_rng(1).random((160, 150, 3)),
        board(120, 160),
        disc(Circle(10.0, 60.0, 50.0), 120, 120),
        np.zeros((1, 1, 3)),
        np.ones((3, 500, 3)),
    ],
    ids=["grey", "noise", "more noise", "board", "cut off", "one pixel", "strip"],
)
def test_no_pearl_is_said_and_not_guessed(picture: np.ndarray) -> None:
    with pytest.raises(InputError, match="give it with --centre X Y --radius R"):
        estimate(picture)


def test_a_nearby_eye_sees_a_larger_outline() -> None:
    eyes: list[dict[str, Any]] = [{}, {"projection": "perspective", "distance_mm": 20.0}]
    far, near = (
        Circle.of_view(Pearl(), Scene(camera=Camera(field_mm=12.0, **eye)), 120) for eye in eyes
    )
    assert near.radius_px / far.radius_px == pytest.approx(1 / np.sqrt(1 - (4 / 20) ** 2))


def test_a_recipe_that_no_longer_fits_is_not_believed(rendered: Path, tmp_path: Path) -> None:
    texts = list(read_png_text(rendered).items())
    doubled = np.kron(pixels(rendered), np.ones((2, 2, 1), np.uint8))
    _core.write_png(tmp_path / "doubled.png", doubled, "srgb", texts)
    assert cutting.cut_file(tmp_path / "doubled.png", tmp_path / "a").found.startswith("estimated")
    broken = [(key, "size = " if key == "nacreous:scene" else text) for key, text in texts]
    _core.write_png(tmp_path / "broken.png", pixels(rendered), "srgb", broken)
    assert cutting.cut_file(tmp_path / "broken.png", tmp_path / "b").found.startswith("estimated")


# --- the command


@pytest.mark.parametrize("ending", ["jpg", "tif", "png"])
def test_the_command_says_what_it_cut_and_how_the_pearl_was_found(
    rendered: Path, tmp_path: Path, capsys: Any, ending: str
) -> None:
    picture = without_recipe(rendered, tmp_path / f"pearl.{ending}")
    assert cli.main(["crops", str(picture), "-o", str(tmp_path / "parts")]) == 0
    line = capsys.readouterr().out
    assert "7 crops, 19 x 19 pixels each" in line
    assert "estimated, with an edge in" in line
    assert sorted(path.name for path in (tmp_path / "parts").iterdir()) == sorted(cutting.FILES)


def test_given_outlines_win(rendered: Path, tmp_path: Path, capsys: Any) -> None:
    outline = ["--centre", "82", "79.5", "--radius", "50"]
    assert cli.main(["crops", str(rendered), "-o", str(tmp_path / "parts"), *outline]) == 0
    assert "(82.0, 79.5), radius 50.0, as given" in capsys.readouterr().out
    record = json.loads((tmp_path / "parts" / "crops.json").read_text())
    assert record["outline"]["radius_px"] == 50.0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["none.png"], "none.png: does not exist"),
        (["text.png"], "text.png"),
        (["empty.png"], "empty.png"),
        (["folder"], "folder"),
        (["grey.png"], "grey.png: no round outline of one pearl stands out"),
        (["pearl.png", "--centre", "80", "80"], "--centre is given without --radius"),
        (["pearl.png", "--radius", "50"], "--radius is given without --centre"),
        (["pearl.png", "--centre", "80", "80", "--radius", "0"], "--radius is 0; allowed: above 0"),
        (["pearl.png", "--centre", "80", "80", "--radius", "nan"], "--radius is nan"),
        (["pearl.png", "--centre", "inf", "80", "--radius", "50"], "--centre is inf 80"),
        (["pearl.png", "--centre", "80", "80", "--radius", "20"], "radius is 20.0 pixels"),
        (["pearl.png", "--centre", "80", "80", "--radius", "79"], "would leave the picture"),
        (
            ["pearl.png", "--centre", "900", "80", "--radius", "50"],
            "pearl.png: the pearl's outline",
        ),
        (["pearl.png", "--centre", "1e300", "1e300", "--radius", "1e300"], "pearl.png: "),
        (["pearl.png", "--bits", "12"], "12"),
        (["pearl.png", "-o", "folder"], "folder: holds 'mine.txt'"),
        (["pearl.png", "-o", "text.png"], "text.png: is a file; wanted: a folder"),
    ],
)
def test_bad_calls_end_with_code_2_and_write_nothing(
    rendered: Path, tmp_path: Path, monkeypatch: Any, capsys: Any, arguments: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("pearl.png").write_bytes(rendered.read_bytes())
    Path("text.png").write_text("no picture")
    Path("empty.png").touch()
    Path("folder").mkdir()
    Path("folder/mine.txt").write_text("mine")
    Pillow.new("RGB", (90, 90), "grey").save("grey.png")
    before = sorted(tmp_path.rglob("*"))
    assert cli.main(["crops", *arguments]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert said in captured.err
    assert sorted(tmp_path.rglob("*")) == before


def test_all_seven_or_none(rendered: Path, tmp_path: Path, monkeypatch: Any) -> None:
    written = []

    def failing_write(path: Path, *rest: Any) -> None:
        written.append(path)
        if len(written) == 5:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(_core, "write_png", failing_write)
    with pytest.raises(InputError, match="No space left on device"):
        cutting.cut_file(rendered, tmp_path / "parts")
    assert list(tmp_path.iterdir()) == []

"""What `nacreous render` and `nacreous grow` write and say."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from PIL import Image as Pillow

import nacreous as nc
from nacreous import cli
from nacreous.nacre import diary
from nacreous.spec import Growth


def test_render_writes_one_picture_and_says_so(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert (
        cli.main(["render", "akoya-r", "--size", "16", "--samples", "1", "--scene", "booth"]) == 0
    )
    said = capsys.readouterr()
    assert said.err == ""
    assert said.out.count("\n") == 1
    assert said.out.startswith("pearl.png: pearl akoya-r (")
    assert "in scene booth, 16 x 16, 1 samples a pixel" in said.out
    assert [path.name for path in folder.iterdir()] == ["pearl.png"]
    with Pillow.open("pearl.png") as picture:
        assert picture.size == (16, 16)
    assert nc.file.read_png_text("pearl.png")["nacreous:pearl"].startswith('name = "akoya-r"')


def test_settings_reach_pearl_and_scene(folder: Path) -> None:
    settings = ["depth=0.25", "nacre.seed=9", "camera.elevation_deg=-3", "lamps.0.intensity=2"]
    options = [word for setting in settings for word in ("--set", setting)]
    assert cli.main(["render", "paper", "--size=8", "--samples=1", "-o", "a.png", *options]) == 0
    texts = nc.file.read_png_text("a.png")
    assert "depth = 0.25" in texts["nacreous:pearl"]
    assert "seed = 9" in texts["nacreous:pearl"]
    assert "elevation_deg = -3" in texts["nacreous:scene"]
    assert "intensity = 2" in texts["nacreous:scene"]


@pytest.mark.parametrize(
    ("name", "magic"),
    [
        ("a.png", b"\x89PNG\r\n\x1a\n"),
        ("a.SVG", b"<?xml "),
        ("a.pdf", b"%PDF-"),
        ("a.csv", b"date,depth_um,thickness_nm\n"),
    ],
)
def test_grow_draws_what_the_ending_asks_for_and_the_same_again(
    folder: Path, capsys: pytest.CaptureFixture[str], name: str, magic: bytes
) -> None:
    drawings = []
    for _ in range(2):
        assert cli.main(["grow", "paper", "-o", name]) == 0
        drawings.append((folder / name).read_bytes())
    assert drawings[0].startswith(magic)
    assert drawings[0] == drawings[1]
    assert [path.name for path in folder.iterdir()] == [name]
    assert capsys.readouterr().err == ""


def test_grow_prints_the_statistics_of_the_stack(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["grow", "akoya-g", "--set", "seed=7", "-o", "a.csv"]) == 0
    said = capsys.readouterr().out
    stack = nc.grow("akoya-g", seed=7)
    assert "akoya-g, seed 7" in said
    assert "244 days, 04-15 to 12-15" in said
    assert f"layers       {len(stack)}\n" in said
    assert f"{stack.total_um:.1f} um in all" in said
    for depth_um in (10, 50):
        layers, mean_nm, spread_nm = stack.outer(depth_um)
        line = (
            f"outer {depth_um} um  {layers} layers, mean {mean_nm:.1f} nm, spread {spread_nm:.1f}"
        )
        assert line in said


def test_the_table_of_grow_is_the_stack_from_the_nucleus_outward(folder: Path) -> None:
    assert cli.main(["grow", "paper", "--set", "nacre.seed=7", "-o", "a.csv"]) == 0
    with Path("a.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    stack = nc.grow("paper", seed=7)
    thickness_nm = [float(row["thickness_nm"]) for row in rows]
    np.testing.assert_array_equal(thickness_nm, stack.thickness_nm[::-1])
    tops_um = np.concatenate([[0], np.cumsum(stack.thickness_nm + 20)[:-1]]) / 1000
    np.testing.assert_allclose([float(row["depth_um"]) for row in rows], tops_um[::-1], atol=1e-4)
    dates = diary(Growth(preset="paper", seed=7)).date
    assert [row["date"] for row in rows] == [f"{date:%m-%d}" for date in dates]


def test_days_of_a_year_are_written_with_their_year(folder: Path) -> None:
    settings = ["--set=seeding=2023-05-01", "--set=harvest=2024-02-03"]
    assert cli.main(["grow", "paper", "-o", "a.csv", *settings]) == 0
    dates = [line.partition(",")[0] for line in Path("a.csv").read_text().splitlines()[1:]]
    assert dates == sorted(dates)
    assert dates[0][:7] == "2023-05"
    assert dates[-1][:5] == "2024-"


def test_the_axis_of_dates_shows_months_and_years_only_where_given(folder: Path) -> None:
    """matplotlib notes each text of an SVG in a comment."""
    assert cli.main(["grow", "paper", "-o", "every.svg"]) == 0
    drawing = Path("every.svg").read_text()
    assert all(f"<!-- {month} -->" in drawing for month in ("May", "Aug", "Nov"))
    assert "2001" not in drawing
    assert cli.main(["grow", "paper", "-o", "days.svg", "--set=harvest=04-25"]) == 0
    assert "<!-- Apr 15 -->" in Path("days.svg").read_text()
    settings = ["--set=seeding=2023-05-01", "--set=harvest=2023-12-03"]
    assert cli.main(["grow", "paper", "-o", "one.svg", *settings]) == 0
    assert "<!-- 2023-" in Path("one.svg").read_text()


def test_a_folder_does_not_hide_a_preset_and_a_file_does(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("akoya").mkdir()
    assert cli.main(["grow", "akoya", "-o", "a.csv"]) == 0
    Path("akoya").rmdir()
    Path("akoya").write_text("[nacre]\nseed = 41\n")
    assert cli.main(["grow", "akoya", "-o", "a.csv"]) == 0
    assert "seed 41" in capsys.readouterr().out


def test_what_is_set_and_changes_nothing_is_noted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    small = ["--size", "8", "--samples", "1", "--set", "blemishes.area=0.1"]
    noted = "note: blemishes.area is 0.1 and changes nothing"
    for words in (["render"], ["card"], ["turn", "--frames", "2"]):
        assert cli.main([*words, "akoya-rg", *small]) == 0
        assert noted in capsys.readouterr().out
    assert cli.main(["render", "akoya-rg", *small, "--set", "blemishes.pits=2"]) == 0
    assert noted not in capsys.readouterr().out


def test_the_summary_says_the_nacre_that_is_given_and_factors_have_japanese_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    words = ["--word", "巻き（黒蝶）=厚巻き", "--word", "テリ=最上"]
    assert cli.main(["render", "tahitian", *words, "--size", "8", "--samples", "1"]) == 0
    assert "layers, 2200 um of nacre" in capsys.readouterr().out

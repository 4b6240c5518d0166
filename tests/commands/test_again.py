"""`nacreous render picture.png`: a picture made again from the recipe inside it."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image as Pillow

import nacreous as nc
from nacreous import _core, cli


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def render(*arguments: str) -> None:
    assert cli.main(["render", *arguments]) == 0


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    before = sorted(Path().iterdir())
    assert cli.main(["render", *arguments]) == 2
    assert sorted(Path().iterdir()) == before
    (line,) = capsys.readouterr().err.splitlines()
    return line


@pytest.mark.parametrize(
    "how",
    [
        ["paper", "-o", "a.png"],
        ["tahitian", "--scene", "booth", "-o", "a.png", "--bits=16", "--space=display-p3"],
        ["akoya-rg", "akoya-r", "--scene", "two-tier", "-o", "a.png", "--gamut=clip", "--alpha"],
        ["akoya-g", "--set", "depth=0.3", "--set", "camera.elevation_deg=70", "-o", "a.exr"],
    ],
    ids=["plain", "wide", "rows", "exr"],
)
def test_a_picture_made_again_has_the_same_bytes(folder: Path, how: list[str]) -> None:
    render(*how, "--size", "12", "--samples", "4")
    (made,) = folder.iterdir()
    render(made.name)
    assert (folder / f"a-again{made.suffix}").read_bytes() == made.read_bytes()


def test_what_is_said_beside_the_picture_changes_it(folder: Path) -> None:
    render("paper", "--size", "12", "--samples", "1", "--bits", "16", "-o", "a.png")
    again = ["--size", "20", "--scene", "booth", "--set", "depth=0.1", "--set", "camera.glare=0.1"]
    render("a.png", *again, "--alpha", "-o", "b.png")
    texts = nc.file.read_png_text("b.png")
    assert "depth = 0.1" in texts["nacreous:pearl"]
    assert 'name = "paper"' in texts["nacreous:pearl"]
    assert 'name = "booth"' in texts["nacreous:scene"]
    assert "glare = 0.1" in texts["nacreous:scene"]
    with Pillow.open("b.png") as picture:
        assert (picture.size, picture.mode) == ((20, 20), "RGBA")
    assert (folder / "b.png").read_bytes()[24] == 16  # bits, as in a.png
    render("b.png", "--no-alpha", "-o", "c.png")
    assert (folder / "c.png").read_bytes()[25] == 2  # RGB


def test_a_picture_without_a_whole_recipe_is_refused(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Pillow.new("RGB", (4, 4)).save("photograph.png")
    assert "photograph.png: has no recipe; allowed: a picture" in refused(capsys, "photograph.png")
    assert "gone.png: does not exist" in refused(capsys, "gone.png")
    Path("text.exr").write_text("pearl")
    assert "text.exr: is not a picture that can be read here" in refused(capsys, "text.exr")
    render("paper", "--size", "8", "--samples", "1", "-o", "a.png")
    assert "one picture, or pearls" in refused(capsys, "a.png", "paper")
    texts = nc.file.read_png_text("a.png")
    codes = nc.render("paper", size=8, samples=1).develop()[0]
    for key, text, message in (
        ("settings", '{"size": "many"}', "a.png: its recipe is damaged"),
        ("pearl", "depth = 9", "a.png: pearl: depth is 9"),
        ("scene", "depth =", "a.png: scene: line 1"),
    ):
        broken = texts | {f"nacreous:{key}": text}
        _core.write_png("a.png", codes, "srgb", list(broken.items()))
        assert message in refused(capsys, "a.png")

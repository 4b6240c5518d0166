"""`nacreous render picture.png`: a picture made again from the recipe inside it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
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
        ["paper", "--alpha", "-o", "a.exr"],
    ],
    ids=["plain", "wide", "rows", "exr", "exr with alpha"],
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


@pytest.mark.parametrize(
    "how", [["--bits=16"], ["--space=display-p3", "--gamut=clip"], ["--alpha"]]
)
def test_a_png_is_made_again_as_openexr_without_what_is_the_pngs_own(
    folder: Path, capsys: pytest.CaptureFixture[str], how: list[str]
) -> None:
    small = ["paper", "--size", "8", "--samples", "1"]
    alpha = [one for one in how if one == "--alpha"]
    render(*small, *how, "-o", "a.png")
    capsys.readouterr()
    render("a.png", "-o", "a.exr")
    said = capsys.readouterr().out
    render(*small, *alpha, "-o", "b.exr")
    assert (folder / "a.exr").read_bytes() == (folder / "b.exr").read_bytes()
    for option in set(how) - {"--alpha"}:
        assert option.removeprefix("--").replace("=", " ") in said
    assert ("which OpenEXR has no place for" in said) == (not alpha)


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
        ("settings", '{"size": 8, "size": 9, "samples": 1}', "a.png: its recipe is damaged"),
        ("pearl", "depth = 9", "a.png: pearl: depth is 9"),
        ("scene", "depth =", "a.png: scene: line 1"),
    ):
        broken = texts | {f"nacreous:{key}": text}
        _core.write_png("a.png", codes, "srgb", list(broken.items()))
        assert message in refused(capsys, "a.png")


LAMP = "400,1\n700,{}\n"
LIT = '[[lamps]]\nazimuth_deg = 0\nelevation_deg = 40\nspectrum = "lamp.csv"\n'


@pytest.fixture
def lit(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A picture in `a/` with a measured lamp beside it, and another such lamp in `b/`."""
    for name, red in (("a", 1), ("b", 9)):
        (folder / name).mkdir()
        (folder / name / "lamp.csv").write_text(LAMP.format(red))
    (folder / "a" / "lit.toml").write_text(LIT)
    monkeypatch.chdir(folder / "a")
    render("paper", "--scene", "lit.toml", "--size", "8", "--samples", "1", "-o", "p.png")
    return folder


def test_a_picture_with_files_makes_itself_again_from_every_folder(
    lit: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = Path("p.png").read_bytes()
    monkeypatch.chdir(lit / "b")
    render("../a/p.png", "-o", "../a/again.png")
    assert (lit / "a" / "again.png").read_bytes() == first
    (lit / "a").rename(lit / "moved")
    render("../moved/p.png", "-o", "../moved/again.png")
    assert (lit / "moved" / "again.png").read_bytes() == first
    assert str(lit) not in nc.file.read_png_text("../moved/p.png")["nacreous:scene"]


def test_a_file_that_changed_or_is_gone_is_refused_by_name_unless_named_anew(
    lit: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lamp = Path("lamp.csv")
    lamp.write_text(LAMP.format(2))
    assert "p.png: was made with another " in refused(capsys, "p.png")
    lamp.unlink()
    line = refused(capsys, "p.png")
    assert line.endswith(
        f"{lamp.absolute()}, which does not exist; allowed: the same file, or another one that is "
        "named anew"
    )
    render("p.png", "--set", "lamps.0.spectrum=../b/lamp.csv", "-o", "../b/q.png")
    assert 'spectrum = "lamp.csv"' in nc.file.read_png_text("../b/q.png")["nacreous:scene"]
    render("p.png", "--scene", "booth", "-o", "r.png")
    assert "nacreous:files" not in nc.file.read_png_text("r.png")


def test_panoramas_and_photographs_count_as_files_too_and_an_unlit_lamp_does_not(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    red = np.full((8, 16, 3), [1.0, 0.5, 0.5], np.float32)
    _core.write_exr("sky.exr", [("", red)], [])
    noise = np.random.default_rng(1).integers(100, 200, (160, 160, 3), np.uint8)
    Pillow.fromarray(noise).save("photo.png")
    Path("s.toml").write_text(f'[sky]\nkind = "panorama"\npath = "sky.exr"\n{LIT}intensity = 0\n')
    Path("p.toml").write_text('[texture]\nsource = "photo.png"\nside_px = 16\n')
    Path("lamp.csv").write_text(LAMP.format(1))
    render("p.toml", "--scene", "s.toml", "--size", "8", "--samples", "1", "-o", "p.exr")
    render("p.exr", "-o", "q.exr")
    assert Path("p.exr").read_bytes() == Path("q.exr").read_bytes()
    assert "does not say what" in refused(capsys, "p.exr", "--set", "lamps.0.intensity=1")
    for name in ("photo.png", "sky.exr"):
        kept = Path(name).read_bytes()
        Path(name).write_bytes(kept + b"x")
        assert name in refused(capsys, "p.exr")
        Path(name).write_bytes(kept)

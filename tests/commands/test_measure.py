"""`nacreous measure`: what it says, what it writes, what it refuses."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import nacreous as nc
from nacreous.cli import main


@pytest.fixture
def there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_it_tells_all_and_writes_json_and_plot(
    there: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    nc.render("akoya-rg", "north-window-black", size=160, samples=4).save("pearl.exr")
    assert main(["measure", "pearl.exr", "--json", "out.json", "--plot", "out.png"]) == 0
    said = capsys.readouterr().out
    for word in ("diameter", " mm", "roundness", "L*", "half-width", "blemished area", "by hue"):
        assert word in said
    numbers = json.loads(Path("out.json").read_text("utf-8"))
    assert numbers["size"]["unit"] == "mm"
    assert numbers["size"]["mean"]["value"] == pytest.approx(8.0, rel=0.01)
    with Image.open("out.png") as plot:
        assert plot.width > 1000


def test_highlights_that_a_png_bends_are_named(
    there: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    nc.render("akoya-rg", "north-window-black", size=128, samples=4).save("pearl.png")
    assert main(["measure", "pearl.png"]) == 0
    assert "not measured: the highlight is clipped" in capsys.readouterr().out


def test_white_is_given_by_codes_or_by_place(
    there: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rows, columns = np.ogrid[:120, :120]
    picture = np.where((np.hypot(rows - 60, columns - 60) < 40)[..., None], [150, 140, 130], 20)
    picture[:12, :12] = [240, 230, 220]
    Image.fromarray(picture.astype(np.uint8)).save("photo.png")
    assert main(["measure", "photo.png", "--white", "#f0e6dc"]) == 0
    first = capsys.readouterr().out
    assert " px" in first
    assert main(["measure", "photo.png", "--white", "6,6,8"]) == 0
    assert capsys.readouterr().out == first
    assert main(["measure", "photo.png"]) == 0
    assert capsys.readouterr().out != first


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--white", "chalk"], "--white is 'chalk'; allowed: '#rrggbb', or X,Y,SIDE in pixels"),
        (["--white", "#12345"], "--white is '#12345'"),
        (["--white", "300,3,8"], "leaves the picture of 64 x 64 pixels"),
        (["--radius", "20"], "--radius is given without --centre"),
        (["--centre", "nan", "1", "--radius", "80"], "--centre x is nan; allowed: finite pixels"),
        (["--centre", "1", "inf", "--radius", "80"], "--centre y is inf; allowed: finite pixels"),
        (["--centre", "1", "1", "--radius", "nan"], "--radius is nan; allowed: finite pixels"),
        (["--mm-per-pixel", "0"], "photo.png: mm_per_pixel is 0"),
        (["--plot", "out.gif"], "out.gif: the ending is .gif"),
        (["--json", "photo.json", "--plot", "photo.png"], "photo.png: is the same file as"),
        ([], "photo.png: no pearl"),
        (["--white", "nan,1,1"], "--white is 'nan,1,1'; allowed: '#rrggbb', or X,Y,SIDE"),
        (["--white", "inf,1,1"], "--white is 'inf,1,1'; allowed: '#rrggbb', or X,Y,SIDE"),
    ],
)
def test_mistakes_end_with_one_line_and_nothing_is_written(
    there: Path, capsys: pytest.CaptureFixture[str], options: list[str], said: str
) -> None:
    Image.new("RGB", (64, 64), (90, 90, 90)).save("photo.png")
    assert main(["measure", "photo.png", *options]) == 2
    told = capsys.readouterr().err
    assert said in told
    assert told.count("\n") == 1
    assert [path.name for path in there.iterdir()] == ["photo.png"]


def test_every_mark_of_a_ring_has_room_in_its_plot() -> None:
    from matplotlib.figure import Figure

    from nacreous.commands.measure_plot import _by_ring
    from nacreous.measure import Colour, Measures, Number, Ring

    for chroma in (0.0, 4.0, 40.0):
        colour = Colour(Number(70.0), Number(chroma), None)
        rings = tuple(Ring(0.0, 0.1, view, 1.0, colour) for view in (5.0, 60.0))
        axes = Figure().add_subplot()
        _by_ring(axes, Measures(*(None,) * 5, rings, *(None,) * 4))  # type: ignore[arg-type]
        assert axes.get_ylim()[1] > 1.1 * chroma

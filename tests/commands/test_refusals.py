"""What `nacreous render` and `nacreous grow` refuse, each in one line."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest

import nacreous as nc
from nacreous import cli
from nacreous.file import read_panorama
from nacreous.strand import read_lot

Run = Callable[..., list[str]]


def chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def huge_png() -> bytes:
    """20000 x 20000 by its header; of its pixels only the first few bytes are there."""
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", 20_000, 20_000, 8, 2, 0, 0, 0))
    pixels = chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + header + pixels


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with all kinds of bad files, which is where commands run."""
    texts = {
        "unknown.toml": "[nacre]\nprotien_nm = 20\n",
        "type.toml": 'depth = "deep"\ngrain = true\n',
        "negative.toml": "[nacre]\nthickness_nm = [400, -410]\n",
        "nan.toml": "diameter_mm = nan\n",
        "none.toml": "[nacre]\nthickness_nm = []\n",
        "winter.toml": "[nacre]\nlayers_winter = 1e9\n",
        "many.toml": f"[nacre]\nthickness_nm = [{'400,' * 5001}]\n",
        "long.toml": f"# {'x' * 1_000_001}\n",
        "decades.toml": '[nacre]\nseeding = "2001-01-01"\nharvest = "2020-12-31"\n'
        "layers_winter = 20\n",
        "empty.toml": "",
        "syntax.toml": "depth = \n",
        "scene.toml": '[table]\nkind = "cloth"\n',
        "picture.toml": '[texture]\nsource = "text.png"\n',
        "hollow.toml": '[texture]\nsource = "hollow.png"\n',
        "huge.toml": '[texture]\nsource = "huge.png"\n',
        "folder.toml": '[texture]\nsource = "folder.png"\n',
        "gone.toml": '[texture]\nsource = "gone.png"\n',
        "absorbing.toml": "[nacre]\nthickness_nm = [400]\naragonite = [1.53, 0.1]\n",
        "listed.toml": "[nacre]\nthickness_nm = [400]\n",
        "text.png": "This is not a picture.\n",
        "hollow.png": "",
        "ground.exr": "neither is this",
        "lamp.csv": "380,1\n500,-1\n780,1\n",
    }
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "huge.png").write_bytes(huge_png())
    (tmp_path / "binary.toml").write_bytes(b"\x7fELF\0\0")
    (tmp_path / "folder.png").mkdir()
    if Path("/dev/full").exists():
        (tmp_path / "full.png").symlink_to("/dev/full")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def listing(folder: Path) -> dict[str, tuple[int, int]]:
    return {
        str(path): (path.lstat().st_size, path.lstat().st_mtime_ns) for path in folder.rglob("*")
    }


@pytest.fixture
def refused(desk: Path, capsys: pytest.CaptureFixture[str]) -> Run:
    """Runs a command that must be refused; gives the lines it says."""

    def run(*arguments: str) -> list[str]:
        before = listing(desk)
        assert cli.main(arguments) == 2
        said = capsys.readouterr()
        assert listing(desk) == before
        assert said.out == ""
        lines = said.err.splitlines()
        for line in lines:
            assert line.startswith("nacreous: ")
            assert len(line) < 400
            for jargon in ("pydantic", "Traceback", "Error", "http", "validation", "NoneType"):
                assert jargon not in line
        return [line.removeprefix("nacreous: ") for line in lines]

    return run


FILES = {
    "unknown.toml": ["unknown.toml: nacre.protien_nm is not a key here; did you mean protein_nm?"],
    "type.toml": [
        'type.toml: depth is "deep"; wanted: a number; allowed: 0 to 1',
        "type.toml: grain is true; wanted: a number; allowed: 0 to 1",
    ],
    "negative.toml": ["negative.toml: nacre.thickness_nm.1 is -410; allowed: 1 to 5000 numbers, "],
    "nan.toml": ["nan.toml: diameter_mm is nan; allowed: 1 to 30 mm"],
    "none.toml": ["none.toml: nacre.thickness_nm is []; allowed: 1 to 5000 numbers, "],
    "winter.toml": ["winter.toml: nacre.layers_winter is 1000000000.0; allowed: 0 to 20 "],
    "many.toml": ["many.toml: nacre.thickness_nm is a list of 5001; allowed: 1 to 5000 numbers"],
    "decades.toml": ["the stack has 1"],
    "long.toml": ["long.toml: is longer than 1000000 bytes, the most that is read"],
    "empty.toml": ["empty.toml: the file is empty; wanted: at least one key, such as name"],
    "syntax.toml": ["syntax.toml: line 1, column 9: not TOML: "],
    "binary.toml": ["binary.toml: is a binary file; wanted: a TOML file"],
    "scene.toml": ["scene.toml: is a scene file; wanted: a pearl file"],
    "no.toml": ["no.toml: does not exist"],
    "folder.png": ["folder.png: is a folder; wanted: a TOML file"],
}


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("command", ["render", "grow"])
def test_a_bad_pearl_file_is_refused(refused: Run, command: str, name: str) -> None:
    lines = refused(command, name)
    assert len(lines) == len(FILES[name])
    for line, expected in zip(lines, FILES[name], strict=True):
        assert line.startswith(expected)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("picture.toml", "text.png: is not a picture that can be read here; allowed: PNG, "),
        ("hollow.toml", "hollow.png: is empty (0 bytes)"),
        ("huge.toml", "huge.png: is 20000 x 20000 pixels; allowed: 1 to 16384 a side"),
        ("folder.toml", "folder.png: is a directory; a picture file is needed"),
        ("gone.toml", "gone.png: does not exist"),
        ("absorbing.toml", "absorbing.toml: nacre.aragonite is [1.53, 0.1] while model is "),
    ],
)
def test_a_pearl_with_a_bad_picture_is_refused(refused: Run, name: str, expected: str) -> None:
    (line,) = refused("render", name, "--size", "8", "--samples", "1")
    assert line.startswith(expected)


@pytest.mark.parametrize(
    ("settings", "expected"),
    [
        (["nacre.layers_summer=1e9"], "--set: nacre.layers_summer is 1000000000.0; allowed: 0 to"),
        (["depth=2"], "--set: depth is 2; allowed: 0 to 1"),
        (["depth"], '--set "depth": wanted: key=value, such as nacre.seed=9'),
        (["=2"], '--set "=2": wanted: key=value'),
        (["nacre..seed=2"], '--set "nacre..seed": a part of the key is empty'),
        (["depht=1"], "--set: depht is not a key here; did you mean depth?"),
        (["camra.elevation_deg=3"], "--set: camra is not a key here; did you mean camera?"),
        (["camera.elevaton_deg=3"], "--set: camera.elevaton_deg is not a key here; did you mean"),
        (["lamps.3.intensity=1"], '--set "lamps.3.intensity": lamps is a list; allowed: lamps.0'),
        (["lamps.0.spectrum=lamp.csv"], "lamp.csv"),
        (["lamps.0.spectrum=gone.csv"], "gone.csv: does not exist"),
        (["sky.kind=panorama"], 'preset paper: sky.path is missing while sky.kind is "panorama"'),
        (["sky.kind=panorama", "sky.path=ground.exr"], "ground.exr: is not "),
        (["sky.kind=panorama", "sky.path=gone.hdr"], "gone.hdr: does not exist"),
        (["nacre.protein=0.5"], "protein has n = 0.5; allowed: at least the ambient's 1, "),
    ],
    ids=lambda case: str(case)[:40],
)
def test_a_bad_setting_is_refused(refused: Run, settings: list[str], expected: str) -> None:
    options = [word for setting in settings for word in ("--set", setting)]
    (line,) = refused("render", "paper", "--size", "8", "--samples", "1", *options)
    assert line.startswith(expected)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["--size", "0"], "size is 0; allowed: a whole number from 1 to 8192"),
        (["--size", "-1"], "size is -1; allowed: a whole number from 1 to 8192"),
        (["--size", "8193"], "size is 8193; allowed: a whole number from 1 to 8192"),
        (["--size", "1000000000"], "size is 1000000000; allowed: a whole number from 1 to 8192"),
        (["--size", "big"], "argument --size: 'big' is not a whole number"),
        (["--size", "1e3"], "argument --size: '1e3' is not a whole number"),
        (["--samples", "0"], "samples is 0; allowed: a square number from 1 to 1024"),
        (["--samples", "10"], "samples is 10; allowed: a square number from 1 to 1024"),
        (["--samples", "1.5"], "argument --samples: '1.5' is not a whole number"),
        (["--bits", "12"], "--bits is 12; allowed: 8, 16"),
        (["--space", "adobe"], "--space is 'adobe'; allowed: "),
        (["--scene", "boot"], '"boot" is neither a file nor a scene preset; did you mean booth?'),
        (["--scene", "unknown.toml"], "unknown.toml: is a pearl file; wanted: a scene file"),
        (["-o", "pearl.gif"], "pearl.gif: the ending is .gif; allowed: .png, .exr"),
        (["-o", "pearl"], "pearl: the ending is missing; allowed: .png, .exr"),
        (["-o", "folder.png"], "folder.png: is a folder; allowed: a file in it, by its name"),
        (["-o", "gone/pearl.png"], "gone/pearl.png: the folder "),
        (["-o", "text.png/pearl.png"], "text.png/pearl.png: "),
        (["-o", "/proc/pearl.png"], "/proc/pearl.png: cannot be written ("),
        (["-o", "full.png"], "full.png: is not an ordinary file, and cannot be replaced by one"),
        (["-o", "\0.png"], r"path is '\x00.png'; allowed: the path of a file"),
        (["-o", "x" * 270 + ".png"], "xxx"),
    ],
    ids=lambda case: ascii(case)[:30],
)
def test_a_bad_option_of_render_is_refused(
    refused: Run, arguments: list[str], expected: str
) -> None:
    lines = refused("render", "paper", *arguments)
    (line,) = lines
    assert line.startswith(expected)
    assert line.endswith("; try: nacreous render --help") == expected.startswith("argument ")


def test_the_output_is_tried_before_the_long_work(
    refused: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("nacreous.image.render", lambda *_: pytest.fail("rendered already"))
    monkeypatch.setattr("nacreous.nacre.diary", lambda *_: pytest.fail("grew already"))
    assert refused("render", "paper", "-o", "gone/pearl.png")
    assert refused("grow", "paper", "-o", "gone/growth.png")


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["papre"], '"papre" is neither a file nor a nacre or pearl preset; did you mean paper?'),
        (["akoia"], '"akoia" is neither a file nor a nacre or pearl preset; did you mean akoya'),
        (["paper", "--set", "harvst=08-15"], "--set: nacre.harvst is not a key here; did you mean"),
        (
            ["paper", "--set", "nacre.harvst=1"],
            "--set: nacre.harvst is not a key here; did you mea",
        ),
        (
            ["paper", "--set", "seed=-1"],
            "--set: nacre.seed is -1; allowed: 0 to 922337203685477580",
        ),
        (["paper", "--set", "harvest=02-30"], '--set: nacre.harvest is "02-30"; allowed: "MM-DD"'),
        (["paper", "--set", "thickness_winter_nm=-1"], "--set: nacre.thickness_winter_nm is -1; "),
        (
            ["paper", "--set=layers_summer=0", "--set=layers_winter=0", "--set=layers_noise=0"],
            "--set: nacre.layers_summer is 0, and so are ",
        ),
        (
            ["paper", "--set=layers_summer=0.1", "--set=layers_winter=0.1", "--set=layers_noise=0"],
            "the stack has 0 layers; allowed: 1 to 5000",
        ),
        (["listed.toml"], "listed.toml: lists its layers in nacre.thickness_nm; wanted: "),
        (
            ["paper", "-o", "growth.gif"],
            "growth.gif: the ending is .gif; allowed: .png, .svg, .pdf",
        ),
        (["paper", "-o", "gone/a.csv"], "gone/a.csv: the folder "),
    ],
    ids=lambda case: str(case)[:40],
)
def test_grow_refuses_what_cannot_grow(refused: Run, arguments: list[str], expected: str) -> None:
    (line,) = refused("grow", *arguments)
    assert line.startswith(expected)


def test_all_problems_of_a_file_arrive_together(refused: Run, desk: Path) -> None:
    (desk / "three.toml").write_text('depht = 1\nmodel = "x"\n[surface]\nfalloff_mm = 0\n')
    assert len(refused("render", "three.toml")) == 3


def test_an_old_picture_survives_a_refusal(refused: Run, desk: Path) -> None:
    (desk / "pearl.png").write_text("the old picture")
    refused("render", "nan.toml", "-o", "pearl.png")
    refused("render", "huge.toml", "-o", "pearl.png")
    assert (desk / "pearl.png").read_text() == "the old picture"


@pytest.mark.parametrize("command", [["render"], ["card"], ["turn"], ["grow"]])
def test_a_key_that_is_set_twice_is_refused(
    command: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["akoya-rg", "--set", "nacre.seed=1", "--set", "nacre.seed=2"]
    assert cli.main([*command, *words]) == 2
    said = '--set "nacre.seed=2": sets nacre.seed, as "nacre.seed=1" does; allowed: once'
    assert said in capsys.readouterr().err


def test_a_link_that_leads_nowhere_is_called_so(tmp_path: Path) -> None:
    for name in ("lot.csv", "pearl.toml", "panorama.hdr"):
        (tmp_path / name).symlink_to("nowhere")
    for read, name in (
        (read_lot, "lot.csv"),
        (nc.Pearl.load, "pearl.toml"),
        (read_panorama, "panorama.hdr"),
    ):
        with pytest.raises(nc.InputError, match="is a link that leads nowhere, to nowhere"):
            read(tmp_path / name)


@pytest.mark.parametrize("command", ["render", "card", "turn"])
def test_a_key_that_a_word_sets_is_told_by_the_word(command, tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main([command, "paper", "--word", "shape=drop", "--set", "grain=7"]) == 2
    *words, sets = capsys.readouterr().err.splitlines()
    assert all('--word "shape=drop": shape.' in line for line in words)
    assert "--set: grain is 7; allowed" in sets

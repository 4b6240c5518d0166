"""Frames of a turn, and the folder or the file that keeps them."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image as Pillow

import nacreous as nc
from nacreous.cli import main
from nacreous.spec import Camera, Coat, Lamp, Layers, Pearl, Pose, Scene, Sky, Table, Window
from nacreous.turn import motion, moving
from tests.support.terminal import at_terminal

#: Unlike from side to side, and quick to render.
PATCHED = Pearl(
    name="patched",
    nacre=Layers(thickness_nm=[380.0 + 9.0 * (layer % 7) for layer in range(24)]),
    coat=Coat(seed=2, thickness_spread=0.08, hammering_rad=0.1),
)
ROOM = Scene(
    name="room",
    lamps=[Lamp(azimuth_deg=20, elevation_deg=40)],
    windows=[Window(position_mm=(300, 200, 100), facing=(-3, -2, -2))],
    table=Table(kind="none"),
    sky=Sky(intensity=0.3),
)
SMALL = {"size": 16, "samples": 1}


def posed(angle_deg: float) -> Pearl:
    return PATCHED.replace(pose=Pose(turn_deg=angle_deg))


def viewed(angle_deg: float) -> Scene:
    return ROOM.replace(camera=Camera(azimuth_deg=angle_deg))


def lit(angle_deg: float) -> Scene:
    return ROOM.replace(
        lamps=[Lamp(azimuth_deg=20 + angle_deg, elevation_deg=40)],
        windows=[
            Window(
                position_mm=motion._rotated((300, 200, 100), angle_deg),
                facing=motion._rotated((-3, -2, -2), angle_deg),
            )
        ],
    )


@pytest.mark.parametrize(
    ("what", "stage"),
    [
        ("pearl", lambda angle_deg: (posed(angle_deg), ROOM)),
        ("camera", lambda angle_deg: (PATCHED, viewed(angle_deg))),
        ("lamp", lambda angle_deg: (PATCHED, lit(angle_deg))),
    ],
)
def test_each_frame_is_the_picture_of_its_angle_to_the_byte(
    what: str, stage: Callable[[float], tuple[Pearl, Scene]]
) -> None:
    shown = list(nc.turn.frames(PATCHED, ROOM, 3, what, **SMALL))
    assert shown == [nc.render(*stage(angle), **SMALL) for angle in (0.0, 120.0, 240.0)]
    assert not np.array_equal(shown[0].linear, shown[1].linear)


@pytest.mark.parametrize("what", motion.WHATS)
def test_a_full_turn_returns_to_the_first_frame(what: str) -> None:
    assert motion.turned(what, PATCHED, ROOM, 360.0) == motion.turned(what, PATCHED, ROOM, 0.0)


def test_pearl_lights_and_camera_go_round_the_same_way() -> None:
    """All three together leave the picture as it was."""
    pearl, scene = PATCHED, ROOM
    for what in motion.WHATS:
        pearl, scene = motion.turned(what, pearl, scene, 130.0)
    found = nc.render(pearl, scene, 24, 4).linear
    np.testing.assert_allclose(found, nc.render(PATCHED, ROOM, 24, 4).linear, rtol=0, atol=2e-3)


def test_part_of_a_turn_ends_where_it_was_told_to() -> None:
    texts = [
        image.recipe["pearl"] for image in nc.turn.frames(PATCHED, ROOM, 3, degrees=-90, **SMALL)
    ]
    assert [
        f"turn_deg = {angle}" in text
        for angle, text in zip((0.0, -45.0, -90.0), texts, strict=True)
    ] == [True] * 3


def test_a_lost_or_damaged_frame_alone_is_rendered_again(tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert nc.turn.save(out, PATCHED, ROOM, 3, **SMALL) == 3
    files = {path.name: path.read_bytes() for path in out.iterdir()}
    assert sorted(files) == ["frame-000.png", "frame-001.png", "frame-002.png", "turn.json"]
    (out / "frame-001.png").unlink()
    (out / "frame-002.png").write_bytes(files["frame-002.png"][:-20])
    assert nc.turn.save(out, PATCHED, ROOM, 3, **SMALL) == 2
    assert {path.name: path.read_bytes() for path in out.iterdir()} == files
    assert nc.turn.save(out, PATCHED, ROOM, 3, fps=12, **SMALL) == 0
    assert json.loads((out / "turn.json").read_text())["fps"] == 12


def test_a_frame_carries_what_makes_it_again(tmp_path: Path) -> None:
    nc.turn.save(tmp_path / "out", PATCHED, ROOM, 2, **SMALL)
    again = tmp_path / "again.png"
    frame = tmp_path / "out" / "frame-001.png"
    assert main(["render", str(frame), "-o", str(again)]) == 0
    assert again.read_bytes() == frame.read_bytes()


def test_frames_of_another_turn_and_files_of_others_are_left_alone(tmp_path: Path) -> None:
    out = tmp_path / "out"
    nc.turn.save(out, PATCHED, ROOM, 2, **SMALL)
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    for count, pearl in ((3, PATCHED), (2, PATCHED.replace(depth=0.1))):
        with pytest.raises(
            nc.InputError, match=r"frames of another turn \(pearl patched, scene room"
        ):
            nc.turn.save(out, pearl, ROOM, count, **SMALL)
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before
    (out / "turn.json").unlink()
    with pytest.raises(nc.InputError, match=r"holds 'frame-000\.png' and no turn\.json"):
        nc.turn.save(out, PATCHED, ROOM, 2, **SMALL)


@pytest.mark.parametrize("ending", [".png", ".gif", ".webp"])
def test_a_file_that_moves_has_all_frames_and_lasts_as_long(ending: str, tmp_path: Path) -> None:
    place = tmp_path / f"turn{ending}"
    assert nc.turn.save(place, PATCHED, ROOM, 3, fps=5, **SMALL) == 3
    with Pillow.open(place) as moving_picture:
        lasted = []
        for number in range(moving_picture.n_frames):
            moving_picture.seek(number)
            moving_picture.load()
            lasted.append(moving_picture.info["duration"])
    assert lasted == [200, 200, 200]


def test_an_animated_png_shows_the_codes_of_its_frames_and_carries_the_firsts_recipe(
    tmp_path: Path,
) -> None:
    place = tmp_path / "turn.png"
    nc.turn.save(place, PATCHED, ROOM, 3, **SMALL)
    codes = [image.develop()[0] for image in nc.turn.frames(PATCHED, ROOM, 3, **SMALL)]
    with Pillow.open(place) as moving_picture:
        for number, wanted in enumerate(codes):
            moving_picture.seek(number)
            assert np.array_equal(np.asarray(moving_picture.convert("RGB")), wanted)
    assert main(["render", str(place), "-o", str(tmp_path / "first.png")]) == 0
    with Pillow.open(tmp_path / "first.png") as first:
        assert np.array_equal(np.asarray(first), codes[0])


@pytest.mark.parametrize("ending", [".mp4", ".webm"])
def test_a_video_has_all_frames_in_their_colours(ending: str, tmp_path: Path) -> None:
    try:
        import av
    except ImportError:
        pytest.skip("no PyAV here:   pip install 'nacreous[video]'")
    place = tmp_path / f"turn{ending}"
    nc.turn.save(place, PATCHED, ROOM, 3, fps=5, size=64, samples=1)
    wanted = [image.develop()[0] for image in nc.turn.frames(PATCHED, ROOM, 3, size=64, samples=1)]
    with av.open(str(place)) as container:
        found = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
    assert len(found) == 3
    for shown, codes in zip(found, wanted, strict=True):
        off = np.abs(shown.astype(float) - codes).mean((0, 1))
        assert off.max() < 3, off


def test_video_without_its_encoder_and_of_odd_size_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(nc.InputError, match=r"not installed:   pip install 'nacreous\[video\]'"):
        moving.check_place(tmp_path / "a.mp4", 64, 2, 24)
    with pytest.raises(nc.InputError, match=r"size is 65; allowed for \.mp4: an even number"):
        moving.check_place(tmp_path / "a.mp4", 65, 2, 24)
    monkeypatch.setitem(sys.modules, "av", SimpleNamespace(codecs_available={"libvpx-vp9"}))
    with pytest.raises(nc.InputError, match=r"the PyAV here has no libx264; allowed without it"):
        moving.check_place(tmp_path / "a.mp4", 64, 2, 24)


def test_what_no_browser_plays_and_no_memory_holds_is_refused(tmp_path: Path) -> None:
    for name, arguments, told in (
        ("a.gif", {"fps": 51}, "fps is 51; allowed for .gif: 1 to 50"),
        ("a.webp", {"fps": 61}, "fps is 61; allowed: a whole number, 1 to 60"),
        ("a.png", {"count": 16, "size": 8192}, "16 frames of 8192 x 8192 are 1074 megapixels"),
    ):
        with pytest.raises(nc.InputError) as caught:
            nc.turn.save(tmp_path / name, PATCHED, ROOM, **arguments)  # type: ignore[arg-type]
        assert told in str(caught.value)
    assert not list(tmp_path.iterdir())


def test_a_pillow_without_webp_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("PIL.features.check", lambda feature: False)
    with pytest.raises(nc.InputError, match=r"writes no WebP; allowed: \.png or \.gif"):
        moving.check_place(tmp_path / "a.webp", 16, 2, 24)


NO_LIGHT = Scene(name="dark")
LIT_FROM_BELOW = Scene(name="plate", windows=[Window(below_mm=1)], table=Table(kind="none"))


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"pearl": "paper"}, 'model = "illuminant", which knows no [pose]; allowed: a pearl of'),
        ({"what": "lamp", "scene": NO_LIGHT}, "has no lamp or window that could go round"),
        ({"what": "lamp", "scene": LIT_FROM_BELOW}, "other than flat below or straight above it"),
        ({"what": "table"}, 'what is "table"; allowed: pearl, lamp, camera'),
        ({"count": 1}, "frames is 1; allowed: a whole number, 2 to 2000"),
        ({"degrees": 0}, "degrees is 0; allowed: -3600 to 3600, and not 0"),
        ({"degrees": float("nan")}, "degrees is nan"),
        ({"pearl": 7}, "pearl is 7; allowed: a pearl, a file or a preset's name"),
        ({"size": 0}, "size is 0; allowed"),
    ],
)
def test_what_cannot_go_round_is_refused_before_the_first_frame(
    arguments: dict[str, object], told: str
) -> None:
    with pytest.raises(nc.InputError) as caught:
        nc.turn.frames(**{"pearl": PATCHED, "scene": ROOM, **arguments})  # type: ignore[arg-type]
    assert told in str(caught.value)


@pytest.mark.parametrize(
    ("output", "told"),
    [
        ("a.avi", "the ending is .avi; allowed: .png, .gif, .webp, .mp4, .webm, or none"),
        ("no/a.webp", "does not exist"),
        ("no/out", "does not exist"),
        ("file", "is a file; wanted: a folder"),
        ("-", "allowed: a file or a folder"),
    ],
)
def test_a_place_that_cannot_be_is_refused_and_nothing_is_left(
    output: str,
    told: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("file").touch()
    assert main(["turn", "tahitian", "--size", "8", "-o", output]) == 2
    assert told in capsys.readouterr().err
    assert main(["turn", "tahitian", "--size", "8", "--samples", "3", "-o", "out"]) == 2
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_samples_that_are_no_square_are_refused_before_the_first_frame() -> None:
    with pytest.raises(nc.InputError, match="samples is 3; allowed: a square number"):
        nc.turn.frames("tahitian", count=2, size=8, samples=3)


def test_a_pearl_alike_from_all_sides_is_noted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "turn.png"
    words = ["turn", "akoya-rg", "--size", "8", "--samples", "1", "--frames", "2", "-o", str(place)]
    assert main([*words, "--set", "grain=0"]) == 0
    told = capsys.readouterr().out
    assert "turn.png: 2 frames of pearl akoya-rg in scene paper, pearl by 360 degrees" in told
    assert "note: pearl akoya-rg has no grain, coat or blemishes" in told
    for more in (["--set", "coat.terrace_um=300"], ["--what", "camera"]):
        assert main([*words, "--set", "grain=0", *more]) == 0
        assert "note" not in capsys.readouterr().out


@pytest.mark.parametrize("output", ["turn.webp", "out"])
def test_ctrl_c_keeps_finished_frames_of_a_folder_and_nothing_of_a_file(
    output: str, tmp_path: Path
) -> None:
    command = [sys.executable, "-m", "nacreous", "turn", "tahitian", "--size", "64"]
    with at_terminal([*command, "--frames", "60", "-o", output], tmp_path) as watched:
        watched.shows(b"turning [")
        watched.shows(b"turning [")  # a frame takes a part of a second
        while output == "out" and not (tmp_path / "out" / "frame-000.png").exists():
            watched.shows(b"turning [")
        code, _ = watched.interrupted()
        assert code == 130
        if output == "out":
            watched.shows(b"frames are in out; the same call goes on")
    left = sorted(path.name for path in tmp_path.rglob("*") if path.is_file())
    assert left == ([*left[:-1], "turn.json"] if output == "out" else [])
    assert all(name.startswith("frame-") for name in left[:-1])


def test_frames_of_several_different_pearls_are_kept_too(tmp_path: Path) -> None:
    tray = ROOM.replace(rows=[{"pearls": ["*", "akoya-rg-0.0"]}])
    how = {"count": 2, "degrees": 90.0, "size": 16, "samples": 1}
    nc.turn.save(tmp_path / "out", PATCHED, tray, **how)
    before = {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()}
    nc.turn.save(tmp_path / "out", PATCHED, tray, **how)
    assert {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()} == before


def test_more_than_fits_is_refused_before_any_frame_is_laid_out(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def never(*_: object) -> None:
        raise AssertionError

    monkeypatch.setattr("nacreous.turn.plan.plan", never)
    words = ["turn", "akoya-rg", "--size", "8192", "--frames", "2000", "-o", "t.webp"]
    assert main(words) == 2
    assert "allowed for .webp: 1000" in capsys.readouterr().err

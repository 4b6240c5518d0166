"""Same spec, same bytes; and every picture file says how to make it again."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import pytest
from PIL import Image as Pillow

import nacreous as nc
from nacreous import cli
from nacreous.embedded import read_embedded
from nacreous.spec import (
    Growth,
    Lamp,
    Pearl,
    Scene,
    Walls,
)
from tests.picture.stage import (
    LEFT,
    SUM,
    pearl,
    refusal,
)


def test_same_spec_same_bytes_on_one_core_or_many(tmp_path: Path) -> None:
    program = (
        "import sys, nacreous as nc; image = nc.render('paper', size=40, samples=4);"
        "[image.save(sys.argv[1] + ending) for ending in ('.png', '.exr')]"
    )
    for threads in ("1", "3"):
        environment = os.environ | {"RAYON_NUM_THREADS": threads}
        command = [sys.executable, "-c", program, str(tmp_path / threads)]
        subprocess.run(command, check=True, env=environment)
    for ending in (".png", ".exr"):
        assert (tmp_path / f"1{ending}").read_bytes() == (tmp_path / f"3{ending}").read_bytes()


def recipe_in(path: Path) -> dict[str, str]:
    if path.suffix == ".png":
        texts = nc.file.read_png_text(path)
    else:
        with OpenEXR.File(str(path)) as file:
            texts = dict(file.header())
    marked = {key: text for key, text in texts.items() if key.startswith("nacreous:")}
    return {key.partition(":")[2]: text for key, text in marked.items()}


@pytest.mark.parametrize("ending", [".png", ".exr"])
def test_the_recipe_in_the_file_makes_the_same_bytes_again(tmp_path: Path, ending: str) -> None:
    subject = pearl(name='真珠 \\ "1"', depth=0.73, grain=0.2, nacre=Growth(seed=5))
    scene = Scene(lamps=[LEFT, Lamp(position_mm=(1, 30, 0))], walls=Walls(colour="#102030"))
    first, again = tmp_path / f"first{ending}", tmp_path / f"again{ending}"
    nc.render(subject, scene, 20, 4).save(first)
    recipe = recipe_in(first)
    settings_ = json.loads(recipe["settings"])
    made = nc.render(
        Pearl.from_toml(recipe["pearl"]),
        Scene.from_toml(recipe["scene"]),
        settings_["size"],
        settings_["samples"],
    )
    made.save(again)
    assert first.read_bytes() == again.read_bytes()
    assert settings_["seed"] == 5
    assert json.loads(recipe["versions"])["nacreous"] == nc.__version__


def test_exr_holds_the_linear_picture_and_all_its_layers(tmp_path: Path) -> None:
    image = nc.render(pearl(), "paper", 20, 4)
    assert image.save(tmp_path / "a.exr") == 0
    with OpenEXR.File(str(tmp_path / "a.exr"), separate_channels=True) as file:
        channels = {name: channel.pixels for name, channel in file.channels().items()}
    for index, letter in enumerate("RGB"):
        np.testing.assert_array_equal(channels[letter], image.linear[..., index])
        for name in SUM:
            np.testing.assert_array_equal(
                channels[f"{name}.{letter}"], image.layers[name][..., index]
            )


def test_8_and_16_bits_are_one_picture(tmp_path: Path) -> None:
    image = nc.render(pearl(), "paper", 48, 4)
    coarse, fine = image.develop(bits=8)[0], image.develop(bits=16)[0]
    assert coarse.dtype == np.uint8
    assert fine.dtype == np.uint16
    assert np.abs(coarse * 257.0 - fine).max() <= 128
    image.save(tmp_path / "a.png")
    with Pillow.open(tmp_path / "a.png") as written:
        np.testing.assert_array_equal(np.asarray(written), coarse)


def test_fewer_colours_are_out_of_gamut_in_display_p3(tmp_path: Path) -> None:
    ramp = np.linspace(0, 1, 32, dtype=np.float32)
    red, green, blue = np.meshgrid(ramp, ramp, ramp[::8] - np.float32(0.02))
    image = nc.Image(np.stack([red, green, blue], axis=-1).reshape(32, -1, 3), {})
    shares = {
        space: image.save(tmp_path / "a.png", space=space) for space in ("srgb", "display-p3")
    }
    assert 0 < shares["display-p3"] < shares["srgb"] < 1
    inside = nc.Image(np.full((4, 4, 3), 0.5, np.float32), {})
    assert inside.develop()[1] == 0


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"bits": 7}, "bits is 7; allowed: 8, 16"),
        ({"bits": -1}, "bits is -1; allowed: 8, 16"),
        ({"bits": "8"}, "bits is '8'; allowed: 8, 16"),
        ({"space": "adobe"}, 'RGB space is "adobe"; allowed: srgb, display-p3'),
        ({"gamut": None}, 'gamut is "None"; allowed: clip, soft'),
        ({"path": "a.gif"}, "a.gif: the ending is .gif; allowed: .png, .exr"),
        ({"path": "no/a.png"}, "no/a.png: the folder "),
    ],
    ids=str,
)
def test_save_says_what_is_wrong_and_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, given: dict[str, Any], message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    image = nc.Image(np.zeros((2, 2, 3), np.float32), {})
    assert refusal(lambda: image.save(**{"path": "a.png", **given})).startswith(message)
    assert not list(tmp_path.iterdir())


def test_a_picture_with_a_hole_is_not_developed() -> None:
    hole = np.full((2, 2, 3), np.nan, np.float32)
    assert refusal(nc.Image(hole, {}).develop) == "linear has a value that is not finite"


def test_a_picture_made_by_hand_is_converted_or_refused() -> None:
    made = nc.Image([[[0.5, 0.5, 0.5]]], {"mask": np.ones((1, 1, 1))})
    assert made.linear.dtype == made.layers["mask"].dtype == np.float32
    light = np.zeros((2, 2, 3))
    for given, message in (
        ((np.zeros((2, 2)), {}), "linear has the shape (2, 2); allowed: [row, column, 3]"),
        (("pearl", {}), "linear is 'pearl'; allowed: numbers"),
        ((light, {"mask": np.zeros((3, 2, 1))}), "layer 'mask' has the shape (3, 2, 1)"),
        ((light, [light]), "layers are "),
        ((light, {}, {"x": 5}), "recipe has 5 for 'x'; allowed: texts"),
        ((np.full((2, 2, 3), 20, np.uint8), {}), "linear holds whole numbers up to 20, as codes"),
    ):
        assert refusal(lambda given=given: nc.Image(*given)).startswith(message)
    assert refusal(lambda: made.develop(bits=8.0)) == "bits is 8.0; allowed: 8, 16"
    assert made.develop(bits=np.int64(16))[0].dtype == np.uint16


def test_what_means_nothing_is_refused_and_not_passed_over(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    image = nc.render("paper", size=4, samples=1)
    message = refusal(lambda: image.save(tmp_path / "k.exr", gamut="x"))
    assert message == 'gamut is "x"; allowed: clip, soft'
    for name, word in (("bits", 16), ("space", "display-p3"), ("gamut", "clip")):
        message = refusal(
            lambda name=name, word=word: image.save(tmp_path / "k.exr", **{name: word})
        )
        assert message.startswith(f"{name} is ")
    assert cli.main(["render", "paper", "-o", str(tmp_path / "p.exr"), "--bits", "16"]) == 2
    assert "--bits is given for" in capsys.readouterr().err
    masked = np.ma.masked_array([400.0, 500.0], [True, False])
    assert "has masked values" in refusal(lambda: nc.LayerStack(masked))
    message = refusal(lambda: nc.nacre.diary("paper"))  # type: ignore[arg-type]
    assert message.startswith("growth is 'paper'")


def test_a_picture_of_no_place_names_its_files_absolutely_and_makes_itself_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of a notebook, or through a pipe."""
    (tmp_path / "lamp.csv").write_text("380,1\n780,2\n", "utf-8")
    lamp = '[[lamps]]\nposition_mm = [0, 200, 200]\nspectrum = "lamp.csv"\n'
    (tmp_path / "scene.toml").write_text(lamp, "utf-8")
    monkeypatch.chdir(tmp_path)
    image = nc.render("paper", "scene.toml", 8, 4)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    piped = io.BytesIO()
    image.save(piped, bits=16)
    for name, made in (("shown.png", image._repr_png_()), ("piped.png", piped.getvalue())):
        (elsewhere / name).write_bytes(made)
        monkeypatch.chdir("/")
        kept = read_embedded(elsewhere / name)
        again = nc.render(kept.pearls, kept.scene, kept.size, kept.samples)
        assert (again.linear == image.linear).all()

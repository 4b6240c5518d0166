"""Alpha and shadow: pearls cut out, and laid on another ground."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import pytest
from numpy.lib.stride_tricks import sliding_window_view
from PIL import Image as Pillow

import nacreous as nc
from nacreous.spec import Camera, Scene, Sky, Table, Window
from tests.picture.stage import BLACK, LEFT, NO_TABLE, pearl, refusal


def channels(path: Path) -> dict[str, np.ndarray]:
    with OpenEXR.File(str(path), separate_channels=True) as file:
        return {name: channel.pixels for name, channel in file.channels().items()}


def test_an_exr_has_alpha_one_and_cut_out_the_coverage(tmp_path: Path) -> None:
    image = nc.render("akoya-rg", "north-window-black", 24, 4)
    copy = nc.Image(image.linear, image.layers)
    for number, picture in enumerate((image, copy)):
        picture.save(tmp_path / f"{number}.exr")
        picture.save(tmp_path / f"{number}-alpha.exr", alpha=True)
        whole, alone = (channels(tmp_path / f"{number}{end}.exr") for end in ("", "-alpha"))
        assert np.all(whole["A"] == 1)
        np.testing.assert_array_equal(whole["R"], image.linear[..., 0])
        np.testing.assert_array_equal(alone["A"], image.layers["coverage"][..., 0])
        np.testing.assert_array_equal(alone["shadow.Y"], image.layers["shadow"][..., 0])


def test_pearls_cut_out_and_laid_on_their_own_ground_are_the_picture() -> None:
    """Over: light that is multiplied by alpha, plus what the ground sends past it."""
    for scene in ("paper", "north-window-white", "two-tier"):
        image = nc.render("akoya-rg", scene, 48, 16)
        alone = sum(image.layers[name] for name in ("interference", "diffuse", "mirror"))
        np.testing.assert_allclose(image.linear - image.layers["surroundings"], alone, atol=1e-6)


def test_a_png_cut_out_shows_the_same_codes_where_the_pearl_fills_the_pixel(tmp_path: Path) -> None:
    image = nc.render("akoya-rg", "booth", 48, 4)
    image.save(tmp_path / "whole.png")
    image.save(tmp_path / "alone.png", alpha=True)
    with Pillow.open(tmp_path / "whole.png") as whole, Pillow.open(tmp_path / "alone.png") as alone:
        assert (whole.mode, alone.mode) == ("RGB", "RGBA")
        rgb, rgba = np.asarray(whole), np.asarray(alone)
    cover = image.layers["coverage"][..., 0]
    np.testing.assert_array_equal(rgba[..., 3], np.rint(255 * cover))
    np.testing.assert_array_equal(rgba[cover == 1][:, :3], rgb[cover == 1])
    rim = (cover > 0.3) & (cover < 1)
    assert np.ptp(rgba[rim][:, :3].astype(int).max(axis=1)) < 200  # of the pearl, not of black
    for bits in (8, 16):
        codes, _ = image.develop(bits, alpha=True)
        assert codes[..., 3].max() == 2**bits - 1


def test_a_picture_without_layers_has_nothing_to_cut_out() -> None:
    bare = nc.Image(np.zeros((2, 2, 3), np.float32), {})
    assert "no layer interference" in refusal(lambda: bare.develop(alpha=True))


@pytest.mark.parametrize(
    "light",
    [
        {"lamps": [LEFT], "sky": BLACK},
        {"sky": Sky(intensity=1.0)},
        {"windows": [Window(azimuth_deg=-60, elevation_deg=40, width_mm=400, height_mm=400)]},
    ],
    ids=["lamp", "sky", "window"],
)
def test_the_shadow_is_what_the_table_lacks_beside_the_pearl(light: dict) -> None:
    """The table as it is, over the same table with a pearl too small to take any light."""
    camera = Camera(elevation_deg=60, field_mm=24.0)
    scene = Scene(table=Table(kind="plain", colour="#808080"), camera=camera, **light)
    image = nc.render(pearl(diameter_mm=8), scene, 48, 1)
    ground = image.layers["surroundings"].astype(float) @ [0.2126, 0.7152, 0.0722]
    away = nc.render(pearl(diameter_mm=1), scene, 48, 1).layers["surroundings"].astype(float)
    bare = np.median((away @ [0.2126, 0.7152, 0.0722])[:6])
    shadow = image.layers["shadow"][..., 0]
    # Beside the pearl a pixel shows the mean of what it does not cover, the shadow its middle.
    beside = np.pad(image.layers["coverage"][..., 0], 2)
    seen = sliding_window_view(beside, (5, 5)).max(axis=(2, 3)) == 0
    np.testing.assert_allclose(1 - ground[seen] / bare, shadow[seen], atol=0.03)
    assert shadow.max() > 0.5
    assert shadow.min() >= 0
    assert shadow.max() <= 1


def test_where_there_is_no_table_there_is_no_shadow() -> None:
    image = nc.render(pearl(), Scene(lamps=[LEFT], table=NO_TABLE), 24, 1)
    assert not image.layers["shadow"].any()


def test_an_image_shows_itself_in_a_notebook() -> None:
    image = nc.render("paper", size=24, samples=1)
    with Pillow.open(io.BytesIO(image._repr_png_())) as shown:
        np.testing.assert_array_equal(np.asarray(shown), image.develop()[0])
    assert repr(image) == "Image(24 x 24, paper)"


@pytest.mark.parametrize("alpha", ["no", "yes", 1, None])
def test_alpha_is_a_yes_or_no_and_no_word(tmp_path: Path, alpha: Any) -> None:
    image = nc.render("paper", size=8, samples=1)
    for act in (
        lambda: image.save(tmp_path / "a.png", alpha=alpha),
        lambda: image.save(io.BytesIO(), alpha=alpha),
        lambda: image.develop(alpha=alpha),
    ):
        with pytest.raises(nc.InputError, match=r"alpha is .*; allowed: True, False"):
            act()
    assert not list(tmp_path.iterdir())

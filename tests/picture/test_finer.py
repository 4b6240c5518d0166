"""A picture is the mean of a finer one, in every pixel: at rims, where mirrored light changes
without end within a pixel, at the edges of mirrored windows, and on a woven cloth.

A pixel's filter is a tent two pixels wide (docs/picture.md). A finer picture is laid under the same
filter: its pixels, tents themselves, get the weights that together make the wide tent. Without
grain, which is finer the finer the pixels are.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.spec import Pearl, Scene
from tests.picture.finer import differences, filtered, pair

BACKLIGHT = str(Path(__file__).with_name("backlight.toml"))
SCENES = [
    ("akoya-rg", BACKLIGHT, []),
    ("akoya-rg", BACKLIGHT, [("camera.projection", '"perspective"')]),
    ("paper", BACKLIGHT, []),
    ("paper", "paper", []),
    ("akoya-rg", "paper", []),
    ("paper", "aurora", []),
    ("akoya-rg", "north-window-white", []),
    ("akoya-rg", "north-window-black", []),
    ("tahitian", "north-window-black", []),
    ("south-sea-white", "booth", []),
    ("akoya-rg", "booth", []),
    ("akoya-pink", "aurora", []),
]
SIZE_PX = 64


@pytest.mark.parametrize(("name", "scene", "changes"), SCENES)
def test_every_pixel_is_that_of_a_finer_picture_under_the_same_filter(
    name: str, scene: str, changes: list[tuple[str, str]]
) -> None:
    pearl = Pearl.load(name, [("grain", "0")])
    coarse, mean = pair(pearl, Scene.load(scene, changes), SIZE_PX)
    seen, pearl_there = differences(coarse, mean)
    assert seen[pearl_there].max() < 0.02
    # The edge of a window that the camera sees itself.
    assert seen.max() < 0.025
    # What is brighter than white, a lamp's image 12 times so, by its own light.
    beyond = np.abs(coarse.linear - mean) / np.maximum(1.0, mean)
    assert beyond[1:-1, 1:-1].max() < 0.025


def test_a_finer_picture_covers_what_a_coarse_one_does() -> None:
    pearl, scene = Pearl.load("paper", [("grain", "0")]), Scene.load(BACKLIGHT)
    coarse, fine = (
        nc.render(pearl, scene, size).layers["coverage"].astype(float) for size in (24, 96)
    )
    assert np.abs(coarse - filtered(fine)).max() < 0.006

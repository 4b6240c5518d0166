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
from numpy.typing import NDArray

import nacreous as nc
from nacreous.spec import Pearl, Scene

Array = NDArray[np.float64]

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
FINER = 4


def weights() -> Array:
    """Of fine pixels under a coarse one: the least squares of its tent by a sum of theirs."""
    middle = (np.arange(2 * FINER) + 0.5) / FINER - 1.0
    x = np.linspace(-1.5, 1.5, 3001)
    fine = np.maximum(0.0, 1.0 - np.abs(x[:, np.newaxis] - middle) * FINER)
    coarse = np.maximum(0.0, 1.0 - np.abs(x))
    found: Array = np.linalg.lstsq(fine, coarse, rcond=None)[0]
    total: float = found.sum()
    return np.asarray(found / total, float)


def filtered(fine: Array) -> Array:
    """A picture FINER times as fine, under the filter of a coarse one."""
    for _ in range(2):
        rows = np.pad(fine, [(FINER // 2, FINER // 2), (0, 0), (0, 0)], mode="edge")
        taps = (weight * rows[i:][: fine.shape[0] : FINER] for i, weight in enumerate(weights()))
        fine = np.swapaxes(np.sum(list(taps), axis=0), 0, 1)
    return fine


@pytest.mark.parametrize(("name", "scene", "changes"), SCENES)
def test_every_pixel_is_that_of_a_finer_picture_under_the_same_filter(
    name: str, scene: str, changes: list[tuple[str, str]]
) -> None:
    pearl = Pearl.load(name, [("grain", "0")])
    coarse, fine = (
        nc.render(pearl, Scene.load(scene, changes), size) for size in (SIZE_PX, FINER * SIZE_PX)
    )
    mean = filtered(fine.linear.astype(float))
    inner = np.s_[1:-1, 1:-1]
    seen = np.abs(np.clip(coarse.linear, 0, 1) - np.clip(mean, 0, 1))[inner].max(axis=2)
    pearl_there = coarse.layers["coverage"][..., 0][inner] > 0
    assert seen[pearl_there].max() < 0.02
    # The edge of a window that the camera sees itself.
    assert seen.max() < 0.025
    # What is brighter than white, a lamp's image 12 times so, by its own light.
    assert (np.abs(coarse.linear - mean) / np.maximum(1.0, mean))[inner].max() < 0.025


def test_a_finer_picture_covers_what_a_coarse_one_does() -> None:
    pearl, scene = Pearl.load("paper", [("grain", "0")]), Scene.load(BACKLIGHT)
    coarse, fine = (
        nc.render(pearl, scene, size).layers["coverage"].astype(float) for size in (24, 96)
    )
    assert np.abs(coarse - filtered(fine)).max() < 0.006

"""The exposure that a photographer of white pearls would take."""

import numpy as np
import pytest

import nacreous as nc
from nacreous import InputError, Scene, metered_exposure


def test_twice_the_light_takes_half_the_exposure() -> None:
    window = {"azimuth_deg": -60.0, "elevation_deg": 40.0, "width_mm": 300.0, "height_mm": 300.0}
    exposures = [
        metered_exposure(Scene(windows=[window | {"luminance": luminance}], sky={"intensity": 0.0}))
        for luminance in (2.0, 4.0)
    ]
    assert exposures[0] / exposures[1] == pytest.approx(2, rel=1e-3)


def test_the_scenes_own_exposure_and_pearls_do_not_count() -> None:
    scene = Scene.load("two-tier")
    other = scene.replace(rows=(), camera=scene.camera.replace(exposure=7.0))
    assert metered_exposure(other) == metered_exposure(scene)


def test_of_a_white_pearl_so_exposed_little_burns_out() -> None:
    scene = Scene.load("north-window-white")
    image = nc.render("south-sea-white", scene, size=96)
    disc = image.layers["coverage"][..., 0] > 0.999
    luminance = image.linear[disc] @ np.array([0.2126, 0.7152, 0.0722])
    assert 0.05 < np.mean(luminance > 1) < 0.2
    assert np.median(luminance) > 0.5


def test_a_dark_scene_is_named() -> None:
    with pytest.raises(InputError, match="sends no light"):
        metered_exposure(Scene(sky={"intensity": 0.0}))

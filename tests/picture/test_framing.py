"""A scene frames the pearl it is given, and a panorama stands as it was taken."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.image import field_mm
from nacreous.spec import Camera, Pearl, Scene, Sky, preset
from tests.picture.stage import NO_TABLE, pearl
from tests.picture.test_image import exr

LONE = [name for name in preset.names("scene") if not Scene.load(name).rows]


@pytest.mark.parametrize("scene", LONE)
def test_every_preset_pearl_lies_within_every_scene_of_one(scene: str) -> None:
    for name in ("paper", "south-sea-gold", "south-sea-white", "tahitian"):
        cover = nc.render(name, scene, 32, 1).layers["coverage"][..., 0]
        edges = [cover[0], cover[-1], cover[:, 0], cover[:, -1]]
        assert not np.any(edges), (name, scene)
        assert cover.mean() > 0.25, (name, scene)


@pytest.mark.parametrize("diameter_mm", [1.0, 8.0, 30.0])
@pytest.mark.parametrize("distance_mm", [20.0, 100.0])
def test_the_largest_pearl_fits_even_before_the_nearest_eye(
    diameter_mm: float, distance_mm: float
) -> None:
    scene = Scene(camera=Camera(projection="perspective", distance_mm=distance_mm))
    cover = nc.render(pearl(diameter_mm=diameter_mm), scene, 64, 1).layers["coverage"]
    assert not cover[0].any()
    assert not cover[:, -1].any()


def test_a_width_that_is_told_is_kept() -> None:
    scene = Scene.load("paper", [("camera.field_mm", "11.5")])
    assert field_mm(Pearl(diameter_mm=12), scene) == 11.5


def test_a_panorama_seen_past_the_pearl_is_not_mirrored(tmp_path: Path) -> None:
    """Its middle lies straight ahead of a camera at azimuth 0, its right to the camera's right."""
    picture = np.zeros((64, 128, 3), np.float32)
    picture[:, 64:70, 0] = 1.0  # red right of the middle, green left of it, blue above
    picture[:, 58:64, 1] = 1.0
    picture[:31, 58:70, 2] = 1.0
    exr(tmp_path / "sky.exr", picture)

    def seen(**keys: float) -> np.ndarray:
        sky = Sky(
            kind="panorama",
            path=str(tmp_path / "sky.exr"),
            rotation_deg=keys.get("rotation_deg", 0),
        )
        camera = Camera(
            projection="perspective",
            distance_mm=20,
            elevation_deg=0,
            azimuth_deg=keys.get("azimuth_deg", 0),
            field_mm=8,
        )
        return nc.render(
            pearl(diameter_mm=1), Scene(sky=sky, table=NO_TABLE, camera=camera), 32, 1
        ).linear

    def halves(picture: np.ndarray) -> tuple[bool, bool, bool]:
        red, green, blue = (picture[..., i] for i in range(3))
        return (
            red[:, 20:].sum() > 9 * red[:, :12].sum(),
            green[:, :12].sum() > 9 * green[:, 20:].sum(),
            blue[:10].sum() > 9 * blue[-10:].sum(),
        )

    assert halves(seen()) == (True, True, True)
    # Turned to the left by a right angle, as seen from above; the camera looks there from +90.
    assert halves(seen(rotation_deg=90, azimuth_deg=90)) == (True, True, True)

"""Depth, shininess and grain do what the paper says of them."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from PIL import Image as Pillow

import nacreous as nc
from nacreous.spec import (
    Camera,
    Layers,
    Pearl,
    Scene,
    Sky,
    Surface,
    Table,
    Texture,
)
from tests.picture.stage import (
    BLACK,
    LEFT,
    NO_TABLE,
    Array,
    away_from_rim,
    covered,
    luminance,
    normals,
    pearl,
)


def chroma_of(depth: float) -> float:
    """Mean chroma of rings and body together."""
    image = nc.render(Pearl(model="illuminant", depth=depth, grain=0.0), "paper", 32, 4)
    both = image.layers["interference"] + image.layers["diffuse"]
    return float(nc.colour.hvc_from_rgb(both[covered(image)])[:, 2].mean())


def test_depth_strengthens_the_colour_of_the_pearl() -> None:
    """Paper 4.1, figures 10, 11, 14b."""
    chroma = [chroma_of(depth) for depth in (0.0, 0.2, 0.4, 0.6, 0.75)]
    assert np.all(np.diff(chroma) > 0.1 * chroma[0])
    assert chroma[-1] > 4 * chroma[0]


def test_depth_strengthens_the_colour_up_to_its_end() -> None:
    chroma = [chroma_of(depth) for depth in (0.75, 0.9, 1.0)]
    assert np.all(np.diff(chroma) > 0)


def test_without_depth_there_is_no_interference() -> None:
    assert not nc.render(pearl(depth=0.0), "paper", 16, 1).layers["interference"].any()


def test_shininess_makes_the_lamps_image_brighter_and_narrower() -> None:
    """Paper 4.2, figures 12, 14c."""
    small = LEFT.replace(angular_radius_deg=0.2)
    scene = Scene(lamps=[small], sky=BLACK, table=NO_TABLE, camera=Camera(field_mm=8.0))
    peaks, widths = [], []
    for shininess in (0.0, 0.25, 0.5, 0.75, 1.0):
        mirror = luminance(nc.render(pearl(shininess=shininess), scene, 192, 4).layers["mirror"])
        peaks.append(mirror.max())
        widths.append(int((mirror > 0.5 * mirror.max()).sum()))
    assert np.all(np.diff(peaks) > 0)
    assert np.all(np.diff(widths) < 0)


def test_the_lamps_image_lies_where_the_normal_halves_light_and_view() -> None:
    scene = Scene(lamps=[LEFT], sky=BLACK, table=NO_TABLE, camera=Camera(field_mm=9.0))
    mirror = luminance(nc.render(pearl(shininess=0.8), scene, 128, 4).layers["mirror"])
    normal, view = normals(128, 9.0, 4.0, scene.camera)
    light = np.array([-math.sin(math.radians(49.5)), 1.0, math.cos(math.radians(49.5))])
    half = view + light / math.sqrt(2)
    aim = np.nan_to_num(normal @ (half / np.linalg.norm(half)), nan=-1.0)
    rows, columns = np.indices(mirror.shape)
    middle = [np.average(index, weights=mirror) for index in (rows, columns)]
    np.testing.assert_allclose(middle, np.unravel_index(aim.argmax(), aim.shape), atol=1.5)


def test_shininess_mirrors_the_surroundings_and_at_0_there_is_none() -> None:
    mirrors = [
        nc.render(pearl(shininess=shininess), Scene(sky=Sky(intensity=1.0)), 16, 1).layers["mirror"]
        for shininess in (0.0, 0.5, 1.0)
    ]
    assert not mirrors[0].any()
    assert 0 < mirrors[1].sum() < mirrors[2].sum()


def test_grain_acts_by_its_weights_in_proportion_to_lightness() -> None:
    """Paper 4.3, 4.4: hue and chroma of the diffuse part, lightness of the mirrored one."""
    weights = Texture(hue_weight=3.3, chroma_weight=4.4, value_weight=5.5)
    plain, grainy = (
        nc.render(pearl(texture=texture), Scene(lamps=[LEFT]), 48, 4)
        for texture in (Texture(hue_weight=0, chroma_weight=0, value_weight=0), weights)
    )
    for name in ("interference", "surroundings", "coverage"):
        np.testing.assert_array_equal(plain.layers[name], grainy.layers[name])
    inside = covered(plain)
    hue, value, chroma = grainy.layers["texture"][inside].astype(float).T
    assert min(hue.std(), value.std(), chroma.std()) > 0.002

    def hvc(image: nc.Image, name: str) -> Array:
        return nc.colour.hvc_from_rgb(image.layers[name][inside])

    body, grained = hvc(plain, "diffuse"), hvc(grainy, "diffuse")
    light = body[:, 1].clip(0, 10) / 10
    np.testing.assert_allclose(grained[:, 0] - body[:, 0], 3.3 * light * hue, atol=1e-4)
    np.testing.assert_allclose(grained[:, 1], body[:, 1], atol=1e-4)
    np.testing.assert_allclose(grained[:, 2] / body[:, 2], 1 + 4.4 * light * chroma, atol=1e-4)
    light = hvc(plain, "mirror")[:, 1].clip(0, 10) / 10
    mirror = plain.layers["mirror"][inside] * (1 + 5.5 * light * value)[:, None]
    np.testing.assert_allclose(grainy.layers["mirror"][inside], mirror, rtol=1e-5)


def test_grain_grows_with_its_knob() -> None:
    plain = nc.render(pearl(grain=0.0), "paper", 48, 4)
    changes = [
        np.abs(nc.render(pearl(grain=grain), "paper", 48, 4).linear - plain.linear).mean()
        for grain in (0.25, 0.5, 1.0)
    ]
    assert changes[0] > 2e-5
    assert np.all(np.diff(changes) > 0)


def test_the_grain_of_a_photograph_lies_beside_its_pearl(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "box").mkdir()
    noise = np.random.default_rng(1).normal(190, 12, (160, 160, 3)).clip(0, 255).astype(np.uint8)
    Pillow.fromarray(noise).save(tmp_path / "box" / "photo.png")
    (tmp_path / "box" / "my.toml").write_text(
        'model = "illuminant"\n[nacre]\nthickness_nm = [400, 410, 420]\n'
        '[texture]\nsource = "photo.png"\nside_px = 16\n'
    )
    monkeypatch.chdir(tmp_path)
    taken = nc.render("box/my.toml", "paper", 24, 1).layers["texture"]
    stand_in = pearl(grain=0.5, nacre=Layers(thickness_nm=[400, 410, 420]))
    assert taken.any()
    assert np.any(taken != nc.render(stand_in, "paper", 24, 1).layers["texture"])


def test_the_mirrored_table_fades_by_the_length_of_the_mirrored_ray() -> None:
    """Contrast exp(-distance / falloff), the distance from the geometry of a ball on a plane."""
    scene = Scene(sky=Sky(intensity=1.0), camera=Camera(field_mm=9.0, elevation_deg=24))
    swapped = Table(colour=scene.table.second_colour, second_colour=scene.table.colour)
    other = scene.replace(table=swapped)

    def contrast(falloff_mm: float) -> Array:
        subject = pearl(surface=Surface(falloff_mm=falloff_mm))
        mirrors = [nc.render(subject, s, 64, 1).layers["mirror"] for s in (scene, other)]
        return np.abs(mirrors[0] - mirrors[1]).astype(float).mean(axis=-1)

    normal, view = normals(64, 9.0, 4.0, scene.camera)
    along = 2 * (normal @ view)[..., None] * normal - view
    with np.errstate(invalid="ignore", divide="ignore"):
        distance_mm = (-4.0 - 4.0 * normal[..., 1]) / along[..., 1]
    clear, near, far = contrast(1e6), contrast(10.0), contrast(3.0)
    inside = away_from_rim(nc.render(pearl(), scene, 64, 1))
    seen = inside & (clear > 0.02) & (distance_mm < 30)
    assert seen.sum() > 200
    for faded, falloff_mm in ((near, 10), (far, 3)):
        expected = np.exp(-distance_mm[seen] / falloff_mm)
        np.testing.assert_allclose(faded[seen] / clear[seen], expected, atol=2e-3)

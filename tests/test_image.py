"""The picture: what must not change, what must change how, and no number that is not one."""

from __future__ import annotations

import json
import math
import os
import pty
import select
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from PIL import Image as Pillow

import nacreous as nc
from nacreous.spec import (
    Camera,
    Growth,
    Interference,
    Lamp,
    Layers,
    Pearl,
    Scene,
    Sky,
    Surface,
    Table,
    Texture,
    Walls,
)

Array = NDArray[np.float64]

#: Few layers, quick to sum up; uneven enough to have colours.
THIN = Layers(thickness_nm=[380.0 + 9.0 * (layer % 7) for layer in range(24)])
LEFT = Lamp(azimuth_deg=-49.5, elevation_deg=45, angular_radius_deg=6, spectrum="E")
NO_TABLE = Table(kind="none")
BLACK = Sky(intensity=0.0)
SUM = ("interference", "diffuse", "mirror", "surroundings")


def pearl(**keys: Any) -> Pearl:
    return Pearl(**{"nacre": THIN, "grain": 0.0, **keys})


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    return message


def luminance(rgb: NDArray[np.float32]) -> Array:
    return nc.colour.xyz_from_rgb(rgb)[..., 1]


def covered(image: nc.Image) -> NDArray[np.bool_]:
    return image.layers["coverage"][..., 0] == 1


def normals(size: int, field_mm: float, radius_mm: float, camera: Camera) -> tuple[Array, ...]:
    """Normals of a ball under each pixel's middle, NaN beside it, and the direction to the eye."""
    azimuth, elevation = math.radians(camera.azimuth_deg), math.radians(camera.elevation_deg)
    flat = math.cos(elevation)
    view = np.array([math.sin(azimuth) * flat, math.sin(elevation), math.cos(azimuth) * flat])
    right = np.array([math.cos(azimuth), 0.0, -math.sin(azimuth)])
    up = np.cross(view, right)
    step = (np.arange(size) + 0.5) / size - 0.5
    x, y = np.meshgrid(step, -step) * np.array(field_mm / radius_mm)
    with np.errstate(invalid="ignore"):
        z = np.sqrt(1 - x**2 - y**2)
    return x[..., None] * right + y[..., None] * up + z[..., None] * view, view


# --- parts


@pytest.mark.parametrize("scene", ["paper", "dark", "white-cloth"])
def test_the_four_parts_add_up_to_the_picture_exactly(scene: str) -> None:
    image = nc.render("akoya-rg", scene, 48, 4)
    first, *rest = (image.layers[name] for name in SUM)
    for part in rest:
        first = first + part
    np.testing.assert_array_equal(image.linear, first)
    assert image.linear.dtype == np.float32
    assert set(image.layers) == {*SUM, "texture", "coverage"}
    for name in ("interference", "diffuse", "mirror"):
        assert np.all(image.layers[name][image.layers["coverage"][..., 0] == 0] == 0)
    assert np.all(image.layers["surroundings"][covered(image)] == 0)
    assert image.layers["coverage"].min() == 0
    assert image.layers["coverage"].max() == 1


def test_coverage_is_the_area_of_the_disc() -> None:
    scene = Scene(camera=Camera(field_mm=12.0))
    area = nc.render(pearl(diameter_mm=8.0), scene, 64, 16).layers["coverage"].mean() * 12.0**2
    assert area == pytest.approx(math.pi * 4.0**2, rel=2e-3)


# --- interference depends on the view angle alone


_ANGLES = st.tuples(st.floats(-180, 180), st.floats(-90, 90))
_POINT = st.tuples(*[st.floats(-500, 500)] * 3).filter(lambda p: math.hypot(*p) > 21)


@settings(max_examples=40, deadline=None)
@given(place=st.one_of(_ANGLES, _POINT))
def test_moving_a_lamp_changes_no_bit_of_the_interference(place: tuple[float, ...]) -> None:
    """Paper 3.1: light spreads through the nacre; what is seen depends on the view angle alone."""
    if len(place) == 2:
        moved = Lamp(azimuth_deg=place[0], elevation_deg=place[1], spectrum="A")
    else:
        moved = Lamp(position_mm=place, spectrum="A")
    still = Lamp(azimuth_deg=10, elevation_deg=20, spectrum="D65")
    home = Lamp(azimuth_deg=123.4, elevation_deg=56.7, spectrum="A")
    first, second = (nc.render(pearl(), Scene(lamps=[still, a]), 16, 1) for a in (home, moved))
    parts = [image.layers["interference"].tobytes() for image in (first, second)]
    assert parts[0] == parts[1]
    assert np.any(first.layers["diffuse"] != second.layers["diffuse"])


def test_pixels_at_one_distance_from_the_middle_have_one_interference_colour() -> None:
    """With one sample, in the pixel's middle: all pixels of one radius, not only mirrored ones."""
    scene = Scene(lamps=[LEFT], camera=Camera(elevation_deg=31, azimuth_deg=77))
    image = nc.render(pearl(depth=1.0), scene, 128, 1)
    odd = 2 * np.arange(128) - 127
    radius2 = (odd[:, None] ** 2 + odd[None, :] ** 2)[covered(image)]
    colours = image.layers["interference"][covered(image)]
    rings = 0
    for ring in np.unique(radius2):
        on_ring = colours[radius2 == ring]
        assert np.ptp(on_ring, axis=0).max() <= 1e-6
        rings += len(on_ring) > 8
    assert rings > 100  # more than the eight that mirror each other


def test_with_many_samples_the_rings_keep_the_symmetry_of_the_square() -> None:
    scene = Scene(lamps=[LEFT], camera=Camera(elevation_deg=-20, azimuth_deg=130))
    part = nc.render(pearl(depth=1.0), scene, 96, 16).layers["interference"]
    for turned in (part[::-1], part[:, ::-1], part.transpose(1, 0, 2)):
        np.testing.assert_allclose(part, turned, rtol=0, atol=1e-6)


@pytest.mark.parametrize(
    ("coherence_nm", "quantile"),
    # The paper's window gains and loses layers at once, and the table of rings is straight between
    # its steps: beside such an edge the two may differ.
    [(1e6, 1.0), (5000.0, 0.95)],
)
def test_the_rings_are_the_models_spectra_as_colours(coherence_nm: float, quantile: float) -> None:
    """Each pixel against `nc.optics` and `nc.colour` at its own view angle, up to one factor."""
    scene = Scene(lamps=[LEFT], camera=Camera(field_mm=9.0), sky=BLACK, table=NO_TABLE)
    model = {"coherence_nm": coherence_nm, "diffuse_loss": 0.03}
    image = nc.render(pearl(interference=Interference(mixing=1.0, **model)), scene, 24, 1)
    normal, view = normals(24, 9.0, 4.0, scene.camera)
    theta = np.arccos((normal @ view)[covered(image)])
    stack = nc.LayerStack(THIN.thickness_nm)
    spectra = nc.optics.illuminant(stack, theta, nc.colour.WAVELENGTH_NM, **model)
    xyz = nc.colour.xyz_from_spectrum(spectra, "E")
    seen = nc.colour.adapt(xyz, nc.colour.white_xyz("E"), nc.colour.xyz_from_rgb([1, 1, 1]))
    expected = nc.colour.rgb_from_xyz(seen)
    found = image.layers["interference"][covered(image)]
    factor = np.sum(found * expected) / np.sum(expected**2)
    error = np.abs(found - factor * expected).max(axis=1) / found.max()
    assert np.quantile(error, quantile) < 0.003


def test_the_rings_are_as_bright_on_average_as_the_light_inside() -> None:
    """Half of a lamp's light gets in; mixing is the share of interference."""
    subject = pearl(interference=Interference(mixing=0.6))
    image = nc.render(subject, Scene(lamps=[LEFT], sky=BLACK), 64, 16)
    mean = luminance(image.layers["interference"]).sum() / image.layers["coverage"].sum()
    assert mean == pytest.approx(0.6 * 0.5 * LEFT.intensity, rel=5e-3)


def test_zero_coherence_leaves_one_hue() -> None:
    def spread(coherence_nm: float) -> float:
        subject = pearl(depth=1.0, interference=Interference(coherence_nm=coherence_nm))
        image = nc.render(subject, Scene(lamps=[LEFT]), 48, 4)
        colours = image.layers["interference"][covered(image)].astype(float)
        return float((colours / colours.sum(axis=1, keepdims=True)).std(axis=0).max())

    assert spread(0.0) < 0.01
    assert spread(5000.0) > 0.1


# --- light


def test_mirroring_the_lamp_mirrors_the_picture() -> None:
    """The checker stands on a corner under the pearl: mirrored, its colours change places."""
    colours = {"colour": "#d8d4cc", "second_colour": "#5a554d"}
    swapped = {"colour": "#5a554d", "second_colour": "#d8d4cc"}

    def image(side: float, table: dict[str, str]) -> nc.Image:
        lamps = [Lamp(azimuth_deg=side * 49.5, elevation_deg=45), Lamp(position_mm=(0, 300, 90))]
        return nc.render(pearl(), Scene(lamps=lamps, table=Table(**table)), 64, 4)

    left, right = image(-1, colours), image(1, swapped)
    for name in ("interference", "diffuse", "surroundings"):
        mirrored = right.layers[name][:, ::-1]
        np.testing.assert_allclose(left.layers[name], mirrored, rtol=0, atol=2e-6)
    # The points that stand for a lamp are not mirrored with it.
    peak = left.layers["mirror"].max()
    np.testing.assert_allclose(
        left.layers["mirror"], right.layers["mirror"][:, ::-1], rtol=0, atol=0.01 * peak
    )


@pytest.mark.parametrize(
    "light",
    [
        {"lamps": [Lamp(azimuth_deg=0, elevation_deg=90, spectrum="3000K")], "sky": BLACK},
        {"lamps": [], "sky": Sky(intensity=1.0)},
    ],
    ids=["lamp", "sky"],
)
def test_light_of_intensity_1_makes_white_paper_1(light: dict[str, Any]) -> None:
    scene = Scene(
        **light,
        table=Table(kind="plain", colour="#ffffff"),
        camera=Camera(elevation_deg=89, field_mm=400.0),
    )
    corner = nc.render(pearl(), scene, 32, 1).linear[0, 0]
    np.testing.assert_allclose(corner, 1.0, atol=2e-3)


def test_twice_the_light_is_twice_the_picture_and_so_is_twice_the_exposure() -> None:
    def scene(light: float, exposure: float) -> Scene:
        lamps = [LEFT.model_copy(update={"intensity": light}), Lamp(position_mm=(90, 80, 70))]
        lamps[1] = lamps[1].model_copy(update={"intensity": 0.5 * light, "spectrum": "A"})
        sky = Sky(kind="gradient", horizon="#803010", intensity=0.3 * light)
        return Scene(lamps=lamps, sky=sky, walls=Walls(), camera=Camera(exposure=exposure))

    once = nc.render(pearl(), scene(1.0, 1.0), 32, 4).linear
    for other in (scene(2.0, 1.0), scene(1.0, 2.0)):
        np.testing.assert_allclose(nc.render(pearl(), other, 32, 4).linear, 2 * once, rtol=1e-5)


def test_a_lamp_switched_off_is_no_lamp() -> None:
    off = Lamp(azimuth_deg=20, elevation_deg=20, spectrum="A", intensity=0.0)
    for lamps in ([], [LEFT]):
        with_it = nc.render(pearl(), Scene(lamps=[*lamps, off]), 16, 1).linear
        np.testing.assert_array_equal(nc.render(pearl(), Scene(lamps=lamps), 16, 1).linear, with_it)


def test_a_measured_lamp_counts_by_shape_and_lies_beside_its_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "bench").mkdir()
    (tmp_path / "bench" / "lamp.csv").write_text("wavelength_nm,value\n380,3\n500,3\n780,3\n")
    text = '[[lamps]]\nazimuth_deg = -40\nelevation_deg = 45\nspectrum = "{}"\n'
    for name, spectrum in (("measured", "lamp.csv"), ("flat", "E"), ("warm", "A")):
        (tmp_path / "bench" / f"{name}.toml").write_text(text.format(spectrum))
    monkeypatch.chdir(tmp_path)
    measured, flat, warm = (
        nc.render(pearl(), Path("bench", f"{name}.toml"), 16, 1).linear
        for name in ("measured", "flat", "warm")
    )
    np.testing.assert_allclose(measured, flat, rtol=1e-6)
    assert np.abs(warm - flat).max() > 0.01


# --- panoramas


def hdr(path: Path, value: float) -> None:
    """A Radiance file of one grey, flat pixels: value = mantissa / 256 * 2^(exponent - 128)."""
    mantissa, exponent = math.frexp(value)
    pixel = bytes([int(mantissa * 256)] * 3 + [exponent + 128])
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n"
    path.write_bytes(head + pixel * 32)


def exr(path: Path, pixels: NDArray[np.float32]) -> None:
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"RGB": pixels}).write(str(path))


@pytest.mark.parametrize("ending", [".hdr", ".exr"])
def test_a_panorama_of_one_colour_is_a_constant_sky(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"sky{ending}"
    hdr(path, 0.5) if ending == ".hdr" else exr(path, np.full((4, 8, 3), 0.5, np.float32))
    panorama = Sky(kind="panorama", path=str(path), intensity=1.6, rotation_deg=33)
    constant = Sky(kind="constant", intensity=0.8)
    first, second = (
        nc.render(pearl(), Scene(lamps=[LEFT], sky=sky, table=table), 32, 4).linear
        for sky in (panorama, constant)
        for table in [NO_TABLE]
    )
    np.testing.assert_allclose(first, second, rtol=2e-6)


def test_a_panorama_is_turned_as_asked_and_mirrored_in_the_pearl(tmp_path: Path) -> None:
    """Light from the left half only; half a turn later it comes from the right."""
    pixels = np.zeros((32, 64, 3), np.float32)
    pixels[:, :32] = 1.0
    exr(tmp_path / "sky.exr", pixels)

    def halves(rotation_deg: float) -> tuple[float, float]:
        sky = Sky(kind="panorama", path=str(tmp_path / "sky.exr"), rotation_deg=rotation_deg)
        scene = Scene(sky=sky, table=NO_TABLE, camera=Camera(elevation_deg=0))
        mirror = nc.render(pearl(), scene, 32, 4).layers["mirror"]
        return float(mirror[:, :16].sum()), float(mirror[:, 16:].sum())

    left, right = halves(0)
    assert left > 5 * right
    left, right = halves(180)
    assert right > 5 * left


# --- the three knobs


def chroma_of(depth: float) -> float:
    """Mean chroma of rings and body together."""
    image = nc.render(Pearl(depth=depth, grain=0.0), "paper", 32, 4)
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
    small = LEFT.model_copy(update={"angular_radius_deg": 0.2})
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
        '[nacre]\nthickness_nm = [400, 410, 420]\n[texture]\nsource = "photo.png"\nside_px = 16\n'
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
    other = scene.model_copy(update={"table": swapped})

    def contrast(falloff_mm: float) -> Array:
        subject = pearl(surface=Surface(falloff_mm=falloff_mm))
        mirrors = [nc.render(subject, s, 64, 1).layers["mirror"] for s in (scene, other)]
        return np.abs(mirrors[0] - mirrors[1]).astype(float).mean(axis=-1)

    normal, view = normals(64, 9.0, 4.0, scene.camera)
    along = 2 * (normal @ view)[..., None] * normal - view
    with np.errstate(invalid="ignore", divide="ignore"):
        distance_mm = (-4.0 - 4.0 * normal[..., 1]) / along[..., 1]
    clear, near, far = contrast(1e6), contrast(10.0), contrast(3.0)
    seen = (clear > 0.02) & (distance_mm < 30)
    assert seen.sum() > 200
    for faded, falloff_mm in ((near, 10), (far, 3)):
        expected = np.exp(-distance_mm[seen] / falloff_mm)
        np.testing.assert_allclose(faded[seen] / clear[seen], expected, atol=2e-3)


# --- no NaN leaves the room


def lamps(count: int) -> list[Lamp]:
    return [
        Lamp(azimuth_deg=23.0 * i - 180, elevation_deg=11.0 * i - 85, angular_radius_deg=0.05 + i)
        for i in range(count)
    ]


EXTREMES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "all knobs 0": ({"depth": 0.0, "shininess": 0.0, "grain": 0.0}, {}),
    "all knobs 1": ({"depth": 1.0, "shininess": 1.0, "grain": 1.0}, {}),
    "weights beyond the knob": ({"texture": Texture(hue_weight=10, chroma_weight=10)}, {}),
    "no lamps, black sky": ({}, {"lamps": [], "sky": BLACK}),
    "nothing at all": ({"body_colour": "#000000"}, {"lamps": [], "sky": BLACK, "table": NO_TABLE}),
    "sixteen lamps": ({"shininess": 1.0}, {"lamps": lamps(16)}),
    "broad lamps": ({}, {"lamps": [Lamp(position_mm=(20.1, 0, 0), angular_radius_deg=30)]}),
    "lamp behind": ({}, {"lamps": [Lamp(azimuth_deg=180, elevation_deg=-12)]}),
    "lamp below": ({}, {"lamps": [Lamp(azimuth_deg=0, elevation_deg=-90)]}),
    "blinding": (
        {"shininess": 1.0},
        {
            "lamps": [Lamp(azimuth_deg=0, elevation_deg=12, intensity=1e6)],
            "sky": Sky(intensity=1e6),
        },
    ),
    "candle seen as white by day": (
        {},
        {
            "lamps": [LEFT.model_copy(update={"spectrum": "1000K"})],
            "camera": Camera(white="25000K"),
        },
    ),
    "no coherence": ({"interference": Interference(coherence_nm=0)}, {}),
    "endless coherence": ({"interference": Interference(coherence_nm=1e6, threshold=0)}, {}),
    "all light lost": ({"interference": Interference(diffuse_loss=0.9, mixing=1)}, {}),
    "one thin layer": ({"nacre": Layers(thickness_nm=[1e-3])}, {}),
    "one thick layer": ({"nacre": Layers(thickness_nm=[1e5], protein_nm=200)}, {}),
    "no difference in index": ({"nacre": Layers(thickness_nm=[400], protein=1.53)}, {}),
    "nacre of air": ({"nacre": Layers(thickness_nm=[400] * 9, aragonite=1, protein=1)}, {}),
    "dense nacre": ({"nacre": Layers(thickness_nm=[400] * 9, aragonite=10, protein=1)}, {}),
    "table none": ({}, {"table": NO_TABLE}),
    "cloth finer than a pixel": ({}, {"table": Table(kind="cloth", weave_mm=0.05)}),
    "checker finer than a pixel": ({}, {"table": Table(check_mm=0.1)}),
    "walls": ({}, {"walls": Walls(half_width_mm=20, height_mm=1)}),
    "tall walls": ({}, {"walls": Walls(half_width_mm=20, height_mm=100_000)}),
    "from 20 mm": (
        {"diameter_mm": 30},
        {"camera": Camera(projection="perspective", distance_mm=20)},
    ),
    "from below the table": ({}, {"camera": Camera(elevation_deg=-80)}),
    "from above": ({}, {"camera": Camera(elevation_deg=89, projection="perspective")}),
    "along the table": ({}, {"camera": Camera(elevation_deg=0)}),
    "tiny": ({"diameter_mm": 1}, {"camera": Camera(field_mm=10_000)}),
    "nothing but nacre": ({"diameter_mm": 30}, {"camera": Camera(field_mm=0.1)}),
    "satin": ({"surface": Surface(facet_spread_rad=0.6, falloff_mm=0.1)}, {}),
    "glass": ({"surface": Surface(facet_spread_rad=0.005, layer_reflectance=0.9)}, {}),
    "ten degrees": ({}, {"observer": "1964-10"}),
}


@pytest.mark.parametrize("case", EXTREMES)
def test_no_spec_makes_a_number_that_is_not_finite(case: str, tmp_path: Path) -> None:
    of_pearl, of_scene = EXTREMES[case]
    scene = Scene(**{"lamps": [LEFT], **of_scene})
    image = nc.render(pearl(**{"grain": 0.5, **of_pearl}), scene, 17, 4)
    for name, layer in {"linear": image.linear, **image.layers}.items():
        assert np.all(np.isfinite(layer)), name
    assert image.layers["coverage"].min() >= 0
    assert image.layers["coverage"].max() <= 1 + 1e-6
    image.save(tmp_path / "a.png", bits=16)
    image.save(tmp_path / "a.exr")


def test_what_is_lit_by_nothing_is_black() -> None:
    scene = Scene(lamps=[], sky=BLACK)
    assert not nc.render(pearl(), scene, 16, 4).linear.any()


@pytest.mark.parametrize(
    ("nacre", "message"),
    [
        (Layers(thickness_nm=[400], aragonite=(1.53, 0.1)), "aragonite has k = 0.1; allowed: 0"),
        (Layers(thickness_nm=[400], protein=0.9), "protein has n = 0.9; allowed: at least"),
    ],
)
def test_nacre_that_the_model_has_no_answer_for_is_refused(nacre: Layers, message: str) -> None:
    assert refusal(lambda: nc.render(pearl(nacre=nacre), "paper", 8, 1)).startswith(message)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"size": 0}, "size is 0; allowed: a whole number from 1 to 8192"),
        ({"size": -1}, "size is -1; "),
        ({"size": 8193}, "size is 8193; "),
        ({"size": 10**30}, "size is 1000000000000"),
        ({"size": 64.0}, "size is 64.0; "),
        ({"size": True}, "size is True; "),
        ({"samples": 0}, "samples is 0; allowed: a square number from 1 to 1024, such as 16"),
        ({"samples": 10}, "samples is 10; "),
        ({"samples": 1089}, "samples is 1089; "),
        ({"samples": 4.0}, "samples is 4.0; "),
        ({"pearl": "papre"}, '"papre" is neither a file nor a pearl preset; did you mean paper?'),
        ({"pearl": None}, "pearl is None; allowed: a pearl, a file or a preset's name"),
        ({"scene": Pearl()}, "scene is Pearl("),
        ({"scene": "akoya-r"}, '"akoya-r" is a pearl preset; wanted: a scene file or preset'),
    ],
    ids=lambda case: str(case)[:40],
)
def test_render_says_what_is_wrong(arguments: dict[str, Any], message: str) -> None:
    assert refusal(lambda: nc.render(**{"size": 8, "samples": 1, **arguments})).startswith(message)


# --- files


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


# --- progress and the wish to stop


def test_progress_rises_from_0_to_1() -> None:
    shares: list[float] = []
    nc.render(pearl(), "paper", 256, 16, progress=shares.append)
    assert len(shares) > 3
    assert shares == sorted(shares)
    assert 0 <= shares[0] < shares[-1] <= 1


def test_what_progress_raises_stops_the_render() -> None:
    class EnoughError(Exception):
        pass

    def stop(share: float) -> None:
        if share > 0:
            raise EnoughError

    begin = time.monotonic()
    with pytest.raises(EnoughError):
        nc.render(pearl(), "paper", 2048, 64, progress=stop)
    assert time.monotonic() - begin < 5


def terminal_shows(reader: int, words: bytes, patience_s: float = 30) -> bytes:
    """What a program writes to its terminal, until the words appear."""
    shown = b""
    end = time.monotonic() + patience_s
    while words not in shown and time.monotonic() < end:
        if select.select([reader], [], [], 0.1)[0]:
            shown += os.read(reader, 4096)
    return shown


def test_ctrl_c_ends_a_big_render_at_once_and_leaves_nothing(tmp_path: Path) -> None:
    reader, writer = pty.openpty()
    command = [sys.executable, "-m", "nacreous", "render", "paper", "--size", "4096"]
    try:
        with subprocess.Popen(
            [*command, "--samples", "64", "-o", "x.png"], cwd=tmp_path, stderr=writer
        ) as program:
            shown = terminal_shows(reader, b"rendering [")
            assert b"rendering [" in shown
            begin = time.monotonic()
            program.send_signal(signal.SIGINT)
            assert program.wait(20) == 130
            assert time.monotonic() - begin < 2
        shown = terminal_shows(reader, b"nothing was written")
        assert shown.endswith(b"nacreous: interrupted; nothing was written\r\n")
    finally:
        os.close(writer)
        os.close(reader)
    assert not list(tmp_path.iterdir())


def test_ctrl_c_is_heard_without_anybody_watching() -> None:
    program = """
import os, signal, threading, time, nacreous as nc
def interrupt():
    global begin
    begin = time.monotonic()
    os.kill(os.getpid(), signal.SIGINT)
threading.Timer(0.5, interrupt).start()
try:
    nc.render("paper", size=4096, samples=64)
except KeyboardInterrupt:
    print(time.monotonic() - begin)
"""
    done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True)
    assert float(done.stdout) < 2

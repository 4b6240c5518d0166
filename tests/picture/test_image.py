"""The picture: what must not change, and what must change how."""

from __future__ import annotations

import copy
import math
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import OpenEXR
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import nacreous as nc
from nacreous.spec import (
    Camera,
    Interference,
    Lamp,
    Scene,
    Sky,
    Table,
    Walls,
)
from tests.picture.stage import (
    BLACK,
    LEFT,
    NO_TABLE,
    SUM,
    THIN,
    away_from_rim,
    covered,
    luminance,
    normals,
    pearl,
)


@pytest.mark.parametrize(
    "scene", ["paper", "north-window-black", "north-window-white", "booth", "aurora"]
)
def test_the_four_parts_add_up_to_the_picture_exactly(scene: str) -> None:
    image = nc.render("akoya-rg", scene, 48, 4)
    first, *rest = (image.layers[name] for name in SUM)
    for part in rest:
        first = first + part
    np.testing.assert_array_equal(image.linear, first)
    assert image.linear.dtype == np.float32
    assert set(image.layers) == {*SUM, "texture", "coverage", "shadow"}
    for name in ("interference", "diffuse", "mirror"):
        assert np.all(image.layers[name][image.layers["coverage"][..., 0] == 0] == 0)
    assert np.all(image.layers["surroundings"][covered(image)] == 0)
    assert image.layers["coverage"].min() == 0
    assert image.layers["coverage"].max() == 1


def test_coverage_is_the_area_of_the_disc() -> None:
    scene = Scene(camera=Camera(field_mm=12.0))
    area = nc.render(pearl(diameter_mm=8.0), scene, 64, 16).layers["coverage"].mean() * 12.0**2
    assert area == pytest.approx(math.pi * 4.0**2, rel=2e-3)


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
    inside = away_from_rim(image)
    radius2 = (odd[:, None] ** 2 + odd[None, :] ** 2)[inside]
    colours = image.layers["interference"][inside]
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
    image = nc.render(pearl(interference=Interference(mixing=1.0, **model)), scene, 48, 1)
    normal, view = normals(48, 9.0, 4.0, scene.camera)
    inside = away_from_rim(image)
    theta = np.arccos((normal @ view)[inside])
    stack = nc.LayerStack(THIN.thickness_nm)
    spectra = nc.optics.illuminant(stack, theta, nc.colour.WAVELENGTH_NM, **model)
    xyz = nc.colour.xyz_from_spectrum(spectra, "E")
    seen = nc.colour.adapt(xyz, nc.colour.white_xyz("E"), nc.colour.xyz_from_rgb([1, 1, 1]))
    expected = nc.colour.rgb_from_xyz(seen)
    found = image.layers["interference"][inside]
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
        lamps = [LEFT.replace(intensity=light), Lamp(position_mm=(90, 80, 70))]
        lamps[1] = lamps[1].replace(intensity=0.5 * light, spectrum="A")
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


def test_an_image_goes_from_process_to_process_with_all_that_it_holds() -> None:
    image = nc.render("paper", size=8, samples=1)
    copies = [pickle.loads(pickle.dumps(image)), copy.deepcopy(image)]
    for other in copies:
        np.testing.assert_array_equal(other.linear, image.linear)
        assert list(other.layers) == list(image.layers)
        assert other.recipe == image.recipe
    assert repr(copies[0]) == "Image(8 x 8, paper)"

"""Criteria of each figure: planted numbers are found, tampered pictures fail."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from nacreous import colour
from nacreous.image import Image
from nacreous.paper import (
    crop,
    figure_2,
    figure_8,
    figure_9,
    figure_10,
    figure_11,
    figure_12,
    figure_13,
    figure_14,
    hue,
    table_image,
)
from nacreous.paper.lamp_image import LampImage, luminance
from nacreous.paper.pictures import Pictures
from nacreous.paper.sight import Sight, direction_of
from nacreous.spec import Pearl, Scene
from tests.paper.tampering import failing


def changed(picture: Image, **parts: np.ndarray) -> Image:
    return Image(picture.linear, {**picture.layers, **parts}, picture.recipe)


def test_figure_8_holds_and_another_index_or_a_dip_does_not() -> None:
    view, incidence, reflectance = figure_8.table()
    assert failing(figure_8.measure(view, incidence, reflectance)) == set()
    assert failing(figure_8.measure(view, incidence * 1.01, reflectance)) == {1}
    assert failing(figure_8.measure(view, incidence, reflectance * 1.01)) == {0, 2}
    dipping = reflectance.copy()
    dipping[90] = dipping[88]
    assert failing(figure_8.measure(view, incidence, dipping)) == {3}


def fringes(order: float, index: float = 1.53) -> np.ndarray:
    """Spectra by degree whose every fringe moves as cos(theta_1)."""
    sine = np.sin(np.radians(np.arange(81.0))) / index
    phase = order * 380 * np.sqrt(1 - sine**2)[:, None] / colour.WAVELENGTH_NM
    return 1 + 0.6 * np.cos(2 * np.pi * phase)


@pytest.mark.parametrize("order", [8.0, 14.0])
def test_a_shift_planted_in_spectra_is_found(order: float) -> None:
    found = figure_9.fringe_shifts(fringes(order)).sum()
    first, last = (1 - (np.sin(np.radians(angle)) / 1.53) ** 2 for angle in figure_9.VIEW_DEG)
    assert found == pytest.approx(0.5 * np.log(last / first), rel=0.08)


def test_figure_9_fails_for_flat_still_or_backward_fringes() -> None:
    light = figure_9.spectra(Pearl.load("paper"))
    assert failing(figure_9.measure(light, 1.53, 0)) == set()
    assert failing(figure_9.measure(light, 1.53, 1)) == {6}
    still = np.broadcast_to(light[30], light.shape)
    # Criterion 4, no step backward, is met or missed by rounding where nothing moves.
    assert failing(figure_9.measure(still, 1.53, 0)) - {4} == {2, 3, 5}
    backward = light.copy()
    backward[10:61] = light[60:9:-1]
    assert {3, 4, 5} <= failing(figure_9.measure(backward, 1.53, 0))
    assert {0, 1} <= failing(figure_9.measure(0.01 * light / light.mean() + 1, 1.53, 0))


def test_one_bit_in_one_layer_is_a_change(taken: Pictures) -> None:
    layers = [picture.layers["interference"] for picture in taken.lamps]
    assert len(layers) >= 4
    assert figure_9.changed_values(layers) == 0
    other = layers[2].copy()
    other[40, 40, 1] = np.nextafter(other[40, 40, 1], np.float32(1))
    assert figure_9.changed_values([*layers[:2], other, layers[3]]) == 1


def test_figure_10_fails_when_colour_follows_the_lamp(taken: Pictures) -> None:
    layers = [picture.layers["interference"] for picture in taken.lamps]
    sight = taken.lamp_sight
    assert failing(figure_10.measure(layers, sight)) == set()
    redder = layers[1] * np.array([1.02, 1, 1], np.float32)
    assert failing(figure_10.measure([layers[0], redder], sight)) == {0}


def test_figure_10_fails_when_a_ring_is_uneven_by_a_hundred_thousandth(taken: Pictures) -> None:
    layer, sight = taken.lamps[0].layers["interference"], taken.lamp_sight
    slanted = layer * np.linspace(1, 1 + 2e-5, len(layer), dtype=np.float32)[:, None]
    assert failing(figure_10.measure([slanted, slanted], sight)) == {1}


def test_figure_10_fails_without_colour(taken: Pictures) -> None:
    layer, sight = taken.lamps[0].layers["interference"], taken.lamp_sight
    grey = np.repeat(luminance(layer)[..., None], 3, axis=-1).astype(np.float32)
    assert {2, 3, 4} <= failing(figure_10.measure([grey, grey], sight))


def test_a_planted_hue_span_is_found() -> None:
    turn = np.radians(np.linspace(10, 130, 50))
    hvc = np.stack([turn, np.full(50, 6.0), np.full(50, 5.0)], axis=1)
    assert hue.span_deg(colour.rgb_from_hvc(hvc)) == pytest.approx(120, abs=1e-6)
    assert hue.span_deg(colour.rgb_from_hvc(hvc[:1])) == 0


def test_figure_11_fails_for_light_that_does_not_follow_the_lamp(taken: Pictures) -> None:
    layers = [picture.layers["diffuse"] for picture in taken.lamps]
    lamp, smooth, sight = direction_of(taken.scene.lamps[0]), taken.smooth, taken.sight
    assert failing(figure_11.measure(smooth, layers, sight, lamp)) == set()
    assert failing(figure_11.measure(smooth, [layers[0]] * 3, sight, lamp)) == {3}
    assert failing(figure_11.measure(smooth, layers, sight, -lamp)) == {0}
    rings = changed(smooth, diffuse=smooth.layers["interference"])
    assert {0, 1, 2} <= failing(figure_11.measure(rings, layers, sight, lamp))


@pytest.fixture(scope="module")
def sight() -> Sight:
    return Sight.of(Pearl.load("paper"), Scene.load("paper"), 256)


def bell(sight: Sight, spread_deg: float) -> np.ndarray:
    """A lamp's image of known shape about one place of the pearl, on a floor of 0.1."""
    away = np.degrees(np.arccos(np.clip(sight.normal @ sight.normal[100, 110], -1, 1)))
    light = 0.1 + 5 * np.exp(-0.5 * (away / spread_deg) ** 2)
    return np.repeat(np.nan_to_num(light)[..., None], 3, axis=-1).astype(np.float32)


@pytest.mark.parametrize("spread_deg", [2.0, 5.0, 9.0])
def test_a_planted_lamp_image_is_measured(sight: Sight, spread_deg: float) -> None:
    lamp = LampImage.of(bell(sight, spread_deg), sight)
    assert lamp.peak == pytest.approx(5, rel=0.02)
    assert lamp.half_width_deg == pytest.approx(spread_deg * np.sqrt(2 * np.log(2)), rel=0.05)
    edge = np.sqrt(2 * np.log(10)) - np.sqrt(2 * np.log(1 / 0.9))
    assert lamp.edge_deg == pytest.approx(spread_deg * edge, rel=0.1)


def test_a_hard_edge_is_told_from_a_soft_one() -> None:
    sight = Sight.of(Pearl.load("paper"), Scene.load("paper"), 512)
    away = np.degrees(np.arccos(np.clip(sight.normal @ sight.normal[200, 220], -1, 1)))
    hard = np.repeat(np.where(away < 3, 5.0, 0.1)[..., None], 3, axis=-1).astype(np.float32)
    measured = figure_12.measure(hard, sight, Scene.load("paper"))
    assert 2 in failing(measured)
    assert LampImage.of(hard, sight).half_width_deg == pytest.approx(3, abs=0.3)


def squares(sight: Sight, contrast_by_mm: Any) -> np.ndarray:
    """A mirrored table of known contrast, shaded over the pearl."""
    distance_mm, x_mm, z_mm = sight.on_table()
    even = (np.floor(x_mm / 3) + np.floor(z_mm / 3)) % 2 == 0
    shade = 0.1 * np.exp(0.8 * sight.normal[..., 0] - 0.5 * sight.normal[..., 1])
    light = shade * (1 + contrast_by_mm(distance_mm) * np.where(even, 1, -1))
    return np.repeat(np.nan_to_num(light)[..., None], 3, axis=-1).astype(np.float32)


def test_a_planted_contrast_of_the_table_is_found(sight: Sight) -> None:
    mirror = squares(sight, lambda _: 0.4)
    _, found = table_image.fading(mirror, sight, 3.0)
    np.testing.assert_allclose(found, 0.4, atol=0.005)


def test_figure_12_fails_without_fading_or_with_a_dim_lamp(taken: Pictures) -> None:
    mirror, scene = taken.smooth.layers["mirror"], taken.scene
    assert failing(figure_12.measure(mirror, taken.sight, scene)) == set()
    lamp = LampImage.of(mirror, taken.sight)
    light = np.where(lamp.inside, 1.0, 0.0)[..., None] * mirror.max()
    unfading = squares(taken.sight, lambda _: 0.4)
    assert {5, 6} & failing(
        figure_12.measure(unfading + light.astype(np.float32), taken.sight, scene)
    )
    assert 0 in failing(figure_12.measure(0.01 * mirror, taken.sight, scene))


def test_geometry_here_agrees_with_the_renderer(taken: Pictures) -> None:
    covered = taken.lamps[0].layers["coverage"][..., 0] > 0.5
    np.testing.assert_array_equal(covered, np.isfinite(taken.lamp_sight.cos_view))
    lamp = LampImage.of(taken.smooth.layers["mirror"], taken.sight)
    half = direction_of(taken.scene.lamps[0]) + direction_of(taken.scene.camera)
    brightest = taken.sight.normal[np.unravel_index(lamp.share.argmax(), lamp.share.shape)]
    # The eye is near, the lamp's disc wide: a few degrees of leeway.
    assert np.degrees(np.arccos(brightest @ half / np.linalg.norm(half))) < 5


def test_figure_13_fails_for_a_flat_a_coarse_or_a_shifted_texture() -> None:
    step_mm = np.arange(64) * 1.92 / 64
    band, rest = (2.0, 12.0), np.random.default_rng(1).normal(size=5000)
    wave = 0.1 * np.sin(2 * np.pi * 5 * step_mm)[:, None] * np.ones(64)
    assert failing(figure_13.measure(wave, rest, 1.92, band)) == set()
    assert figure_13.band_share(wave, 1.92, band) > 0.999
    coarse = 0.1 * np.sin(2 * np.pi * 0.6 * step_mm)[:, None] * np.ones(64)
    assert failing(figure_13.measure(coarse, rest, 1.92, band)) == {2}
    fine = 0.1 * np.sin(2 * np.pi * 15 * step_mm)[:, None] * np.ones(64)
    assert failing(figure_13.measure(fine, rest, 1.92, band)) == {2}
    assert failing(figure_13.measure(wave, rest + 0.5, 1.92, band)) == {0}
    assert failing(figure_13.measure(np.zeros((64, 64)), np.zeros(9), 1.92, band)) == {0, 1, 2}


def test_figure_14_a_fails_for_another_lamp_or_a_missing_part(taken: Pictures) -> None:
    assert failing(figure_14.measure_a(taken.smooth, taken.scene)) == set()
    moved = Scene.load("paper", [("lamps.0.azimuth_deg", -45)])
    assert failing(figure_14.measure_a(taken.smooth, moved)) == {0}
    dark = changed(taken.smooth, mirror=np.zeros_like(taken.smooth.layers["mirror"]))
    assert failing(figure_14.measure_a(dark, taken.scene)) == {1, 4}


def test_knobs_that_do_nothing_or_the_reverse_fail(taken: Pictures) -> None:
    a, b, c, d, sight = taken.smooth, taken.shallow, taken.dull, taken.grained, taken.sight
    knobs, check_mm = taken.knobs, taken.scene.table.check_mm
    assert failing(figure_14.measure_b(a, b, knobs["depth"], sight)) == set()
    assert failing(figure_14.measure_b(a, a, knobs["depth"], sight)) == {2}
    assert failing(figure_14.measure_b(a, b, knobs["depth"][::-1], sight)) == set()
    assert failing(figure_14.measure_b(a, b, knobs["depth"][:1] * 5, sight)) == {3}
    assert failing(figure_14.measure_c(a, c, knobs["shininess"], sight, check_mm)) == set()
    assert failing(figure_14.measure_c(c, a, knobs["shininess"], sight, check_mm)) == {1, 2, 4}
    assert failing(figure_14.measure_d(a, d, knobs["grain"])) == set()
    assert failing(figure_14.measure_d(a, a, knobs["grain"])) == {0}
    assert failing(figure_14.measure_d(a, b, knobs["grain"])) == {0, 1}
    shuffled = [knobs["grain"][i] for i in (0, 3, 1, 2, 4)]
    assert failing(figure_14.measure_d(a, d, shuffled)) == {2}


def test_figure_2_fails_for_crops_in_the_wrong_places(taken: Pictures) -> None:
    picture, circle = taken.grained, taken.sight.circle
    codes, _ = picture.develop()
    crops = crop.seven(colour.decode(codes / 255), circle)
    assert failing(figure_2.measure(picture, crops, taken.sight)) == set()
    on_lamp = [*crops[:2], dataclasses.replace(crops[0], number=3), *crops[3:]]
    assert {1, 4, 9} <= failing(figure_2.measure(picture, on_lamp, taken.sight))
    at_rim = [*crops[:3], dataclasses.replace(crops[6], number=4), *crops[4:]]
    assert {6, 9} <= failing(figure_2.measure(picture, at_rim, taken.sight))
    reversed_rim = [*crops[:4], crops[6], crops[5], crops[4]]
    assert {8, 9} <= failing(figure_2.measure(picture, reversed_rim, taken.sight))

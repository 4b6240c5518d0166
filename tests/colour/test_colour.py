"""The colour room against colour-science, an independent peer, and what it refuses."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from nacreous import colour as nc
from nacreous.problem import InputError

if TYPE_CHECKING:
    from types import ModuleType

    from colour import RGB_Colourspace, SpectralDistribution, SpectralShape

OBSERVERS = {
    "1931-2": "CIE 1931 2 Degree Standard Observer",
    "1964-10": "CIE 1964 10 Degree Standard Observer",
}


@cache
def peer() -> ModuleType:
    """Imported when it is asked: it takes seconds, and every worker of pytest reads every test."""
    with warnings.catch_warnings():
        # It warns of optional packages (plots, graphs) that it does not find.
        warnings.simplefilter("ignore")
        import colour
    return colour


def grid() -> SpectralShape:
    return peer().SpectralShape(380, 780, 1)


def white_c() -> np.ndarray:
    return peer().xy_to_XYZ(peer().CCS_ILLUMINANTS[OBSERVERS["1931-2"]]["C"])


def rng() -> np.random.Generator:
    return np.random.default_rng(1996)


def peer_spectrum(values: np.ndarray) -> SpectralDistribution:
    return peer().SpectralDistribution(values, grid().wavelengths)


def peer_space(space: str) -> RGB_Colourspace:
    """With the matrices derived from the primaries, not the rounded ones of the standards."""
    found = peer().RGB_COLOURSPACES[{"srgb": "sRGB", "display-p3": "Display P3"}[space]].copy()
    found.use_derived_transformation_matrices(True)
    return found


def relative_to_560_nm(spectrum: SpectralDistribution) -> np.ndarray:
    return np.interp(grid().wavelengths, spectrum.wavelengths, spectrum.values) / spectrum[560]


@pytest.mark.parametrize("name", ["D50", "D65"])
def test_tabulated_illuminants_are_those_of_the_peer(name: str) -> None:
    expected = relative_to_560_nm(peer().SDS_ILLUMINANTS[name])
    np.testing.assert_allclose(nc.illuminant(name), expected, rtol=1e-12)


def test_illuminant_a_is_that_of_the_peer() -> None:
    expected = peer().sd_CIE_standard_illuminant_A(grid())
    np.testing.assert_allclose(nc.illuminant("A"), relative_to_560_nm(expected), rtol=1e-12)


@pytest.mark.parametrize("kelvin", [4000, 5003, 6504, 7000, 7001, 25000])
def test_daylight_of_a_colour_temperature_is_that_of_the_peer(kelvin: int) -> None:
    xy = peer().temperature.CCT_to_xy_CIE_D(float(kelvin))
    expected = peer().sd_CIE_illuminant_D_series(xy, M1_M2_rounding=False)
    np.testing.assert_allclose(nc.illuminant(f"{kelvin}K"), relative_to_560_nm(expected), rtol=1e-9)


@pytest.mark.parametrize("kelvin", [1000, 2700, 3999.5])
def test_planck_below_4000_kelvin_is_that_of_the_peer(kelvin: float) -> None:
    expected = peer().sd_blackbody(kelvin, grid())
    # The peer takes c2 = 1.4388e-2 m K as CIE 015 does.
    np.testing.assert_allclose(nc.illuminant(f"{kelvin}K"), relative_to_560_nm(expected), rtol=1e-9)


@pytest.mark.parametrize("observer", OBSERVERS)
@pytest.mark.parametrize("light", ["A", "D50", "D65", "E", "2700K", "9300K"])
def test_xyz_of_spectra_are_those_of_the_peer(light: str, observer: str) -> None:
    spectra = rng().uniform(0, 1, (2, 3, 401))
    functions = peer().MSDS_CMFS[OBSERVERS[observer]].copy().align(grid())
    expected = [
        [
            peer().colorimetry.sd_to_XYZ_integration(
                peer_spectrum(values), functions, peer_spectrum(nc.illuminant(light))
            )
            / 100
            for values in row
        ]
        for row in spectra
    ]
    np.testing.assert_allclose(nc.xyz_from_spectrum(spectra, light, observer), expected, rtol=1e-12)


def test_a_measured_light_weighs_like_a_named_one() -> None:
    spectra = rng().uniform(0, 1, (4, 401))
    np.testing.assert_allclose(
        nc.xyz_from_spectrum(spectra, 7.5 * nc.illuminant("D50")),
        nc.xyz_from_spectrum(spectra, "D50"),
        rtol=1e-13,
    )


def test_lab_is_that_of_the_peer_and_returns() -> None:
    xyz = rng().uniform(0, 1.2, (500, 3)) ** 3  # many near black, where the line is straight
    white_xy = np.array([0.3457, 0.3585])
    white = peer().xy_to_XYZ(white_xy)
    lab = nc.lab_from_xyz(xyz, white)
    np.testing.assert_allclose(lab, peer().XYZ_to_Lab(xyz, white_xy), atol=1e-9)
    np.testing.assert_allclose(nc.xyz_from_lab(lab, white), xyz, atol=1e-13)


def test_delta_e_2000_is_that_of_the_peer() -> None:
    centre, reach = np.array([50.0, 0, 0]), np.array([50.0, 100, 100])
    first, second = centre + reach * rng().uniform(-1, 1, (2, 5000, 3))
    second[::2] = first[::2] + rng().normal(0, 2, first[::2].shape)  # near pairs as well
    np.testing.assert_allclose(
        nc.delta_e_2000(first, second), peer().delta_E(first, second, method="CIE 2000"), atol=1e-9
    )


def test_delta_e_2000_broadcasts() -> None:
    colours = rng().uniform(0, 50, (2, 5, 3))
    expected = nc.delta_e_2000(colours, np.broadcast_to([50.0, 1.0, 2.0], colours.shape))
    assert expected.shape == (2, 5)
    np.testing.assert_array_equal(nc.delta_e_2000(colours, [50, 1, 2]), expected)


@pytest.mark.parametrize("space", ["srgb", "display-p3"])
def test_rgb_matrices_are_those_of_the_peer(space: str) -> None:
    xyz = rng().uniform(-0.2, 1.5, (100, 3))
    expected = xyz @ peer_space(space).matrix_XYZ_to_RGB.T
    np.testing.assert_allclose(nc.rgb_from_xyz(xyz, space), expected, atol=1e-12)
    np.testing.assert_allclose(nc.xyz_from_rgb(expected, space), xyz, atol=1e-12)


def test_p3_and_srgb_convert_as_in_the_peer() -> None:
    rgb = rng().uniform(0, 1, (100, 3))
    matrix = peer().matrix_RGB_to_RGB(peer_space("srgb"), peer_space("display-p3"), None)
    np.testing.assert_allclose(nc.p3_from_srgb(rgb), rgb @ matrix.T, atol=1e-12)
    np.testing.assert_allclose(nc.srgb_from_p3(nc.p3_from_srgb(rgb)), rgb, atol=1e-13)


def test_transfer_function_is_that_of_the_peer() -> None:
    rgb = np.concatenate([rng().uniform(0, 1.5, (200, 3)), rng().uniform(0, 0.01, (200, 3))])
    encoded = peer().cctf_encoding(rgb, "sRGB")
    np.testing.assert_allclose(nc.encode(rgb), encoded, atol=1e-14)
    np.testing.assert_allclose(
        nc.decode(encoded), peer().cctf_decoding(encoded, "sRGB"), atol=1e-14
    )
    np.testing.assert_array_equal(nc.encode(-rgb), -nc.encode(rgb))


def test_bradford_is_that_of_the_peer() -> None:
    xyz = rng().uniform(0, 1, (100, 3))
    whites = nc.white_xyz("A"), nc.white_xyz("D65")
    matrix = peer().adaptation.matrix_chromatic_adaptation_VonKries(*whites, "Bradford")
    np.testing.assert_allclose(nc.adapt(xyz, *whites), xyz @ matrix.T, atol=1e-12)


def test_hvc_returns_over_the_cube_and_beyond() -> None:
    steps = np.linspace(-0.25, 1.5, 36)
    rgb = np.stack(np.meshgrid(steps, steps, steps), axis=-1)
    hvc = nc.hvc_from_rgb(rgb)
    assert np.isfinite(hvc).all()
    np.testing.assert_allclose(nc.rgb_from_hvc(hvc), rgb, atol=1e-10)


def test_value_is_a_tenth_of_lab_lightness() -> None:
    xyz = rng().uniform(0, 1, (200, 3))
    lightness = peer().XYZ_to_Lab(xyz, peer().XYZ_to_xy(white_c()))[:, 0]
    np.testing.assert_allclose(nc.hvc_from_xyz(xyz)[:, 1], lightness / 10, atol=1e-10)
    np.testing.assert_allclose(nc.xyz_from_hvc(nc.hvc_from_xyz(xyz)), xyz, atol=1e-12)


def test_notation_is_near_that_of_the_peer() -> None:
    # Pearl-like and stronger colours, found in the renotation by the peer's slow search.
    rgb = np.array([[0.8, 0.6, 0.6], [0.4, 0.5, 0.3], [0.3, 0.4, 0.6], [0.6, 0.5, 0.2]])
    xyz = nc.adapt(nc.xyz_from_rgb(rgb), nc.xyz_from_rgb([1, 1, 1]), white_c())
    families = ["R", "YR", "Y", "GY", "G", "BG", "B", "PB", "P", "RP"]
    for colour, ours in zip(xyz, nc.munsell_notation(nc.hvc_from_rgb(rgb)), strict=True):
        theirs = peer().xyY_to_munsell_colour(peer().XYZ_to_xyY(colour))
        steps, values, chromas = [], [], []
        for notation in (str(ours), theirs):
            hue, rest = notation.split()
            family = hue.lstrip("0123456789.")
            steps.append(10 * families.index(family) + float(hue.removesuffix(family)))
            values.append(float(rest.split("/")[0]))
            chromas.append(float(rest.split("/")[1]))
        # The transform itself is off by 8 degrees of hue (2.2 steps of 100) and 0.76 chroma, rms.
        assert abs((steps[0] - steps[1] + 50) % 100 - 50) < 5, (ours, theirs)
        assert abs(values[0] - values[1]) < 0.3, (ours, theirs)
        assert abs(chromas[0] - chromas[1]) < 1, (ours, theirs)


def test_gamut_maps_end_inside_and_the_share_counts_what_was_outside() -> None:
    rgb = rng().uniform(-0.5, 1.5, (10, 10, 3))
    outside = ((rgb < 0) | (rgb > 1)).any(axis=-1).mean()
    assert nc.out_of_gamut_share(rgb) == pytest.approx(outside)
    for method in ("clip", "soft"):
        mapped = nc.map_to_gamut(rgb, method)
        assert mapped.shape == rgb.shape
        assert nc.out_of_gamut_share(mapped) == 0
    np.testing.assert_array_equal(nc.map_to_gamut(rgb), np.clip(rgb, 0, 1))


def test_any_memory_layout_gives_the_same_colours() -> None:
    rgb = rng().uniform(0, 1, (6, 4, 3))
    expected = nc.hvc_from_rgb(rgb)
    np.testing.assert_array_equal(nc.hvc_from_rgb(np.asfortranarray(rgb)), expected)
    np.testing.assert_array_equal(nc.hvc_from_rgb(rgb[::-1])[::-1], expected)
    np.testing.assert_array_equal(nc.hvc_from_rgb(rgb.tolist()), expected)
    assert nc.hvc_from_rgb(np.empty((0, 3))).shape == (0, 3)


NAN_AT_1_2 = np.array([[0.5, 0.5, 0.5], [0.5, 0.5, np.nan]])
ONE = [1.0, 1.0, 1.0]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda: nc.illuminant("F13"),
            'illuminant is "F13"; allowed: A, C, D50, D55, D65, D75, E,',
        ),
        (lambda: nc.illuminant("900K"), "colour temperature is 900.0 K; allowed: 1000 to 25000 K"),
        (lambda: nc.encode(NAN_AT_1_2), "rgb[1, 2] is NaN; allowed: -1e12 to 1e12"),
        (lambda: nc.encode([[1.0, -np.inf, 0.0]]), "rgb[0, 1] is -inf; allowed: -1e12 to 1e12"),
        (lambda: nc.encode([1.0, 2.0]), "rgb has shape [2]; allowed: [..., 3]"),
        (lambda: nc.encode(0.5), "rgb has shape []; allowed: [..., 3]"),
        (lambda: nc.encode("red"), "rgb has type <U3; allowed: an array of real numbers"),
        (lambda: nc.encode([[1.0], [1.0, 2.0]]), "rgb is ragged; allowed: an array of numbers"),
        (
            lambda: nc.xyz_from_spectrum(np.full(401, -0.5)),
            "spectra[0] is -0.5; allowed: 0 to 1e12",
        ),
        (
            lambda: nc.xyz_from_spectrum(np.ones(400)),
            "spectra has shape [400]; allowed: [..., 401]",
        ),
        (
            lambda: nc.xyz_from_spectrum(np.ones(401), np.zeros(401)),
            "illuminant has luminance 0; allowed: above 0",
        ),
        (
            lambda: nc.xyz_from_spectrum(np.ones(401), np.ones((2, 401))),
            "illuminant has shape [2, 401]; allowed: [401]",
        ),
        (
            lambda: nc.xyz_from_spectrum(np.ones(401), "E", "1931"),
            'observer is "1931"; allowed: 1931-2, 1964-10',
        ),
        (
            lambda: nc.lab_from_xyz(ONE, [1, 0, 1]),
            "white is [1.0, 0.0, 1.0]; allowed: 1e-6 to 1e12 each",
        ),
        (lambda: nc.lab_from_xyz(ONE, 1.0), "white has shape []; allowed: [3]"),
        (
            lambda: nc.adapt(ONE, [0.34, 0.04, 1.77], ONE),
            "white XYZ is [0.34, 0.04, 1.77]; allowed: a light that all three cones see",
        ),
        (
            lambda: nc.delta_e_2000(np.ones((2, 3)), np.ones((3, 3))),
            "first and second have shapes [2, 3] and [3, 3]; allowed: equal shapes",
        ),
        (lambda: nc.rgb_from_xyz(ONE, "p3"), 'RGB space is "p3"; allowed: srgb, display-p3'),
        (lambda: nc.map_to_gamut(ONE, "hard"), 'gamut is "hard"; allowed: clip, soft'),
        (
            lambda: nc.rgb_from_hvc([[0.0, 5.0, -1.0]]),
            "hvc[0, 2] (chroma) is -1.0; allowed: 0 or more",
        ),
    ],
)
def test_the_door_refuses_with_one_line(call: Callable[[], object], message: str) -> None:
    with pytest.raises(InputError) as refusal:
        call()
    assert str(refusal.value).startswith(message)
    assert "\n" not in str(refusal.value)

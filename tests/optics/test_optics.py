"""Fresnel's equations against closed forms and a peer; the model of 1996 against its words."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import nacreous as nc
from nacreous.optics import Fresnel, fresnel, illuminant
from tests.optics.refusal import refusal

AIR, ARAGONITE, PROTEIN = 1.0, 1.53, 1.43


# --- one boundary: against the peer


class Case(NamedTuple):
    """One line of the peer's table."""

    name: str
    polarisation: str
    wavelength_nm: float
    incidence_rad: float
    R: float
    T: float
    n: list[complex]
    d_nm: list[float]


def peer() -> list[Case]:
    with (Path(__file__).parent.parent / "golden" / "tmm_reference.csv").open(newline="") as file:
        return [
            Case(
                row["case"],
                row["polarisation"],
                float(row["wavelength_nm"]),
                math.radians(float(row["incidence_deg"])),
                float(row["R"]),
                float(row["T"]),
                [complex(n) for n in row["n_front_to_back"].split(";")],
                [float(d) for d in row["d_nm_front_to_back"].split(";")],
            )
            for row in csv.DictReader(file)
        ]


def cases(*names: str) -> list[Any]:
    found = [case for case in peer() if case.name in names]
    return [
        pytest.param(
            case,
            id=f"{case.name}-{case.polarisation}-{case.wavelength_nm}-{case.incidence_rad:.2f}",
        )
        for case in found
    ]


def test_the_peer_has_all_its_cases() -> None:
    assert len(peer()) == 144


@pytest.mark.parametrize("case", cases("bare_aragonite"))
def test_a_bare_boundary_agrees_with_the_peer(case: Case) -> None:
    boundary = fresnel(*case.n, case.incidence_rad)
    assert getattr(boundary, f"R_{case.polarisation}") == pytest.approx(case.R, abs=1e-12)
    assert getattr(boundary, f"T_{case.polarisation}") == pytest.approx(case.T, abs=1e-12)


def reflected_amplitude(case: Case) -> complex:
    """Our single boundaries put together by Airy's sum, from the substrate upward."""
    across = case.n[0].real * math.sin(case.incidence_rad)
    amplitude = 0j
    for n, below, d_nm in reversed(list(zip(case.n, case.n[1:], case.d_nm, strict=False))):
        inside_rad = math.asin(across / n.real)
        r = complex(getattr(fresnel(n, below, inside_rad), f"r_{case.polarisation}"))
        amplitude = (r + amplitude) / (1 + r * amplitude)
        if math.isfinite(d_nm):
            turns = 2 * n.real * d_nm * math.cos(inside_rad) / case.wavelength_nm
            amplitude *= np.exp(2j * np.pi * turns)
    return amplitude


@pytest.mark.parametrize("case", cases("one_bilayer", "six_bilayers", "on_metal"))
def test_amplitudes_add_up_to_the_peers_stacks(case: Case) -> None:
    """Signs and phases: lossless layers on aragonite and, absorbing and oblique, on metal."""
    assert abs(reflected_amplitude(case)) ** 2 == pytest.approx(case.R, abs=1e-12)


# --- one boundary: against closed forms


def test_figure_8_of_the_paper() -> None:
    """From aragonite to air: R1 = 0.0439 head on, and 1 at the grazing ray, theta_1 = 40.8 deg."""
    assert float(fresnel(ARAGONITE, AIR, 0.0).R) == pytest.approx(0.0439, abs=5e-5)
    theta_1 = math.asin(1 / ARAGONITE)
    assert math.degrees(theta_1) == pytest.approx(40.8, abs=0.05)
    assert float(fresnel(ARAGONITE, AIR, theta_1).R) == pytest.approx(1.0, abs=1e-6)
    rising = fresnel(ARAGONITE, AIR, np.arcsin(np.sin(np.linspace(0, np.pi / 2, 91)) / 1.53)).R
    assert np.all(np.diff(rising) >= -1e-4)  # flat near 0, where s and p cancel
    assert np.all(np.diff(rising[30:]) > 0)


def test_head_on_both_polarisations_reflect_alike() -> None:
    boundary = fresnel(AIR, 1.5 + 2j, 0.0)
    n = 1.5 + 2j
    assert boundary.r_s == pytest.approx((1 - n) / (1 + n), rel=1e-14)
    assert boundary.r_p == pytest.approx((1 - n) / (1 + n), rel=1e-14)
    assert boundary.t_s == pytest.approx(2 / (1 + n), rel=1e-14)
    assert boundary.t_p == pytest.approx(2 / (1 + n), rel=1e-14)


def test_nothing_is_reflected_in_p_at_brewsters_angle() -> None:
    boundary = fresnel(AIR, ARAGONITE, math.atan(ARAGONITE / AIR))
    assert abs(boundary.r_p) < 1e-15
    assert float(boundary.R_s) == pytest.approx(((1.53**2 - 1) / (1.53**2 + 1)) ** 2, rel=1e-13)


def test_angles_of_stokes_and_snell() -> None:
    """Sine and tangent law: r_s = -sin(i-t)/sin(i+t), and tan(i-t)/tan(i+t) is -r_p here."""
    i = np.linspace(0.05, 1.5, 40)
    t = np.arcsin(np.sin(i) / ARAGONITE)
    boundary = fresnel(AIR, ARAGONITE, i)
    np.testing.assert_allclose(boundary.r_s, -np.sin(i - t) / np.sin(i + t), rtol=0, atol=1e-14)
    np.testing.assert_allclose(boundary.r_p, -np.tan(i - t) / np.tan(i + t), rtol=0, atol=1e-13)
    np.testing.assert_allclose(boundary.t_s, 1 + boundary.r_s, rtol=0, atol=1e-14)
    back = fresnel(ARAGONITE, AIR, t)
    np.testing.assert_allclose(back.r_s, -boundary.r_s, rtol=0, atol=1e-13)
    np.testing.assert_allclose(back.r_p, -boundary.r_p, rtol=0, atol=1e-13)
    np.testing.assert_allclose(1 - boundary.r_p**2, boundary.t_p * back.t_p, rtol=0, atol=1e-13)


def test_total_reflection_has_fresnels_phases() -> None:
    """tan(phase/2) = sqrt(sin^2 - n^2) / cos in s, and that over n^2 in p (Born and Wolf 1.5.4)."""
    angle = np.linspace(math.asin(1 / 1.53) + 1e-3, 1.57, 50)
    boundary = fresnel(ARAGONITE, AIR, angle)
    n = AIR / ARAGONITE
    tangent = np.sqrt(np.sin(angle) ** 2 - n**2) / np.cos(angle)
    for r, expected in ((boundary.r_s, tangent), (-boundary.r_p, tangent / n**2)):
        np.testing.assert_allclose(np.abs(r), 1, rtol=0, atol=1e-14)
        np.testing.assert_allclose(r, np.exp(-2j * np.arctan(expected)), rtol=0, atol=1e-11)
    for T in (boundary.T_s, boundary.T_p):
        np.testing.assert_allclose(T, 0, rtol=0, atol=1e-14)


def test_a_metal_seen_obliquely_has_the_textbook_reflectance() -> None:
    """Born and Wolf 14.2: 2a^2, 2b^2 = sqrt((n^2-k^2-sin^2)^2 + 4n^2k^2) +- (n^2-k^2-sin^2)."""
    n, k = 0.5, 3.5
    angle = np.linspace(0, 1.5, 31)
    sin2, cos = np.sin(angle) ** 2, np.cos(angle)
    difference = n**2 - k**2 - sin2
    root = np.sqrt(difference**2 + 4 * n**2 * k**2)
    a, b2 = np.sqrt((root + difference) / 2), (root - difference) / 2
    R_s = ((a - cos) ** 2 + b2) / ((a + cos) ** 2 + b2)
    beyond = np.sin(angle) * np.tan(angle)
    R_p = R_s * ((a - beyond) ** 2 + b2) / ((a + beyond) ** 2 + b2)
    boundary = fresnel(AIR, complex(n, k), angle)
    np.testing.assert_allclose(boundary.R_s, R_s, rtol=1e-12)
    np.testing.assert_allclose(boundary.R_p, R_p, rtol=1e-12)


_N = st.floats(0.1, 10)
_ANGLE = st.floats(0, math.pi / 2)


@settings(max_examples=200, deadline=None)
@given(n_i=_N, n_t=_N, k_t=st.one_of(st.just(0.0), st.floats(0, 10)), angle_rad=_ANGLE)
def test_r_plus_t_is_one_when_the_light_comes_from_a_lossless_medium(
    n_i: float, n_t: float, k_t: float, angle_rad: float
) -> None:
    boundary = fresnel(n_i, complex(n_t, k_t), angle_rad)
    for R, T in ((boundary.R_s, boundary.T_s), (boundary.R_p, boundary.T_p)):
        assert float(R + T) == pytest.approx(1.0, abs=1e-9)
        assert -1e-12 <= R <= 1 + 1e-12
    assert float(boundary.R + boundary.T) == pytest.approx(1.0, abs=1e-9)


@settings(max_examples=100, deadline=None)
@given(n_i=_N, k_i=st.floats(0, 10), n_t=_N, k_t=st.floats(0, 10), angle_rad=_ANGLE)
def test_no_medium_and_no_angle_gives_nan(
    n_i: float, k_i: float, n_t: float, k_t: float, angle_rad: float
) -> None:
    boundary = fresnel(complex(n_i, k_i), complex(n_t, k_t), angle_rad)
    for name in Fresnel.__dataclass_fields__:
        assert np.isfinite(getattr(boundary, name))


@pytest.mark.parametrize("shape", [(), (1,), (5,), (2, 3), (0,), (2, 0, 3)])
def test_the_answer_has_the_shape_of_the_angle(shape: tuple[int, ...]) -> None:
    angle = np.linspace(0, 1.5, math.prod(shape)).reshape(shape)
    boundary = fresnel(AIR, ARAGONITE, angle)
    for name in (*Fresnel.__dataclass_fields__, "R", "T"):
        assert np.shape(getattr(boundary, name)) == shape
    flat = fresnel(AIR, ARAGONITE, angle.ravel())
    np.testing.assert_array_equal(np.ravel(boundary.R), flat.R)


def test_strided_and_whole_numbers_are_angles_too() -> None:
    angle = np.linspace(0, 1.5, 20).reshape(4, 5)
    turned = fresnel(AIR, ARAGONITE, angle.T[::-1, ::2]).R
    np.testing.assert_array_equal(turned, fresnel(AIR, ARAGONITE, angle).R.T[::-1, ::2])
    assert fresnel(AIR, ARAGONITE, 1).R == fresnel(AIR, ARAGONITE, 1.0).R


@pytest.mark.parametrize(
    ("n_i", "n_t", "angle_rad", "message"),
    [
        (0, 1.5, 0.0, "n_i: n is 0; allowed: above 0, up to 100"),
        (1, -1.5, 0.0, "n_t: n is -1.5; allowed: above 0, up to 100"),
        (1, 1.5 - 1j, 0.0, "n_t: k is -1; allowed: 0 to 100"),
        (1, math.nan, 0.0, "n_t: n is NaN; allowed: above 0, up to 100"),
        (math.inf, 1.5, 0.0, "n_i: n is inf; allowed: above 0, up to 100"),
        ("air", 1.5, 0.0, "n_i is 'air'; allowed: a number n or a complex number n + ik"),
        (1, None, 0.0, "n_t is None; allowed: a number n or a complex number n + ik"),
        (1, 1.5, -0.1, "angle_rad is -0.1; allowed: 0 to pi/2"),
        (1, 1.5, 90.0, "angle_rad is 90; allowed: 0 to pi/2"),
        (1, 1.5, [0.0, math.nan], "angle_rad is NaN; allowed: 0 to pi/2"),
        (1, 1.5, "steep", "angle_rad is 'steep'; allowed: numbers"),
        (1, 1.5, [[0.1], [0.2, 0.3]], "angle_rad is [[0.1], [0.2, 0.3]]; allowed: numbers"),
        (1, 1.5, 0.1j, "angle_rad is 0.1j; allowed: numbers"),
    ],
)
def test_fresnel_says_what_is_wrong(n_i: Any, n_t: Any, angle_rad: Any, message: str) -> None:
    assert refusal(lambda: fresnel(n_i, n_t, angle_rad)) == message


# --- the illuminant model, read a second time


def by_the_book(
    stack: nc.LayerStack,
    theta_0: float,
    wavelength_nm: float,
    coherence_nm: float,
    threshold: float,
    diffuse_loss: float,
) -> float:
    """Paper 3.1 to 3.2.4, in the paper's order, every window summed wave by wave."""
    n0, n1, n2 = (complex(n).real for n in (stack.ambient, stack.aragonite, stack.protein))
    d, d_p = stack.thickness_nm, stack.protein_nm
    # Snell; then equations (1) and (2) by the sine and tangent laws' cousins in cosines.
    c0 = math.cos(theta_0)
    c1 = math.sqrt(1 - (n0 * math.sin(theta_0) / n1) ** 2)
    c2 = math.sqrt(1 - (n0 * math.sin(theta_0) / n2) ** 2)
    R1_s = ((n1 * c1 - n0 * c0) / (n1 * c1 + n0 * c0)) ** 2
    R1_p = ((n1 * c0 - n0 * c1) / (n1 * c0 + n0 * c1)) ** 2
    T1 = 1 - (R1_s + R1_p) / 2
    r2 = [(n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2), (n1 * c2 - n2 * c1) / (n1 * c2 + n2 * c1)]
    delta = 4 * math.pi * n2 * d_p * c2 / wavelength_nm
    intensity = 0.0
    for r in r2:
        a = r - r * np.exp(1j * delta)
        light = 1.0
        for first in range(len(d)):
            wave, path_nm = a, 0.0
            for layer in range(first + 1, len(d)):
                path_nm += 2 * n1 * c1 * d[layer]
                if path_nm >= coherence_nm:
                    break
                wave = wave + a * np.exp(2j * math.pi * path_nm / wavelength_nm)
            intensity += light * abs(wave) ** 2
            light *= max(0.0, 1 - abs(a) ** 2 - diffuse_loss) ** 2
            if light < threshold:
                break
    return T1 * intensity / 2


VIEWS = np.array([0.0, 0.3, 0.9, 1.4, 1.55])
LIGHTS = np.array([380.0, 440.0, 511.1, 633.0, 780.0])


def assert_is_the_book(stack: nc.LayerStack, *model: float) -> None:
    expected = [[by_the_book(stack, view, light, *model) for light in LIGHTS] for view in VIEWS]
    table = illuminant(stack, VIEWS, LIGHTS, *model)
    np.testing.assert_allclose(table, expected, rtol=1e-10, atol=1e-10 * np.max(expected) + 1e-25)


@settings(max_examples=30, deadline=None)
@given(
    thickness_nm=st.lists(st.floats(50, 900), min_size=1, max_size=30),
    protein_nm=st.floats(0, 60),
    aragonite=st.floats(1.2, 2.0),
    protein=st.floats(1.05, 1.8),
    # No round numbers: at a tie a last bit decides whether one more layer belongs to a window.
    coherence_nm=st.sampled_from([0.0, 1000.37, 5000.13, 1e6]),
    threshold=st.sampled_from([0.0, 0.05, 0.5, 1.0]),
    diffuse_loss=st.sampled_from([0.0, 0.01, 0.2, 1.0]),
)
def test_the_model_is_the_papers_word_for_word(
    thickness_nm: list[float],
    protein_nm: float,
    aragonite: float,
    protein: float,
    coherence_nm: float,
    threshold: float,
    diffuse_loss: float,
) -> None:
    stack = nc.LayerStack(thickness_nm, protein_nm, aragonite, protein)
    assert_is_the_book(stack, coherence_nm, threshold, diffuse_loss)


def test_the_papers_pearl_is_the_papers_word_for_word() -> None:
    """The whole season: windows of four layers out of hundreds, and more wavelengths than lanes."""
    stack = nc.grow("paper", seed=7)
    assert_is_the_book(stack, 5000.0, 0.05, 0.02)
    many_nm = np.linspace(380, 780, 37)
    together = illuminant(stack, VIEWS, many_nm)
    alone = np.hstack([illuminant(stack, VIEWS, [light]) for light in many_nm])
    np.testing.assert_array_equal(together, alone)


@pytest.mark.parametrize("view_rad", VIEWS)
@pytest.mark.parametrize("coherence_nm", [1.0, 2500.0, 5000.0, 20_000.0])
def test_one_window_of_equal_layers_is_a_finite_sum_in_closed_form(
    view_rad: float, coherence_nm: float
) -> None:
    """|a|^2 sin^2(m xi / 2) / sin^2(xi / 2); threshold 1 ends after the first start layer."""
    stack = nc.LayerStack([410.0] * 60)
    c0 = math.cos(view_rad)
    c1, c2 = (math.sqrt(1 - (math.sin(view_rad) / n) ** 2) for n in (ARAGONITE, PROTEIN))
    step_nm = 2 * ARAGONITE * c1 * 410.0
    m = min(60, math.ceil(coherence_nm / step_nm))
    half_xi = math.pi * step_nm / LIGHTS
    r_s = (ARAGONITE * c1 - PROTEIN * c2) / (ARAGONITE * c1 + PROTEIN * c2)
    r_p = (ARAGONITE * c2 - PROTEIN * c1) / (ARAGONITE * c2 + PROTEIN * c1)
    a2 = 2 * (r_s**2 + r_p**2) * np.sin(2 * math.pi * PROTEIN * 20.0 * c2 / LIGHTS) ** 2
    T_s = 4 * ARAGONITE * c1 * c0 / (ARAGONITE * c1 + c0) ** 2
    T_p = 4 * ARAGONITE * c1 * c0 / (ARAGONITE * c0 + c1) ** 2
    expected = (T_s + T_p) / 2 * a2 * (np.sin(m * half_xi) / np.sin(half_xi)) ** 2
    table = illuminant(stack, [view_rad], LIGHTS, coherence_nm, threshold=1.0)
    np.testing.assert_allclose(table[0], expected, rtol=1e-9, atol=1e-13)


def test_zero_coherence_gives_no_fringes() -> None:
    """Without interference thicknesses do not matter, and the spectrum falls without a turn."""
    wavelength_nm = np.arange(380.0, 781.0)

    def spectra(stack: nc.LayerStack, coherence_nm: float) -> NDArray[np.float64]:
        return illuminant(stack, VIEWS[:4], wavelength_nm, coherence_nm, threshold=0.0)

    thin, thick = (nc.LayerStack([nm] * 40) for nm in (350.0, 620.0))
    np.testing.assert_allclose(spectra(thin, 0.0), spectra(thick, 0.0), rtol=1e-13)
    assert np.all(np.diff(spectra(thin, 0.0), axis=1) < 0)
    turns = np.diff(np.sign(np.diff(spectra(thin, 5000.0), axis=1)), axis=1)
    assert np.all((turns != 0).sum(axis=1) > 3)


def test_coherence_beyond_the_nacre_changes_nothing() -> None:
    stack = nc.LayerStack([400.0] * 20)
    np.testing.assert_array_equal(
        illuminant(stack, VIEWS, LIGHTS, 1e5), illuminant(stack, VIEWS, LIGHTS, 1e9)
    )


def test_nothing_is_seen_at_grazing() -> None:
    head_on, grazing = illuminant(nc.LayerStack([400.0] * 20), [0.0, math.pi / 2], LIGHTS)
    assert np.all(grazing < 1e-6 * head_on)


@pytest.mark.parametrize("n", [AIR, ARAGONITE])
def test_matched_indices_show_nothing(n: float) -> None:
    stack = nc.LayerStack([400.0] * 20, aragonite=n, protein=n)
    views = [*VIEWS, math.pi / 2]
    assert np.all(np.abs(illuminant(stack, views, LIGHTS)) < 1e-25)


@pytest.mark.parametrize("n", [AIR, PROTEIN])
def test_nacre_no_denser_than_air_is_finite_up_to_grazing(n: float) -> None:
    stack = nc.LayerStack([400.0] * 20, aragonite=n, protein=AIR)
    table = illuminant(stack, np.linspace(0, math.pi / 2, 19), LIGHTS)
    assert np.all(np.isfinite(table))
    assert np.all(table >= 0)


def test_all_that_is_allowed_is_finite() -> None:
    stack = nc.LayerStack([1e-3, 1e6] * 20, protein_nm=1e6, aragonite=100, protein=1, ambient=1)
    for coherence_nm in (0.0, 1e9):
        table = illuminant(stack, VIEWS, [1.0, 1e6], coherence_nm, threshold=0.0)
        assert np.all(np.isfinite(table))
        assert np.all(table >= 0)


@pytest.mark.parametrize(
    ("views", "lights", "shape"),
    [
        (0.5, 500, (1, 1)),
        ([0.5], [500, 600], (1, 2)),
        ([], [500], (0, 1)),
        ([0.1, 0.2], [], (2, 0)),
    ],
)
def test_the_table_has_a_row_for_each_angle(views: Any, lights: Any, shape: Any) -> None:
    assert illuminant(nc.LayerStack([400.0]), views, lights).shape == shape


STACK = nc.LayerStack([400.0])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"stack": [400.0]}, "stack is [400.0]; allowed: a LayerStack"),
        ({"angle_rad": 1.6}, "angle_rad is 1.6; allowed: 0 to pi/2"),
        ({"angle_rad": [0.0, -0.1]}, "angle_rad is -0.1; allowed: 0 to pi/2"),
        ({"angle_rad": math.nan}, "angle_rad is NaN; allowed: 0 to pi/2"),
        ({"angle_rad": [[0.0]]}, "angle_rad has 2 dimensions; allowed: 1"),
        ({"angle_rad": "steep"}, "angle_rad is 'steep'; allowed: numbers"),
        ({"wavelength_nm": 0.5}, "wavelength_nm is 0.5; allowed: 1 to 1000000 nm"),
        ({"wavelength_nm": math.inf}, "wavelength_nm is inf; allowed: 1 to 1000000 nm"),
        ({"wavelength_nm": None}, "wavelength_nm is None; allowed: numbers"),
        ({"coherence_nm": -1}, "coherence_nm is -1; allowed: 0 to 1e9 nm"),
        ({"coherence_nm": math.nan}, "coherence_nm is NaN; allowed: 0 to 1e9 nm"),
        ({"coherence_nm": "5000"}, "coherence_nm is '5000'; allowed: a number"),
        ({"threshold": 1.5}, "threshold is 1.5; allowed: 0 to 1"),
        ({"diffuse_loss": -0.1}, "diffuse_loss is -0.1; allowed: 0 to 1"),
        ({"diffuse_loss": None}, "diffuse_loss is None; allowed: a number"),
        (
            {"angle_rad": np.zeros(40_000), "wavelength_nm": np.full(40_000, 500.0)},
            "the table has 40000 x 40000 values; allowed: up to 134217728",
        ),
    ],
    ids=lambda case: str(case)[:50],
)
def test_the_model_says_what_is_wrong(given: dict[str, Any], message: str) -> None:
    arguments = {"stack": STACK, "angle_rad": 0.5, "wavelength_nm": 500.0, **given}
    assert refusal(lambda: illuminant(**arguments)) == message


@pytest.mark.parametrize(
    ("media", "words"),
    [
        ({"aragonite": 1.53 + 0.1j}, ["aragonite", "0.1"]),
        ({"protein": 1.43 + 0.1j}, ["protein", "0.1"]),
        ({"ambient": 1 + 0.1j}, ["ambient", "0.1"]),
        ({"ambient": 1.5}, ["protein", "1.43", "1.5"]),
        ({"ambient": 1.6}, ["aragonite", "1.53", "1.6"]),
    ],
)
def test_media_that_the_model_has_no_answer_for_are_named(
    media: dict[str, complex], words: list[str]
) -> None:
    message = refusal(lambda: illuminant(nc.LayerStack([400.0], **media), 0.5, 500.0))
    assert all(word in message for word in words)

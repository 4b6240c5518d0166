"""Apertures, hemispheres and ensembles of given layers, against closed forms and quadrature."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy import integrate

import nacreous as nc
from nacreous.optics import columns, energies, ensemble, fresnel, over_aperture, over_hemisphere

NM = np.array([450.0, 550.0])
NACRE = nc.LayerStack([380.0, 402.0, 391.0, 377.0], 20.0, (1.683, 1.53), 1.43 + 0.01j)


def test_diffuse_light_on_glass_has_the_published_reflectance() -> None:
    """n = 1.5: 0.0918 (Judd 1942, table I), Walsh's closed form (1926) at other indices."""
    for n in (1.33, 1.5, 1.8):
        glass = nc.LayerStack([100.0], 0.0, n, substrate=n)
        n2 = n * n
        walsh = (
            0.5
            + (n - 1) * (3 * n + 1) / (6 * (n + 1) ** 2)
            + n2 * (n2 - 1) ** 2 / (n2 + 1) ** 3 * math.log((n - 1) / (n + 1))
            - 2 * n**3 * (n2 + 2 * n - 1) / ((n2 + 1) * (n2 * n2 - 1))
            + 8 * n2 * n2 * (n2 * n2 + 1) / ((n2 + 1) * (n2 * n2 - 1) ** 2) * math.log(n)
        )
        assert over_hemisphere(glass, 550.0).R[0, 0] == pytest.approx(walsh, abs=1e-6)
        if n == 1.5:
            assert walsh == pytest.approx(0.0918, abs=5e-5)


def test_a_hemisphere_is_lamberts_integral() -> None:
    def at(angle: float) -> float:
        return 2 * math.sin(angle) * math.cos(angle) * float(energies(NACRE, angle, 550.0).R[0, 0])

    expected = integrate.quad(at, 0, math.pi / 2, epsabs=1e-9)[0]
    assert over_hemisphere(NACRE, NM).R[0, 1] == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize(("axis", "half"), [(0.0, 0.3), (0.5, 0.2), (1.2, 0.3)])
def test_an_aperture_is_the_mean_over_its_directions(axis: float, half: float) -> None:
    """Independent: many random directions of the cone, drawn evenly over the solid angle."""
    random = np.random.default_rng(1)
    cosine = 1 - random.uniform(0, 1, 40000) * (1 - math.cos(half))
    around = random.uniform(0, 2 * math.pi, cosine.size)
    sine = np.sqrt(1 - cosine**2)
    tilted = cosine * math.cos(axis) + sine * np.cos(around) * math.sin(axis)
    R = energies(NACRE, np.arccos(np.clip(tilted, 0, 1)), 550.0).R[:, 0]
    found = over_aperture(NACRE, axis, half, NM).R[0, 1]
    assert abs(found - R.mean()) < 4.5 * R.std() / math.sqrt(R.size)


@pytest.mark.parametrize(
    ("stack", "axis", "half", "polarisation", "expected"),
    [
        # 512 x 128 directions of Gauss's rule, at which another doubling moves less than 1e-7.
        (
            nc.LayerStack([421.079, 363.811, 137.205], 380.8117074904739, 1.0, 2.4, 1.8, 1.0),
            0.19539477829203383,
            0.2139152349007004,
            "unpolarised",
            0.5459617,
        ),
        # Beyond the critical angle of the gap; a one-dimensional quadrature.
        (nc.LayerStack([300.0], 0.0, 1.0, 1.5, 1.8, 1.8), 0.3, 0.6, "p", 0.3043574),
    ],
)
def test_light_caught_between_layers_is_no_false_convergence(
    stack: nc.LayerStack, axis: float, half: float, polarisation: str, expected: float
) -> None:
    found = over_aperture(stack, axis, half, 550.0, polarisation).R[0, 0]
    assert found == pytest.approx(expected, abs=1e-6)


def test_total_reflection_guided_light_and_a_plates_fringes_are_resolved() -> None:
    angle = np.linspace(0, math.pi / 2, 800_001)
    weight = np.sin(2 * angle)
    for stack, error in (
        # Guided in the middle: of its lines one is 1e-6 rad wide, and may be missed.
        (nc.LayerStack([600.0, 600.0], [500.0, 0.0], 1.0, 2.2, 1.8, 1.8), 1e-5),
        (nc.LayerStack([1.0], 0.0, 1.0, 1.0, 1.5, 1.0), 1e-6),  # total reflection, a kink
        (nc.LayerStack([20000.0], 0.0, 1.53, substrate=1.0), 1e-6),  # 110 fringes
    ):
        fine = integrate.simpson(weight * energies(stack, angle, 550.0).R[:, 0], x=angle)
        assert over_hemisphere(stack, 550.0).R[0, 0] == pytest.approx(fine, abs=error)


def test_a_closed_aperture_is_the_plane_wave_and_energy_is_kept() -> None:
    closed, wave = over_aperture(NACRE, [0.0, 0.7], 0.0, NM), energies(NACRE, [0.0, 0.7], NM)
    np.testing.assert_allclose(closed.R, wave.R, rtol=0, atol=1e-14)
    for light in (over_aperture(NACRE, [0.0, 0.7], 0.4, NM, "p"), over_hemisphere(NACRE, NM)):
        np.testing.assert_allclose(light.R + light.T + light.A, 1, rtol=0, atol=1e-12)
    half_sphere = over_aperture(
        nc.LayerStack([1.0], 0.0, 1.5, substrate=1.5), 0.0, math.pi / 2, 550.0
    )
    angle = np.linspace(0, math.pi / 2, 20001)
    even = integrate.simpson(np.sin(angle) * fresnel(1.0, 1.5, angle).R, x=angle)
    assert half_sphere.R[0, 0] == pytest.approx(even, abs=1e-6)


@pytest.mark.parametrize("axis", [0.0, 0.7])
def test_a_cone_that_closes_becomes_the_plane_wave(axis: float) -> None:
    plate = nc.LayerStack([20000.0], 0.0, 1.53, substrate=1.0)
    wave = energies(plate, axis, NM).R
    for half in (1e-17, 1e-9, 1e-8, 1.001e-7, 1e-6, 1e-5):
        np.testing.assert_allclose(over_aperture(plate, axis, half, NM).R, wave, rtol=0, atol=1e-7)


def test_each_cone_and_wavelength_is_what_it_is_alone() -> None:
    """Cones that hold the normal and those that do not, each halved where it needs to be."""
    axes = np.array([0.0, 0.1, 0.3, 0.30001, 0.9, math.pi / 2 - 0.3])
    together = over_aperture(NACRE, axes, 0.3, 550.0)
    for axis, R, A in zip(axes, together.R, together.A, strict=True):
        alone = over_aperture(NACRE, axis, 0.3, 550.0)
        np.testing.assert_allclose([alone.R[0], alone.A[0]], [R, A], rtol=0, atol=1e-14)
    both = over_aperture(NACRE, axes, 0.3, NM)
    np.testing.assert_allclose(both.R[:, 1:], together.R, rtol=0, atol=2e-7)
    assert over_aperture(NACRE, [], 0.3, NM).R.shape == (0, 2)
    assert over_aperture(NACRE, axes, 0.3, []).R.shape == (6, 0)
    assert over_hemisphere(NACRE, []).R.shape == (1, 0)


# --- ensembles of stacks that are given


def test_an_ensemble_of_sections_is_their_mean() -> None:
    random = np.random.default_rng(4)
    sections = [nc.LayerStack(random.normal(390, 15, n)) for n in (30, 25, 41)]
    alone = np.stack([energies(stack, [0.0, 0.6], NM).R for stack in sections])
    together = ensemble(sections, [0.0, 0.6], NM)
    assert together.columns == 3
    np.testing.assert_allclose(together.R, alone.mean(axis=0), rtol=0, atol=1e-13)
    np.testing.assert_allclose(together.R_spread, alone.std(axis=0, ddof=1), rtol=0, atol=1e-12)
    uneven = [nc.LayerStack([390.0, 401.0], [10.0, p], cover=[(1.33, 200.0)]) for p in (20.0, 30.0)]
    alone = np.stack([energies(stack, 0.0, NM).R for stack in uneven])
    np.testing.assert_allclose(ensemble(uneven, 0.0, NM).R, alone.mean(axis=0), rtol=0, atol=1e-13)


def test_layers_by_numbers_have_the_mean_spread_and_correlation_asked_for() -> None:
    make = columns._grown((400.0, 20.0, 2000, 0.6), None)
    nm = np.stack([make(seed).thickness_nm for seed in range(30)])
    assert nm.mean() == pytest.approx(400, abs=1)
    assert nm.std() == pytest.approx(20, abs=0.5)
    assert np.corrcoef(nm[:, :-1].ravel(), nm[:, 1:].ravel())[0, 1] == pytest.approx(0.6, abs=0.02)
    assert np.corrcoef(nm[:, :-2].ravel(), nm[:, 2:].ravel())[0, 1] == pytest.approx(0.36, abs=0.03)
    assert nm[:, 0].std() == pytest.approx(20, rel=0.4)
    assert np.array_equal(make(3).thickness_nm, make(3).thickness_nm)


def test_an_ensemble_by_numbers_takes_its_media_from_a_stack() -> None:
    like = nc.LayerStack([1.0], 25.0, "aragonite", "chitin", 1.33)
    numbers = (390.0, 15.0, 40, 0.3)
    wet = ensemble(numbers, 0.0, NM, columns=12, seed=5, like=like)
    assert wet == ensemble(numbers, 0.0, NM, columns=12, seed=5, like=like)
    assert wet != ensemble(numbers, 0.0, NM, columns=12, seed=5)
    still = ensemble((390.0, 0.0, 40, 0.0), 0.0, NM, columns=2)
    np.testing.assert_allclose(
        still.R, energies(nc.LayerStack([390.0] * 40), 0.0, NM).R, atol=1e-13
    )
    known = ensemble(numbers, 0.0, NM, columns=8, error=0.05)
    assert known.R_error.max() <= 0.05


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (
            lambda: over_aperture(NACRE, 1.5, 0.2, NM),
            "angle_rad is 1.5; allowed with half_angle_rad 0.2",
        ),
        (
            lambda: over_aperture(NACRE, [0.0, -0.1], 0.2, NM),
            "angle_rad is -0.1; allowed with half_angle_rad 0.2: 0 to 1.3708",
        ),
        (lambda: over_aperture(NACRE, 0.0, -0.2, NM), "half_angle_rad is -0.2; allowed: 0 to"),
        (lambda: over_hemisphere(7, NM), "stack is 7; allowed: a LayerStack"),
        (lambda: ensemble([NACRE], 0.0, NM), "growth has 1 stacks; allowed: 2 to 10000"),
        (lambda: ensemble([NACRE, 7], 0.0, NM), "growth[1] is 7; allowed: a LayerStack"),
        (
            lambda: ensemble([NACRE, NACRE], 0.0, NM, error=0.1),
            "error is 0.1; allowed for a list of",
        ),
        (
            lambda: ensemble((400.0, 20.0, 50), 0.0, NM),
            "growth is (400.0, 20.0, 50); allowed: a preset",
        ),
        (
            lambda: ensemble((400.0, 200.0, 50, 0.0), 0.0, NM),
            "growth: spread is 200; allowed: 0 to 133.3",
        ),
        (
            lambda: ensemble((400.0, 20.0, 50, 1.0), 0.0, NM),
            "growth: correlation is 1; allowed: -0.999",
        ),
        (lambda: ensemble((400.0, 20.0, 0, 0.0), 0.0, NM), "growth: layers is 0; allowed: a whole"),
        (
            lambda: ensemble("paper", 0.0, NM, like=NACRE),
            "like is given; allowed with (mean, spread",
        ),
        (
            lambda: ensemble((400.0, 20.0, 5, 0.0), 0.0, NM, like=7),
            "like is 7; allowed: a LayerStack",
        ),
    ],
)
def test_bad_input_is_refused_in_one_line(act: Any, message: str) -> None:
    with pytest.raises(nc.InputError) as caught:
        act()
    assert str(caught.value).startswith(message)
    assert "\n" not in str(caught.value)

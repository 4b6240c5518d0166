"""Laws of exact stacks and of ensembles, and what is refused."""

from __future__ import annotations

import math
import os
import signal
import threading
import time
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import nacreous as nc
from nacreous.optics import absorptance, energies, fresnel, reflectance, transmittance
from tests.optics.refusal import NM, refusal

_N = st.floats(0.05, 4)
_K = st.one_of(st.just(0.0), st.floats(0, 5))
_INDEX = st.builds(complex, _N, _K)
_MEDIUM = st.one_of(_INDEX, st.tuples(_INDEX, _INDEX))


@settings(max_examples=150, deadline=None)
@given(
    thickness_nm=st.lists(st.floats(1.0, 5000), min_size=1, max_size=80),
    protein_nm=st.floats(0, 500),
    aragonite=_MEDIUM,
    protein=_MEDIUM,
    substrate=_MEDIUM,
    ambient=_N,
    angle_rad=st.floats(0, math.pi / 2),
    wavelength_nm=st.floats(100, 3000),
    polarisation=st.sampled_from(["s", "p", "unpolarised"]),
)
@example([1.0], 0.0, 1.0, 1.0, (1.0, 0.05078125 + 1j), 1.0, 0.0, 500.0, "p")
@example([1.0], 0.0, 1.0, 1.0, (0.05 + 4j, 0.5), 1.0, 0.6, 500.0, "p")
def test_energy_is_conserved_and_shares_are_shares(
    thickness_nm: list[float],
    protein_nm: float,
    aragonite: Any,
    protein: Any,
    substrate: Any,
    ambient: float,
    angle_rad: float,
    wavelength_nm: float,
    polarisation: str,
) -> None:
    stack = nc.LayerStack(thickness_nm, protein_nm, aragonite, protein, ambient, substrate)
    light = energies(stack, angle_rad, wavelength_nm, polarisation)
    R, T, A = (float(share[0, 0]) for share in (light.R, light.T, light.A))
    assert pytest.approx(1, abs=1e-9) == R + T + A
    for share in (R, T, A):
        assert -1e-12 <= share <= 1 + 1e-9


@pytest.mark.parametrize("extraordinary", [0.05078125 + 1j, 0.3 + 2j, 2.5, 0.05 + 0.05j])
def test_head_on_a_uniaxial_medium_shows_its_ordinary_index_alone(extraordinary: complex) -> None:
    for ordinary in (1.0, 1.68, 0.2 + 3j):
        stacks = [
            nc.LayerStack([400.0, 350.0], 20.0, 1.68, 1.55, 1.0, substrate)
            for substrate in ((ordinary, extraordinary), ordinary)
        ]
        uniaxial, isotropic = (energies(stack, 0.0, NM, "p") for stack in stacks)
        np.testing.assert_allclose(uniaxial.R, isotropic.R, rtol=0, atol=1e-13)
        np.testing.assert_allclose(uniaxial.T, isotropic.T, rtol=0, atol=1e-13)


def test_natural_light_is_the_mean_of_both() -> None:
    stack = nc.LayerStack([400.0, 380.0], 20.0, (1.683 + 1e-3j, 1.53), 1.43 + 0.1j)
    angles = np.linspace(0, np.pi / 2, 30)
    s, p, both = (energies(stack, angles, NM, name) for name in ("s", "p", "unpolarised"))
    for share in "RTA":
        mean = (getattr(s, share) + getattr(p, share)) / 2
        np.testing.assert_allclose(getattr(both, share), mean, rtol=0, atol=1e-15)


def test_each_name_gives_its_share() -> None:
    stack = nc.LayerStack([400.0, 380.0], 20.0, 1.53 + 1e-3j)
    light = energies(stack, [0.1, 0.9], NM)
    np.testing.assert_array_equal(reflectance(stack, [0.1, 0.9], NM), light.R)
    np.testing.assert_array_equal(transmittance(stack, [0.1, 0.9], NM), light.T)
    np.testing.assert_array_equal(absorptance(stack, [0.1, 0.9], NM), light.A)
    assert light.R.shape == (2, 401)
    assert light.A.min() > 0


def test_a_film_of_its_surroundings_is_fresnels_boundary() -> None:
    stack = nc.LayerStack([1.0, 1e-12], 0.0, 1.0, 1.4, 1.0, 0.5 + 3.5j)
    angles = np.linspace(0, 1.57, 50)
    boundary = fresnel(1.0, 0.5 + 3.5j, angles)
    np.testing.assert_allclose(
        reflectance(stack, angles, 500.0)[:, 0], boundary.R, rtol=0, atol=1e-12
    )


def test_a_wavelength_does_not_know_its_neighbours() -> None:
    stack = nc.LayerStack(np.linspace(350, 450, 37), 20.0, "aragonite", "chitin")
    together = reflectance(stack, [0.0, 0.7], NM[:45])
    alone = np.hstack([reflectance(stack, [0.0, 0.7], nm) for nm in NM[:45]])
    np.testing.assert_array_equal(together, alone)


def test_thousands_of_strongly_absorbing_layers_are_finite() -> None:
    stack = nc.LayerStack([500.0] * 5000, 20.0, 1.53 + 2j, 0.05 + 6j, 1.7, 0.2 + 3j)
    light = energies(stack, np.linspace(0, np.pi / 2, 20), NM)
    assert np.all(np.isfinite(light.R))
    np.testing.assert_allclose(light.R + light.T + light.A, 1, rtol=0, atol=1e-12)
    assert np.all(light.T == 0)


def test_single_precision_of_a_free_flake_errs_as_stated_by_angle() -> None:
    """Near grazing its lines narrow with the cosine, and a phase's rounding counts the more."""
    layers = np.random.default_rng(5).normal(450, 40, 400)
    stack = nc.LayerStack(layers, 20.0, (1.683, 1.53), 1.43, 1.0, 1.0)
    for degrees in (0, 60, 80, 85, 88, 89, 89.5, 89.9, 89.99):
        angle = math.radians(degrees)
        allowed = 2e-4 if degrees <= 85 else max(2e-4, 2e-5 / math.cos(angle))
        double = reflectance(stack, angle, NM)
        single = reflectance(stack, angle, NM, precision="single")
        assert np.abs(single - double).max() < allowed, degrees


@pytest.mark.parametrize(("ratio", "allowed"), [(1.1, 1e-3), (1.2, 4e-3)])
def test_single_precision_errs_by_contrast_as_stated(ratio: float, allowed: float) -> None:
    """Twice the largest error of the stacks that docs/optics.md tells of, for others are drawn."""
    random = np.random.default_rng(8)
    for _ in range(4):
        layers = random.normal(random.uniform(120, 480), 10, 400)
        stack = nc.LayerStack(layers, 60.0, 1.4, 1.4 * ratio, 1.0, 1.4 * ratio)
        angles = np.radians([0.0, 60.0, 80.0, 85.0])
        both = [reflectance(stack, angles, NM, "p", precision=p) for p in ("single", "double")]
        assert np.abs(both[0] - both[1]).max() < allowed


@pytest.mark.parametrize("wavelengths", [1, 2, 3, 5, 7, 16])
@pytest.mark.parametrize("precision", ["double", "single"])
def test_few_wavelengths_beside_many_angles_give_what_each_angle_gives_alone(
    wavelengths: int, precision: str
) -> None:
    """Lanes hold points of several angles then; media of every kind."""
    angle, nm = np.linspace(0, math.pi / 2, 41), np.linspace(400, 700, wavelengths)
    for media in (
        (1.53, 1.43, 1.0, 1.53),
        ("aragonite", "chitin", 1.0, "aragonite"),
        (1.5 + 0.01j, 1.3, 1.0, 0.2 + 3j),
        ((1.683, 1.53), 1.0, 1.7, 1.0),
    ):
        stack = nc.LayerStack([380.0, 420.0, 400.0], 60.0, *media)
        table = nc.optics.energies(stack, angle, nm, precision=precision)
        alone = [nc.optics.energies(stack, each, nm, precision=precision) for each in angle]
        tolerance = 1e-12 if precision == "double" else 1e-5
        for share in "RTA":
            rows = [getattr(light, share)[0] for light in alone]
            np.testing.assert_allclose(getattr(table, share), rows, rtol=0, atol=tolerance)


@pytest.mark.parametrize("precision", ["double", "single"])
@pytest.mark.parametrize(
    ("media", "in_double", "in_single"),
    [
        ((1.53, 1.43, 1.0, 1.53), 0.0, 0.0),
        (("aragonite", 1.43, 1.0, "aragonite"), 0.0, 0.0),
        ((1.9, 1.2, 1.8, 1.0), 1e-12, 1e-3),
    ],
)
def test_without_total_reflection_what_else_is_asked_changes_no_bit(
    media: tuple[Any, ...], in_double: float, in_single: float, precision: str
) -> None:
    random = np.random.default_rng(6)
    stack = nc.LayerStack(random.normal(380, 30, 60), 20.0, *media)
    angle, nm = random.uniform(0, 1.48, 24), np.sort(random.uniform(402, 680, 70))
    table = reflectance(stack, angle, nm, precision=precision)
    most = in_double if precision == "double" else in_single
    for few in (1, 5, 16, 17, 33):
        part = reflectance(stack, angle[:7], nm[:few], precision=precision)
        assert np.abs(part - table[:7, :few]).max() <= most


def test_single_precision_is_right_to_1e_4_and_1e_5_rms() -> None:
    """At 400 bilayers, isotropic and uniaxial."""
    layers = np.random.default_rng(5).normal(450, 40, 400)
    angles = np.radians(np.arange(90))
    for aragonite in (1.53, (1.683, 1.53)):
        stack = nc.LayerStack(layers, 20.0, aragonite)
        double = reflectance(stack, angles, NM)
        single = reflectance(stack, angles, NM, precision="single")
        assert np.abs(single - double).max() < 1e-4
        assert np.sqrt(np.mean((single - double) ** 2)) < 1e-5


def test_an_ensemble_is_the_mean_and_spread_of_its_columns() -> None:
    found = nc.optics.ensemble("akoya-rg", [0.0, 0.6], NM[::20], columns=5, seed=3)
    stacks = [nc.grow("akoya-rg", seed=seed) for seed in range(3, 8)]
    R = [reflectance(stack, [0.0, 0.6], NM[::20]) for stack in stacks]
    T = [transmittance(stack, [0.0, 0.6], NM[::20]) for stack in stacks]
    np.testing.assert_allclose(found.R, np.mean(R, axis=0), rtol=0, atol=1e-14)
    np.testing.assert_allclose(found.T, np.mean(T, axis=0), rtol=0, atol=1e-14)
    np.testing.assert_allclose(found.R_spread, np.std(R, axis=0, ddof=1), rtol=1e-9)
    np.testing.assert_allclose(found.T_spread, np.std(T, axis=0, ddof=1), rtol=1e-9)


def test_an_ensemble_converges_as_its_error_says() -> None:
    """Two ensembles that share no column differ by their errors, no more and no less."""
    first, second = (
        nc.optics.ensemble("paper", [0.0, 0.7], NM[::10], columns=48, seed=seed)
        for seed in (100, 900)
    )
    off = (first.R - second.R) / np.hypot(first.R_error, second.R_error)
    assert 0.6 < np.sqrt(np.mean(off**2)) < 1.5
    again = nc.optics.ensemble("paper", [0.0, 0.7], NM[::10], columns=48, seed=100)
    np.testing.assert_array_equal(first.R, again.R)


def test_an_ensemble_goes_on_until_its_error_is_reached() -> None:
    """And with as many columns as it then has, it is the same ensemble."""
    asked = {"angle_rad": [0.0, 0.7], "wavelength_nm": NM[::10], "seed": 5}
    found = nc.optics.ensemble("paper", columns=16, error=0.01, **asked)
    assert found.columns > 64
    assert max(found.R_error.max(), found.T_error.max()) <= 0.01
    whole = nc.optics.ensemble("paper", columns=found.columns, **asked)
    np.testing.assert_array_equal(found.R, whole.R)
    np.testing.assert_array_equal(found.T_spread, whole.T_spread)
    with pytest.raises(nc.InputError, match=r"error is 1e-09; allowed for this nacre: what 10000"):
        nc.optics.ensemble("paper", columns=4, error=1e-9, **asked)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"columns": 1}, "columns is 1; allowed: a whole number, 2 to 10000"),
        ({"columns": 2.5}, "columns is 2.5; allowed: a whole number, 2 to 10000"),
        ({"seed": -1}, "seed is -1; allowed: a whole number, 0 to 4611686018427387904"),
        ({"error": 2.0}, "error is 2.0; allowed: 1e-9 to 1, or None"),
        ({"growth": 3}, "growth is 3; allowed: a nacre preset's name or a Growth"),
    ],
)
def test_an_ensemble_says_what_is_wrong(given: dict[str, Any], message: str) -> None:
    whole = {"growth": "paper", "angle_rad": 0.0, "wavelength_nm": 500.0, **given}
    assert refusal(lambda: nc.optics.ensemble(**whole)) == message


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"stack": [400.0]}, "stack is [400.0]; allowed: a LayerStack"),
        ({"angle_rad": 1.6}, "angle_rad is 1.6; allowed: 0 to pi/2"),
        ({"angle_rad": math.nan}, "angle_rad is NaN; allowed: 0 to pi/2"),
        ({"wavelength_nm": 0.5}, "wavelength_nm is 0.5; allowed: 1 to 1000000 nm"),
        ({"polarisation": "x"}, "polarisation is 'x'; allowed: s, p, unpolarised"),
        ({"polarisation": None}, "polarisation is None; allowed: a name"),
        ({"precision": "half"}, "precision is 'half'; allowed: double, single"),
        (
            {"stack": nc.LayerStack([400.0], ambient=(1.0, 1.1))},
            "the index of ambient changes with direction; allowed: an isotropic medium",
        ),
        (
            {"stack": nc.LayerStack([400.0], aragonite="aragonite"), "wavelength_nm": 200.0},
            "wavelength_nm is 200; allowed with this aragonite: 300 to 1100 nm",
        ),
        (
            {"angle_rad": np.zeros(40_000), "wavelength_nm": np.full(40_000, 500.0)},
            "the table has 40000 x 40000 values; allowed: up to 134217728",
        ),
    ],
    ids=lambda case: str(case)[:50],
)
def test_exact_optics_says_what_is_wrong(given: dict[str, Any], message: str) -> None:
    whole = {"stack": nc.LayerStack([400.0]), "angle_rad": 0.5, "wavelength_nm": 500.0, **given}
    assert refusal(lambda: energies(**whole)) == message


def test_the_model_of_1996_refuses_two_indices_at_once() -> None:
    for medium in ("aragonite", (1.6, 1.5)):
        stack = nc.LayerStack([400.0], aragonite=medium)
        assert refusal(lambda stack=stack: nc.optics.illuminant(stack, 0.0, NM)) == (
            "the index of aragonite changes with direction; allowed: an isotropic medium"
        )


@pytest.mark.parametrize("views", [[], [0.5]])
@pytest.mark.parametrize("lights", [[], [500, 600]])
def test_the_table_has_a_row_for_each_angle(views: Any, lights: Any) -> None:
    stack = nc.LayerStack([400.0], protein=lambda nm: nm / 400)
    assert reflectance(stack, views, lights).shape == (len(views), len(lights))


def test_ctrl_c_ends_a_long_computation() -> None:
    """Half a minute of work; the time is generous, for machines are busy."""
    stack = nc.LayerStack([400.0] * 5000, 20.0, 1.53 + 1e-4j)
    angles, lights = np.linspace(0, 1.5, 2000), np.linspace(380, 780, 2000)
    interrupt = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    begin = time.perf_counter()
    interrupt.start()
    with pytest.raises(KeyboardInterrupt):
        reflectance(stack, angles, lights)
    assert time.perf_counter() - begin < 5

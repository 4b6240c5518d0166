"""Partial coherence against closed forms of one layer, a plain quadrature and its own limits."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous.optics import energies, ensemble, fresnel, reflectance
from tests.optics.refusal import refusal

NM = np.linspace(400.0, 700.0, 61)
PLATE_NM, N_PLATE, N_SUBSTRATE = 20_000.0, 2.0, 4.0


def plate() -> nc.LayerStack:
    return nc.LayerStack([PLATE_NM], 0.0, N_PLATE, 1.43, 1.0, N_SUBSTRATE)


def transmittance_of_plate(coherence_nm: float, nm: NDArray[np.float64]) -> NDArray[np.float64]:
    """Airy's sum as a series in path differences, each with its own degree of coherence."""
    top, bottom = fresnel(1.0, N_PLATE, 0.0), fresnel(N_PLATE, N_SUBSTRATE, 0.0)
    r = float(top.r_s.real * bottom.r_s.real)
    path_nm = 2 * N_PLATE * PLATE_NM
    m = np.arange(1, 60)[:, None]
    seen = np.exp(-math.pi * (m * path_nm) ** 2 / (2 * coherence_nm**2))
    # Seen from inside, the upper face reflects with the opposite sign.
    series = 1 + 2 * ((-r) ** m * seen * np.cos(2 * np.pi * m * path_nm / nm)).sum(0)
    return float(top.T) * float(bottom.T) / (1 - r * r) * series


@pytest.mark.parametrize("coherence_nm", [3e3, 3e4, 8e4, 3e5, 1e6])
def test_fringes_of_every_order_fade_with_their_path_difference(coherence_nm):
    light = energies(plate(), 0.0, NM, coherence_nm=coherence_nm)
    expected = transmittance_of_plate(coherence_nm, NM)
    np.testing.assert_allclose(light.T[0], expected, rtol=0, atol=1e-6)


def test_long_coherence_is_the_exact_result():
    stack = nc.LayerStack([420.0] * 30, 20.0, "aragonite", "chitin")
    apart = [
        np.abs(
            reflectance(stack, [0.0, 0.9], NM, coherence_nm=length)
            - reflectance(stack, [0.0, 0.9], NM)
        ).max()
        for length in (1e6, 1e7)
    ]
    assert apart[1] < 1e-4
    # A Gaussian's error falls with the square of its width.
    assert apart[0] / apart[1] == pytest.approx(100, rel=0.1)


def test_short_coherence_adds_energies_between_the_faces_of_a_thick_layer():
    top, bottom = (float(fresnel(*pair, 0.0).R) for pair in ((1.0, 2.0), (2.0, 4.0)))
    incoherent = top + (1 - top) ** 2 * bottom / (1 - top * bottom)
    light = energies(plate(), 0.0, NM, coherence_nm=3000.0)
    np.testing.assert_allclose(light.R, incoherent, rtol=0, atol=1e-6)
    assert np.ptp(energies(plate(), 0.0, NM).R) > 0.1


@pytest.mark.parametrize("coherence_nm", [5e3, 8e4])
def test_the_integral_over_wavenumber_stays(coherence_nm):
    # One fringe of a plate without dispersion, evenly in wavenumber.
    fringe = 1 / (2 * N_PLATE * PLATE_NM)
    nm = 1 / (1 / 550 + fringe * np.arange(64) / 64)
    exact, partial = (reflectance(plate(), 0.0, nm, coherence_nm=c) for c in (None, coherence_nm))
    assert partial.mean() == pytest.approx(exact.mean(), abs=1e-6)
    assert np.ptp(partial) < 0.9 * np.ptp(exact)


@pytest.mark.parametrize("polarisation", ["s", "p", "unpolarised"])
def test_dispersive_nacre_agrees_with_a_plain_quadrature(polarisation):
    stack = nc.grow("akoya-rg", seed=3)
    stack = nc.LayerStack(stack.thickness_nm[:60], 20.0, "aragonite", "chitin")
    length, at = 2e4, np.array([450.0, 587.0])
    partial = energies(stack, [0.3, 1.2], at, polarisation, coherence_nm=length)
    for i, nm in enumerate(at):
        sigma = 1 / nm + np.linspace(-2.0, 2.0, 20_001) / length
        weight = np.exp(-2 * np.pi * ((sigma - 1 / nm) * length) ** 2)
        exact = energies(stack, [0.3, 1.2], 1 / sigma, polarisation)
        for ours, table in ((partial.R, exact.R), (partial.T, exact.T)):
            mean = table @ weight / weight.sum()
            np.testing.assert_allclose(ours[:, i], mean, rtol=0, atol=1e-6)


def test_the_line_has_the_stated_width():
    """Half the top at half of 0.664 / L from the middle; the integral of |g|^2 is L."""
    length = 5000.0
    half_width = math.sqrt(2 * math.log(2) / math.pi) / length / 2
    assert math.exp(-2 * math.pi * (half_width * length) ** 2) == pytest.approx(0.5)
    path = np.linspace(-4e4, 4e4, 80_001)
    g = np.exp(-math.pi * path**2 / (2 * length**2))
    assert (g**2).sum() * (path[1] - path[0]) == pytest.approx(length)


def test_energy_stays_one():
    absorbing = nc.LayerStack([400.0] * 80, 20.0, 1.66 + 1e-4j, 1.43 + 1e-2j, 1.0, 0.2 + 3j)
    light = energies(absorbing, [0.0, 1.0, math.pi / 2], NM, coherence_nm=5000.0)
    np.testing.assert_allclose(light.R + light.T + light.A, 1, rtol=0, atol=1e-10)


def test_ensembles_take_a_coherence_length():
    angle, few = [0.0, 0.8], NM[::20]
    mean = ensemble("akoya-rg", angle, few, columns=2, seed=4, coherence_nm=6e3)
    alone = [
        reflectance(nc.grow("akoya-rg", seed=seed), angle, few, coherence_nm=6e3) for seed in (4, 5)
    ]
    np.testing.assert_allclose(mean.R, np.mean(alone, axis=0), rtol=0, atol=1e-9)


def plain_quadrature(stack: nc.LayerStack, nm: float, length: float) -> Any:
    """T by a million equal steps, more than any line here needs."""
    sigma = 1 / nm + np.linspace(-1.9, 1.9, 1_000_001) / length
    weight = np.exp(-2 * np.pi * ((sigma - 1 / nm) * length) ** 2)
    return energies(stack, 0.0, 1 / sigma).T[0] @ weight / weight.sum()


def cavity(pairs: int, gap_nm: float, n: float) -> nc.LayerStack:
    """Two quarter-wave mirrors for 550 nm and a gap between them."""
    mirror = [550 / 4 / 1.45] * pairs
    return nc.LayerStack([*mirror, gap_nm, *mirror], 55.0, 1.45, n, 1.0, 1.45)


def test_a_cavity_whose_lines_are_narrower_than_first_steps_is_resolved():
    light = energies(cavity(4, 20_000.0, 2.5), 0.0, 550.0, coherence_nm=5000.0)
    assert light.T[0, 0] == pytest.approx(0.01475, abs=5e-6)


@pytest.mark.parametrize("pairs", [2, 3, 5])
@pytest.mark.parametrize(("gap_nm", "n"), [(5000.0, 2.5), (31_234.0, 2.5), (60_000.0, 2.2)])
def test_no_cavity_converges_to_a_wrong_answer(pairs, gap_nm, n):
    stack = cavity(pairs, gap_nm, n)
    for length in (3000.0, 2e4):
        found = energies(stack, 0.0, 550.0, coherence_nm=length).T[0, 0]
        assert found == pytest.approx(plain_quadrature(stack, 550.0, length), abs=1e-4)


def test_tables_worked_out_in_pieces_are_those_of_one_piece(monkeypatch):
    stack, angle = nc.LayerStack([420.0] * 30, 20.0, "aragonite", "chitin"), [0.0, 0.5, 1.2]
    whole = energies(stack, angle, NM, coherence_nm=2e4)
    monkeypatch.setattr(nc.optics.coherence, "_AT_ONCE", 100)
    pieces = energies(stack, angle, NM, coherence_nm=2e4)
    for one, other in ((whole.R, pieces.R), (whole.T, pieces.T)):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-12)


def test_a_line_that_reaches_beyond_a_table_is_named_for_what_it_is():
    """The wavelength asked for is known; the coherence length is what asks for more."""
    stack = nc.LayerStack([420.0] * 10, 20.0, nc.medium.IndexTable([400.0, 700.0], [1.6, 1.5]))
    message = refusal(lambda: energies(stack, 0.0, [500.0, 690.0], coherence_nm=5000.0))
    assert message.startswith("coherence_nm is 5000, whose line around 690 nm reaches to 90")
    assert message.endswith("allowed with this aragonite: 400 to 700 nm")
    beyond = refusal(lambda: energies(stack, 0.0, 710.0, coherence_nm=5000.0))
    assert beyond.startswith("wavelength_nm is 710")


def test_what_cannot_be_is_refused():
    stack = nc.LayerStack([420.0] * 10, 20.0, "aragonite")
    for bad in (0.0, -1.0, math.nan, math.inf, 2e9):
        assert "coherence_nm is" in refusal(
            lambda bad=bad: energies(stack, 0.0, NM, coherence_nm=bad)
        )
    short = refusal(lambda: energies(stack, 0.0, 550.0, coherence_nm=1000.0))
    assert short == "coherence_nm is 1000; allowed at 550 nm: from 1100 nm, two waves"
    for bad_nm in (math.nan, math.inf, 0.0, -500.0):
        assert "wavelength_nm is" in refusal(
            lambda nm=bad_nm: energies(stack, 0.0, [500.0, nm], coherence_nm=5000.0)
        )
    assert "angle_rad is" in refusal(lambda: energies(stack, math.nan, NM, coherence_nm=5000.0))
    # The line reaches beyond what is measured.
    assert "allowed with this aragonite: 300 to 1100 nm" in refusal(
        lambda: energies(stack, 0.0, 780.0, coherence_nm=2000.0)
    )
    thick = nc.LayerStack([1e6] * 5000)
    assert "allowed: fewer" in refusal(lambda: energies(thick, 0.0, NM, coherence_nm=5000.0))
    assert "a number" in refusal(lambda: energies(stack, 0.0, NM, coherence_nm="5000"))  # type: ignore[arg-type]


def test_no_wavelengths_give_an_empty_table():
    assert energies(plate(), [0.0, 0.5], [], coherence_nm=5000.0).R.shape == (2, 0)
    assert energies(plate(), [], NM, coherence_nm=5000.0).R.shape == (0, NM.size)

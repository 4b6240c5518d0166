"""Colours by angle against exact spectra on finer grids of angles and wavelengths."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous import iridescence

WHITE = nc.colour.white_xyz("D65")
FINE_NM = 380 + np.arange(400 * 32 + 1) / 32


def refusal(act: Any) -> str:
    with pytest.raises(nc.InputError) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    return message


def fine_weights() -> NDArray[np.float64]:
    """Illuminant D65 times observer, in steps of 1/32 nm, straight lines between samples."""
    each_nm = nc.colour.xyz_from_spectrum(np.eye(401), "D65")
    columns = [np.interp(FINE_NM, nc.colour.WAVELENGTH_NM, column) for column in each_nm.T]
    weights = np.stack(columns, axis=1)
    return weights * (WHITE / weights.sum(axis=0))


def difference(first: NDArray[np.float64], second: NDArray[np.float64]) -> float:
    first, second = (nc.colour.lab_from_xyz(xyz.clip(0), WHITE) for xyz in (first, second))
    return float(nc.colour.delta_e_2000(first, second).max())


def nacre(layers: int, aragonite: Any, spread_nm: float) -> nc.LayerStack:
    thickness_nm = np.random.default_rng(1).normal(380, spread_nm, layers)
    return nc.LayerStack(thickness_nm, 20.0, aragonite, 1.43)


@pytest.mark.parametrize(
    ("layers", "aragonite", "spread_nm"),
    [
        *((layers, 1.53, 0.0) for layers in (20, 100)),
        *((layers, (1.683, 1.53), 0.0) for layers in (20, 100, 500)),
        *((layers, 1.53, 15.0) for layers in (20, 100)),
    ],
)
def test_straight_lines_stay_below_what_can_be_seen(layers, aragonite, spread_nm):
    stack = nacre(layers, aragonite, spread_nm)
    tables = iridescence.exact(stack)
    steps = len(tables[0].xyz) - 1
    # Some of the nodes of a grid four times finer; all would take minutes.
    some = np.random.default_rng(2).integers(0, 4 * steps, 40)
    angle = np.arccos(some / (4 * steps))
    light = nc.optics.energies(stack, angle, FINE_NM, precision="single")
    weights = fine_weights()
    for table, share in zip(tables, (light.R, light.T), strict=True):
        assert difference(table.at(angle), share @ weights) < 0.2


@pytest.mark.parametrize("preset", ["paper", "akoya-rg"])
def test_the_illuminant_models_lines_stay_below_what_can_be_seen_between_its_jumps(preset):
    stack = nc.grow(preset, seed=7, aragonite=1.53, protein=1.43)  # it knows no crystals
    table = iridescence.illuminant_model(stack, diffuse_loss=0.03)
    fine = 4 * (len(table.xyz) - 1)
    angle = np.arccos(np.arange(fine + 1) / fine)
    spectra = nc.optics.illuminant(stack, angle, nc.colour.WAVELENGTH_NM, diffuse_loss=0.03)
    xyz = nc.colour.xyz_from_spectrum(spectra, "D65")
    xyz /= xyz[::4, 1].max()
    first, second = (nc.colour.lab_from_xyz(colours, WHITE) for colours in (table.at(angle), xyz))
    apart = nc.colour.delta_e_2000(first, second)
    assert np.quantile(apart, 0.99) < 0.2
    assert apart.max() < 0.7


@pytest.mark.parametrize("layers", [1, 5, 20])
@pytest.mark.parametrize(("aragonite", "protein"), [((1.683, 1.53), 1.43), (2.2, 1.43)])
def test_a_free_flake_keeps_its_colours_up_to_grazing(layers, aragonite, protein):
    """Two mirrors near grazing, whose lines narrow without end."""
    stack = nc.LayerStack([380.0] * layers, 20.0, aragonite, protein, 1.0, 1.0)
    tables = iridescence.exact(stack)
    nm = 380 + np.arange(400 * 1000 + 1) / 1000
    each_nm = nc.colour.xyz_from_spectrum(np.eye(401), "D65")
    weights = np.stack([np.interp(nm, nc.colour.WAVELENGTH_NM, c) for c in each_nm.T], axis=1)
    weights *= WHITE / weights.sum(axis=0)
    for degrees in (60.0, 80.0, 86.0, 88.3, 89.1, 89.5, 89.8, 89.95):
        angle = math.radians(degrees)
        light = nc.optics.energies(stack, angle, nm)
        for table, share in zip(tables, (light.R, light.T), strict=True):
            assert difference(table.at([angle]), share @ weights) < 0.2


def film_transmittance(
    n: float, thickness_nm: float, angle: float, nm: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Airy's sum for natural light through a film in air."""
    outside, inside = math.cos(angle), math.sqrt(n**2 - math.sin(angle) ** 2)
    turned = np.sin(2 * np.pi * thickness_nm * inside / nm) ** 2
    mirrors = [(u - v) / (u + v) for u, v in ((outside, inside), (n**2 * outside, inside))]
    return sum(0.5 / (1 + 4 * r**2 / (1 - r**2) ** 2 * turned) for r in mirrors)


@pytest.mark.parametrize(
    ("n", "thickness_nm"),
    [
        *((1.33, 260.0), (1.68, 300.0), (1.68, 55.0), (2.0, 250.0), (2.1, 135.0), (2.6, 90.0)),
        *((2.6, 170.0), (3.0, 80.0), (3.0, 150.0), (3.4, 250.0), (4.0, 205.0), (5.0, 150.0)),
        *((5.0, 45.0), (5.0, 640.0)),
    ],
)
def test_films_thinner_than_their_light_keep_their_colours_up_to_grazing(n, thickness_nm):
    """One line or two in all that the eye sees; and films so dense that fringes come close."""
    stack = nc.LayerStack([thickness_nm], 0.0, n, 1.4, 1.0, 1.0)
    tables = iridescence.exact(stack)
    nm = 380 + np.arange(400 * 200 + 1) / 200
    each_nm = nc.colour.xyz_from_spectrum(np.eye(401), "D65")
    weights = np.stack([np.interp(nm, nc.colour.WAVELENGTH_NM, c) for c in each_nm.T], axis=1)
    weights *= WHITE / weights.sum(axis=0)
    for degrees in (70.0, 88.0, 89.2, 89.6, 89.8, 89.88, 89.93, 89.96, 89.986):
        angle = math.radians(degrees)
        through = film_transmittance(n, thickness_nm, angle, nm) @ weights
        for table, xyz in zip(tables, (WHITE - through, through), strict=True):
            assert difference(table.at([angle]), xyz) < 0.2, degrees


DENSE = nc.LayerStack([150.0, 150.0], 700.0, 1.0, 1.8, 1.5, 1.5)


def test_light_that_tunnels_between_gaps_keeps_its_colours():
    """Gaps of air in glass: beyond total reflection light passes by narrow lines alone."""
    tables = iridescence.exact(DENSE)
    nm = 380 + np.arange(400 * 1000 + 1) / 1000
    each_nm = nc.colour.xyz_from_spectrum(np.eye(401), "D65")
    weights = np.stack([np.interp(nm, nc.colour.WAVELENGTH_NM, c) for c in each_nm.T], axis=1)
    weights *= WHITE / weights.sum(axis=0)
    for degrees in (30.0, 41.0, 45.0, 60.0, 75.0, 85.0):
        angle = math.radians(degrees)
        light = nc.optics.energies(DENSE, angle, nm)
        for table, share in zip(tables, (light.R, light.T), strict=True):
            assert difference(table.at([angle]), share @ weights) < 0.2


@pytest.mark.parametrize(
    "stack",
    [
        nc.LayerStack([300.0, 300.0], 500.0, 1.0, 2.0, 2.0, 2.0),
        nc.LayerStack([400.0, 400.0], 900.0, 1.3, 1.8, 1.8, 1.8),
        nc.LayerStack([94.8] * 8 + [20_000.0] + [94.8] * 8, 59.0, 1.45, 2.3, 1.0, 1.45),
    ],
    ids=["gaps of air", "gaps of water", "mirrors 20 um apart"],
)
def test_lines_too_narrow_to_be_worked_out_are_refused_with_what_they_would_take(stack):
    message = refusal(lambda: iridescence.exact(stack))
    found = re.search(r"would take (\S+) layers .* allowed: up to (\S+)\. Thinner", message)
    assert found is not None, message
    assert float(found[1]) > float(found[2]) == 1e10


def test_reflected_and_transmitted_light_add_up_to_white():
    reflected, transmitted = iridescence.exact(nacre(100, "aragonite", 15.0))
    assert np.abs(reflected.xyz + transmitted.xyz - WHITE).max() < 1e-4


def test_at_grazing_incidence_everything_comes_back():
    reflected, _ = iridescence.exact(nacre(20, 1.53, 0.0), "A", "1964-10")
    white = nc.colour.white_xyz("A", "1964-10")
    np.testing.assert_allclose(reflected.at(math.pi / 2), white, atol=1e-6)


def test_unpolarised_light_is_the_mean_of_both_polarisations():
    stack = nacre(50, (1.683, 1.53), 0.0)
    at = np.linspace(0, 1.5, 9)
    s, p, both = (
        iridescence.exact(stack, polarisation=of)[0].at(at) for of in ("s", "p", "unpolarised")
    )
    assert difference(0.5 * (s + p), both) < 0.2


def test_nodes_are_met_exactly():
    table = iridescence.exact(nacre(20, 1.53, 0.0))[0]
    np.testing.assert_allclose(table.at(table.angle_rad), table.xyz, atol=1e-9)
    assert table.at(np.zeros((2, 3))).shape == (2, 3, 3)


def test_what_cannot_be_is_refused():
    stack = nacre(5, 1.53, 0.0)
    assert "allowed: a LayerStack" in refusal(lambda: iridescence.exact([380.0]))  # type: ignore[arg-type]
    assert "light has shape [3]" in refusal(lambda: iridescence.exact(stack, [1.0, 2.0, 3.0]))
    assert "D65" in refusal(lambda: iridescence.exact(stack, "moon"))
    assert "allowed: above 0" in refusal(lambda: iridescence.exact(stack, np.zeros(401)))
    assert "observer is" in refusal(lambda: iridescence.exact(stack, "A", "me"))  # type: ignore[arg-type]
    assert "polarisation is" in refusal(lambda: iridescence.exact(stack, polarisation="x"))
    assert "allowed: 0 to pi/2" in refusal(lambda: iridescence.exact(stack)[0].at(2.0))
    assert "allowed: 0 to pi/2" in refusal(lambda: iridescence.exact(stack)[0].at(math.nan))
    assert "k = 0.1" in refusal(
        lambda: iridescence.illuminant_model(nc.LayerStack([400.0], aragonite=1.53 + 0.1j))
    )

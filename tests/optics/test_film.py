"""Covers, unequal proteins, amplitudes, ellipsometry, plates and depth, against laws and tmm."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
import tmm

import nacreous as nc
from nacreous.optics import amplitudes, depth_profile, energies, fresnel, on_plate

NM = np.array([420.0, 550.0, 700.0])
ANGLES = np.array([0.0, 0.4, 1.0, 1.5])


def random_stack(seed: int) -> nc.LayerStack:
    """Cover, unequal proteins, dye, a metal now and then."""
    random = np.random.default_rng(seed)
    layers = int(random.integers(1, 9))
    dyed = complex(random.uniform(1.3, 1.6), random.choice([0.0, 0.02]))
    substrate = [1.53, 1.0, 0.3 + 3.2j][seed % 3]
    return nc.LayerStack(
        random.uniform(100, 600, layers),
        random.uniform(0, 60, layers),
        random.uniform(1.4, 1.8),
        dyed,
        [1.0, 1.33][seed % 2],
        substrate,
        [(1.33, random.uniform(0, 2000)), (complex(1.5, random.choice([0.0, 0.01])), 90.0)][
            : seed % 3
        ],
    )


def layers_of(stack: nc.LayerStack) -> tuple[list[complex], list[float]]:
    """(indices, thicknesses) as tmm takes them."""
    protein = np.broadcast_to(stack.protein_nm, len(stack))
    nm = [d for pair in zip(stack.thickness_nm, protein, strict=True) for d in pair]
    covers: list[Any] = [n for n, _ in stack.cover]
    n = [stack.ambient, *covers, *[stack.aragonite, stack.protein] * len(stack), stack.substrate]
    return n, [math.inf, *(d for _, d in stack.cover), *nm, math.inf]


@pytest.mark.parametrize("seed", range(30))
def test_stacks_layer_by_layer_agree_with_tmm(seed: int) -> None:
    """R, T and the complex amplitudes; tmm's r_p has the opposite sign."""
    stack = random_stack(seed)
    n, d = layers_of(stack)
    light, shares = amplitudes(stack, ANGLES, NM), {p: energies(stack, ANGLES, NM, p) for p in "sp"}
    for a, angle in enumerate(ANGLES):
        for w, nm in enumerate(NM):
            for p, sign in (("s", 1), ("p", -1)):
                peer = tmm.coh_tmm(p, n, d, angle, nm)
                r, t = getattr(light, f"r_{p}")[a, w], getattr(light, f"t_{p}")[a, w]
                assert abs(r - sign * peer["r"]) < 1e-11
                assert abs(t - peer["t"]) < 1e-11 * max(1, abs(peer["t"]))
                assert shares[p].R[a, w] == pytest.approx(peer["R"], abs=1e-12)
                assert shares[p].T[a, w] == pytest.approx(peer["T"], abs=1e-12)


@pytest.mark.parametrize("seed", range(12))
def test_what_stays_by_depth_and_by_layer_is_what_is_missing(seed: int) -> None:
    """Energy is kept: sum over layers and integral over depth (Gauss, layer by layer) are A."""
    stack = random_stack(seed)
    _, d = layers_of(stack)
    edges = np.concatenate([[0.0], np.cumsum(d[1:-1])])
    x, w = np.polynomial.legendre.leggauss(40)
    depth = (edges[:-1, None] + np.diff(edges)[:, None] * (x + 1) / 2).ravel()
    weight = (np.diff(edges)[:, None] * w / 2).ravel()
    for polarisation in ("s", "p", "unpolarised"):
        inside = depth_profile(stack, depth, ANGLES, NM, polarisation)
        A = energies(stack, ANGLES, NM, polarisation).A
        np.testing.assert_allclose(inside.absorptance.sum(axis=2), A, rtol=0, atol=1e-11)
        np.testing.assert_allclose(inside.absorbed_per_nm @ weight, A, rtol=0, atol=1e-10)


def test_fields_by_depth_agree_with_tmm() -> None:
    """tmm's position_resolved: Poynting, absorption and the three fields."""
    stack = nc.LayerStack(
        [120.0, 300.0], [40.0, 70.0], 1.6 + 0.03j, 1.4, 1.0, 1.5 + 0.2j, [(1.33, 80.0)]
    )
    n, d = layers_of(stack)
    for p in "sp":
        data = tmm.coh_tmm(p, n, d, 0.7, 550.0)
        for depth in (0.0, 33.0, 100.0, 225.0, 420.0, 560.0):
            layer, below = tmm.find_in_structure_with_inf(d, depth)
            peer = tmm.position_resolved(layer, below, data)
            inside = depth_profile(stack, depth, 0.7, 550.0, p)
            squared = sum(abs(peer[name]) ** 2 for name in ("Ex", "Ey", "Ez"))
            assert inside.intensity[0, 0, 0] == pytest.approx(squared, rel=1e-10)
            assert inside.absorbed_per_nm[0, 0, 0] == pytest.approx(
                peer["absor"], rel=1e-9, abs=1e-15
            )


def test_the_depth_of_a_thick_absorber_is_lamberts_law() -> None:
    """exp(-4 pi k z / wavelength), however dark it gets."""
    black = nc.LayerStack([50000.0], 0.0, 1.5 + 0.5j, substrate=1.5 + 0.5j)
    inside = depth_profile(black, [0.0, 100.0, 1000.0, 4e4], 0.0, 550.0).intensity[0, 0]
    expected = inside[0] * np.exp(-4 * np.pi * 0.5 * np.array([0, 100, 1000, 4e4]) / 550)
    np.testing.assert_allclose(inside, expected, rtol=1e-9)


def test_stacks_layer_by_layer_are_those_of_equal_layers_where_they_are_equal() -> None:
    plain = nc.LayerStack([380.0, 402.0, 391.0, 377.0], 20.0, (1.683, 1.53), 1.43 + 0.01j)
    each = nc.LayerStack(plain.thickness_nm, [20.0] * 4, (1.683, 1.53), 1.43 + 0.01j)
    covered = nc.LayerStack(
        [402.0, 391.0, 377.0],
        20.0,
        (1.683, 1.53),
        1.43 + 0.01j,
        cover=[((1.683, 1.53), 380.0), (1.43 + 0.01j, 20.0)],
    )
    for polarisation in ("s", "p", "unpolarised"):
        expected = energies(plain, ANGLES, NM, polarisation)
        for stack in (each, covered):
            found = energies(stack, ANGLES, NM, polarisation)
            for name in "RTA":
                np.testing.assert_allclose(
                    getattr(found, name), getattr(expected, name), rtol=0, atol=1e-12
                )
    assert each.total_um == pytest.approx(plain.total_um)
    assert each.outer(0.5) == pytest.approx(plain.outer(0.5))


def test_a_cover_like_the_ambient_changes_nothing_and_a_quarter_wave_mirrors_nothing() -> None:
    bare = nc.LayerStack([400.0] * 6, 20.0, ambient=1.33)
    wet = nc.LayerStack([400.0] * 6, 20.0, ambient=1.33, cover=[(1.33, 777.0)])
    assert wet == nc.LayerStack([400.0] * 6, 20.0, ambient=1.33, cover=np.array([[1.33, 777.0]]))
    np.testing.assert_allclose(
        energies(wet, ANGLES, NM).R, energies(bare, ANGLES, NM).R, rtol=0, atol=1e-13
    )
    n = math.sqrt(1.53)
    clear = nc.LayerStack([400.0], 0.0, 1.53, substrate=1.53, cover=[(n, 550 / 4 / n)])
    assert energies(clear, 0.0, 550.0).R[0, 0] < 1e-20


def test_amplitudes_of_one_boundary_are_fresnels() -> None:
    glass = nc.LayerStack([100.0], 0.0, 0.5 + 3.5j, substrate=0.5 + 3.5j)
    light, one = amplitudes(glass, ANGLES, 550.0), fresnel(1.0, 0.5 + 3.5j, ANGLES)
    np.testing.assert_allclose(light.r_s[:, 0], one.r_s, rtol=0, atol=1e-14)
    np.testing.assert_allclose(light.r_p[:, 0], one.r_p, rtol=0, atol=1e-14)


def test_psi_and_delta_are_those_of_the_textbook() -> None:
    """Bare dielectric: delta is pi below Brewster's angle and 0 above; psi is 45 deg head on.

    Known metal: gold, 0.18 + 3.43i at 633 nm and 70 deg has psi 43.7, delta 108 deg by Fresnel's
    equations of Azzam and Bashara (n - ik, exp(+iwt), r_p positive head on), computed here anew.
    """
    dielectric = nc.LayerStack([100.0], 0.0, 1.5, substrate=1.5)
    brewster = math.atan(1.5)
    light = amplitudes(dielectric, [0.0, brewster - 0.1, brewster + 0.1], 633.0)
    np.testing.assert_allclose(light.psi_rad[0, 0], math.pi / 4)
    np.testing.assert_allclose(light.delta_rad[:2, 0], math.pi, rtol=1e-9)
    assert math.cos(light.delta_rad[2, 0]) == pytest.approx(1)
    n, angle = 0.18 - 3.43j, math.radians(70)
    inside = np.sqrt(1 - (math.sin(angle) / n) ** 2 + 0j)
    inside = inside if (n * inside).imag < 0 else -inside
    r_p = (n * math.cos(angle) - inside) / (n * math.cos(angle) + inside)
    r_s = (math.cos(angle) - n * inside) / (math.cos(angle) + n * inside)
    gold = amplitudes(nc.LayerStack([1.0], 0.0, 0.18 + 3.43j, substrate=0.18 + 3.43j), angle, 633.0)
    assert gold.rho[0, 0] == pytest.approx(r_p / r_s, rel=1e-12)
    assert gold.psi_rad[0, 0] == pytest.approx(math.atan(abs(r_p / r_s)))
    assert 0 < gold.delta_rad[0, 0] < math.pi
    assert gold.delta_rad[0, 0] == pytest.approx(np.angle(r_p / r_s), rel=1e-12)


@pytest.mark.parametrize("seed", range(8))
def test_a_plate_out_of_step_agrees_with_tmm(seed: int) -> None:
    """tmm's inc_tmm, film coherent, plate not; lossless and slightly tinted plates, head on."""
    random = np.random.default_rng(seed)
    plate = complex(1.5, [0.0, 1e-5][seed % 2])
    stack = nc.LayerStack(
        random.uniform(100, 500, 4), random.uniform(0, 40, 4), 1.65, 1.4, 1.0, plate
    )
    n, d = layers_of(stack)
    n, d = [*n, 1.2], [*d[:-1], 1e6, math.inf]
    kinds = ["i", *["c"] * (len(n) - 3), "i", "i"]
    for angle in (0.0, 0.6) if plate.imag == 0 else (0.0,):
        for p in "sp":
            peer = tmm.inc_tmm(p, n, d, kinds, angle, 550.0)
            ours = on_plate(stack, 1.0, angle, 550.0, 1.2, p)
            assert ours.R[0, 0] == pytest.approx(peer["R"], abs=1e-10)
            assert ours.T[0, 0] == pytest.approx(peer["T"], abs=1e-10)


def test_a_plate_out_of_step_is_the_mean_over_a_fringe_of_one_in_step() -> None:
    """Independent quadrature: the plate as a coherent layer, over one fringe of thickness."""
    film = nc.LayerStack([300.0, 250.0], 30.0, 1.65, 1.4, substrate=1.5)
    for angle in (0.0, 0.8):
        along = math.sqrt(1.5**2 - math.sin(angle) ** 2)
        found = []
        for share in np.arange(400) / 400:
            nm = 5e4 + share * 550.0 / 2 / along
            # The film as covers of the last nanometre of the plate.
            coherent = nc.LayerStack(
                [1.0],
                0.0,
                1.5,
                1.5,
                1.0,
                1.2,
                [(1.65, 300.0), (1.4, 30.0), (1.65, 250.0), (1.4, 30.0), (1.5, nm - 1.0)],
            )
            found.append(energies(coherent, angle, 550.0).R[0, 0])
        ours = on_plate(film, 0.05, angle, 550.0, 1.2).R[0, 0]
        assert ours == pytest.approx(np.mean(found), abs=1e-9)


def test_energy_is_kept_on_a_plate() -> None:
    clear = nc.LayerStack([300.0] * 5, 20.0, substrate=1.5)
    np.testing.assert_allclose(on_plate(clear, 2.0, ANGLES, NM).A, 0, atol=1e-12)
    dyed = nc.LayerStack([300.0] * 5, 20.0, 1.53, 1.43 + 0.01j, substrate=1.5 + 1e-6j)
    A = on_plate(dyed, 2.0, ANGLES, NM).A
    assert (A > energies(dyed, ANGLES, NM).A).all()
    assert (A < 1).all()
    total = on_plate(nc.LayerStack([300.0], 0.0, 1.6, ambient=1.6, substrate=1.2), 1.0, 1.2, NM)
    np.testing.assert_allclose(total.R, 1, atol=1e-12)  # total reflection: no wave in the plate


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (
            lambda: nc.LayerStack([1.0, 2.0], [1.0, 2.0, 3.0]),
            "protein_nm has 3 values; allowed: one, or 2",
        ),
        (
            lambda: nc.LayerStack([1.0, 2.0], [1.0, -2.0]),
            "protein_nm[1] is -2; allowed: 0 to 1e+06",
        ),
        (
            lambda: nc.LayerStack([1.0], cover=[1.33]),
            "cover[0] is 1.33; allowed: (medium, thickness in nm)",
        ),
        (
            lambda: nc.LayerStack([1.0], cover=[(1.33, -1.0)]),
            "cover[0] thickness is -1; allowed: 0 to",
        ),
        (
            lambda: energies(nc.LayerStack([1.0], cover=[("tar", 1.0)]), 0.0, 550.0),
            "cover[0] is 'tar'; allowed: arag",
        ),
        (lambda: nc.LayerStack([1.0], cover=7), "cover is 7; allowed: up to 100 pairs"),
        (
            lambda: energies(
                nc.LayerStack([1.0], cover=[(1.3, 1.0)]), 0.0, 550.0, coherence_nm=5000.0
            ),
            "coherence_nm is 5000; allowed with a cover or protein layer by layer: None",
        ),
        (
            lambda: energies(nc.LayerStack([1.0, 2.0], [1.0, 2.0]), 0.0, 550.0, "q"),
            "polarisation is 'q'; allowed: s, p",
        ),
        (
            lambda: nc.optics.illuminant(nc.LayerStack([1.0, 2.0], [1.0, 2.0]), 0.0, 550.0),
            "the stack has protein_nm layer by layer; allowed here: one",
        ),
        (
            lambda: depth_profile(nc.LayerStack([1.0]), -1.0, 0.0, 550.0),
            "depth_nm is -1; allowed: 0 to",
        ),
        (
            lambda: on_plate(nc.LayerStack([1.0]), -1.0, 0.0, 550.0),
            "plate_mm is -1; allowed: 0 to 1000",
        ),
        (lambda: amplitudes(7, 0.0, 550.0), "stack is 7; allowed: a LayerStack"),
        (
            lambda: amplitudes(nc.LayerStack([1.0], ambient=(1.5, 1.6)), 0.0, 550.0),
            "the index of ambient changes",
        ),
    ],
)
def test_bad_input_is_refused_in_one_line(act: Any, message: str) -> None:
    with pytest.raises(nc.InputError) as caught:
        act()
    assert str(caught.value).startswith(message)
    assert "\n" not in str(caught.value)


def test_a_covers_medium_is_known_when_the_stack_is_made() -> None:
    for medium, said in (("x", "cover[0] is 'x'; allowed: "), (1.5 - 0.1j, "cover[0]: k is -0.1")):
        with pytest.raises(nc.InputError) as refusal:
            nc.LayerStack([400.0], cover=[(medium, 3.0)])
        assert str(refusal.value).startswith(said)
    kept = dataclasses.asdict(nc.LayerStack([400.0], cover=[("chitin", 3.0)]))
    assert kept["cover"] == (("chitin", 3.0),)

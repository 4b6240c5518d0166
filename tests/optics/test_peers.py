"""Exact stacks against peers: tmm, a 4x4 method, and what was computed elsewhere."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import tmm
from numpy.typing import NDArray
from scipy.linalg import expm

import nacreous as nc
from nacreous.optics import energies, reflectance
from tests.optics.refusal import NM


def random_stack(random: np.random.Generator) -> tuple[nc.LayerStack, float]:
    """A stack of one of six kinds, and an angle; absorbing x oblique x evanescent x metal."""
    kind = random.choice(["lossless", "absorbing", "evanescent", "metal", "metallic", "mixed"])
    bilayers = int(np.exp(random.uniform(0, math.log(400))))
    ambient, k, d_p = 1.0, 0.0, random.uniform(1, 60)
    aragonite, protein = complex(random.uniform(1.5, 1.7)), complex(random.uniform(1.3, 1.6))
    substrate = complex(random.uniform(1.2, 2.0))
    if kind in ("absorbing", "mixed"):
        k = 10 ** random.uniform(-6, -2)
        aragonite, protein = aragonite + k * 1j, protein + 3j * k
    if kind in ("evanescent", "mixed"):
        ambient, protein, d_p = 1.8, complex(random.uniform(1, 1.3)) + k * 1j, random.uniform(1, 9)
        bilayers = min(bilayers, 60)
    if kind in ("metal", "mixed"):
        substrate = complex(random.uniform(0.04, 2), random.uniform(1, 6))
    if kind == "metallic":
        protein, d_p = complex(random.uniform(0.04, 2), random.uniform(1, 6)), random.uniform(1, 9)
        bilayers = min(bilayers, 25)
    thickness_nm = random.uniform(100, 700, bilayers)
    stack = nc.LayerStack(thickness_nm, d_p, aragonite, protein, ambient, substrate)
    return stack, random.uniform(0, 1.55)


@pytest.mark.parametrize("seed", range(200))
def test_random_stacks_agree_with_tmm(seed: int) -> None:
    random = np.random.default_rng(seed)
    stack, angle_rad = random_stack(random)
    wavelength_nm = random.uniform(300, 900)
    layers = [item for d in stack.thickness_nm for item in (d, stack.protein_nm)]
    indices = [stack.aragonite, stack.protein] * len(stack)
    n = [stack.ambient, *indices, stack.substrate]
    for polarisation in "sp":
        peer = tmm.coh_tmm(polarisation, n, [math.inf, *layers, math.inf], angle_rad, wavelength_nm)
        ours = energies(stack, angle_rad, wavelength_nm, polarisation)
        assert float(ours.R[0, 0]) == pytest.approx(peer["R"], abs=1e-10)
        assert float(ours.T[0, 0]) == pytest.approx(peer["T"], abs=1e-10)
        assert float(ours.A[0, 0]) == pytest.approx(1 - peer["R"] - peer["T"], abs=1e-10)


def berreman(
    epsilon: NDArray[np.complex128], across: float, thickness_nm: float, wavelength_nm: float
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Berreman 1972: (matrix of a layer, its Delta) for (Ex, Hy, Ey, -Hx) and any tensor."""
    e = epsilon
    delta = np.array(
        [
            [-across * e[2, 0] / e[2, 2], 1 - across**2 / e[2, 2], -across * e[2, 1] / e[2, 2], 0],
            [
                e[0, 0] - e[0, 2] * e[2, 0] / e[2, 2],
                -across * e[0, 2] / e[2, 2],
                e[0, 1] - e[0, 2] * e[2, 1] / e[2, 2],
                0,
            ],
            [0, 0, 0, 1],
            [
                e[1, 0] - e[1, 2] * e[2, 0] / e[2, 2],
                -across * e[1, 2] / e[2, 2],
                e[1, 1] - e[1, 2] * e[2, 1] / e[2, 2] - across**2,
                0,
            ],
        ]
    )
    return expm(2j * np.pi / wavelength_nm * thickness_nm * delta), delta


def four_by_four(
    stack: nc.LayerStack, angle_rad: float, wavelength_nm: float
) -> dict[str, tuple[float, float]]:
    """R and T for s and p by 4x4 matrices, energies from Poynting's vector."""

    def tensor(medium: Any) -> NDArray[np.complex128]:
        o, e = medium if isinstance(medium, tuple) else (medium, medium)
        return np.diag([o**2, o**2, e**2]).astype(complex)

    n_0 = float(stack.ambient)  # type: ignore[arg-type]
    across, cos = n_0 * math.sin(angle_rad), math.cos(angle_rad)
    through = np.eye(4, dtype=complex)
    for d in stack.thickness_nm:
        for medium, nm in ((stack.aragonite, d), (stack.protein, stack.protein_nm)):
            through = berreman(tensor(medium), across, nm, wavelength_nm)[0] @ through
    slopes, modes = np.linalg.eig(berreman(tensor(stack.substrate), across, 1, 1)[1])
    leaving = modes[:, np.argsort(slopes.imag + 1e-3 * slopes.real)[2:]]

    def flux(psi: NDArray[np.complex128]) -> float:
        return float((psi[0] * psi[1].conj() + psi[2] * psi[3].conj()).real)

    found = {}
    for name, incoming in (("s", [0, 0, 1, n_0 * cos]), ("p", [cos, n_0, 0, 0])):
        back_s, back_p = np.array([0, 0, 1, -n_0 * cos]), np.array([cos, -n_0, 0, 0])
        system = np.column_stack([leaving, -through @ back_s, -through @ back_p])
        t_1, t_2, r_s, r_p = np.linalg.solve(system, through @ np.array(incoming))
        energy = flux(np.array(incoming))
        reflected = -flux(r_s * back_s + r_p * back_p)
        found[name] = (reflected / energy, flux(leaving @ np.array([t_1, t_2])) / energy)
    return found


@pytest.mark.parametrize("seed", range(60))
def test_uniaxial_stacks_agree_with_berremans_4x4_matrices(seed: int) -> None:
    random = np.random.default_rng(1000 + seed)

    def medium(k: float) -> tuple[complex, complex]:
        o, e = random.uniform(1.3, 1.8, 2) + 1j * random.uniform(0, k, 2)
        return complex(o), complex(e)

    k = [0.0, 0.02][seed % 2]
    ambient = [1.0, 1.6][seed // 2 % 2]  # 1.6: total reflection at many angles
    bilayers = int(random.integers(1, 20))
    stack = nc.LayerStack(
        random.uniform(50, 500, bilayers),
        random.uniform(0, 60),
        medium(k),
        medium(k),
        ambient,
        medium(k) if seed % 3 else 1.53,
    )
    angle_rad, wavelength_nm = random.uniform(0, 1.5), random.uniform(350, 800)
    for polarisation, (R, T) in four_by_four(stack, angle_rad, wavelength_nm).items():
        ours = energies(stack, angle_rad, wavelength_nm, polarisation)
        assert float(ours.R[0, 0]) == pytest.approx(R, abs=1e-10)
        assert float(ours.T[0, 0]) == pytest.approx(T, abs=1e-10)


def test_nacre_reflects_as_much_as_was_computed_elsewhere() -> None:
    """100 bilayers head on: 0.088 on average with 1.53, 0.243 with the uniaxial pair (a peer)."""
    layers = np.random.default_rng(0).normal(450, 40, (20, 100))
    for aragonite, expected in ((1.53, 0.088), ((1.683, 1.53), 0.243)):
        stacks = [nc.LayerStack(d, 20.0, aragonite, 1.43) for d in layers]
        mean = np.mean([reflectance(stack, 0.0, NM) for stack in stacks])
        assert mean == pytest.approx(expected, abs=0.03)

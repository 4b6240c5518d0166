"""Light through an ambient that absorbs: the limit of a clear one, and a peer's numbers."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

import numpy as np
import pytest
import tmm
from numpy.typing import NDArray

import nacreous as nc
from nacreous import optics

LAYERS_NM = [380.0, 410.0, 360.0]
NM = np.array([450.0, 550.0, 650.0])
#: Oblique, near grazing, and none; total reflection begins at 0.85 on air.
ANGLES = np.array([0.0, 0.3, 0.7, 1.2, 1.5])
KAPPAS = 10.0 ** np.arange(-16.0, -2.0)

Shares = Callable[[complex], NDArray[np.float64]]


def stacked(**given: object) -> Callable[[complex], nc.LayerStack]:
    return lambda n: nc.LayerStack(LAYERS_NM, ambient=n, **given)  # type: ignore[arg-type]


def energies(stack: Callable[[complex], nc.LayerStack], **given: str) -> Shares:
    def shares(n: complex) -> NDArray[np.float64]:
        found = optics.energies(stack(n), ANGLES, NM, **given)
        return np.stack([found.R, found.T])

    return shares


def boundary(beyond: complex) -> Shares:
    def shares(n: complex) -> NDArray[np.float64]:
        found = optics.fresnel(n, beyond, ANGLES)
        return np.stack([found.R_s, found.R_p, found.T_s, found.T_p])

    return shares


def depth(n: complex) -> NDArray[np.float64]:
    dyed = nc.LayerStack(LAYERS_NM, protein=1.43 + 0.02j, ambient=n)
    return optics.depth_profile(dyed, [0.0, 300.0, 5000.0], ANGLES, NM).intensity


def on_plate(n: complex) -> NDArray[np.float64]:
    found = optics.on_plate(nc.LayerStack(LAYERS_NM, ambient=n), 2.0, ANGLES, NM)
    return np.stack([found.R, found.T])


def ensemble(n: complex) -> NDArray[np.float64]:
    stacks = [nc.LayerStack(np.roll(LAYERS_NM, turn), ambient=n) for turn in range(3)]
    return optics.ensemble(stacks, ANGLES, NM).R


@pytest.mark.parametrize(
    "shares",
    [
        energies(stacked()),
        energies(stacked(substrate=1.0)),
        energies(stacked(protein=1.0, substrate=1.2)),
        energies(stacked(aragonite=(1.683, 1.53), substrate=(1.6, 1.5)), polarisation="p"),
        energies(stacked(substrate=(0.05 + 4j, 0.5)), polarisation="p"),
        energies(stacked(cover=[(1.0, 100.0), (1.48, 500.0)])),
        energies(stacked(protein_nm=[10.0, 20.0, 30.0], substrate=0.05 + 3.3j)),
        boundary(1.53),
        boundary(1.0),
        boundary(0.05 + 3.3j),
        depth,
        on_plate,
        ensemble,
    ],
)
def test_a_clear_ambient_is_the_limit_of_an_absorbing_one(shares: Shares) -> None:
    clear = shares(1.33)
    for k in KAPPAS:
        # Near grazing, where the incoming wave is 14 times as steep, k counts 200 times.
        assert np.abs(shares(1.33 + 1j * k) - clear).max() <= 1e-12 + 200 * k * max(1, clear.max())


def test_in_single_precision_too_a_clear_ambient_is_the_limit() -> None:
    clear = energies(stacked(), precision="single")(1.33)
    for k in KAPPAS:
        single = energies(stacked(), precision="single")(1.33 + 1j * k)
        assert np.abs(single - clear).max() <= 1e-6 + 200 * k


@pytest.mark.parametrize("k", [1e-9, 1e-3, 0.1, 1.0])
def test_an_absorbing_ambient_agrees_with_tmm(k: float) -> None:
    """Its angle is complex there, so that n sin is real."""
    ambient, angle_rad = 1.33 + 1j * k, 0.9
    layers = [item for d in LAYERS_NM for item in (d, 20.0)]
    for protein, substrate in [(1.43, 1.53), (1.43 + 0.01j, 1.0), (1.0, 0.05 + 3.3j)]:
        stack = nc.LayerStack(LAYERS_NM, 20.0, 1.53, protein, ambient, substrate)
        n = [ambient, *[1.53, protein] * len(LAYERS_NM), substrate]
        inner = cmath.asin(1.33 * math.sin(angle_rad) / ambient)
        fields = optics.amplitudes(stack, angle_rad, 550.0)
        for plane in "sp":
            peer = tmm.coh_tmm(plane, n, [math.inf, *layers, math.inf], inner, 550.0)
            ours = optics.energies(stack, angle_rad, 550.0, plane)
            r, t = (getattr(fields, f"{field}_{plane}")[0, 0] for field in "rt")
            sign = 1 if plane == "s" else -1
            assert abs(ours.R[0, 0] - peer["R"]) < 1e-12 * max(1, peer["R"])
            assert abs(ours.T[0, 0] - peer["T"]) < 1e-12 * max(1, peer["T"])
            assert abs(r - sign * peer["r"]) < 1e-12
            assert abs(t - peer["t"]) < 1e-12


@pytest.mark.parametrize("k", [1e-16, 1e-6, 1e-3])
def test_no_share_leaves_0_to_1_by_more_than_the_ambients_k(k: float) -> None:
    found = energies(stacked())(1.33 + 1j * k)
    assert found.min() >= 0
    assert found.max() <= 1 + 2 * k

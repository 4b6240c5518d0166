"""Uniaxial stacks against pyElli, an independent package for 4x4 matrices (Berreman)."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest

import nacreous as nc

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # of the packages that pyElli brings
    import elli

Index = complex | tuple[complex, complex]


def material(index: Index) -> Any:
    parts = [
        elli.ConstantRefractiveIndex(part)
        for part in (index if isinstance(index, tuple) else (index,))
    ]
    return elli.UniaxialMaterial(*parts) if len(parts) == 2 else elli.IsotropicMaterial(*parts)


def peer(stack: nc.LayerStack, angle_rad: float, wavelength_nm: float) -> Any:
    aragonite, protein = material(stack.aragonite), material(stack.protein)
    layers = [
        layer
        for d in stack.thickness_nm
        for layer in (elli.Layer(aragonite, d), elli.Layer(protein, stack.protein_nm))
    ]
    between = elli.Structure(material(stack.ambient), layers, material(stack.substrate))
    return between.evaluate(
        np.array([wavelength_nm]), float(np.degrees(angle_rad)), solver=elli.Solver4x4
    )


@pytest.mark.parametrize("seed", range(40))
def test_uniaxial_stacks_agree_with_another_package(seed: int) -> None:
    """Absorbing and lossless, oblique, both kinds of layer uniaxial.

    The substrate is isotropic and lossless: into others pyElli's transmittance is not the energy's
    (its R and T of a lossless stack on a uniaxial substrate do not add up to 1).
    """
    draw = np.random.default_rng(seed)
    loss = 0.02 if seed % 2 else 0.0

    def index(least: float, most: float) -> complex:
        return complex(draw.uniform(least, most), loss * draw.uniform())

    stack = nc.LayerStack(
        draw.normal(450, 40, draw.integers(1, 40)),
        draw.uniform(5, 60),
        (index(1.6, 1.7), index(1.5, 1.55)),
        (index(1.4, 1.6), index(1.4, 1.6)) if seed % 3 else index(1.4, 1.6),
        1.0,
        draw.uniform(1.3, 2.0),
    )
    angle_rad, wavelength_nm = draw.uniform(0.0, 1.5), draw.uniform(380, 780)
    theirs = peer(stack, angle_rad, wavelength_nm)
    for polarisation in "sp":
        ours = nc.optics.energies(stack, angle_rad, wavelength_nm, polarisation)
        reflected = getattr(theirs, f"R_{polarisation}{polarisation}")
        passed = getattr(theirs, f"T_{polarisation}{polarisation}")
        np.testing.assert_allclose(ours.R[0], reflected, rtol=0, atol=1e-10)
        np.testing.assert_allclose(ours.T[0], passed, rtol=0, atol=1e-10)

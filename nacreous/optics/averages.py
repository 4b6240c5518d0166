"""What instruments see that gather light of many directions: an aperture, an integrating sphere."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.nacre import LayerStack
from nacreous.number import within
from nacreous.optics.amplitudes import asked
from nacreous.optics.transfer import Energies, energies
from nacreous.problem import InputError

Array: TypeAlias = NDArray[np.float64]
#: Angles in rad and their weights, whose sum is 1, for a number of nodes.
Rule: TypeAlias = Callable[[int], tuple[Array, Array]]

#: Nodes are doubled until no value changes by more.
_TOLERANCE = 1e-6
_FIRST_NODES, _MOST_NODES = 16, 4096


def over_aperture(
    stack: LayerStack,
    angle_rad: ArrayLike,
    half_angle_rad: float,
    wavelength_nm: ArrayLike,
    polarisation: str = "unpolarised",
) -> Energies:
    """R, T and A for light of a full cone around each angle, each [angle, wavelength], to 1e-6.

    Every direction within `half_angle_rad` (0 to pi/2) of the axis carries the same power per solid
    angle, as from a lens of even brightness. The whole cone lies above the surface: angle_rad +
    half_angle_rad is at most pi/2. "s" and "p" are of each ray's own plane of incidence. The rest
    as `energies`. Raises `InputError` for what is out of range.

    Fringes of a plate fade as the cone opens:

    >>> from nacreous.nacre import LayerStack
    >>> plate = LayerStack([20000.0], 0.0, aragonite=1.53, substrate=1.0)
    >>> nm = np.linspace(540, 560, 81)
    >>> [round(float(np.ptp(over_aperture(plate, 0.0, half, nm).R)), 2) for half in (0.0, 0.1, 0.3)]
    [0.16, 0.15, 0.01]
    """
    angles, wavelength = asked(stack, angle_rad, wavelength_nm)
    half = within("half_angle_rad", half_angle_rad, 0, math.pi / 2)
    for angle in angles:
        if angle + half > math.pi / 2 + 1e-12:
            raise InputError(
                f"angle_rad is {angle:g}; allowed with half_angle_rad {half:g}: "
                f"0 to {math.pi / 2 - half:g}"
            )
    rows = [
        _averaged(stack, wavelength, polarisation, partial(_cone, float(angle), half))
        for angle in angles
    ]
    shape = (3, angles.size, wavelength.size)
    return Energies(*(np.stack(rows, axis=1) if rows else np.zeros(shape)))


def over_hemisphere(
    stack: LayerStack, wavelength_nm: ArrayLike, polarisation: str = "unpolarised"
) -> Energies:
    """R, T and A for light that comes evenly from all sides, each [1, wavelength], to 1e-6.

    What a sphere that lights the sample evenly makes of it: the mean over the hemisphere with the
    weight cos, Lambert's. The rest as `energies`.

    Glass of n = 1.5 reflects 9.2 % of diffuse light and 4 % of light from above:

    >>> from nacreous.nacre import LayerStack
    >>> glass = LayerStack([100.0], 0.0, aragonite=1.5, substrate=1.5)
    >>> over_hemisphere(glass, 550.0).R.round(4).tolist()
    [[0.0918]]
    """
    _, wavelength = asked(stack, 0.0, wavelength_nm)
    return Energies(*_averaged(stack, wavelength, polarisation, _hemisphere)[:, None])


def _averaged(stack: LayerStack, nm: Array, polarisation: str, rule: Rule) -> Array:
    """R, T, A [3, wavelength], with as many nodes as they need."""
    coarse, nodes = None, _FIRST_NODES
    while True:
        angle, weight = rule(nodes)
        found = energies(stack, angle, nm, polarisation)
        fine = np.stack([weight @ found.R, weight @ found.T, weight @ found.A])
        if coarse is not None and np.abs(fine - coarse).max(initial=0.0) <= _TOLERANCE:
            return fine
        if nodes >= _MOST_NODES:
            raise InputError(
                f"the stack is {stack.total_um:g} um thick; allowed here: one whose fringes "
                f"{_MOST_NODES} directions resolve to {_TOLERANCE:g}"
            )
        coarse, nodes = fine, 2 * nodes


def _hemisphere(nodes: int) -> tuple[Array, Array]:
    """Gauss's rule in the cosine, in which R and T are smooth up to grazing, weight 2 cos."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    cosine = 0.5 * (x + 1)
    return np.arccos(cosine), w * cosine


def _cone(axis: float, half: float, nodes: int) -> tuple[Array, Array]:
    """Gauss's rule in the cosine from the axis, equal steps around it."""
    if half == 0:
        return np.array([axis]), np.ones(1)
    x, w = np.polynomial.legendre.leggauss(nodes)
    cosine = 1 - 0.5 * (1 - math.cos(half)) * (x + 1)
    # Half a turn is enough, for the other half mirrors it; head on, one direction is.
    turns = max(8, nodes // 4) if axis > 0 else 1
    around = (np.arange(turns) + 0.5) * np.pi / turns
    sine = np.sqrt(1 - cosine**2)
    tilted = cosine[:, None] * math.cos(axis) + sine[:, None] * np.cos(around) * math.sin(axis)
    weight = np.repeat(0.5 * w / turns, turns)
    return np.arccos(np.clip(tilted, 0, 1)).ravel(), weight

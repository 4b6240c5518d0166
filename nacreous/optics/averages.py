"""What instruments see that gather light of many directions: an aperture, an integrating sphere."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import integrate

from nacreous.nacre import LayerStack
from nacreous.number import within
from nacreous.optics.amplitudes import asked
from nacreous.optics.transfer import Energies, energies
from nacreous.problem import InputError

Array: TypeAlias = NDArray[np.float64]
#: The share of the light per rad of incidence, at angles in rad.
Density: TypeAlias = Callable[[Array], Array]

#: Pieces are halved until Gauss's and Kronrod's sums differ by no more in all: a tenth of what is
#: promised, for at the kink of total reflection both are wrong alike, by 4e-6 at 1e-6.
_TOLERANCE = 1e-7
_FEWEST_PIECES, _MOST_PIECES = 16, 20_000


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
    half_angle_rad is at most pi/2. "s" and "p" are of each ray's own plane of incidence. A line of
    guided light narrower than 1e-5 rad may be missed, which changes the mean by no more than some
    of its width. The rest as `energies`. Raises `InputError` for what is out of range.

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
    if half == 0:
        return energies(stack, angles, wavelength, polarisation)
    shares = np.zeros((3, angles.size, wavelength.size))
    for row, angle in enumerate(angles):
        cone = _of_cone(float(angle), half)
        shares[:, row] = _averaged(stack, wavelength, polarisation, *cone)
    return Energies(*shares)


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
    edges = [0.0, math.pi / 2]
    shares = _averaged(stack, wavelength, polarisation, lambda angle: np.sin(2 * angle), edges)
    return Energies(*shares[:, None])


def _averaged(
    stack: LayerStack, nm: Array, polarisation: str, density: Density, edges: list[float]
) -> Array:
    """R, T, A [3, wavelength]: the integral over incidence of density times each of them."""
    if nm.size == 0:
        return np.zeros((3, 0))

    def summed(turn: Array) -> Array:
        """Between two edges, the angle runs as 1 - cos, which takes roots at both ends away."""
        at = turn[:, 0]
        piece = np.minimum(at.astype(int), len(edges) - 2)
        low, high = np.array(edges)[piece], np.array(edges)[piece + 1]
        angle = low + (high - low) * np.sin(0.5 * np.pi * (at - piece)) ** 2
        speed = 0.5 * np.pi * (high - low) * np.sin(np.pi * (at - piece))
        found = energies(stack, angle, nm, polarisation)
        weight = (density(angle) * speed)[:, None, None]
        return np.asarray(weight * np.stack([found.R, found.T, found.A], axis=1))

    ends = np.linspace(0, len(edges) - 1, (len(edges) - 1) * _FEWEST_PIECES + 1)[1:-1]
    done = integrate.cubature(
        summed,
        [0.0],
        [len(edges) - 1.0],
        rule="gk21",
        rtol=0,
        atol=_TOLERANCE,
        points=[[end] for end in ends],
        max_subdivisions=_MOST_PIECES,
    )
    if done.status != "converged":
        raise InputError(
            f"the stack, {stack.total_um:g} um thick, changes too fast with the angle; allowed "
            f"here: what {_MOST_PIECES} pieces of 21 directions resolve to {_TOLERANCE:g}"
        )
    return np.asarray(done.estimate)


def _of_cone(axis: float, half: float) -> tuple[Density, list[float]]:
    """The share of the cone's directions at each incidence, and where it has its roots."""

    def density(angle: Array) -> Array:
        # How far around the normal the cone reaches at this incidence: the spherical triangle of
        # normal, axis and ray.
        reach = math.cos(half) - math.cos(axis) * np.cos(angle)
        width = math.sin(axis) * np.sin(angle)
        with np.errstate(divide="ignore", invalid="ignore"):
            around = np.arccos(np.clip(reach / width, -1, 1))
        around = np.where(width > 0, around, np.where(reach > 0, 0.0, np.pi))
        return np.asarray(np.sin(angle) * around / (np.pi * (1 - math.cos(half))))

    edges = {max(axis - half, 0.0), min(axis + half, math.pi / 2)}
    if half > axis:
        edges.add(half - axis)
    return density, sorted(edges)

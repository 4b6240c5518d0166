"""What instruments see that gather light of many directions: an aperture, an integrating sphere."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from nacreous.nacre import LayerStack
from nacreous.number import within
from nacreous.optics.amplitudes import asked
from nacreous.optics.quadrature import Array, Places, UnresolvedError, integrals
from nacreous.optics.transfer import Energies, energies
from nacreous.problem import InputError

#: The share of the light per rad of incidence, [piece, node], from the range that a piece lies in
#: [piece] and angles in rad [piece, node].
Density: TypeAlias = Callable[[Places, Array], Array]

#: Pieces are halved until Gauss's and Kronrod's sums differ by no more in a range: a tenth of what
#: is promised, for at the kink of total reflection both are wrong alike, by 4e-6 at 1e-6.
_TOLERANCE = 1e-7
_FEWEST_PIECES, _MOST_PIECES = 16, 20_000
#: Cones as narrow as this are plane waves: nothing that is resolved changes within them.
_PLANE_RAD = 1e-7


def over_aperture(
    stack: LayerStack,
    angle_rad: ArrayLike,
    half_angle_rad: float,
    wavelength_nm: ArrayLike,
    polarisation: str = "unpolarised",
) -> Energies:
    """R, T and A for light of a full cone around each angle, each [angle, wavelength], to 1e-6.

    Every direction within `half_angle_rad` (0 to pi/2) of the axis carries the same power per solid
    angle, as from a lens of even brightness; up to 1e-7 the cone is taken as a plane wave. The
    whole cone lies above the surface: angle_rad + half_angle_rad is at most pi/2. "s" and "p" are
    of each ray's own plane of incidence. A line of guided light narrower than 1e-5 rad may be
    missed, which changes the mean by no more than some of its width. The rest as `energies`. Raises
    `InputError` for what is out of range.

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
        if not 0 <= angle <= math.pi / 2 - half + 1e-12:
            raise InputError(
                f"angle_rad is {angle:g}; allowed with half_angle_rad {half:g}: "
                f"0 to {math.pi / 2 - half:g}"
            )
    if half <= _PLANE_RAD:
        return energies(stack, angles, wavelength, polarisation)
    cones = _Cones(angles, half)
    parts = _averaged(stack, wavelength, polarisation, cones.density, cones.ends_rad)
    shares = np.zeros((3, angles.size, wavelength.size))
    for part, cone in zip(parts.swapaxes(0, 1), cones.of.tolist(), strict=True):
        shares[:, cone] += part
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
    ends_rad = np.array([[0.0, math.pi / 2]])
    return Energies(*_averaged(stack, wavelength, polarisation, _lambert, ends_rad))


def _averaged(
    stack: LayerStack, nm: Array, polarisation: str, density: Density, ends_rad: Array
) -> Array:
    """R, T, A [3, range, wavelength]: integrals of density times each of them.

    ends_rad: the first and the last incidence of each range, [range, 2].
    """

    def summed(of: Places, turn: Array) -> Array:
        """In a range, the angle runs as 1 - cos, which takes roots at both ends away."""
        low, high = ends_rad[of, :1], ends_rad[of, 1:]
        angle = low + (high - low) * np.sin(0.5 * np.pi * turn) ** 2
        weight = density(of, angle) * 0.5 * np.pi * (high - low) * np.sin(np.pi * turn)
        found = energies(stack, angle.ravel(), nm, polarisation)
        tables = [table.reshape(*angle.shape, nm.size) for table in (found.R, found.T, found.A)]
        return np.concatenate(tables, axis=2) * weight[:, :, None]

    ranges, values = len(ends_rad), 3 * nm.size
    try:
        found = integrals(summed, ranges, values, _TOLERANCE, _FEWEST_PIECES, _MOST_PIECES)
    except UnresolvedError:
        raise InputError(
            f"the stack, {stack.total_um:g} um thick, changes too fast with the angle; allowed "
            f"here: what {_MOST_PIECES} pieces of 21 directions resolve to {_TOLERANCE:g}"
        ) from None
    return found.reshape(ranges, 3, nm.size).swapaxes(0, 1)


def _lambert(_: Places, angle_rad: Array) -> Array:
    return np.asarray(np.sin(2 * angle_rad))


class _Cones:
    """Full cones around some axes: the share of their directions at each incidence.

    That has a root at both ends, and where a cone holds the normal one between them, at which its
    incidences are cut in two. ends_rad: of each range, [range, 2]; of: which cone it belongs to.
    """

    def __init__(self, axis_rad: Array, half_rad: float) -> None:
        self.half_rad = half_rad
        low, root = np.maximum(axis_rad - half_rad, 0), np.maximum(half_rad - axis_rad, 0)
        high = np.minimum(axis_rad + half_rad, math.pi / 2)
        root = np.clip(root, low, high)
        ends_rad = np.array([[low, root], [root, high]]).transpose(2, 0, 1)
        self.of, part = np.nonzero(ends_rad[:, :, 0] < ends_rad[:, :, 1])
        self.ends_rad, self.axis_rad = ends_rad[self.of, part], axis_rad[self.of]

    def density(self, of: Places, angle_rad: Array) -> Array:
        """Of all directions of its cone, the share at an incidence, per rad.

        As far around the normal as the cone reaches there: the spherical triangle of normal, axis
        and ray, by the tangent of half its angle, which keeps its digits where cones are narrow.
        """
        axis, half = self.axis_rad[of, None], self.half_rad
        beyond, apart = axis + angle_rad, axis - angle_rad
        inside = np.sin(0.5 * (half - apart)) * np.sin(0.5 * (half + apart))
        outside = np.sin(0.5 * (beyond + half)) * np.sin(0.5 * (beyond - half))
        around = 2 * np.arctan2(np.sqrt(inside.clip(0)), np.sqrt(outside.clip(0)))
        solid_angle = 4 * math.pi * math.sin(0.5 * half) ** 2
        return np.asarray(2 * np.sin(angle_rad) * around / solid_angle)

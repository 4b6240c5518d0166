"""Complex amplitudes of a whole stack, and the angles that an ellipsometer measures."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.nacre import LayerStack
from nacreous.number import row_of, said
from nacreous.problem import InputError
from nacreous.value import value_class


@value_class
class Amplitudes:
    """What a stack does to a plane wave, each complex128 [angle, wavelength].

    r_s, r_p, t_s, t_p: reflected and transmitted electric fields, across (s) and in (p) the plane
    of incidence, in units of the incoming one, r at the surface and t just inside the substrate
    (for p, where that is uniaxial, by its n_o). Signs and time as everywhere here: r_p is r_s at
    normal incidence, and waves run as exp(i(kx - wt)).
    """

    r_s: NDArray[np.complex128]
    r_p: NDArray[np.complex128]
    t_s: NDArray[np.complex128]
    t_p: NDArray[np.complex128]

    @property
    def rho(self) -> NDArray[np.complex128]:
        """Ellipsometry's tan(psi) exp(i delta), in its own convention.

        There r_p is -r_s at normal incidence and time runs as exp(+iwt), so that rho is -r_p / r_s
        conjugated (R. Azzam and N. Bashara, Ellipsometry and Polarized Light, 1977).
        """
        return np.conj(-self.r_p / self.r_s)

    @property
    def psi_rad(self) -> NDArray[np.float64]:
        """Ellipsometry's psi, 0 to pi/2."""
        return np.arctan2(np.abs(self.r_p), np.abs(self.r_s))

    @property
    def delta_rad(self) -> NDArray[np.float64]:
        """Ellipsometry's delta, 0 to 2 pi; between 0 and pi for bare substrates that absorb."""
        turned = np.conj(-self.r_p) * self.r_s  # no quotient: r_s may be 0
        return np.mod(np.angle(turned), 2 * np.pi)


def amplitudes(stack: LayerStack, angle_rad: ArrayLike, wavelength_nm: ArrayLike) -> Amplitudes:
    """Complex amplitudes of a stack, all reflections included, each [angle, wavelength].

    angle_rad: incidence, 0 to pi/2. wavelength_nm: 1 to 1e6, in vacuum. The table has at most 2^23
    values. Media as for `energies`. Raises `InputError` for what is out of range.

    Psi and delta of aragonite under 20 nm of lacquer, in degrees:

    >>> from nacreous.nacre import LayerStack
    >>> lacquered = LayerStack([400.0], 0.0, aragonite=1.53, substrate=1.53, cover=[(1.48, 20.0)])
    >>> light = amplitudes(lacquered, 1.0, 550.0)
    >>> np.degrees([light.psi_rad[0, 0], light.delta_rad[0, 0]]).round(2).tolist()
    [1.15, 37.9]
    """
    angle, wavelength = asked(stack, angle_rad, wavelength_nm)
    return Amplitudes(*stack.film(wavelength).amplitudes(angle, wavelength)[0])


def asked(
    stack: LayerStack, angle_rad: ArrayLike, wavelength_nm: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Angles and wavelengths of a question about a stack."""
    if not isinstance(stack, LayerStack):
        raise InputError(f"stack is {said(stack)}; allowed: a LayerStack")
    return row_of("angle_rad", angle_rad), row_of("wavelength_nm", wavelength_nm)

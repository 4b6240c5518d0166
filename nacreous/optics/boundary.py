"""One boundary between two media: Fresnel's equations."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.number import array_of, index_of
from nacreous.value import value_class


@value_class
class Fresnel:
    """What one smooth boundary does to a plane wave; every field has the shape of the angle.

    r_s, r_p, t_s, t_p: complex amplitudes, reflected and transmitted, with the electric field
    across (s) and in (p) the plane of incidence. r_p has the paper's sign, that of r_s at normal
    incidence.
    R_s, R_p, T_s, T_p: shares of the energy. R, T: the same for natural light, equations (1), (2).
    """

    r_s: NDArray[np.complex128]
    r_p: NDArray[np.complex128]
    t_s: NDArray[np.complex128]
    t_p: NDArray[np.complex128]
    R_s: NDArray[np.float64]
    R_p: NDArray[np.float64]
    T_s: NDArray[np.float64]
    T_p: NDArray[np.float64]

    @property
    def R(self) -> NDArray[np.float64]:  # noqa: N802, the paper's letter
        """Reflectance of natural light, equation (1)."""
        return 0.5 * (self.R_s + self.R_p)

    @property
    def T(self) -> NDArray[np.float64]:  # noqa: N802, the paper's letter
        """Transmittance of natural light, equation (2)."""
        return 0.5 * (self.T_s + self.T_p)


def fresnel(n_i: complex, n_t: complex, angle_rad: ArrayLike) -> Fresnel:
    """Fresnel's equations for light in `n_i` that meets `n_t` (paper, equations 1 and 2).

    n_i, n_t: indices n or n + ik, 0 < n <= 100, 0 <= k <= 100. angle_rad: incidence, 0 to pi/2, any
    shape. Total reflection included. R + T = 1 for a lossless n_i; T counts the energy just behind
    the boundary. Raises `InputError` for what is out of range.

    Figure 8 of the paper, aragonite to air at normal incidence:

    >>> round(float(fresnel(1.53, 1.0, 0.0).R), 4)
    0.0439
    """
    angle = array_of("angle_rad", angle_rad)
    amplitudes, energies = _core.fresnel(
        index_of("n_i", n_i), index_of("n_t", n_t), np.ascontiguousarray(angle.ravel())
    )
    r_s, r_p, t_s, t_p = (part.reshape(angle.shape) for part in amplitudes)
    R_s, R_p, T_s, T_p = (part.reshape(angle.shape) for part in energies)
    return Fresnel(r_s, r_p, t_s, t_p, R_s, R_p, T_s, T_p)

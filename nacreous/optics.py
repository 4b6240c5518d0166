"""What light does in nacre: Fresnel's equations and the illuminant model of 1996.

Conventions: waves run as exp(i(kx - wt)), so n + ik with k > 0 absorbs; angles in rad from the
normal; tables are [angle, wavelength].
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.nacre import LayerStack, array_of, index_of, number_of, row_of, said
from nacreous.problem import InputError

__all__ = ["Fresnel", "fresnel", "illuminant"]


@dataclass(frozen=True)
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


def illuminant(
    stack: LayerStack,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    coherence_nm: float = 5000.0,
    threshold: float = 0.05,
    diffuse_loss: float = 0.0,
) -> NDArray[np.float64]:
    """Interference light of nacre lit from within, float64 [angle, wavelength] (paper, section 3).

    angle_rad: view angles theta_0, 0 (middle of the pearl) to pi/2 (rim). wavelength_nm: 1 to 1e6.
    The table has at most 2^27 values, 1 GB.
    coherence_nm: waves interfere while their path difference is below this; 5 um in the paper.
    threshold: the sum ends where the light going down falls below this share; 0.05 in the paper.
    diffuse_loss: D of equation (4), the share scattered at each layer, 0 to 1.

    Relative: the intensity sent up from under a layer counts as 1 and all start layers are added,
    so energy is not conserved; see docs/model.md. Does not depend on where a lamp is. Media must
    be lossless, and the nacre denser than its surroundings; `InputError` otherwise.

    >>> from nacreous.nacre import LayerStack
    >>> table = illuminant(LayerStack([420.0] * 100), [0.0, 0.5], [450.0, 550.0, 650.0])
    >>> table.shape
    (2, 3)
    """
    if not isinstance(stack, LayerStack):
        raise InputError(f"stack is {said(stack)}; allowed: a LayerStack")
    return _core.illuminant(
        stack._core,
        row_of("angle_rad", angle_rad),
        row_of("wavelength_nm", wavelength_nm),
        number_of("coherence_nm", coherence_nm),
        number_of("threshold", threshold),
        number_of("diffuse_loss", diffuse_loss),
    )

"""Exact reflectance, transmittance and absorptance of a stack, every reflection included."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.nacre import LayerStack
from nacreous.number import number_of, row_of, said
from nacreous.optics import coherence
from nacreous.problem import InputError
from nacreous.unchanging import released
from nacreous.value import value_class


@value_class
class Energies:
    """Shares of the incoming energy, each float64 [angle, wavelength]; R + T + A = 1.

    R comes back, T arrives just inside the substrate, A stays in the layers. (In an absorbing
    ambient the incoming and the reflected wave exchange energy, and the sum is not 1.)
    """

    R: NDArray[np.float64]
    T: NDArray[np.float64]
    A: NDArray[np.float64]


def energies(
    stack: LayerStack,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    polarisation: str = "unpolarised",
    precision: str = "double",
    coherence_nm: float | None = None,
) -> Energies:
    """Exact reflectance, transmittance and absorptance of a stack, in one pass.

    All reflections inside the stack are added with their phases, by 2x2 transfer matrices; see
    docs/optics.md. angle_rad: incidence, 0 to pi/2. wavelength_nm: 1 to 1e6, in vacuum. The table
    has at most 2^27 values. polarisation: "s", "p" or "unpolarised".
    precision: "double", right to about 1e-12; "single", faster and for nacre of 400 layers right to
    2e-4 up to 85 degrees and on a substrate as dense as the layers (an rms of 1e-5), to 2e-5 / cos
    beyond, for lossless layers (others are computed in double).

    coherence_nm: None for a plane wave of one wavelength; a length for partial coherence: R, T and
    A are averaged over a line of Gaussian shape in wavenumber, full width 0.664 / coherence_nm, to
    1e-4. At least two wavelengths long; media must be known where the line reaches. See
    docs/coherence.md.

    Media may be absorbing, dispersive, metals, uniaxial with their axis along the normal; the
    ambient isotropic; n from 0.001. Other threads run meanwhile, and Ctrl-C interrupts.
    Raises `InputError` for what is out of range.

    >>> from nacreous.nacre import LayerStack
    >>> nacre = LayerStack([380.0] * 100, 20.0, "aragonite", "chitin", 1.0, "aragonite")
    >>> light = energies(nacre, [0.0, 0.5], [450.0, 550.0, 650.0])
    >>> bool(abs(light.R + light.T - 1).max() < 1e-12)
    True
    """
    if not isinstance(stack, LayerStack):
        raise InputError(f"stack is {said(stack)}; allowed: a LayerStack")
    for name, value in (("polarisation", polarisation), ("precision", precision)):
        if not isinstance(value, str):
            raise InputError(f"{name} is {said(value)}; allowed: a name")
    angle, wavelength = row_of("angle_rad", angle_rad), row_of("wavelength_nm", wavelength_nm)

    def exact(nm: NDArray[np.float64]) -> list[NDArray[np.float64]]:
        if not stack.is_plain:
            return _layer_by_layer(stack, angle, nm, polarisation, precision)
        return list(released(_core.energies(stack.at(nm), angle, nm, polarisation, precision)))

    if coherence_nm is None:
        return Energies(*exact(wavelength))
    length_nm = number_of("coherence_nm", coherence_nm)
    if not stack.is_plain:
        raise InputError(
            f"coherence_nm is {length_nm:g}; allowed with a cover or protein layer by layer: None"
        )
    ask = coherence.Question(
        exact,
        lambda nm: _core.resonances(stack.at(nm), coherence.some(angle), nm, polarisation),
        # No index of a layer in sight is far above 2.
        path_nm=2 * 2.0 * 1e3 * stack.total_um,
        layers=2 * len(stack),
        angles=angle.size,
    )
    return Energies(*coherence.averaged(ask, wavelength, length_nm))


def _layer_by_layer(
    stack: LayerStack,
    angle: NDArray[np.float64],
    nm: NDArray[np.float64],
    polarisation: str,
    precision: str,
) -> list[NDArray[np.float64]]:
    """R, T and A of a stack with a cover or unequal proteins, in double precision."""
    if precision not in ("double", "single"):
        raise InputError(f"precision is {said(precision)}; allowed: double, single")
    R, T = polarised(stack.film(nm).amplitudes(angle, nm)[1], polarisation)
    return [released(R), released(T), released(1 - R - T)]


def polarised(
    shares: NDArray[np.float64], polarisation: str
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """R and T of this light from (R_s, R_p, T_s, T_p)."""
    check_polarisation(polarisation)
    if polarisation == "unpolarised":
        return 0.5 * (shares[0] + shares[1]), 0.5 * (shares[2] + shares[3])
    which = "sp".index(polarisation)
    return shares[which].copy(), shares[2 + which].copy()


def check_polarisation(polarisation: str) -> None:
    """Refuse what is no polarisation."""
    if polarisation not in ("s", "p", "unpolarised"):
        raise InputError(f"polarisation is {said(polarisation)}; allowed: s, p, unpolarised")


def reflectance(
    stack: LayerStack,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    polarisation: str = "unpolarised",
    precision: str = "double",
    coherence_nm: float | None = None,
) -> NDArray[np.float64]:
    """Share of the energy that comes back, exact, float64 [angle, wavelength]; as `energies`.

    >>> from nacreous.nacre import LayerStack
    >>> bare = LayerStack([400.0], 0.0, aragonite=1.53, substrate=1.53)
    >>> round(float(reflectance(bare, 0.0, 550.0)[0, 0]), 4)
    0.0439
    """
    return energies(stack, angle_rad, wavelength_nm, polarisation, precision, coherence_nm).R.copy()


def transmittance(
    stack: LayerStack,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    polarisation: str = "unpolarised",
    precision: str = "double",
    coherence_nm: float | None = None,
) -> NDArray[np.float64]:
    """Share of the energy that arrives just inside the substrate, exact; as `energies`.

    >>> from nacreous.nacre import LayerStack
    >>> bare = LayerStack([400.0], 0.0, aragonite=1.53, substrate=1.53)
    >>> round(float(transmittance(bare, 0.0, 550.0)[0, 0]), 4)
    0.9561
    """
    return energies(stack, angle_rad, wavelength_nm, polarisation, precision, coherence_nm).T.copy()


def absorptance(
    stack: LayerStack,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    polarisation: str = "unpolarised",
    precision: str = "double",
    coherence_nm: float | None = None,
) -> NDArray[np.float64]:
    """Share of the energy that stays in the layers, exact; as `energies`.

    >>> from nacreous.nacre import LayerStack
    >>> lossless = LayerStack([400.0] * 50)
    >>> float(absorptance(lossless, 0.3, 550.0)[0, 0])
    0.0
    """
    return energies(stack, angle_rad, wavelength_nm, polarisation, precision, coherence_nm).A.copy()

"""What light does in nacre: Fresnel's equations, exact stacks, the illuminant model of 1996.

Conventions: waves run as exp(i(kx - wt)), so n + ik with k > 0 absorbs; angles in rad from the
normal; tables are [angle, wavelength].
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core, coherence
from nacreous.nacre import LayerStack, grow
from nacreous.number import array_of, index_of, number_of, row_of, said
from nacreous.problem import InputError

if TYPE_CHECKING:
    from nacreous.spec import Growth

__all__ = [
    "Energies",
    "Ensemble",
    "Fresnel",
    "absorptance",
    "energies",
    "ensemble",
    "fresnel",
    "illuminant",
    "reflectance",
    "transmittance",
]


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


@dataclass(frozen=True)
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
    precision: "double", right to about 1e-12; "single", faster and right to 2e-4 for
    nacre of 400 layers (an rms of 1e-5), for lossless layers (others are computed in double).

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
        return list(_core.energies(stack.at(nm), angle, nm, polarisation, precision))

    if coherence_nm is None:
        return Energies(*exact(wavelength))
    length_nm = number_of("coherence_nm", coherence_nm)
    # The start of a search for the step: no index of a layer in sight is far above 2.
    path_nm = 2 * 2.0 * 1e3 * stack.total_um
    return Energies(*coherence.averaged(exact, wavelength, length_nm, path_nm, angle.size))


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


#: The most columns of an ensemble.
MAX_COLUMNS = 10_000

#: Columns grown before they are computed: enough to be worth a call, few megabytes.
AT_ONCE = 64


@dataclass(frozen=True)
class Ensemble:
    """What an eye sees of many columns of tablets side by side, each float64 [angle, wavelength].

    R, T: means over the columns. R_spread, T_spread: standard deviations from column to column.
    columns: how many. A mean is known to R_error or T_error, the standard deviation of itself.
    """

    R: NDArray[np.float64]
    T: NDArray[np.float64]
    R_spread: NDArray[np.float64]
    T_spread: NDArray[np.float64]
    columns: int

    @property
    def R_error(self) -> NDArray[np.float64]:  # noqa: N802, as R
        """Standard error of R: four times the columns halve it."""
        return self.R_spread / math.sqrt(self.columns)

    @property
    def T_error(self) -> NDArray[np.float64]:  # noqa: N802, as T
        """Standard error of T."""
        return self.T_spread / math.sqrt(self.columns)


def ensemble(
    growth: str | Growth,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    columns: int = 64,
    seed: int = 1,
    polarisation: str = "unpolarised",
    precision: str = "double",
    coherence_nm: float | None = None,
    error: float | None = None,
) -> Ensemble:
    """Mean and spread of R and T over stacks that grew alike, each on its own: disordered nacre.

    growth: a nacre preset's name or a `Growth`, as for `nc.grow`. columns: how many stacks, 2 to
    10000; they have the seeds seed, seed + 1, ... and nothing else in common, so light from
    different columns is added by energy **(ours)**. The rest as `energies`.
    error: None, or how well every mean must be known: columns are added until no R_error and no
    T_error is above it. A mean of few columns that chance made alike may stop too early; begin
    with enough of them.

    Same seed, same answer. Raises `InputError` for what is out of range, and for an error that
    10000 columns do not reach.

    >>> nacre = ensemble("akoya-rg", [0.0, 0.5], [450.0, 550.0, 650.0], columns=8, seed=7)
    >>> nacre.R.shape
    (2, 3)
    """
    for name, value, least, most in (
        ("columns", columns, 2, MAX_COLUMNS),
        ("seed", seed, 0, 2**62),
    ):
        if not isinstance(value, (int, np.integer)) or isinstance(value, bool):
            raise InputError(f"{name} is {said(value)}; allowed: a whole number")
        if not least <= value <= most:
            raise InputError(f"{name} is {said(value)}; allowed: {least} to {most}")
    if error is not None and not 1e-9 <= number_of("error", error) <= 1:
        raise InputError(f"error is {said(error)}; allowed: 1e-9 to 1, or None")
    angle, wavelength = row_of("angle_rad", angle_rad), row_of("wavelength_nm", wavelength_nm)
    tables = np.zeros((4, angle.size, wavelength.size))
    done, goal = 0, int(columns)
    while True:
        while done < goal:
            seeds = range(int(seed) + done, int(seed) + min(done + AT_ONCE, goal))
            stacks = [grow(growth, seed=each) for each in seeds]
            if coherence_nm is None:
                sampled = [stack.at(wavelength) for stack in stacks]
                tables = _core.ensemble(
                    sampled, angle, wavelength, polarisation, precision, done, tables
                )
            else:
                for column, stack in enumerate(stacks, start=done + 1):
                    light = energies(
                        stack, angle, wavelength, polarisation, precision, coherence_nm
                    )
                    _add_column(tables, column, light)
            done += len(stacks)
        spread = np.sqrt(tables[2:] / (done - 1))
        found = Ensemble(tables[0], tables[1], spread[0], spread[1], done)
        reached = spread.max(initial=0.0) / math.sqrt(done)
        if error is None or reached <= error:
            return found
        # A standard error falls with the root of the columns.
        goal = max(done + 1, math.ceil(done * (reached / error) ** 2))
        if goal > MAX_COLUMNS:
            raise InputError(
                f"error is {said(error)}; allowed for this nacre: what {MAX_COLUMNS} columns "
                f"reach, about {reached * math.sqrt(done / MAX_COLUMNS):.2g}"
            )


def _add_column(tables: NDArray[np.float64], columns: int, light: Energies) -> None:
    """Welford 1962: no difference of large sums."""
    for mean, squares, share in zip(tables[:2], tables[2:], (light.R, light.T), strict=True):
        step = share - mean
        mean += step / columns
        squares += step * (share - mean)


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
    so energy is not conserved; see docs/model.md. Does not depend on where a lamp is. Media may be
    dispersive, but must be lossless and isotropic, and the nacre denser than its surroundings;
    `InputError` otherwise.

    >>> from nacreous.nacre import LayerStack
    >>> table = illuminant(LayerStack([420.0] * 100), [0.0, 0.5], [450.0, 550.0, 650.0])
    >>> table.shape
    (2, 3)
    """
    if not isinstance(stack, LayerStack):
        raise InputError(f"stack is {said(stack)}; allowed: a LayerStack")
    wavelength = row_of("wavelength_nm", wavelength_nm)
    return _core.illuminant(
        stack.at(wavelength),
        row_of("angle_rad", angle_rad),
        wavelength,
        number_of("coherence_nm", coherence_nm),
        number_of("threshold", threshold),
        number_of("diffuse_loss", diffuse_loss),
    )

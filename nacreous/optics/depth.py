"""Light inside a stack: its field by depth, and where its energy stays."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.nacre import LayerStack
from nacreous.number import row_of
from nacreous.optics.amplitudes import asked
from nacreous.optics.transfer import check_polarisation
from nacreous.value import value_class


@value_class
class DepthProfile:
    """Light by depth below the surface, cover included.

    depth_nm: float64 [depth]. intensity: |E|^2, that of the incoming wave being 1, and
    absorbed_per_nm: the share of the incoming energy that stays per nm; both float64 [angle,
    wavelength, depth]. absorptance: the share that stays in each layer, float64 [angle, wavelength,
    layer]: those of the cover, then aragonite, protein, aragonite, ...; their sum is A.
    """

    depth_nm: NDArray[np.float64]
    intensity: NDArray[np.float64]
    absorbed_per_nm: NDArray[np.float64]
    absorptance: NDArray[np.float64]


def depth_profile(
    stack: LayerStack,
    depth_nm: ArrayLike,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    polarisation: str = "unpolarised",
) -> DepthProfile:
    """The field inside a stack and the energy that stays there, exact.

    depth_nm: 0 (surface) or more; beyond the last layer is the substrate, and at a boundary the
    layer above counts. The rest as `energies`. Angles x wavelengths x depths are at most 2^23.
    Raises `InputError` for what is out of range.

    What stays per nm adds up to what stays in the dyed layer of protein:

    >>> from nacreous.nacre import LayerStack
    >>> stack = LayerStack([400.0], 50.0, 1.53, 1.43 + 0.05j)
    >>> light = depth_profile(stack, np.arange(400.5, 450.0), 0.0, 550.0)
    >>> print(f"{light.absorbed_per_nm[0, 0].sum():.4f}, {light.absorptance[0, 0, 1]:.4f}")
    0.0510, 0.0510
    """
    angle, wavelength = asked(stack, angle_rad, wavelength_nm)
    depth = row_of("depth_nm", depth_nm)
    check_polarisation(polarisation)
    film = stack.film(wavelength)
    return DepthProfile(depth, *film.depth(polarisation, depth, angle, wavelength))

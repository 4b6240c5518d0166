"""Nacre lit from within: the illuminant model of 1996."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.nacre import LayerStack
from nacreous.number import number_of, row_of, said
from nacreous.problem import InputError


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

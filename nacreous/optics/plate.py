"""A film on a plate so thick that light reflected at its back is out of step."""

from __future__ import annotations

from numpy.typing import ArrayLike

from nacreous.medium import Medium, sampled
from nacreous.nacre import LayerStack
from nacreous.number import within
from nacreous.optics.amplitudes import asked
from nacreous.optics.transfer import Energies, polarised
from nacreous.unchanging import released


def on_plate(
    stack: LayerStack,
    plate_mm: float,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    behind: Medium = 1.0,
    polarisation: str = "unpolarised",
) -> Energies:
    """R, T and A of a coherent film on an incoherent plate, each [angle, wavelength].

    The plate is made of the stack's substrate, `plate_mm` thick (0 to 1000 mm), its back plane and
    smooth against the medium `behind`. Light that runs up and down in it is added by energy. T
    arrives just inside `behind`; A stays in film and plate. A plate that absorbs weakens the light
    by exp(-4 pi Im(n cos) / wavelength) of each way; where k is not small beside n, R and T of the
    film towards it are no shares of energy any more, and little comes back from its other side.

    Raises `InputError` for what is out of range.

    A plate of glass reflects 2 r / (1 + r) of the light, r = 0.04 being the share of one side:

    >>> from nacreous.nacre import LayerStack
    >>> glass = LayerStack([100.0], 0.0, aragonite=1.5, substrate=1.5)
    >>> on_plate(glass, 1.0, 0.0, 550.0).R.round(5).tolist()
    [[0.07692]]
    """
    angle, wavelength = asked(stack, angle_rad, wavelength_nm)
    thickness_nm = 1e6 * within("plate_mm", plate_mm, 0, 1000)
    back = sampled("behind", behind, wavelength)
    shares = stack.film(wavelength).on_plate(thickness_nm, back, angle, wavelength)
    R, T = polarised(shares, polarisation)
    return Energies(released(R), released(T), released(1 - R - T))

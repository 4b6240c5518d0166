"""Numbers as this room takes them, and the wavelengths of its spectra."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.problem import InputError

Array = NDArray[np.float64]

WAVELENGTH_NM: Array = _core.spectrum_wavelength_nm()
"""Wavelength of each sample of a spectrum: 380, 381 ... 780 nm."""
WAVELENGTH_NM.flags.writeable = False


def array_of(quantity: str, values: ArrayLike) -> Array:
    """Numbers as the bindings take them: float64, in one block of memory."""
    try:
        array = np.asarray(values)
    except ValueError:  # rows of unequal length
        raise InputError(f"{quantity} is ragged; allowed: an array of numbers") from None
    if array.dtype.kind not in "iuf":
        raise InputError(f"{quantity} has type {array.dtype}; allowed: an array of real numbers")
    return np.asarray(array, dtype=np.float64, order="C")


def white_of(quantity: str, values: ArrayLike) -> tuple[float, float, float]:
    """The three components of a white."""
    array = array_of(quantity, values)
    if array.shape != (3,):
        raise InputError(f"{quantity} has shape {list(array.shape)}; allowed: [3]")
    x, y, z = array.tolist()
    return x, y, z

"""A medium as a layer is given one, and as the compiled rooms take it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.number import index_of, row_of, said
from nacreous.problem import InputError
from nacreous.unchanging import keep
from nacreous.value import value_class

#: The media that are known by name; their sources stand in data/dispersion.csv. "aragonite" is
#: uniaxial and dispersive, as measured: in nacre c stands along the normal.
NAMES: tuple[str, ...] = tuple(_core.media())


@value_class
class IndexTable:
    """A medium measured at some wavelengths; straight lines between them, nothing beyond.

    wavelength_nm: rising, 1 to 1e6 nm. ordinary, extraordinary: n or complex n + ik for each, the
    electric field along the layers and along their normal; one alone for an isotropic medium.

    >>> from nacreous.nacre import LayerStack
    >>> dyed = IndexTable([400.0, 500.0, 800.0], [1.43 + 0.02j, 1.43 + 0.01j, 1.43])
    >>> LayerStack([420.0] * 100, protein=dyed)
    LayerStack(100 layers, 44.000 um)
    """

    wavelength_nm: NDArray[np.float64]
    ordinary: NDArray[np.complex128]
    extraordinary: NDArray[np.complex128]

    def __init__(
        self,
        wavelength_nm: ArrayLike,
        ordinary: ArrayLike,
        extraordinary: ArrayLike | None = None,
    ) -> None:
        along = _indices("ordinary", ordinary)
        across = along if extraordinary is None else _indices("extraordinary", extraordinary)
        nm = row_of("wavelength_nm", wavelength_nm)
        keep(self, wavelength_nm=nm, ordinary=along, extraordinary=across)

    def _columns(
        self,
    ) -> tuple[NDArray[np.float64], NDArray[np.complex128], NDArray[np.complex128]]:
        return self.wavelength_nm, self.ordinary, self.extraordinary

    def __repr__(self) -> str:
        """Range, not every row."""
        nm = self.wavelength_nm
        range_nm = f"{nm[0]:g} to {nm[-1]:g} nm" if nm.size else "empty"
        return f"IndexTable({nm.size} wavelengths, {range_nm})"


#: A function of wavelength_nm, float64, that gives indices: one number, or one for each.
Function: TypeAlias = Callable[[NDArray[np.float64]], ArrayLike]

#: A number n or n + ik, a table, a function, a name, or a pair (n_o, n_e) of numbers or functions.
Medium: TypeAlias = (
    complex | tuple[complex | Function, complex | Function] | str | IndexTable | Function
)


def is_function(medium: object) -> bool:
    """Whether its indices are known only once wavelengths are."""
    if isinstance(medium, (tuple, list)):
        return any(map(callable, medium))
    return callable(medium)


def medium_of(name: str, medium: object) -> _core._Medium:
    """A medium as the bindings take it; a function stands as 1 until its wavelengths are known."""
    if isinstance(medium, str):
        return medium
    if isinstance(medium, IndexTable):
        return medium._columns()
    if isinstance(medium, (tuple, list)) and len(medium) == 2:
        ordinary, extraordinary = (
            1.0 if callable(n) else index_of(f"{name}: {part}", n)
            for part, n in zip(("n_o", "n_e"), medium, strict=True)
        )
        return ordinary, extraordinary
    if callable(medium):
        return 1.0
    try:
        return index_of(name, medium)
    except InputError:
        raise InputError(
            f"{name} is {said(medium)}; allowed: n, n + ik, (n_o, n_e), IndexTable, function, name"
        ) from None


def sampled(name: str, medium: Medium, wavelength_nm: NDArray[np.float64]) -> _core._Medium:
    """A medium at these wavelengths; a function is called here, once."""
    if not is_function(medium):
        return medium_of(name, medium)
    known_nm = np.unique(wavelength_nm)
    if isinstance(medium, (tuple, list)):
        medium_of(name, medium)
        answer: object = tuple(n(known_nm.copy()) if callable(n) else n for n in medium)
    else:
        answer = medium(known_nm.copy())  # type: ignore[operator]
    parts = answer if isinstance(answer, tuple) else (answer,)
    indices = [_indices(f"{name}(wavelength_nm)", part, known_nm.shape) for part in parts]
    if len(indices) > 2 or any(part.shape != known_nm.shape for part in indices):
        shapes = ", ".join(str(part.shape) for part in indices[:3])
        raise InputError(
            f"{name}(wavelength_nm) has shape {shapes}; allowed: a number, that of the "
            f"wavelengths, {known_nm.shape}, or a pair of them"
        )
    return known_nm, indices[0], indices[-1]


def _indices(
    name: str, values: ArrayLike, alike: tuple[int, ...] | None = None
) -> NDArray[np.complex128]:
    """A one-dimensional complex128 array, or one clear message; `alike`: what a number fills."""
    try:
        array = np.asarray(values)
    except (TypeError, ValueError):  # lists of different lengths
        array = np.array(None)
    if array.dtype.kind not in "iufc":
        raise InputError(f"{name} is {said(values)}; allowed: numbers")
    if array.ndim == 0 and alike is not None:
        array = np.full(alike, array)
    if array.ndim != 1:
        raise InputError(f"{name} has {array.ndim} dimensions; allowed: 1")
    return array.astype(np.complex128)

"""Partial coherence: what exact optics says of light whose waves do not stay in step for ever.

A line of Gaussian shape in wavenumber (1 / wavelength) stands around each wavelength. With the
coherence length L as Mandel and Wolf define it, the integral of |g|^2 over path differences x,

    |g(x)| = exp(-pi x^2 / (2 L^2))        how far fringes of path difference x still show
    full width at half maximum of the line = sqrt(2 ln 2 / pi) / L = 0.664 / L

(L. Mandel and E. Wolf, Optical Coherence and Quantum Optics, 4.3; B. Saleh and M. Teich,
Fundamentals of Photonics, table 11.1-2). Averaging exact R, T and A over the line multiplies the
fringes of every path difference by g, all reflections included.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError

Array = NDArray[np.float64]

#: Half the line, in units of 1 / coherence length; what lies beyond is 1e-8 of its top.
_REACH = 1.72
#: Steps in wavenumber are halved until no value changes by more. Where nothing resonates (a plate,
#: a few layers) the answer is then right to 1e-6; hundreds of uneven layers trap light in lines so
#: narrow that more digits would take a hundred times the work.
_TOLERANCE = 1e-4
#: Spectra times angles: 64 MB a table.
_MOST_VALUES = 1 << 23


def averaged(
    exact: Callable[[Array], list[Array]],
    wavelength_nm: Array,
    coherence_nm: float,
    path_nm: float,
    angles: int,
) -> list[Array]:
    """Each table [angle, wavelength] that `exact` gives for wavelengths, averaged over the line.

    The rule of equal steps in wavenumber, which for a Gaussian is right to more digits than asked
    once a step is shorter than 1 / (path difference + 3 coherence lengths). path_nm: the longest
    path difference there is with one reflection, from which the search for the step starts.
    """
    _check(wavelength_nm, coherence_nm)
    nodes_per_wavenumber = 2 * path_nm + 4 * coherence_nm
    coarse = None
    while True:
        fine = _tables(exact, wavelength_nm, coherence_nm, nodes_per_wavenumber, angles)
        if coarse is not None and _change(coarse, fine) <= _TOLERANCE:
            return fine
        coarse, nodes_per_wavenumber = fine, 2 * nodes_per_wavenumber


def _check(wavelength_nm: Array, coherence_nm: float) -> None:
    if not 0 < coherence_nm <= 1e9:
        raise InputError(f"coherence_nm is {coherence_nm:g}; allowed: above 0, up to 1e9 nm")
    beyond = ~((wavelength_nm >= 1) & (wavelength_nm <= 1e6))
    if beyond.any():
        raise InputError(f"wavelength_nm is {wavelength_nm[beyond][0]:g}; allowed: 1 to 1000000 nm")
    longest_nm = wavelength_nm.max(initial=0.0)
    if coherence_nm < 2 * longest_nm:
        raise InputError(
            f"coherence_nm is {coherence_nm:g}; allowed at {longest_nm:g} nm: "
            f"from {2 * longest_nm:g} nm, two waves"
        )


def _change(coarse: list[Array], fine: list[Array]) -> float:
    pairs = zip(coarse, fine, strict=True)
    return max(float(np.abs(b - a).max(initial=0.0)) for a, b in pairs)


def _tables(
    exact: Callable[[Array], list[Array]],
    wavelength_nm: Array,
    coherence_nm: float,
    nodes_per_wavenumber: float,
    angles: int,
) -> list[Array]:
    """The averages with one step of nodes; lines share the nodes where they overlap."""
    middle = nodes_per_wavenumber / wavelength_nm
    half_nodes = _REACH * nodes_per_wavenumber / coherence_nm
    first, last = np.ceil(middle - half_nodes), np.floor(middle + half_nodes)
    together = float(2 * half_nodes * wavelength_nm.size)
    apart = float(last.max(initial=0) - first.min(initial=np.inf))
    if together > 4 * _MOST_VALUES or min(together, apart) * angles > _MOST_VALUES:
        raise InputError(
            f"coherence_nm is {coherence_nm:g}, for which a stack so thick needs "
            f"{min(together, apart):.0f} wavelengths; allowed: fewer angles or wavelengths"
        )
    ranges = [np.arange(a, b + 1) for a, b in zip(first, last, strict=True)]
    nodes = np.unique(np.concatenate(ranges)) if ranges else np.zeros(0)
    known = exact(nodes_per_wavenumber / nodes)
    means = [np.empty((table.shape[0], wavelength_nm.size)) for table in known]
    for i, places in enumerate(ranges):
        distance = (places - middle[i]) * (coherence_nm / nodes_per_wavenumber)
        weight = np.exp(-2 * np.pi * distance**2)
        at = slice(*np.searchsorted(nodes, (places[0], places[-1] + 1)))
        for mean, table in zip(means, known, strict=True):
            mean[:, i] = table[:, at] @ (weight / weight.sum())
    return means

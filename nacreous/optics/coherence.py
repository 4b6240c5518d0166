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

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError

Array = NDArray[np.float64]
#: Series, wavenumber, half width and height of each.
Lines: TypeAlias = tuple[NDArray[np.uint64], Array, Array, Array]

#: Half the line, in units of 1 / coherence length; what lies beyond is 1e-8 of its top.
_REACH = 1.72
#: Steps in wavenumber are halved until no value changes by more. Where nothing resonates (a plate,
#: a few layers) the answer is then right to 1e-6; hundreds of uneven layers trap light in lines so
#: narrow that more digits would take a hundred times the work.
_TOLERANCE = 1e-4
#: What lines narrower than a step may hold together, as a share of the energy.
_UNRESOLVED = 3e-5
#: Steps to half the width of a line: the rule of equal steps then misses 1e-4 of it.
_STEPS_TO_HALF_WIDTH = 1.5
#: Angles at which lines are looked for; their widths change slowly with the angle.
_ANGLES = 16
#: Values a table may have that is worked out in one piece: 64 MB.
_AT_ONCE = 1 << 23
#: Wavelengths times angles times layers that are spent on narrow lines: about a second. Hundreds of
#: uneven layers trap light in lines without end, which hold ever less of it.
_WORK_FOR_LINES = 2e8
#: Wavelengths times angles times layers that a call may take: some ten minutes.
_MOST_WORK = 1e12


@dataclass(frozen=True)
class Question:
    """What is averaged: exact tables of one stack.

    exact: R, T and A, each [angle, wavelength], at wavelengths in nm. lines: as
    `_core.resonances`, at some of the angles. path_nm: the longest path difference there is with
    one reflection. layers: how many; angles: how many.
    """

    exact: Callable[[Array], list[Array]]
    lines: Callable[[Array], Lines]
    path_nm: float
    layers: int
    angles: int


def averaged(ask: Question, wavelength_nm: Array, coherence_nm: float) -> list[Array]:
    """Each table [angle, wavelength] that `ask.exact` gives, averaged over the line.

    The rule of equal steps in wavenumber, which for a Gaussian is right to more digits than asked
    once a step is shorter than 1 / (path difference + 3 coherence lengths), and shorter than the
    lines in which light resonates. From there steps are halved until nothing changes.
    """
    _check(wavelength_nm, coherence_nm)
    if wavelength_nm.size * ask.angles == 0:
        return ask.exact(wavelength_nm)
    _check_reach(ask, wavelength_nm, coherence_nm)
    nodes_per_wavenumber = _nodes_per_wavenumber(ask, wavelength_nm, coherence_nm)
    coarse = None
    while True:
        line = Line(wavelength_nm, coherence_nm, nodes_per_wavenumber)
        fine = _tables(ask, line)
        if coarse is not None and _change(coarse, fine) <= _TOLERANCE:
            return fine
        coarse, nodes_per_wavenumber = fine, 2 * nodes_per_wavenumber


def some(angle_rad: Array) -> Array:
    """The angles at which lines are looked for, the ends among them."""
    places = np.linspace(0, angle_rad.size - 1, min(angle_rad.size, _ANGLES)).round()
    return angle_rad[places.astype(np.intp)]


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


def _check_reach(ask: Question, wavelength_nm: Array, coherence_nm: float) -> None:
    """Media are known where lines reach, or the message says that the line is what asks."""
    asked_nm = np.array([wavelength_nm.min(), wavelength_nm.max()])
    ask.exact(asked_nm)
    reach = _REACH / coherence_nm
    for nm, end_nm in zip(asked_nm, 1 / (1 / asked_nm + reach * np.array([1, -1])), strict=True):
        try:
            ask.exact(np.array([end_nm]))
        except InputError as problem:
            what, _, allowed = str(problem).partition("; ")
            if not what.startswith("wavelength_nm is"):
                raise
            raise InputError(
                f"coherence_nm is {coherence_nm:g}, whose line around {nm:g} nm reaches to "
                f"{end_nm:.4g} nm; {allowed}"
            ) from None


def _change(coarse: list[Array], fine: list[Array]) -> float:
    pairs = zip(coarse, fine, strict=True)
    return max(float(np.abs(b - a).max(initial=0.0)) for a, b in pairs)


def _nodes_per_wavenumber(ask: Question, wavelength_nm: Array, coherence_nm: float) -> float:
    """For path differences, the line, and the narrow lines of the stack that matter."""
    at_least = 2 * ask.path_nm + 4 * coherence_nm
    coarse = Line(wavelength_nm, coherence_nm, 2 * at_least)
    _check_work(ask, coarse)
    found = [ask.lines(coarse.per_wavenumber / nodes) for nodes in coarse.pieces(ask)]
    series, at, half_width, height = map(np.concatenate, zip(*found, strict=True))
    # What each holds of the energy of the light line that lies on top of it, Lorentz's area.
    share = np.pi * half_width * height * math.sqrt(2) * coherence_nm
    missed = np.flatnonzero(half_width * at_least < _STEPS_TO_HALF_WIDTH)
    missed = missed[np.argsort(half_width[missed])]
    needed = at_least
    for one in np.unique(series[missed]):
        mine = missed[series[missed] == one]
        apart = coherence_nm * (at[mine, None] - 1 / wavelength_nm)
        unresolved = np.cumsum(share[mine, None] * np.exp(-2 * np.pi * apart**2), axis=0)
        counts = (unresolved > _UNRESOLVED).any(axis=1)
        if counts.any():
            needed = max(needed, _STEPS_TO_HALF_WIDTH / float(half_width[mine[counts.argmax()]]))
    nodes = _WORK_FOR_LINES / (ask.angles * ask.layers)
    return max(at_least, min(needed, coarse.per_wavenumber * nodes / coarse.nodes()))


class Line:
    """Light lines around some wavelengths, and their nodes, evenly in wavenumber."""

    def __init__(self, wavelength_nm: Array, coherence_nm: float, per_wavenumber: float) -> None:
        self.per_wavenumber = per_wavenumber
        self.middle = per_wavenumber / wavelength_nm
        self.per_length = coherence_nm / per_wavenumber
        half = _REACH / self.per_length
        self.first = np.ceil(self.middle - half).astype(np.int64)
        self.last = np.floor(self.middle + half).astype(np.int64)

    def ranges(self) -> list[tuple[int, int]]:
        """First and last node of lines that overlap, together, rising."""
        found: list[tuple[int, int]] = []
        for first, last in sorted(zip(self.first.tolist(), self.last.tolist(), strict=True)):
            if found and first <= found[-1][1] + 1:
                found[-1] = (found[-1][0], max(last, found[-1][1]))
            else:
                found.append((first, last))
        return found

    def nodes(self) -> int:
        """How many there are."""
        return sum(last - first + 1 for first, last in self.ranges())

    def pieces(self, ask: Question) -> Iterator[NDArray[np.int64]]:
        """The nodes in pieces that memory holds."""
        most = max(_AT_ONCE // ask.angles, 1)
        for first, last in self.ranges():
            for start in range(first, last + 1, most):
                yield np.arange(start, min(start + most, last + 1))

    def weights(self, i: int, nodes: NDArray[np.int64]) -> Array:
        """Of a piece of nodes for one wavelength; all of them add up to 1 nearly."""
        distance = (nodes - self.middle[i]) * self.per_length
        weights: Array = np.exp(-2 * np.pi * distance**2)
        return weights


def _check_work(ask: Question, line: Line) -> None:
    work = float(line.nodes()) * ask.angles * ask.layers
    if work > _MOST_WORK:
        raise InputError(
            f"coherence_nm is {line.per_length * line.per_wavenumber:g}, for which this stack "
            f"needs {line.nodes()} wavelengths; allowed: fewer angles, wavelengths or layers, "
            f"{work / _MOST_WORK:.2g} times too many"
        )


def _tables(ask: Question, line: Line) -> list[Array]:
    """The averages with one step of nodes; lines share the nodes where they overlap."""
    _check_work(ask, line)
    size = line.middle.size
    means, total = [np.zeros((ask.angles, size)) for _ in range(3)], np.zeros(size)
    for nodes in line.pieces(ask):
        known = ask.exact(line.per_wavenumber / nodes)
        for i in np.flatnonzero((line.first <= nodes[-1]) & (line.last >= nodes[0])).tolist():
            part = slice(*np.searchsorted(nodes, (line.first[i], line.last[i] + 1)))
            weight = line.weights(i, nodes[part])
            total[i] += weight.sum()
            for mean, table in zip(means, known, strict=True):
                mean[:, i] += table[:, part] @ weight
    return [mean / total for mean in means]

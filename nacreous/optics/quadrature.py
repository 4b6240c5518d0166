"""Integrals of tables, many at once: pieces are halved until Gauss's and Kronrod's sums agree.

All pieces of all integrals that are still open are asked for in one go, for a call costs as much as
some hundred values. Nodes and weights: R. Piessens and others, QUADPACK (1983), dqk21.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Places: TypeAlias = NDArray[np.intp]
#: Values [piece, node, value] at places [piece, node], from the integral that a piece belongs to
#: [piece].
Integrand: TypeAlias = Callable[[Places, Array], Array]

#: Kronrod's nodes from 1 to 0, every second of them Gauss's, their weights and Gauss's.
_NODES = [
    *(0.9956571630258081, 0.9739065285171717, 0.9301574913557082, 0.8650633666889845),
    *(0.7808177265864169, 0.6794095682990244, 0.5627571346686047, 0.4333953941292472),
    *(0.2943928627014602, 0.1488743389816312, 0.0),
]
_WEIGHTS = [
    *(0.011694638867371874, 0.032558162307964725, 0.054755896574351995, 0.07503967481091996),
    *(0.0931254545836976, 0.10938715880229764, 0.12349197626206585, 0.13470921731147334),
    *(0.14277593857706009, 0.14773910490133849, 0.1494455540029169),
]
_GAUSS = [
    *(0.06667134430868814, 0.1494513491505806, 0.21908636251598204),
    *(0.26926671930999635, 0.29552422471475287),
]
_BOTH_SIDES = np.array([*(-node for node in _NODES[:-1]), *_NODES[::-1]])
_KRONROD = np.array([*_WEIGHTS, *_WEIGHTS[-2::-1]])
_APART = _KRONROD.copy()
_APART[1::2] -= [*_GAUSS, *_GAUSS[::-1]]

#: Values of the integrand that are held at a time: 2 MB.
_AT_ONCE = 1 << 18


class UnresolvedError(Exception):
    """An integrand that more pieces would resolve than are allowed."""


def integrals(
    integrand: Integrand, rows: int, values: int, tolerance: float, fewest: int, most: int
) -> Array:
    """Integrals from 0 to 1 of `rows` integrands of so many values each, [row, value].

    Each begins with `fewest` pieces of its own. Those with more than an even share of the tolerance
    are halved until Gauss's and Kronrod's sums, added over pieces, differ by no more than
    `tolerance` in any value. No integral depends on those beside it. Raises `UnresolvedError` where
    one takes more than `most` pieces.
    """
    found = np.zeros((rows, values))
    if found.size:
        for some in _parts(rows, fewest * values):
            mine = np.arange(rows)[some]
            found[some] = _together(integrand, mine, values, tolerance, fewest, most)
    return found


def _parts(items: int, values: int) -> Iterator[slice]:
    """Items of so many values at every node, in parts that memory holds."""
    step = max(1, _AT_ONCE // (_BOTH_SIDES.size * values))
    return (slice(first, first + step) for first in range(0, items, step))


def _together(
    integrand: Integrand, rows: Places, values: int, tolerance: float, fewest: int, most: int
) -> Array:
    edges = np.linspace(0, 1, fewest + 1)
    of = np.repeat(np.arange(rows.size), fewest)
    ends = np.tile(np.stack([edges[:-1], edges[1:]], axis=1), (rows.size, 1))
    found, apart = _sums(integrand, rows[of], ends, values)
    while True:
        pieces = np.bincount(of, minlength=rows.size)
        error = _by_row(apart, of, rows.size).max(axis=1)
        late = (error[of] > tolerance) & (apart.max(axis=1) * pieces[of] > tolerance)
        if not late.any():
            return _by_row(found, of, rows.size)
        if (pieces + np.bincount(of[late], minlength=rows.size)).max() > most:
            raise UnresolvedError
        halves, whose = _halved(ends[late]), np.repeat(of[late], 2)
        new = _sums(integrand, rows[whose], halves, values)
        found, apart = np.vstack([found[~late], new[0]]), np.vstack([apart[~late], new[1]])
        of, ends = np.concatenate([of[~late], whose]), np.vstack([ends[~late], halves])


def _halved(ends: Array) -> Array:
    halves = np.repeat(ends, 2, axis=0)
    halves[::2, 1] = halves[1::2, 0] = ends.mean(axis=1)
    return halves


def _sums(integrand: Integrand, row: Places, ends: Array, values: int) -> tuple[Array, Array]:
    """Kronrod's sums over pieces [piece, value], and how far Gauss's are from them."""
    found, apart = np.zeros((2, row.size, values))
    middle, half = ends.mean(axis=1)[:, None], 0.5 * np.diff(ends, axis=1)
    for some in _parts(row.size, values):
        table = integrand(row[some], middle[some] + half[some] * _BOTH_SIDES)
        # Node by node: whole products would add up in another order for another number of pieces.
        for node, (weight, difference) in enumerate(zip(_KRONROD, _APART, strict=True)):
            found[some] += weight * table[:, node]
            apart[some] += difference * table[:, node]
    return half * found, np.abs(half * apart)


def _by_row(pieces: Array, row: Places, rows: int) -> Array:
    """The sums over the pieces of each integral, in the order of the pieces."""
    total = np.zeros((rows, pieces.shape[1]))
    np.add.at(total, row, pieces)
    return total

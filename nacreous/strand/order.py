"""The order of pearls within a strand, so that neighbours match."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.strand.form import Form

__all__ = ["ordered"]

Array = NDArray[np.float64]
Pearls = NDArray[np.int64]


def ordered(apart: Array, size_mm: Array, form: Form) -> Pearls:
    """The pearls of a strand in their places, int64 [place].

    apart: [pearl, pearl], differences without size for a graduated strand, with it for an even one.

    Even: SciPy's optimal order of the leaves of a tree (Bar-Joseph and others 2001): of the orders
    that the tree of average differences allows, the one of least differences between neighbours;
    other orders may be better still. Graduated: sizes grow from both ends to the centre; the best
    of all ways to put the two of each step to the left and to the right, as a shortest path.
    """
    if len(apart) < 3:
        return np.argsort(size_mm, kind="stable")
    return _graduated(apart, size_mm) if form.graduation_mm > 0 else _even(apart)


def _even(apart: Array) -> Pearls:
    from scipy.cluster.hierarchy import leaves_list, linkage, optimal_leaf_ordering
    from scipy.spatial.distance import squareform

    condensed = squareform(apart, checks=False)
    tree = optimal_leaf_ordering(linkage(condensed, "average"), condensed)
    leaves: Pearls = leaves_list(tree).astype(np.int64)
    return leaves


def _graduated(apart: Array, size_mm: Array) -> Pearls:
    """Pairs of pearls of neighbouring sizes, from the ends to the centre."""
    by_size = np.argsort(size_mm, kind="stable")
    steps = len(by_size) // 2
    pairs = by_size[: 2 * steps].reshape(steps, 2)
    swapped = _sides(apart, pairs)
    left = np.where(swapped, pairs[:, 1], pairs[:, 0])
    right = np.where(swapped, pairs[:, 0], pairs[:, 1])
    return np.concatenate([left, by_size[2 * steps :], right[::-1]])


def _sides(apart: Array, pairs: Pearls) -> NDArray[np.bool_]:
    """Bool [step], whether the first of a pair hangs to the right, by the shortest path.

    The path's points are (step, swapped or not), each joined to both of the next step.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    first, second = pairs[:, 0], pairs[:, 1]
    along = apart[first[:-1], first[1:]] + apart[second[:-1], second[1:]]
    across = apart[first[:-1], second[1:]] + apart[second[:-1], first[1:]]
    at = 2 * np.arange(len(pairs) - 1)
    begin = np.concatenate([at, at + 1, at, at + 1])
    end = np.concatenate([at + 2, at + 3, at + 3, at + 2])
    # A sparse matrix has no edge of length 0; as all paths have as many edges, 1 more changes none.
    length = 1 + np.concatenate([along, along, across, across])
    points = 2 * len(pairs)
    graph = csr_array((length, (begin, end)), shape=(points, points))
    distance, before = dijkstra(graph, indices=0, return_predecessors=True)
    point = points - 2 + int(distance[points - 1] < distance[points - 2])
    swapped = np.zeros(len(pairs), bool)
    for step in range(len(pairs) - 1, -1, -1):
        swapped[step] = point % 2
        point = before[point]
    return swapped

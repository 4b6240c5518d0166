"""The order of pairs in a session, and who stands on the left."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

#: Short lists are arranged anew until no stimulus is shown twice in a row, at most so often.
_MOST_TRIES = 200
_MOST_REPAIRS = 100


def balanced_sides(
    pairs: NDArray[np.int64], count: int, random: np.random.Generator
) -> NDArray[np.int64]:
    """int64 [pair, 2], left and right, so that each stimulus is as often on either side.

    Where a stimulus is in an odd number of pairs, one side has one more. The pairs are the edges of
    a graph: walk along a closed trail through all of them (Euler 1736), and of each edge the end
    where it is entered is the left one. An extra vertex makes odd ones even.
    """
    odd = np.flatnonzero(np.bincount(pairs.ravel(), minlength=count) % 2)
    extra = np.stack([odd, np.full(len(odd), count)], axis=1)
    edges = np.concatenate([random.permutation(pairs, axis=0), extra]).tolist()
    at: list[list[int]] = [[] for _ in range(count + 1)]
    for edge, (a, b) in enumerate(edges):
        at[a].append(edge)
        at[b].append(edge)
    walked = [False] * len(edges)
    sided = {}
    for start in range(count + 1):
        here = start
        while True:  # every vertex has an even number of edges, so a walk ends where it began
            while at[here] and walked[at[here][-1]]:
                at[here].pop()
            if not at[here]:
                break
            edge = at[here].pop()
            walked[edge] = True
            a, b = edges[edge]
            there = b if a == here else a
            sided[min(here, there), max(here, there)] = (here, there)
            here = there
    return np.array([sided[min(a, b), max(a, b)] for a, b in pairs.tolist()], np.int64)


def in_sequence(
    pairs: NDArray[np.int64], random: np.random.Generator, before: NDArray[np.int64] | None = None
) -> NDArray[np.int64]:
    """int64 [pair], a random order in which no stimulus is shown twice in a row where possible.

    `before` is the pair shown before the first. With fewer than five stimuli it is not possible.
    """
    rows = [frozenset(pair) for pair in pairs.tolist()]
    last = frozenset(before.tolist()) if before is not None else frozenset()
    best: list[int] = []
    fewest = len(rows) + 1
    for _ in range(max(1, min(_MOST_TRIES, 20_000 // len(rows)))):
        order = _greedy(rows, random.permutation(len(rows)).tolist(), last)
        clashes = _clashes(rows, order, last)
        if clashes:
            _repair(rows, order, clashes[:_MOST_REPAIRS])
            clashes = _clashes(rows, order, last)
        if len(clashes) < fewest:
            best, fewest = order, len(clashes)
        if fewest == 0:
            break
    return np.array(best, np.int64)


def _greedy(rows: list[frozenset[int]], order: list[int], last: frozenset[int]) -> list[int]:
    """Always the next pair of a random list that shares nothing with the one before."""
    for place in range(len(order)):
        for later in range(place, len(order)):
            if last.isdisjoint(rows[order[later]]):
                order[place], order[later] = order[later], order[place]
                break
        last = rows[order[place]]
    return order


def _clashes(rows: list[frozenset[int]], order: list[int], last: frozenset[int]) -> list[int]:
    """The places of pairs that share a stimulus with the one before."""
    found = []
    for place, row in enumerate(order):
        if not last.isdisjoint(rows[row]):
            found.append(place)
        last = rows[row]
    return found


def _repair(rows: list[frozenset[int]], order: list[int], clashes: list[int]) -> None:
    """Move each of these pairs to a place between two that it shares nothing with, if any."""
    for place in reversed(clashes):  # from the end, so that earlier places stay what they are
        row = order.pop(place)
        for here in range(1, len(order)):
            around = rows[order[here - 1]] | rows[order[here]]
            if around.isdisjoint(rows[row]):
                order.insert(here, row)
                break
        else:
            order.insert(place, row)

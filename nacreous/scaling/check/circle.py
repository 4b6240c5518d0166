"""Circular triads counted where not every pair was compared."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.tournament import Shares

#: So many bytes of rows are looked at in one go.
_BLOCK_BYTES = 2**24


def count_open(shares: Shares) -> tuple[float, int]:
    """How many triads are circular, and how many are complete.

    Each stimulus has a row of bits, one for each other that it beats; for each pair, the third
    ones that close a circle are the bits common to two rows. This takes n² / 8 bytes a kind of row
    and n / 8 steps a pair. A triad with ties counts by the product of its halves, as coins would
    have it.
    """
    beats, count = shares.majority, shares.stimuli
    forward, backward, tied = beats == 1, beats == 0, beats == 0.5
    winner = np.concatenate([shares.first[forward], shares.second[backward]])
    loser = np.concatenate([shares.second[forward], shares.first[backward]])
    even = np.concatenate([shares.first[tied], shares.second[tied]])
    other = np.concatenate([shares.second[tied], shares.first[tied]])
    over, under = _bits(count, winner, loser), _bits(count, loser, winner)
    same = _bits(count, even, other)
    met = over | under | same
    circles = 0.0
    for start, end, weight in ((winner, loser, 1.0), (even, other, 0.5)):
        if len(start):
            circles += weight * _common(over, end, under, start)
            if len(even):
                halves = _common(same, end, under, start) + _common(over, end, same, start)
                circles += weight * (halves / 2 + _common(same, end, same, start) / 4)
    return circles / 3, _common(met, shares.first, met, shares.second) // 3


def _bits(count: int, row: NDArray[np.int64], column: NDArray[np.int64]) -> NDArray[np.uint64]:
    """A row of bits a stimulus, packed in words, set where (row, column) is a pair."""
    words = (count + 63) // 64
    bits = np.zeros((count, words), np.uint64)
    np.bitwise_or.at(bits, (row, column // 64), np.uint64(1) << (column % 64).astype(np.uint64))
    return bits


def _common(
    one: NDArray[np.uint64],
    row: NDArray[np.int64],
    other: NDArray[np.uint64],
    row_of_other: NDArray[np.int64],
) -> int:
    """How many bits these pairs of rows have in common, in all."""
    block = max(1, _BLOCK_BYTES // (8 * one.shape[1]))
    total = 0
    for begin in range(0, len(row), block):
        part = slice(begin, begin + block)
        common = one[row[part]] & other[row_of_other[part]]
        total += int(np.bitwise_count(common).sum(dtype=np.int64))
    return total

"""Designs: which pairs to show, in which order, and which of a pair on the left."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from nacreous.deprecation import keep_former_names
from nacreous.number import seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.label import MOST_STIMULI, labels_of, numbered
from nacreous.scaling.planning.sequence import balanced_sides, in_sequence
from nacreous.value import value_class

#: A list of more pairs than this nobody answers.
MOST_PAIRS = 1_000_000


@value_class
class PairDesign:
    """Pairs to show, in order: `left` and `right`, int64 [pair], are indices into `stimuli`.

    Every stimulus can be compared with every other through a chain of pairs, so that there is one
    scale. Of each stimulus' places, lefts and rights differ by at most one.
    """

    stimuli: tuple[str, ...]
    left: NDArray[np.int64]
    right: NDArray[np.int64]

    def __len__(self) -> int:
        """How many pairs there are."""
        return len(self.left)

    @property
    def pairs(self) -> tuple[tuple[str, str], ...]:
        """The labels of each pair, left and right, in order."""
        rows = zip(self.left.tolist(), self.right.tolist(), strict=True)
        return tuple((self.stimuli[left], self.stimuli[right]) for left, right in rows)

    @property
    def repetitions(self) -> int:
        """How often a stimulus stands in a pair and in the next one too; 0 where that can be."""
        now, after = slice(None, -1), slice(1, None)
        return int(
            np.count_nonzero(
                (self.left[now] == self.left[after])
                | (self.left[now] == self.right[after])
                | (self.right[now] == self.left[after])
                | (self.right[now] == self.right[after])
            )
        )


def full_design(stimuli: int | Iterable[object], seed: int = 1, repeats: int = 1) -> PairDesign:
    """Every pair once, or `repeats` times (1 to 100), with the sides exchanged each time.

    `stimuli` are labels, or how many: then they are "1" to "n". Same arguments, same design; give
    each person a `seed` of their own.

    >>> design = full_design(["a", "b", "c"])
    >>> sorted(map(sorted, design.pairs))
    [['a', 'b'], ['a', 'c'], ['b', 'c']]
    """
    labels = _labels(stimuli)
    count = len(labels)
    times = whole_of("repeats", repeats, 1, 100)
    _check_pairs(times * count * (count - 1) // 2)
    first, second = np.triu_indices(count, 1)
    return _arranged(labels, np.stack([first, second], axis=1), seed_of(seed), times)


def cyclic_design(stimuli: int | Iterable[object], each: int, seed: int = 1) -> PairDesign:
    """An incomplete design in which every stimulus meets `each` others: 2 to n - 1.

    The stimuli stand in a circle, in random order, and each meets those at the same steps from it
    (H. A. David, The method of paired comparisons, 1988, chapter 5): balanced, so that all values
    are known about equally well. The steps are spread evenly, and 1 is among them. `each` times n
    must be even.

    >>> design = cyclic_design(10, each=4)
    >>> len(design)
    20
    """
    labels = _labels(stimuli)
    count = len(labels)
    if count < 3:
        raise InputError("2 stimuli have one pair only; allowed: 3 or more for a cyclic design")
    each = whole_of("each", each, 2, count - 1)
    if each * count % 2:
        raise InputError(
            f"each is {each} and there are {count} stimuli, both odd, which leaves one without a "
            f"partner; allowed: {each - 1} or {each + 1}"
        )
    _check_pairs(each * count // 2)
    random = np.random.default_rng(seed_of(seed))
    circle = random.permutation(count)
    pairs = [
        np.stack([np.arange(count), (np.arange(count) + step) % count], axis=1)
        for step in _steps(count, each // 2)
    ]
    if each % 2:  # each with the one across
        across = np.arange(count // 2)
        pairs.append(np.stack([across, across + count // 2], axis=1))
    return _arranged(labels, circle[np.concatenate(pairs)], seed_of(seed), 1)


def random_design(stimuli: int | Iterable[object], pairs: int, seed: int = 1) -> PairDesign:
    """So many different `pairs` at random, n - 1 to all of them, joining all stimuli.

    A chain through all stimuli in random order joins them; the others are drawn from those left,
    each as likely.

    >>> design = random_design(6, pairs=8)
    >>> len(set(map(frozenset, design.pairs)))
    8
    """
    labels = _labels(stimuli)
    count = len(labels)
    pairs = whole_of("pairs", pairs, count - 1, count * (count - 1) // 2)
    _check_pairs(pairs)
    random = np.random.default_rng(seed_of(seed))
    chain = random.permutation(count)
    codes = np.minimum(chain[:-1], chain[1:]) * count + np.maximum(chain[:-1], chain[1:])
    while len(codes) < pairs:
        wanted = pairs - len(codes)
        if count <= 1000:  # all others can be listed
            first, second = np.triu_indices(count, 1)
            others = np.setdiff1d(first * count + second, codes)
        else:  # few of them are wanted: draw, and drop what was drawn twice
            drawn = np.sort(random.integers(0, count, (2 * wanted + 100, 2)), axis=1)
            drawn = drawn[drawn[:, 0] < drawn[:, 1]]
            others = np.setdiff1d(drawn[:, 0] * count + drawn[:, 1], codes)
        codes = np.append(codes, random.permutation(others)[:wanted])
    found = np.stack([codes // count, codes % count], axis=1)
    return _arranged(labels, found, seed_of(seed), 1)


def _steps(count: int, number: int) -> list[int]:
    """So many different steps around a circle, 1 and others spread evenly up to half of it."""
    longest = (count - 1) // 2
    return [1 + index * (longest - 1) // max(1, number - 1) for index in range(number)]


def _arranged(
    labels: tuple[str, ...], pairs: NDArray[np.int64], seed: int, repeats: int
) -> PairDesign:
    """The pairs with sides and in sequence; the second time round with the sides exchanged."""
    random = np.random.default_rng([seed, 1])
    sided = balanced_sides(pairs, len(labels), random)
    parts: list[NDArray[np.int64]] = []
    for time in range(repeats):
        part = sided if time % 2 == 0 else sided[:, ::-1]
        before = parts[-1][-1] if parts else None
        parts.append(part[in_sequence(part, random, before)])
    left, right = np.concatenate(parts).T
    return PairDesign(labels, left.copy(), right.copy())


def _labels(stimuli: int | Iterable[object]) -> tuple[str, ...]:
    if isinstance(stimuli, Iterable):
        return labels_of(stimuli)
    return numbered(whole_of("stimuli", stimuli, 2, MOST_STIMULI))


def _check_pairs(pairs: int) -> None:
    if pairs > MOST_PAIRS:
        raise InputError(f"the design has {pairs} pairs; allowed: up to {MOST_PAIRS}")


keep_former_names(__name__, {"Design": "PairDesign"}, "nacreous.scaling")

"""Designs of judged differences: which two pairs to show, in which order."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from math import comb

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.label import labels_of, numbered
from nacreous.scaling.fit.difference_existence import are_placed
from nacreous.value import value_class

__all__ = ["QuadrupleDesign", "full_quadruples", "random_quadruples"]

Index = NDArray[np.int64]

#: Beyond, four of them can be chosen in more than 100 million ways.
_MOST_STIMULI = 200
_MOST_QUADRUPLES = 1_000_000
#: How often few quadruples are drawn again until they join all stimuli.
_TRIES = 200


@value_class
class QuadrupleDesign:
    """Pairs of pairs to show, in order: `shown`, int64 [trial, 4], are indices into `stimuli`.

    The two pairs of a trial lie apart in the order of the stimuli: neither holds or meets the
    other, whose larger difference would be plain without a look. Which of them is first, and of a
    pair which stimulus, is tossed.
    """

    stimuli: tuple[str, ...]
    shown: NDArray[np.int64]

    def __len__(self) -> int:
        """How many trials there are."""
        return len(self.shown)

    @property
    def quadruples(self) -> tuple[tuple[str, str, str, str], ...]:
        """The labels of each trial, the first pair and then the second one."""
        return tuple(
            (self.stimuli[a], self.stimuli[b], self.stimuli[c], self.stimuli[d])
            for a, b, c, d in self.shown.tolist()
        )


def full_quadruples(
    stimuli: int | Iterable[object], seed: int = 1, repeats: int = 1
) -> QuadrupleDesign:
    """All non-overlapping quadruples, n (n - 1) (n - 2) (n - 3) / 24, in random order.

    stimuli: 5 to 200 labels in the order of the scale, or how many: then they are "1" to "n". Four
    have a single quadruple, which does not place them.
    repeats: 1 to 100 times all, each time in another order.

    >>> len(full_quadruples(11))
    330
    """
    labels = _labels(stimuli)
    repeats = whole_of("repeats", repeats, 1, 100)
    total = comb(len(labels), 4) * repeats
    if total > _MOST_QUADRUPLES:
        raise InputError(
            f"the design has {total} quadruples; allowed: up to {_MOST_QUADRUPLES}, or "
            "random_quadruples"
        )
    four = np.array(list(combinations(range(len(labels)), 4)), np.int64)
    random = np.random.default_rng(seed_of(seed))
    return QuadrupleDesign(
        labels, np.concatenate([_tossed(random.permutation(four), random) for _ in range(repeats)])
    )


def random_quadruples(
    stimuli: int | Iterable[object], quadruples: int, seed: int = 1
) -> QuadrupleDesign:
    """So many different non-overlapping quadruples at random, that place all stimuli.

    quadruples: n - 1 to all of them. Raises `InputError` where so few hardly ever place all.

    >>> len(random_quadruples(11, 60))
    60
    """
    labels = _labels(stimuli)
    count = len(labels)
    most = min(comb(count, 4), _MOST_QUADRUPLES)
    number = whole_of("quadruples", quadruples, min(count - 1, most), most)
    random = np.random.default_rng(seed_of(seed))
    for _ in range(_TRIES):
        four = _drawn(count, number, random)
        if are_placed(four, count):
            return QuadrupleDesign(labels, _tossed(four, random))
    raise InputError(
        f"quadruples is {number}, of which {_TRIES} draws left some distance open; allowed: more"
    )


def _labels(stimuli: int | Iterable[object]) -> tuple[str, ...]:
    if isinstance(stimuli, Iterable):
        labels = labels_of(stimuli)
        whole_of("the number of stimuli", len(labels), 5, _MOST_STIMULI)
        return labels
    return numbered(whole_of("stimuli", stimuli, 5, _MOST_STIMULI))


def _drawn(count: int, number: int, random: np.random.Generator) -> Index:
    """Different sets of four, int64 [quadruple, 4], each sorted, all as likely."""
    if 2 * number > comb(count, 4):
        every = np.array(list(combinations(range(count), 4)), np.int64)
        return np.asarray(random.permutation(every)[:number])
    found = np.zeros((0, 4), np.int64)
    while len(found) < number:
        tried = np.sort(random.integers(0, count, (4 * number + 20, 4)), axis=1)
        tried = tried[(np.diff(tried, axis=1) > 0).all(axis=1)]
        found = np.unique(np.concatenate((found, tried)), axis=0)
    return np.asarray(random.permutation(found)[:number])


def _tossed(four: Index, random: np.random.Generator) -> Index:
    """Which pair is first, and in each pair which stimulus, by lot."""
    pairs = four.reshape(-1, 2, 2)
    for axis in (1, 2):  # `permuted` would take pairs apart
        turned = random.random(len(pairs) * (1 if axis == 1 else 2)) < 0.5
        which = turned.reshape((-1, 1, 1) if axis == 1 else (-1, 2, 1))
        pairs = np.where(which, np.flip(pairs, axis=axis), pairs)
    return np.asarray(pairs.reshape(-1, 4))

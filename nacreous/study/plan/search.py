"""Orders with the fewest stimuli shown twice in a row, found exactly where there are few pairs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

__all__ = ["order_with"]

Pair = frozenset[int]

#: Steps of a search, at most; small studies take far fewer.
_MOST_STEPS = 60_000


class _Search:
    """All orders of some pairs, walked through in a random order; what fails is remembered."""

    def __init__(self, pairs: Sequence[Pair]) -> None:
        counts = Counter(pairs)
        self.kinds = sorted(counts, key=sorted)
        self.all = tuple(counts[kind] for kind in self.kinds)
        self.steps = 0
        self._failed: set[tuple[tuple[int, ...], int, int]] = set()
        self._clash = [[int(not a.isdisjoint(b)) for b in self.kinds] for a in self.kinds]

    def order(self, before: Pair, budget: int, random: np.random.Generator) -> list[Pair] | None:
        """A random order in which a stimulus comes twice in a row at most `budget` times."""
        first = [int(not before.isdisjoint(kind)) for kind in self.kinds]
        wish = random.permutation(len(self.kinds)).tolist()
        found = self._rest(self.all, -1, first, budget, wish)
        return None if found is None else [self.kinds[kind] for kind in reversed(found)]

    def _rest(
        self, left: tuple[int, ...], last: int, clash: list[int], budget: int, wish: list[int]
    ) -> list[int] | None:
        """What follows `last`, the last one first; None where it cannot be."""
        if not any(left):
            return []
        if (left, last, budget) in self._failed or self.steps > _MOST_STEPS:
            return None
        self.steps += 1
        for extra in range(min(budget, 1) + 1):  # steps that share nothing come first
            for kind in wish:
                if left[kind] and clash[kind] == extra:
                    fewer = (*left[:kind], left[kind] - 1, *left[kind + 1 :])
                    # Another one each time, or all would walk the same way.
                    turned = wish[1:] + wish[:1]
                    found = self._rest(fewer, kind, self._clash[kind], budget - extra, turned)
                    if found is not None:
                        found.append(kind)
                        return found
        if last >= 0 and self.steps <= _MOST_STEPS:
            self._failed.add((left, last, budget))
        return None


def order_with(
    pairs: Sequence[Pair], before: Pair, below: int, random: np.random.Generator, times: int
) -> list[list[Pair]]:
    """Some of the orders with the fewest stimuli twice in a row, `times` tries at most.

    Empty where none has fewer than `below`, or none was found in the steps that a search may take.

    >>> chain = [frozenset(pair) for pair in ((0, 1), (1, 2), (2, 3), (3, 4))]
    >>> (found,) = order_with(chain, frozenset(), 4, np.random.default_rng(1), times=1)
    >>> [now.isdisjoint(after) for now, after in zip(found, found[1:])]
    [True, True, True]
    """
    search = _Search(pairs)
    for budget in range(below):
        found = search.order(before, budget, random)
        if found is not None:
            more = [search.order(before, budget, random) for _ in range(times - 1)]
            return [found, *(order for order in more if order is not None)]
    return []

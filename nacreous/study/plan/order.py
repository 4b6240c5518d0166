"""The order of pairs, repeats and catches under one question."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.planning.sequence import in_sequence
from nacreous.study.plan.choice import Choice
from nacreous.study.plan.search import order_with
from nacreous.study.plan.trial import Kind

__all__ = ["Shown", "in_order"]

#: Trials between a pair and its repeat that are wanted **(ours)**; orders with more are no better.
_APART = 6
_MOST_TRIES = 40


@dataclass(frozen=True)
class Shown:
    """A pair as it is shown: indices of labels, and why."""

    left: int
    right: int
    kind: Kind

    @property
    def both(self) -> frozenset[int]:
        """The two stimuli, on whichever side."""
        return frozenset((self.left, self.right))


def in_order(
    choice: Choice,
    catches: list[tuple[int, int]],
    before: Shown | None,
    random: np.random.Generator,
) -> list[Shown]:
    """All pairs, repeats and catches (left, right), so that no stimulus comes twice in a row.

    Of random orders the best is taken: first the fewest stimuli twice in a row, then pairs and
    their repeats far apart, then catches nearest to where they would be evenly spread. `before`
    is what is shown before the first.
    """
    pairs = np.concatenate([choice.pairs, choice.pairs[: choice.repeated]])
    best: list[Shown] = []
    least = (len(pairs) + len(catches) + 1, 0, 0)
    for _ in range(max(2, min(_MOST_TRIES, 3000 // len(pairs)))):
        order = _arranged(pairs, before, random)
        order, strayed = _with_catches(order, catches, before)
        cost = (_clashes(order, before), _nearness(order), strayed)
        if cost < least:
            best, least = order, cost
        if cost[:2] == (0, 0) and strayed <= len(catches):
            return best
    return best if least[0] == 0 else _mended(best, before, random)


def _mended(order: list[Shown], before: Shown | None, random: np.random.Generator) -> list[Shown]:
    """An order with fewer stimuli twice in a row, where a search finds one; small studies need it.

    Of five stimuli a pair shares nothing with but three of the nine others.
    """
    if len(frozenset().union(*(shown.both for shown in order))) <= 3:
        return order  # any two pairs share a stimulus
    last = before.both if before is not None else frozenset()
    below = _clashes(order, before)
    found = order_with([shown.both for shown in order], last, below, random, _MOST_TRIES)
    named = [_named(pairs, order) for pairs in found]
    return min(named, key=lambda one: (_nearness(one), _unevenness(one)), default=order)


def _named(pairs: list[frozenset[int]], order: list[Shown]) -> list[Shown]:
    """The pairs in their new order as what they were: a pair, then a catch of it, then a repeat."""
    shown: dict[frozenset[int], list[Shown]] = {}
    for one in sorted(order, key=lambda one: ("pair", "catch", "repeat").index(one.kind)):
        shown.setdefault(one.both, []).append(one)
    return [shown[pair].pop(0) for pair in pairs]


def _unevenness(order: list[Shown]) -> float:
    """How far catches are from where they would be evenly spread, all together, in trials."""
    places = [place for place, shown in enumerate(order) if shown.kind == "catch"]
    step = len(order) / max(1, len(places))
    return sum(abs(at - (index + 0.5) * step) for index, at in enumerate(places))


def _arranged(
    pairs: NDArray[np.int64], before: Shown | None, random: np.random.Generator
) -> list[Shown]:
    """A random order; whatever comes the second time is a repeat, the sides exchanged."""
    last = None if before is None else np.array([before.left, before.right])
    seen: set[frozenset[int]] = set()
    order = []
    for left, right in pairs[in_sequence(pairs, random, last)].tolist():
        again = frozenset((left, right)) in seen
        seen.add(frozenset((left, right)))
        order.append(Shown(right, left, "repeat") if again else Shown(left, right, "pair"))
    return order


def _with_catches(
    order: list[Shown], catches: list[tuple[int, int]], before: Shown | None
) -> tuple[list[Shown], int]:
    """Each catch near its even share of the way, between pairs that it shares nothing with.

    Also gives how many trials they are from there, all together.
    """
    spread = list(order)
    strayed = 0
    for place, (left, right) in enumerate(catches):
        catch = Shown(left, right, "catch")
        wanted = round((place + 0.5) * len(order) / len(catches)) + place
        fits = [here for here in range(len(spread) + 1) if _fits(catch, spread, here, before)]
        here = min(fits, key=lambda at: abs(at - wanted), default=min(wanted, len(spread)))
        strayed += abs(here - wanted)
        spread.insert(here, catch)
    return spread, strayed


def _fits(catch: Shown, order: list[Shown], here: int, before: Shown | None) -> bool:
    around = [before] if here == 0 else [order[here - 1]]
    around += order[here : here + 1]
    return all(other is None or catch.both.isdisjoint(other.both) for other in around)


def _clashes(order: list[Shown], before: Shown | None) -> int:
    """How often a stimulus is shown twice in a row."""
    shown = [before, *order] if before is not None else order
    return sum(not a.both.isdisjoint(b.both) for a, b in pairwise(shown))


def _nearness(order: list[Shown]) -> int:
    """How many trials are missing between a pair and its repeat where they are nearest."""
    first: dict[frozenset[int], int] = {}
    apart = [_APART]
    for place, shown in enumerate(order):
        if shown.kind == "repeat":
            apart.append(place - first[shown.both])
        elif shown.kind == "pair":
            first[shown.both] = place
    return _APART - min(apart)

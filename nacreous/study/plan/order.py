"""The order of items, repeats and catches under one question, whatever task they are of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from nacreous.scaling.planning.sequence import in_sequence
from nacreous.study.plan.search import order_with
from nacreous.study.task.counting import Kind
from nacreous.study.task.task import Items

__all__ = ["Again", "Shown", "in_order"]

#: How stimuli, by place, are shown a second time.
Again = Callable[[tuple[int, ...]], tuple[int, ...]]

#: Trials between an item and its repeat that are wanted **(ours)**; orders with more are no better.
_APART = 6
_MOST_TRIES = 40


@dataclass(frozen=True)
class Shown:
    """An item as it is shown: indices of labels by place, and why."""

    stimuli: tuple[int, ...]
    kind: Kind

    @cached_property
    def all(self) -> frozenset[int]:
        """The stimuli, at whichever place."""
        return frozenset(self.stimuli)


def in_order(
    items: Items,
    again: Again,
    catches: list[tuple[int, ...]],
    before: Shown | None,
    random: np.random.Generator,
) -> list[Shown]:
    """All items, repeats and catches, so that no stimulus comes twice in a row.

    Of random orders the best is taken: first the fewest stimuli twice in a row, then items and
    their repeats far apart, then catches nearest to where they would be evenly spread. `before`
    is what is shown before the first.
    """
    best: list[Shown] = []
    count = len(items.stimuli) + items.repeated
    least = (count + len(catches) + 1, 0, 0)
    for _ in range(max(2, min(_MOST_TRIES, 3000 // count))):
        order = _arranged(items, again, before, random)
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
    if len(frozenset().union(*(shown.all for shown in order))) <= 3:
        return order  # any two pairs share a stimulus, and larger items all the more
    last = before.all if before is not None else frozenset()
    below = _clashes(order, before)
    found = order_with([shown.all for shown in order], last, below, random, _MOST_TRIES)
    named = [_named(sets, order) for sets in found]
    return min(named, key=lambda one: (_nearness(one), _unevenness(one)), default=order)


def _named(sets: list[frozenset[int]], order: list[Shown]) -> list[Shown]:
    """Stimuli in their new order as what they were: an item, then a catch of it, then a repeat."""
    shown: dict[frozenset[int], list[Shown]] = {}
    for one in sorted(order, key=lambda one: ("pair", "catch", "repeat").index(one.kind)):
        shown.setdefault(one.all, []).append(one)
    return [shown[stimuli].pop(0) for stimuli in sets]


def _unevenness(order: list[Shown]) -> float:
    """How far catches are from where they would be evenly spread, all together, in trials."""
    places = [place for place, shown in enumerate(order) if shown.kind == "catch"]
    step = len(order) / max(1, len(places))
    return sum(abs(at - (index + 0.5) * step) for index, at in enumerate(places))


def _arranged(
    items: Items, again: Again, before: Shown | None, random: np.random.Generator
) -> list[Shown]:
    """A random order; whatever comes the second time is a repeat."""
    rows = np.concatenate([items.stimuli, items.stimuli[: items.repeated]])
    last = None if before is None else np.array(before.stimuli)
    seen: set[int] = set()
    order = []
    for row in in_sequence(rows, random, last).tolist():
        item, stimuli = row % len(items.stimuli), tuple(rows[row].tolist())
        order.append(Shown(again(stimuli), "repeat") if item in seen else Shown(stimuli, "pair"))
        seen.add(item)
    return order


def _with_catches(
    order: list[Shown], catches: list[tuple[int, ...]], before: Shown | None
) -> tuple[list[Shown], int]:
    """Each catch near its even share of the way, between items that it shares nothing with.

    Also gives how many trials they are from there, all together.
    """
    spread = list(order)
    strayed = 0
    for place, stimuli in enumerate(catches):
        catch = Shown(stimuli, "catch")
        wanted = round((place + 0.5) * len(order) / len(catches)) + place
        fits = [here for here in range(len(spread) + 1) if _fits(catch, spread, here, before)]
        here = min(fits, key=lambda at: abs(at - wanted), default=min(wanted, len(spread)))
        strayed += abs(here - wanted)
        spread.insert(here, catch)
    return spread, strayed


def _fits(catch: Shown, order: list[Shown], here: int, before: Shown | None) -> bool:
    around = [before] if here == 0 else [order[here - 1]]
    around += order[here : here + 1]
    return all(other is None or catch.all.isdisjoint(other.all) for other in around)


def _clashes(order: list[Shown], before: Shown | None) -> int:
    """How often a stimulus is shown twice in a row."""
    shown = [before, *order] if before is not None else order
    return sum(not a.all.isdisjoint(b.all) for a, b in pairwise(shown))


def _nearness(order: list[Shown]) -> int:
    """How many trials are missing between an item and its repeat where they are nearest."""
    first: dict[frozenset[int], int] = {}
    apart = [_APART]
    for place, shown in enumerate(order):
        if shown.kind == "repeat":
            apart.append(place - first[shown.all])
        elif shown.kind == "pair":
            first[shown.all] = place
    return _APART - min(apart)

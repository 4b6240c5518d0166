"""The plans of participants in memory: those that were asked for last."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from nacreous.study.plan import Trial

__all__ = ["Plans", "plain", "trials_of"]

#: People who answer at the same time; a plan of 1000 trials takes some 200 kB.
_MOST = 256


def plain(trials: Sequence[Trial]) -> list[dict[str, Any]]:
    """Trials as a store keeps them."""
    return [asdict(trial) for trial in trials]


def trials_of(plan: Sequence[Mapping[str, Any]]) -> tuple[Trial, ...]:
    """The trials again.

    >>> trials = (Trial(0, "deeper", "a", "b", "pair", 1, False),)
    >>> trials_of(plain(trials)) == trials
    True
    """
    return tuple(Trial(**row) for row in plan)


class Plans:
    """Plans by session; the one that nobody asked for the longest goes first.

    Safe to share among threads.
    """

    def __init__(self) -> None:
        self._kept: OrderedDict[str, tuple[Trial, ...]] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, session: str) -> tuple[Trial, ...] | None:
        """A plan, if it is here."""
        with self._lock:
            if session in self._kept:
                self._kept.move_to_end(session)
            return self._kept.get(session)

    def put(self, session: str, trials: tuple[Trial, ...]) -> None:
        """Keep a plan."""
        with self._lock:
            self._kept[session] = trials
            self._kept.move_to_end(session)
            while len(self._kept) > _MOST:
                self._kept.popitem(last=False)

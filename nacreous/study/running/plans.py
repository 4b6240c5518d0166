"""The plans of participants in memory: those that were asked for last."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from nacreous.study.plan import Trial

__all__ = ["Plans", "plain", "trials_of"]

#: Trials of all plans together, some 60 MB: of 2000 people who answer a hundred each.
_MOST = 200_000


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
        self._trials = 0
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
            self._trials += len(trials) - len(self._kept.pop(session, ()))
            self._kept[session] = trials
            while self._trials > _MOST and len(self._kept) > 1:
                _, dropped = self._kept.popitem(last=False)
                self._trials -= len(dropped)

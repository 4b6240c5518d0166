"""The plans of participants in memory: those that were asked for last."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from typing import Any

from nacreous.scaling.data.label import label_of
from nacreous.study.plan import Trial
from nacreous.study.task.task import Task

__all__ = ["Plans", "plain", "shown", "trials_of"]

#: Trials of all plans together, some 60 MB: of 2000 people who answer a hundred each.
_MOST = 200_000


def shown(trial: Trial, task: Task[Any]) -> dict[str, str]:
    """The labels of a trial by their places."""
    return dict(zip(task.places, trial.stimuli, strict=True))


def plain(trials: Sequence[Trial], task: Task[Any]) -> list[dict[str, Any]]:
    """Trials as a store keeps them."""
    return [
        {
            "number": trial.number,
            "question": trial.question,
            **shown(trial, task),
            "kind": trial.kind,
            "block": trial.block,
            "break_before": trial.break_before,
        }
        for trial in trials
    ]


def trials_of(plan: Sequence[Mapping[str, Any]], task: Task[Any]) -> tuple[Trial, ...]:
    """The trials again.

    >>> from nacreous.study.task.tasks import TASKS
    >>> trials = (Trial(0, "deeper", ("a", "b"), "pair", 1, False),)
    >>> trials_of(plain(trials, TASKS["pair"]), TASKS["pair"]) == trials
    True
    """
    return tuple(
        Trial(
            number=row["number"],
            question=row["question"],
            stimuli=tuple(label_of(row[place]) for place in task.places),
            kind=row["kind"],
            block=row["block"],
            break_before=row["break_before"],
        )
        for row in plan
    )


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

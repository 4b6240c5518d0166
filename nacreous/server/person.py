"""Participants as experimenters see them: numbers, how far, and what is noticed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from nacreous.server.responses import FlagTold, PersonTold
from nacreous.study.plan import trials
from nacreous.study.running import Running
from nacreous.study.store import PersonProgress, Progress


class People:
    """Makes lines of the experimenters' table; `trials`: how many each sitting of the study has.

    A person's line counts as their own pages do: without practice, which comes first.
    """

    def __init__(self, running: Running) -> None:
        self._running = running
        plan = trials(running.frozen.design, 0)
        self.trials = len(plan)
        self._practice = sum(trial.kind == "training" for trial in plan)

    def told(self, progress: Progress, flags: Mapping[int, Sequence[Any]]) -> list[PersonTold]:
        """A line for everyone who has entered. Reads the store: for threads alone."""
        return [
            self._line(person, flags.get(person.session.number, ())) for person in progress.people
        ]

    def _line(self, person: PersonProgress, flags: Sequence[Any]) -> PersonTold:
        session = person.session
        end = session.finished_at or person.last_at
        whole = end is not None and session.erased_at is None
        return PersonTold(
            number=session.number,
            language=session.language,
            groups=dict(session.groups),
            answers=max(0, person.answers - self._practice),
            trials=0 if session.erased_at is not None else self.trials - self._practice,
            started_at=session.started_at,
            last_at=person.last_at,
            finished=session.finished_at is not None,
            seconds=(end - session.started_at).total_seconds() if end and whole else None,
            excluded=session.excluded_reason,
            erased=session.erased_at is not None,
            simulated=person.simulated > 0,
            screen_flags=list(self._running.screen_flags(session)),
            flags=[FlagTold(kind=flag.kind, detail=flag.detail) for flag in flags],
        )

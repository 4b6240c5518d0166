"""How far a study is: who, how many, how long."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from statistics import median

import sqlalchemy as sa

from nacreous.study.store import people
from nacreous.study.store.record import Session
from nacreous.study.store.schema import answers, sessions
from nacreous.value import in_short


@dataclass(frozen=True)
class PersonProgress:
    """One session, how many of its answers are stored, and how many of them a program gave.

    `last_at`: when the newest arrived.
    """

    session: Session
    answers: int
    simulated: int
    last_at: datetime | None


@dataclass(frozen=True, repr=False)
class Progress:
    """Counts of a study. Erased people are in `entered`, and their answers in `answers`.

    `median_s` is from entering to finishing, of those who have finished; None without any.
    """

    __repr__ = in_short

    state: str
    entered: int
    consented: int
    finished: int
    excluded: int
    erased: int
    answers: int
    simulated: int
    erased_answers: int
    median_s: float | None
    people: tuple[PersonProgress, ...]


def progress(connection: sa.Connection, study: str, state: str) -> Progress:
    """The counts now."""
    everyone = people.find(connection, sessions.c.study == study)
    counts = _counts(connection, study)
    lasting = [
        (person.finished_at - person.started_at).total_seconds()
        for person in everyone
        if person.finished_at is not None and person.erased_at is None
    ]
    erased, erased_simulated = _erased(connection, study)
    return Progress(
        state=state,
        entered=len(everyone),
        consented=sum(person.consented_at is not None for person in everyone),
        finished=sum(person.finished_at is not None for person in everyone),
        excluded=sum(person.excluded_reason is not None for person in everyone),
        erased=sum(person.erased_at is not None for person in everyone),
        answers=erased + sum(count for count, _, _ in counts.values()),
        simulated=erased_simulated + sum(simulated for _, simulated, _ in counts.values()),
        erased_answers=erased,
        median_s=median(lasting) if lasting else None,
        people=tuple(
            PersonProgress(person, *counts.get(person.id, (0, 0, None))) for person in everyone
        ),
    )


def _counts(connection: sa.Connection, study: str) -> dict[str, tuple[int, int, datetime | None]]:
    # By person, for so an index holds all that is counted. The newest by sequence, for a clock that
    # was set back must not hide it.
    grouped = (
        sa.select(
            answers.c.session,
            sa.func.count().label("count"),
            sa.func.count().filter(answers.c.simulated).label("simulated"),
            sa.func.max(answers.c.seq).label("last"),
        )
        .where(answers.c.session.in_(sa.select(sessions.c.id).where(sessions.c.study == study)))
        .group_by(answers.c.session)
        .subquery()
    )
    query = sa.select(
        grouped.c.session, grouped.c.count, grouped.c.simulated, answers.c.received_at
    ).join(answers, answers.c.seq == grouped.c.last)
    return {
        session: (count, simulated, datetime.fromisoformat(received))
        for session, count, simulated, received in connection.execute(query)
    }


def _erased(connection: sa.Connection, study: str) -> tuple[int, int]:
    """How many answers are of erased people, who have no session, and how many simulated."""
    simulated = sa.func.count().filter(answers.c.simulated)
    # An expression, lest SQLite look for the study first, and at each of its answers.
    theirs = answers.c.session.is_(None), sa.func.coalesce(answers.c.study, "") == study
    row = connection.execute(sa.select(sa.func.count(), simulated).where(*theirs)).one()
    return int(row[0]), int(row[1])

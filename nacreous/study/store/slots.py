"""Slots of the plan: who fills one, and which one is the next to be given.

A slot, 0, 1, 2, ..., is what a participant's trials and groups follow from. Balance is over slots:
a slot that nobody fills any more is a hole in it, and is given again before any later one.
"""

from __future__ import annotations

from itertools import count
from typing import Any

import sqlalchemy as sa

from nacreous.study.store.schema import answers, sessions

__all__ = ["next_free"]


def _of_answer(column: sa.Column[Any], order: sa.ColumnElement[Any]) -> sa.ScalarSelect[Any]:
    """A column of a session's first or last answer, by one look into the index of trials."""
    return (
        sa.select(column)
        .where(answers.c.session == sessions.c.id)
        .order_by(order)
        .limit(1)
        .correlate(sessions)
        .scalar_subquery()
    )


_SINCE: sa.BindParameter[str] = sa.bindparam("since")
_SIMULATED = _of_answer(answers.c.simulated, answers.c.trial)
_LAST_AT = _of_answer(answers.c.received_at, answers.c.trial.desc())
# Made once, for making a statement takes longer than running it.
_FILLED = sa.select(sessions.c.slot, _SIMULATED.label("simulated")).where(
    sessions.c.study == sa.bindparam("study"),
    sessions.c.slot.is_not(None),
    sessions.c.erased_at.is_(None),
    sessions.c.excluded_reason.is_(None),
    sa.or_(
        sessions.c.finished_at.is_not(None),
        sessions.c.started_at >= _SINCE,
        _LAST_AT >= _SINCE,
    ),
)


def next_free(connection: sa.Connection, study: str, since: str) -> int:
    """The first slot that nobody fills; the study's row is locked, so that it is given once.

    A slot is filled by whoever finished, entered or answered after `since`, and is neither excluded
    nor erased. Simulated observers fill theirs until people have answered, so that a rehearsal goes
    as the study will **(ours)**.
    """
    rows = connection.execute(_FILLED, {"study": study, "since": since}).all()
    people = any(row.simulated is False for row in rows)
    filled = {row.slot for row in rows if not (people and row.simulated)}
    return next(slot for slot in count() if slot not in filled)

"""The audit log: who did what, when. Lines are added and never changed, but for an erased person.

What a line about an erased person told of them is taken out, for it was about them.
"""

from __future__ import annotations

import json
from typing import Any

import sqlalchemy as sa

from nacreous.study.store import check
from nacreous.study.store.record import Event
from nacreous.study.store.schema import audit


def note(
    connection: sa.Connection,
    at: str,
    who: str,
    what: str,
    study: str | None,
    session: str | None,
    *,
    most: int | None = None,
    **detail: Any,
) -> None:
    """Add a line. most: nothing happens where there are so many that say the same of a session."""
    if most is not None:
        alike = audit.c.session == session, audit.c.what == what
        query = sa.select(sa.func.count()).where(*alike)
        if connection.execute(query).scalar_one() >= most:
            return
    connection.execute(
        sa.insert(audit).values(
            at=at,
            who=check.text("who", who),
            what=check.text("what", what),
            study=study,
            session=session,
            detail=check.canonical("detail", detail),
        )
    )


def forget(connection: sa.Connection, session: str) -> None:
    """Take out of the lines about a person what they tell, and times finer than a day."""
    about = audit.c.session == session
    connection.execute(
        sa.update(audit).where(about).values(at=sa.func.substr(audit.c.at, 1, 10), detail="{}")
    )


def events(connection: sa.Connection, study: str | None, last: int | None) -> list[Event]:
    """The lines about a study, or all, in order; only the `last` of them, if it is given."""
    query = sa.select(audit).order_by(audit.c.seq.desc()).limit(last)
    if study is not None:
        query = query.where(audit.c.study == study)
    return [_event(row) for row in connection.execute(query).mappings()][::-1]


def _event(row: sa.RowMapping) -> Event:
    at = check.read(row["at"])
    if at is None:
        raise AssertionError("the column is never null")
    detail = json.loads(row["detail"])
    return Event(at, row["who"], row["what"], row["study"], row["session"], detail)

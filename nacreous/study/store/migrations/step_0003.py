"""Slots of the plan, parameters of the address, completion codes; whoever answered all finished."""

from __future__ import annotations

import json

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"

_SESSIONS = sa.table(
    "sessions",
    *(sa.column(name) for name in ("id", "number", "slot", "plan", "finished_at", "erased_at")),
)
_ANSWERS = sa.table("answers", *(sa.column(name) for name in ("session", "trial", "received_at")))


def upgrade() -> None:
    """Add them; plans made before followed from the number, which so is the slot."""
    op.add_column("sessions", sa.Column("slot", sa.Integer))
    op.add_column("sessions", sa.Column("parameters", sa.Text))
    op.add_column("sessions", sa.Column("completion_code", sa.String(20)))
    there = _SESSIONS.c.erased_at.is_(None)
    op.execute(sa.update(_SESSIONS).where(there).values(slot=_SESSIONS.c.number))
    _finish()


def _finish() -> None:
    """Note the end of those whose page was closed before it could tell of it."""
    connection = op.get_bind()
    query = (
        sa.select(
            _SESSIONS.c.id,
            _SESSIONS.c.plan,
            sa.func.count().label("answers"),
            sa.func.max(_ANSWERS.c.received_at).label("last"),
        )
        .join(_ANSWERS, _ANSWERS.c.session == _SESSIONS.c.id)
        .where(
            _SESSIONS.c.finished_at.is_(None),
            _SESSIONS.c.erased_at.is_(None),
            _SESSIONS.c.plan.is_not(None),
        )
        .group_by(_SESSIONS.c.id, _SESSIONS.c.plan)
    )
    for row in connection.execute(query).all():
        if row.answers == len(json.loads(row.plan)):
            mine = _SESSIONS.c.id == row.id
            connection.execute(sa.update(_SESSIONS).where(mine).values(finished_at=row.last))

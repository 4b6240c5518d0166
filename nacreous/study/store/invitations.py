"""Invitations: links that let one person each into a study."""

from __future__ import annotations

from collections.abc import Sequence

import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.study.store import check, journal, studies
from nacreous.study.store.record import Invitation
from nacreous.study.store.refusal import NotAllowed
from nacreous.study.store.schema import invitations, sessions

#: Invitations made at once.
MOST = 1000
#: What stands in place of the label of an erased person's invitation, which may be a name.
_ERASED = "(erased)"


def make(
    connection: sa.Connection, at: str, study: str, label: str, hashes: Sequence[str], who: str
) -> None:
    """Keep invitations by the hashes of their tokens. Labels, perhaps names, are in no log."""
    if study not in studies.states(connection):
        raise studies.unknown(study)
    row = {"study": study, "label": label, "made_at": at, "made_by": check.text("who", who)}
    connection.execute(sa.insert(invitations), [{**row, "token_hash": hashed} for hashed in hashes])
    journal.note(connection, at, who, "invited", study, None, count=len(hashes))


def of_study(connection: sa.Connection, study: str) -> list[Invitation]:
    """A study's invitations in the order in which they were made."""
    query = (
        sa.select(invitations, sessions.c.number)
        .outerjoin(sessions, sessions.c.id == invitations.c.session)
        .where(invitations.c.study == study)
        .order_by(invitations.c.seq)
    )
    return [_invitation(row) for row in connection.execute(query).mappings()]


def revoke(connection: sa.Connection, at: str, invitation: int, who: str) -> None:
    """Let nobody enter by an invitation; one that was used is the person's own token by now."""
    row = connection.execute(
        sa.select(invitations, sessions.c.number)
        .outerjoin(sessions, sessions.c.id == invitations.c.session)
        .where(invitations.c.seq == check.whole("invitation", invitation))
        .with_for_update(of=invitations)
    ).one_or_none()
    if row is None:
        raise InputError(f"invitation {invitation} is not in this store")
    if row.number is not None:
        raise InputError(
            f"invitation {invitation} was used by person {row.number}; "
            "wanted: one that was not, or that person's token revoked"
        )
    if row.revoked_at is None:
        mine = invitations.c.seq == invitation
        connection.execute(sa.update(invitations).where(mine).values(revoked_at=at))
        detail = {"invitation": invitation}
        journal.note(connection, at, who, "invitation revoked", row.study, None, **detail)


def find(connection: sa.Connection, study: str, hashed: str) -> int | None:
    """The invitation that a token is, if it is one and may still be used."""
    row = connection.execute(
        sa.select(invitations)
        .where(invitations.c.token_hash == hashed, invitations.c.study == study)
        .with_for_update()
    ).one_or_none()
    if row is None:
        return None
    if row.revoked_at is not None or row.session is not None:
        raise NotAllowed("the invitation was revoked; wanted: another one")
    return int(row.seq)


def use(connection: sa.Connection, invitation: int, session: str) -> None:
    """Note who entered by an invitation."""
    mine = invitations.c.seq == invitation
    connection.execute(sa.update(invitations).where(mine).values(session=session))


def forget(connection: sa.Connection, at: str, session: str) -> None:
    """Take away that a person entered by an invitation, and its label, which may be a name."""
    connection.execute(
        sa.update(invitations)
        .where(invitations.c.session == session)
        .values(session=None, token_hash=None, label=_ERASED, revoked_at=check.day(at))
    )


def _invitation(row: sa.RowMapping) -> Invitation:
    made = check.read(row["made_at"])
    if made is None:
        raise AssertionError("the column is never null")
    return Invitation(
        id=row["seq"],
        label=row["label"],
        made_at=made,
        made_by=row["made_by"],
        number=row["number"],
        revoked_at=check.read(row["revoked_at"]),
    )

"""Participants: entering, consent, screen, leaving out with a reason, erasing."""

from __future__ import annotations

import json
import secrets
from collections.abc import Mapping
from typing import Any

import sqlalchemy as sa

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.study.store import check, invitations, journal, slots, studies, tokens
from nacreous.study.store.record import Session
from nacreous.study.store.refusal import NotAllowed
from nacreous.study.store.schema import answers, screens, sessions

#: Why a person is left out who no longer consents.
WITHDREW = "withdrew"
#: What the log says of whoever has answered all.
FINISHED = "finished"
#: Screen checks of one session. Somebody tries again a few times; more only a program that would
#: fill the disk.
MOST_SCREENS = 100

_LAST = sa.select(sa.func.max(screens.c.seq)).where(screens.c.session == sessions.c.id)
# Without the plan, which is long; made once, for making it takes as long as running it.
_SESSIONS = (
    sa.select(*(column for column in sessions.c if column.name != "plan"), screens.c.content)
    .outerjoin(screens, screens.c.seq == _LAST.correlate(sessions).scalar_subquery())
    .order_by(sessions.c.study, sessions.c.number)
)
#: What decides whether something may be added to a session. The row is locked, for another program
#: may be about to erase the person; SQLite lets one write at a time anyhow.
LIVING = (
    sa.select(
        *(sessions.c[name] for name in ("study", "number", "token_hash", "consented_at")),
        *(sessions.c[name] for name in ("erased_at", "excluded_reason")),
    )
    .where(sessions.c.id == sa.bindparam("session"))
    .with_for_update(read=True, key_share=True, of=sessions)
)


def enter(
    connection: sa.Connection, at: str, study: str, hashed: str, row: Mapping[str, Any], since: str
) -> str:
    """Add a session, or find the one that has this token; give its id.

    The study's row is locked first, so that the same token given twice at once enters once, and a
    slot is given once. since: who did nothing after it fills no slot (`slots.next_free`).
    """
    registration = studies.registration(connection, study, hold=True)
    theirs = sa.select(sessions.c.id, sessions.c.study).where(sessions.c.token_hash == hashed)
    there = connection.execute(theirs).one_or_none()
    if there is not None:
        if there.study != study:
            raise tokens.unknown()
        return str(there.id)
    invitation = invitations.find(connection, study, hashed)
    if invitation is None and registration != "open":
        raise NotAllowed(f"study {study[:12]} is for invited people only; wanted: an invitation")
    number = studies.take_number(connection, study)
    slot = slots.next_free(connection, study, since)
    new = {**row, "study": study, "number": number, "slot": slot, "started_at": at}
    new["token_hash"] = hashed
    connection.execute(sa.insert(sessions).values(new))
    if invitation is not None:
        invitations.use(connection, invitation, row["id"])
    journal.note(connection, at, "participant", "entered", study, row["id"])
    return str(row["id"])


def settle(connection: sa.Connection, session: str, groups: str, plan: str) -> None:
    """Keep a session's groups and its plan; once they are kept, nothing changes them."""
    living(connection, session)
    new = sessions.c.id == session, sessions.c.plan.is_(None)
    connection.execute(sa.update(sessions).where(*new).values(groups=groups, plan=plan))


def plan(connection: sa.Connection, session: str) -> list[dict[str, Any]] | None:
    """A session's plan as it was settled; None before, and once the person is erased."""
    row = connection.execute(sa.select(sessions.c.plan).where(sessions.c.id == session))
    found = row.one_or_none()
    if found is None:
        raise _unknown(session)
    made: list[dict[str, Any]] | None = None if found.plan is None else json.loads(found.plan)
    return made


def withdraw(connection: sa.Connection, at: str, session: str) -> None:
    """Leave out a person who no longer consents; once is enough."""
    if living(connection, session).excluded_reason != WITHDREW:
        values = {"excluded_reason": WITHDREW}
        change(connection, at, session, "participant", WITHDREW, values)


def exclude(connection: sa.Connection, at: str, session: str, who: str, reason: str) -> bool:
    """Leave a person out; what a person wished themselves stays so, and nobody else can say it.

    False, and no line in the log, where that is so already.
    """
    if reason == WITHDREW:
        raise InputError(f"reason is {reason!a}; wanted: another, for this is the person's own")
    before = living(connection, session).excluded_reason
    if before == WITHDREW:
        raise NotAllowed("the person withdrew, and is left out by that; nothing was changed")
    if before != reason:
        change(connection, at, session, who, "excluded", {"excluded_reason": reason}, reason=reason)
    return bool(before != reason)


def readmit(connection: sa.Connection, at: str, session: str, who: str) -> bool:
    """Take an exclusion back, but not a person's own; False where there is none."""
    before = living(connection, session).excluded_reason
    if before == WITHDREW:
        raise NotAllowed("the person withdrew; wanted: one whom an experimenter excluded")
    if before is not None:
        change(connection, at, session, who, "readmitted", {"excluded_reason": None})
    return before is not None


def revoke(connection: sa.Connection, at: str, session: str, who: str) -> bool:
    """Make a person's token worthless; False where it is already."""
    known = living(connection, session).token_hash is not None
    if known:
        change(connection, at, session, who, "token revoked", {"token_hash": None})
    return known


def find(connection: sa.Connection, where: sa.ColumnElement[bool]) -> list[Session]:
    """Sessions in the order of their numbers, each with its last screen check."""
    return [_session(row) for row in connection.execute(_SESSIONS.where(where)).mappings()]


def screen_checks(connection: sa.Connection, study: str) -> dict[int, list[dict[str, Any]]]:
    """All screen checks by the person's number, in order, each with `at`, when it came."""
    query = (
        sa.select(sessions.c.number, screens.c.at, screens.c.content)
        .join(screens, screens.c.session == sessions.c.id)
        .where(sessions.c.study == study)
        .order_by(screens.c.seq)
    )
    found: dict[int, list[dict[str, Any]]] = {}
    for number, at, content in connection.execute(query):
        found.setdefault(number, []).append({**json.loads(content), "at": at})
    return found


def groups_of_answers(connection: sa.Connection, study: str) -> list[str]:
    """The groups, as JSON, of all who have given an answer, each once."""
    answered = sa.exists().where(answers.c.session == sessions.c.id)
    known = sessions.c.groups.is_not(None)
    query = sa.select(sessions.c.groups).distinct()
    return list(connection.scalars(query.where(sessions.c.study == study, known, answered)))


def by_session(connection: sa.Connection, study: str) -> dict[str, tuple[str, str]]:
    """By session's id the person's number as text, and the groups as JSON."""
    query = sa.select(sessions.c.id, sessions.c.number, sessions.c.groups)
    found = connection.execute(query.where(sessions.c.study == study))
    return {one: (str(number), groups or "{}") for one, number, groups in found}


def one(connection: sa.Connection, session: str) -> Session:
    """A session by its id."""
    found = find(connection, sessions.c.id == session)
    if not found:
        raise _unknown(session)
    return found[0]


def change(
    connection: sa.Connection,
    at: str,
    session: str,
    who: str,
    what: str,
    values: Mapping[str, Any],
    **detail: Any,
) -> None:
    """Change a session that is not erased, and say so in the log."""
    study = living(connection, session).study
    connection.execute(sa.update(sessions).where(sessions.c.id == session).values(**values))
    journal.note(connection, at, who, what, study, session, **detail)


def living(
    connection: sa.Connection, session: str, query: sa.Select[Any] = LIVING, **bound: Any
) -> Any:
    """The columns of `LIVING`, or of it and more, of a session that something may be added to."""
    row = connection.execute(query, {"session": session, **bound}).one_or_none()
    if row is None:
        raise _unknown(session)
    if row.erased_at is not None:
        raise NotAllowed(f"person {row.number} was erased; nothing can be added or changed")
    return row


def set_once(connection: sa.Connection, at: str, session: str, column: str, what: str) -> None:
    """Set a time that is set once; later calls change nothing."""
    living(connection, session)
    done = connection.execute(
        sa.update(sessions)
        .where(sessions.c.id == session, sessions.c[column].is_(None))
        .values({column: at})
        .returning(sessions.c.study)
    ).scalar_one_or_none()
    if done is not None:
        journal.note(connection, at, "participant", what, done, session)


def add_screen(connection: sa.Connection, at: str, session: str, content: str) -> None:
    """Keep a screen check; earlier ones stay."""
    living(connection, session)
    mine = screens.c.session == session
    kept = connection.execute(sa.select(sa.func.count()).where(mine)).scalar_one()
    if kept >= MOST_SCREENS:
        raise NotAllowed(f"the screen was checked {kept} times; allowed: {MOST_SCREENS}")
    connection.execute(sa.insert(screens).values(session=session, at=at, content=content))


def erase(connection: sa.Connection, at: str, session: str, who: str) -> bool:
    """Take away what leads from answers to a person; False where that is done already.

    The session stays as a number that is not given out again, with days in place of times. The
    answers go in a shuffled order behind all others, under one random name that is written nowhere
    else, without trial numbers, response times, flags and clock times: what was chosen, and that
    one person chose it, is all that is left.
    """
    # First, so that no answer that is on its way elsewhere is overlooked.
    connection.execute(
        sa.select(sessions.c.id).where(sessions.c.id == session).with_for_update(of=sessions)
    )
    found = one(connection, session)
    if found.erased_at is not None:
        return False
    _unlink(connection, found)
    connection.execute(sa.delete(screens).where(screens.c.session == session))
    row = connection.execute(sa.select(sessions).where(sessions.c.id == session)).one()
    connection.execute(
        sa.update(sessions)
        .where(sessions.c.id == session)
        .values(
            token_hash=None,
            language=None,
            groups=None,
            consented_at=check.day(row.consented_at),
            started_at=check.day(row.started_at),
            finished_at=check.day(row.finished_at),
            excluded_reason=None,
            plan=None,
            slot=None,
            parameters=None,
            completion_code=None,
            erased_at=check.day(at),
        )
    )
    invitations.forget(connection, at, session)
    journal.forget(connection, session)
    journal.note(connection, at[:10], who, "erased", found.study, session)
    return True


def _unlink(connection: sa.Connection, person: Session) -> None:
    mine = answers.c.session == person.id
    rows = [dict(row) for row in connection.execute(sa.select(answers).where(mine)).mappings()]
    secrets.SystemRandom().shuffle(rows)
    connection.execute(sa.delete(answers).where(mine))
    name = secrets.token_hex(8)
    for row in rows:
        del row["seq"]
        row.update(
            session=None,
            trial=None,
            response_ms=None,
            shown_at=check.day(row["shown_at"]),
            answered_at=check.day(row["answered_at"]),
            received_at=check.day(row["received_at"]),
            flags="{}",
            digest=None,
            erased_as=f"erased-{name}",
            excluded_reason=None if person.excluded_reason is None else "excluded before erasing",
        )
    if rows:
        connection.execute(sa.insert(answers), rows)


def _unknown(session: object) -> InputError:
    return InputError(f"session {said(session)} is not in this store")


def _session(row: sa.RowMapping) -> Session:
    started = check.read(row["started_at"])
    if started is None:
        raise AssertionError("the column is never null")
    return Session(
        id=row["id"],
        study=row["study"],
        number=row["number"],
        language=row["language"],
        groups=json.loads(row["groups"] or "{}"),
        screen=None if row["content"] is None else json.loads(row["content"]),
        consented_at=check.read(row["consented_at"]),
        started_at=started,
        finished_at=check.read(row["finished_at"]),
        excluded_reason=row["excluded_reason"],
        erased_at=check.read(row["erased_at"]),
        slot=row["slot"],
        parameters=json.loads(row["parameters"] or "{}"),
        completion_code=row["completion_code"],
    )

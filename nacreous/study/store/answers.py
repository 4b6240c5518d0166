"""Answers: put once each, read in the order in which they came."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, cast

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql, sqlite

from nacreous.study.store import check, journal, lines, people, tokens
from nacreous.study.store.engine import in_parts
from nacreous.study.store.record import PLACES, Answer, Receipt
from nacreous.study.store.refusal import Conflict, NotAllowed, OutOfTurn
from nacreous.study.store.schema import answers, sessions
from nacreous.study.task.counting import DATA
from nacreous.study.task.row import Row, Tallied

if TYPE_CHECKING:
    import pyarrow as pa

#: Answers that are read at a time.
ROWS = 8192
#: What a scale takes of an answer, and how it is held.
COUNTED = {
    **dict.fromkeys((*PLACES, "chosen", "who"), "text"),
    **{"trial": "int64", "response_ms": "float64"},
}
#: What flags of an answer's person hang on, and how it is held.
WATCHED = {
    **dict.fromkeys(("session", "kind", "question", *PLACES, "chosen", "flags"), "text"),
    **{"received_at": "string", "response_ms": "float64", "simulated": "bool"},
}
REFUSED = "answer refused"
#: Answers of one session that are kept after they were refused. A second tab or device gives a few;
#: more only a program that would fill the disk.
MOST_REFUSED = 200

_EXCLUDED = sa.func.coalesce(sessions.c.excluded_reason, answers.c.excluded_reason).label(
    "excluded"
)
#: What is known of who gave an answer.
_OF_PERSON = (sessions.c.number, sessions.c.language, sessions.c.groups, _EXCLUDED)
_PERSON = sa.func.coalesce(sa.cast(sessions.c.number, sa.Text), answers.c.erased_as).label("person")
# Made once, for making a statement takes longer than running it.
_INSERT = {
    name: make(answers)
    .on_conflict_do_nothing(index_elements=["session", "trial"])
    .returning(answers.c.seq)
    for name, make in (("sqlite", sqlite.insert), ("postgresql", postgresql.insert))
}
# And how many trials before one are answered, in the same question to the database.
_WITH_TURN = people.LIVING.add_columns(
    sa.select(sa.func.count())
    .where(answers.c.session == sa.bindparam("session"), answers.c.trial < sa.bindparam("trial"))
    .scalar_subquery()
    .label("before")
)


def put(
    connection: sa.Connection,
    at: str,
    session: str,
    answer: Answer,
    in_turn: bool,
    last: bool = False,
) -> Receipt:
    """Store an answer, or find that it is stored; refuse another under the same key.

    What was refused is kept in the audit log, whole, up to `MOST_REFUSED` of a session. `in_turn`:
    from the participant, whose token is not revoked, who did not withdraw, and who has answered all
    trials before it. `last`: with this one, all of the plan are answered, and the person has
    finished, whatever becomes of their page.
    """
    if in_turn:
        person = people.living(connection, session, _WITH_TURN, trial=answer.trial)
        _check_turn(person, answer.trial)
    else:
        person = people.living(connection, session)
    if person.consented_at is None:
        raise NotAllowed(f"session {session} has not consented; wanted: consent before answers")
    row = dict(answer.row, study=person.study, session=session, received_at=at)
    insert = _INSERT[connection.dialect.name]
    stored = connection.execute(insert, {**row, "digest": answer.digest}).scalar_one_or_none()
    if stored is not None:
        if last:
            people.set_once(connection, at, session, "finished_at", people.FINISHED)
        return _receipt(session, answer, at, again=False)
    kept = connection.execute(
        sa.select(answers.c.digest, answers.c.received_at).where(
            answers.c.session == session, answers.c.trial == answer.trial
        )
    ).one()
    if kept.digest == answer.digest:
        return _receipt(session, answer, kept.received_at, again=True)
    journal.note(
        connection,
        at,
        "participant",
        REFUSED,
        person.study,
        session,
        most=MOST_REFUSED,
        answer=answer.row,
    )
    raise Conflict(
        f"trial {answer.trial} of session {session} is answered already, and otherwise; "
        "allowed: the same answer again"
    )


def _check_turn(person: Any, trial: int) -> None:
    """What may have changed since the participant was last looked at, in this very transaction."""
    if person.token_hash is None:
        raise tokens.unknown()
    if person.excluded_reason == people.WITHDREW:
        raise NotAllowed("the participant withdrew; nothing more is taken")
    if person.before < trial:
        raise OutOfTurn(
            f"trial is {trial} while {person.before} trials before it are answered; "
            "allowed: the next one, or one that is answered"
        )


def count(connection: sa.Connection, session: str) -> int:
    """How many answers of a session are stored."""
    query = sa.select(sa.func.count()).where(answers.c.session == session)
    return int(connection.execute(query).scalar_one())


def any_simulated(connection: sa.Connection, session: str) -> bool:
    """Whether a simulated observer answered in a session."""
    mine = (answers.c.session == session) & answers.c.simulated
    return connection.execute(sa.select(answers.c.seq).where(mine).limit(1)).first() is not None


def _receipt(session: str, answer: Answer, at: str, *, again: bool) -> Receipt:
    received = check.read(at)
    if received is None:
        raise AssertionError("the column is never null")
    return Receipt(session, answer.trial, received, again)


def rows(connection: sa.Connection, study: str, session: str | None = None) -> list[Row]:
    """Every answer of a study, in the order of arrival, with what is known of who gave it."""
    query = _joined(study, answers, *_OF_PERSON).order_by(answers.c.seq)
    if session is not None:
        query = query.where(answers.c.session == session)
    return [cast("Row", dict(row)) for row in connection.execute(query).mappings()]


def parts(
    connection: sa.Connection, study: str, names: Sequence[str]
) -> Iterator[dict[str, Sequence[Any]]]:
    """Some columns of every answer, as `rows` has them, `ROWS` answers at a time.

    person: as `nacreous.study.task.row.person_of` has it. The database holds back what has not
    been asked for, and no part outlives the next.
    """
    known = {column.name: column for column in (*answers.c, *_OF_PERSON, _PERSON)}
    query = _joined(study, *(known[name] for name in names)).order_by(answers.c.seq)
    yield from _in_parts(connection, query)


def counting_parts(
    connection: sa.Connection, study: str, question: str, *, simulated: bool
) -> Iterator[pa.Table]:
    """What a scale takes of the answers that count (`COUNTED`), in the order of arrival.

    Those of `nacreous.study.task.counting`, as the database finds them. who: the session, or the
    random name of an erased person; trial: of an erased person, who has none left, the order of
    arrival.
    """
    trial = sa.func.coalesce(answers.c.trial, answers.c.seq)
    who = sa.func.coalesce(answers.c.session, answers.c.erased_as)
    query = sa.select(
        *(answers.c[name] for name in (*PLACES, "chosen", "response_ms")),
        *(who.label("who"), trial.label("trial")),
    ).where(
        answers.c.study == study,
        answers.c.question == question,
        answers.c.kind.in_(DATA),
        answers.c.excluded_reason.is_(None),
        answers.c.simulated == simulated,
    )
    out = sa.select(sessions.c.id).where(
        sessions.c.study == study, sessions.c.excluded_reason.is_not(None)
    )
    if connection.execute(out.limit(1)).first():
        query = query.where(sa.or_(answers.c.session.is_(None), answers.c.session.not_in(out)))
    yield from lines.tables(connection, query, COUNTED, {"response_ms"}, ROWS)


def watched_parts(connection: sa.Connection, study: str) -> Iterator[pa.Table]:
    """What flags hang on (`WATCHED`), of all answers in the order of arrival."""
    query = sa.select(*(answers.c[name] for name in WATCHED)).where(answers.c.study == study)
    yield from lines.tables(connection, query, WATCHED, {"session", "response_ms"}, ROWS)


def _joined(study: str, *columns: Any) -> sa.Select[Any]:
    """Columns of a study's answers and of who gave them."""
    query = sa.select(*columns).select_from(answers)
    query = query.outerjoin(sessions, sessions.c.id == answers.c.session)
    return query.where(answers.c.study == study)


def _in_parts(
    connection: sa.Connection, query: sa.Select[Any]
) -> Iterator[dict[str, Sequence[Any]]]:
    names = [column.name for column in query.selected_columns]
    whether = [
        at for at, of in enumerate(query.selected_columns) if isinstance(of.type, sa.Boolean)
    ]
    for part in in_parts(connection, query, ROWS):
        columns: list[Sequence[Any]] = list(zip(*part, strict=True))
        for at in whether:  # SQLite has but numbers
            columns[at] = [bool(value) for value in columns[at]]
        yield dict(zip(names, columns, strict=True))


def tally(connection: sa.Connection, study: str) -> list[Tallied]:
    """How many answers are the same but for who gave them and when."""
    named = [answers.c[name] for name in ("question", "kind", "simulated", *PLACES, "chosen")]
    query = _joined(study, *named, _EXCLUDED, sa.func.count().label("count"))
    query = query.group_by(*named, _EXCLUDED)
    return [cast("Tallied", dict(row)) for row in connection.execute(query).mappings()]

"""Bring a store's tables to the newest schema, by Alembic, in one transaction."""

from __future__ import annotations

from pathlib import Path

import sqlalchemy as sa
from alembic.runtime.migration import MigrationContext

from nacreous.missing import missing
from nacreous.problem import InputError
from nacreous.study.store.engine import keep_log, keep_private, make_private, writing
from nacreous.study.store.fault import place_of, translated
from nacreous.study.store.foreign import check_own
from nacreous.study.store.steps import script, take

#: Held while tables change, so that two programs that start at once do not both make them.
_LOCK = 0x4E414352


def upgrade(engine: sa.Engine, *, make: bool = True) -> None:
    """Make the tables where there are none, or add what newer versions need; at once if current.

    Raises `InputError` where the database is newer than this program, not a store at all, or,
    unless it may `make` one, empty or absent; `StoreError` where it cannot be reached or written.
    Then nothing is changed.
    """
    place = place_of(engine)
    if not make and engine.dialect.name == "sqlite" and not Path(place).is_file():
        raise missing(place, "a store")
    if engine.dialect.name == "sqlite":
        make_private(Path(place))
    with translated(place):
        _upgrade(engine, place, make)
        if engine.dialect.name == "sqlite":
            keep_private(Path(place))
        keep_log(engine)  # only now, for it changes the file, which may be another program's


def _upgrade(engine: sa.Engine, place: str, make: bool) -> None:
    _, steps = script()
    with writing(engine).begin() as connection:
        if connection.dialect.name == "postgresql":
            connection.execute(sa.text("SELECT pg_advisory_xact_lock(:key)"), {"key": _LOCK})
        revision = check_revision(connection, place)
        if revision is None and not make:
            raise InputError(f"{place}: is empty; wanted: a store")
        if revision != steps.get_current_head():
            take(connection)


def check_revision(connection: sa.Connection, place: str) -> str | None:
    """The schema's version; None for an empty database. Refuses what this program cannot use."""
    _, steps = script()
    tables = sa.inspect(connection).get_table_names()
    if not tables and not _holds_more(connection):
        return None
    if "alembic_version" not in tables or "answers" not in tables:
        raise InputError(f"{place}: holds other tables; wanted: a store, or an empty database")
    heads = MigrationContext.configure(connection).get_current_heads()
    if len(heads) > 1:
        raise InputError(
            f"{place}: names {len(heads)} schemas; wanted: a store as Nacreous made it"
        )
    revision = heads[0] if heads else None
    known = {step.revision for step in steps.walk_revisions()}
    if revision not in known:
        raise InputError(
            f"{place}: has schema {revision!a}, which this version of Nacreous does not know; "
            f"allowed: up to {steps.get_current_head()}"
        )
    if connection.dialect.name == "sqlite" and revision is not None:
        check_own(connection, place, revision)
    return revision


def _holds_more(connection: sa.Connection) -> bool:
    """Views, in an SQLite file without tables."""
    if connection.dialect.name != "sqlite":
        return False
    return bool(connection.exec_driver_sql("SELECT count(*) FROM sqlite_master").scalar_one())

"""Where a store is, and connections to it that keep what they promise."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import stat
import time
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from os import PathLike
from pathlib import Path
from typing import Any

import sqlalchemy as sa
from sqlalchemy.exc import ArgumentError, DBAPIError, OperationalError

from nacreous.problem import InputError

#: The variable that holds a URL or a path.
VARIABLE = "NACREOUS_STORE"
#: The file in a study's folder.
FILE = "answers.sqlite"
#: The files that SQLite keeps beside a database, by what follows its name.
BESIDE = ("-wal", "-shm", "-journal")
#: How long to wait for another program's transaction, in ms.
_BUSY_MS = 10_000


def engine_of(place: str | PathLike[str] | None) -> sa.Engine:
    """The engine for a PostgreSQL URL, a file, or a folder that holds `answers.sqlite`.

    None: what NACREOUS_STORE says. Raises `InputError` for a place that cannot be one; nothing is
    opened yet.

    >>> engine_of("mysql://lab/pearls")
    Traceback (most recent call last):
    nacreous.problem.InputError: store is mysql:...; allowed: a path, or postgresql://...
    """
    given = given_place(place)
    if "://" not in given:
        return _sqlite(Path(given))
    if given.partition("://")[0] not in ("postgresql", "postgres"):
        scheme = given.partition(":")[0]
        raise InputError(f"store is {scheme}:...; allowed: a path, or postgresql://...")
    return _postgresql(given)


def given_place(place: str | PathLike[str] | None) -> str:
    """The place as it was given, or as NACREOUS_STORE says. Raises `InputError` for none."""
    given = os.environ.get(VARIABLE) if place is None else os.fspath(place)
    if not given:
        raise InputError(f"store is empty; wanted: a path or a URL, as an argument or {VARIABLE}")
    return given


def _sqlite(path: Path) -> sa.Engine:
    path = Path(os.path.realpath(path))
    file = path / FILE if path.is_dir() else path
    if file.is_symlink():  # a folder that was handed on could otherwise name any file of ours
        raise InputError(
            f"{file}: is a link to {os.path.realpath(file)}; wanted: a file in the folder itself, "
            "or the path of the store instead of the folder's"
        )
    for beside in (Path(f"{file}{end}") for end in BESIDE):
        if beside.is_symlink():  # SQLite would write to where it leads, or say nothing plain
            raise InputError(
                f"{beside}: is a link to {os.path.realpath(beside)}; wanted: none beside a store "
                "(remove it)"
            )
    if file.exists() and not file.is_file():  # who opens a pipe waits for another program
        raise InputError(f"{file}: is no ordinary file; wanted: a store, or a new file")
    if not file.parent.is_dir():
        raise InputError(f"{file}: the folder {file.parent} does not exist")
    engine = sa.create_engine(
        sa.URL.create("sqlite", database=str(file)), pool_size=8, max_overflow=56
    )
    sa.event.listen(engine, "connect", _prepare_sqlite)
    sa.event.listen(engine, "begin", _begin_sqlite)
    return engine


def _prepare_sqlite(connection: Any, _record: Any) -> None:
    connection.isolation_level = None  # the driver begins no transactions of its own
    for pragma in (
        f"busy_timeout = {_BUSY_MS}",
        "synchronous = FULL",  # a commit is on the disk when it returns
        "foreign_keys = ON",
        "secure_delete = ON",  # what is erased is overwritten
        "trusted_schema = OFF",  # a file that was handed on calls no functions of ours
    ):
        connection.execute(f"PRAGMA {pragma}")


def make_private(path: Path) -> None:
    """Make a database's file, empty, where there is none; SQLite's files beside it follow it."""
    with contextlib.suppress(OSError):  # SQLite itself says what is wrong with the place
        os.close(os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600))


def keep_private(path: Path) -> None:
    """Leave a database and the files beside it to its owner alone, where that is who we are."""
    for name in (path, *(Path(f"{path}{end}") for end in BESIDE)):
        with contextlib.suppress(OSError):  # another user's store, or a file system without rights
            if stat.S_IMODE(name.stat().st_mode) & 0o077:
                name.chmod(0o600)


def keep_log(engine: sa.Engine) -> None:
    """Let SQLite write ahead into a log: readers never wait, and a commit is one flush."""
    if engine.dialect.name != "sqlite":
        return
    end = time.monotonic() + _BUSY_MS / 1000
    while True:
        try:
            outside_transaction(engine, "PRAGMA journal_mode = WAL")
            return
        except OperationalError:  # while another opens it too; SQLite does not wait for this lock
            if time.monotonic() > end:
                raise
            time.sleep(0.02)


def outside_transaction(engine: sa.Engine, statement: str) -> None:
    """Run a statement that SQLite refuses inside a transaction."""
    with engine.connect() as connection:
        driver = connection.connection.driver_connection
        if driver is None:
            raise AssertionError("a connection that is open has its driver's")
        try:
            driver.execute(statement)
        except sqlite3.OperationalError as problem:
            raise OperationalError(statement, {}, problem) from problem


def in_parts(
    connection: sa.Connection, query: sa.Select[Any], rows: int
) -> Iterator[Sequence[tuple[Any, ...]]]:
    """What a query finds, so many rows at a time, as the driver itself has them.

    The database holds back the rest. SQLAlchemy's rows take as long again as the driver's.
    """
    if not connection.in_transaction():
        connection.begin()
    made = query.compile(connection, compile_kwargs={"render_postcompile": True})
    names = made.positiontup
    values = made.params if names is None else [made.params[name] for name in names]
    driver: Any = connection.connection.driver_connection
    held_back = {} if connection.dialect.name == "sqlite" else {"name": "nacreous_parts"}
    try:
        with contextlib.closing(driver.cursor(**held_back)) as cursor:
            cursor.execute(made.string, values)
            while part := cursor.fetchmany(rows):
                yield part
    except connection.dialect.loaded_dbapi.Error as problem:
        raise DBAPIError(made.string, None, problem) from problem


def _begin_sqlite(connection: sa.Connection) -> None:
    # A writer that begins as a reader may find, too late, that another has written in between.
    writes = connection.get_execution_options().get("writes", False)
    connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")


def _postgresql(given: str) -> sa.Engine:
    if find_spec("psycopg") is None:
        raise InputError("PostgreSQL needs psycopg:   pip install 'nacreous[postgresql]'")
    try:
        url = sa.make_url(given).set(drivername="postgresql+psycopg")
    except (ArgumentError, ValueError) as problem:
        raise InputError(
            "store is no URL; wanted: such as postgresql://user@host/name"
        ) from problem
    return sa.create_engine(
        url,
        pool_size=8,
        max_overflow=24,
        pool_pre_ping=True,  # a server that was restarted costs no answer
        isolation_level="REPEATABLE READ",  # whoever reads sees one state, as with SQLite
        connect_args={
            "connect_timeout": 10,
            "options": "-c synchronous_commit=on -c timezone=UTC -c lock_timeout=10000",
            "application_name": "nacreous",
        },
    )


def writing(engine: sa.Engine) -> sa.Engine:
    """The same engine for transactions that write; each statement sees what others wrote."""
    if engine.dialect.name == "sqlite":
        return engine.execution_options(writes=True)
    return engine.execution_options(isolation_level="READ COMMITTED")

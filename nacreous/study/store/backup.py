"""Copies of a whole store, and stores from copies.

A backup is one SQLite file, whichever database the store is in: a laptop's backup can be restored
into PostgreSQL, and the other way round. Accounts are in it, so that experimenters can go on;
logins are not, for whoever is logged in is logged in to one server.
"""

from __future__ import annotations

import contextlib
import os
import sqlite3
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import sqlalchemy as sa

from nacreous import file, json_text
from nacreous.problem import InputError
from nacreous.study.store.belonging import check_belonging
from nacreous.study.store.contents import check_contents
from nacreous.study.store.copy_file import read_only, reading_engine
from nacreous.study.store.earlier import hashes, require_earlier_backup
from nacreous.study.store.engine import BESIDE, engine_of, given_place, writing
from nacreous.study.store.fault import StoreError, place_of, translated
from nacreous.study.store.migrate import check_revision, upgrade
from nacreous.study.store.schema import answers, logins, metadata, sessions, studies
from nacreous.study.store.studies import is_intact

#: Rows read and written at a time.
_ROWS = 2000


@dataclass(frozen=True)
class Copied:
    """How much a copy holds."""

    studies: int
    sessions: int
    answers: int


def backup(place: str | PathLike[str] | None, output: str | PathLike[str]) -> Copied:
    """Copy a store to a file, whole or not at all, while others go on using it.

    The copy shows the store at one instant. Raises `InputError` where there is no store or `output`
    cannot be written, `StoreError` where the machine refuses.
    """
    file.check_output(output, [".sqlite"])
    with _opened(place) as engine:
        file.require_apart([output], [place_of(engine)])
        with engine.connect() as reading:
            require_earlier_backup(Path(output), hashes(reading))
        with _refused(str(output)), file.atomic(output, private=True) as temporary:
            if engine.dialect.name == "sqlite":
                _copy_file(Path(place_of(engine)), temporary)
            else:
                _copy_rows_to_file(engine, temporary)
            return _checked(temporary)


def restore(backup: str | PathLike[str], place: str | PathLike[str] | None) -> Copied:
    """Make a store from a backup, whole or not at all; an older schema is brought up to date.

    The backup is checked first. There must be no store at `place` yet; a folder is made where a
    name without an ending says none that is there. Raises `InputError` otherwise, `StoreError`
    where the machine refuses.
    """
    file.check_ordinary(backup)
    counts = _checked(Path(backup), handed_on=True)
    with _made_folder(place):
        engine = engine_of(place)
        try:
            if engine.dialect.name == "sqlite":
                _restore_file(Path(backup), Path(place_of(engine)))
            else:
                _restore_rows(Path(backup), engine)
        finally:
            engine.dispose()
    return counts


@contextlib.contextmanager
def _made_folder(place: str | PathLike[str] | None) -> Iterator[None]:
    """The folder that a name without an ending means; none is left where nothing comes of it."""
    given = given_place(place)
    folder = Path(os.path.realpath(given))  # of a link that leads nowhere yet, where it leads
    if "://" in given or Path(given).suffix or folder.suffix or not folder.parent.is_dir():
        yield
        return
    try:
        folder.mkdir()
    except FileExistsError:
        yield
        return
    except OSError as problem:
        raise InputError(f"{folder}: cannot be made ({problem.strerror})") from None
    try:
        yield
    except BaseException:
        with contextlib.suppress(OSError):
            folder.rmdir()
        raise


def _restore_file(backup: Path, target: Path) -> None:
    # A log that lies there would be played into the restored file.
    for taken in (target, *(Path(f"{target}{end}") for end in BESIDE)):
        if taken.exists():
            raise InputError(f"{taken}: is there already; wanted: a place without a store")
    with _refused(str(target)), file.atomic(target, private=True) as temporary:
        _copy_file(backup, temporary)
        upgraded = engine_of(temporary)
        try:
            upgrade(upgraded)
        finally:
            upgraded.dispose()
        _single(temporary)


def _restore_rows(backup: Path, target: sa.Engine) -> None:
    place = place_of(target)
    upgrade(target)
    with tempfile.TemporaryDirectory() as folder, _refused(place):
        copy = Path(folder, "copy.sqlite")
        _copy_file(backup, copy)
        source = engine_of(copy)
        try:
            upgrade(source)
            with (
                translated(place),
                source.connect() as rows,
                writing(target).begin() as connection,
            ):
                if connection.execute(sa.select(sa.func.count()).select_from(studies)).scalar():
                    raise InputError(f"{place}: holds studies already; wanted: an empty database")
                _copy_rows(rows, connection)
        finally:
            source.dispose()


def _copy_rows_to_file(source: sa.Engine, target: Path) -> None:
    engine = engine_of(target)
    try:
        upgrade(engine)
        place = place_of(source)
        with (
            translated(place),
            source.connect() as rows,
            writing(engine).begin() as connection,
        ):
            _copy_rows(rows, connection)
    finally:
        engine.dispose()
    _single(target)


def _copy_rows(source: sa.Connection, target: sa.Connection) -> None:
    for table in metadata.sorted_tables:
        if table is logins:
            continue
        ordered = sa.select(table).order_by(*table.primary_key.columns)
        streamed = source.execution_options(yield_per=_ROWS).execute(ordered)
        for part in streamed.mappings().partitions(_ROWS):
            target.execute(sa.insert(table), [dict(row) for row in part])
        if target.dialect.name == "postgresql" and "seq" in table.c:
            highest = sa.select(sa.func.max(table.c.seq)).scalar_subquery()
            name = sa.func.pg_get_serial_sequence(table.name, "seq")
            target.execute(sa.select(sa.func.setval(name, highest)))


def _copy_file(source: Path, target: Path) -> None:
    with read_only(source) as old, contextlib.closing(sqlite3.connect(target)) as new:
        old.backup(new)
        new.execute("PRAGMA secure_delete = ON")
        if new.execute("SELECT 1 FROM sqlite_master WHERE name = 'logins'").fetchone():
            new.execute("DELETE FROM logins")
        new.commit()
    _single(target)


def _single(path: Path) -> None:
    """Let a database be one file, without a log beside it."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA journal_mode = DELETE")


def _checked(path: Path, *, handed_on: bool = False) -> Copied:
    """Of a known schema, whole, and how much is in it; `handed_on`: and each value is looked at.

    The schema first: SQLite runs what a table names, to see whether that is whole.
    """
    engine = reading_engine(path)
    try:
        with _refused(str(path)), engine.connect() as reading:
            if check_revision(reading, str(path)) is None:
                raise InputError(f"{path}: is empty; wanted: a backup of a store")
        with _refused(str(path)), read_only(path) as connection:
            verdict = connection.execute("PRAGMA integrity_check(1)").fetchone()[0]
            stray = connection.execute("PRAGMA foreign_key_check").fetchone()
            if verdict != "ok" or stray is not None:
                raise InputError(f"{path}: is damaged; wanted: a whole backup")
            if handed_on:
                check_contents(connection, str(path))
        with translated(str(path)), engine.connect() as reading:
            _check_manifests(reading, str(path))
            if handed_on:
                check_belonging(reading, str(path))
            return Copied(*(_count(reading, table) for table in (studies, sessions, answers)))
    finally:
        engine.dispose()


def _check_manifests(connection: sa.Connection, place: str) -> None:
    """What the answers are answers to has not been changed since it was frozen."""
    for row in connection.execute(sa.select(studies.c.hash, studies.c.manifest)):
        try:
            intact = is_intact(row.hash, json_text.loads(row.manifest))
        except (TypeError, ValueError, RecursionError):
            intact = False
        if not intact:
            raise InputError(
                f"{place}: the manifest of study {ascii(row.hash)[1:13]} has been changed since it "
                "was frozen; wanted: as it was made"
            )


def _count(connection: sa.Connection, table: sa.Table) -> int:
    return int(connection.execute(sa.select(sa.func.count()).select_from(table)).scalar_one())


@contextlib.contextmanager
def _opened(place: str | PathLike[str] | None) -> Iterator[sa.Engine]:
    """The engine of a store that must be there, its schema up to date."""
    engine = engine_of(place)
    try:
        upgrade(engine, make=False)
        yield engine
    finally:
        engine.dispose()


@contextlib.contextmanager
def _refused(place: str) -> Iterator[None]:
    """SQLite's own errors in one line."""
    try:
        yield
    except (sqlite3.DatabaseError, sa.exc.DatabaseError) as problem:
        text = str(problem.orig if isinstance(problem, sa.exc.DatabaseError) else problem)
        if "not a database" in text or "malformed" in text:
            raise InputError(f"{place}: is no whole store; wanted: a backup") from problem
        if Path(f"{place}-journal").exists():  # SQLite would first write it back into the file
            raise InputError(
                f"{place}-journal: lies beside the backup, of a program that was broken off; "
                "wanted: the backup alone (a backup needs no such file: remove it)"
            ) from problem
        raise StoreError(f"cannot be copied ({text})", place) from problem

"""The steps that make a store's tables, and the tables that they make."""

from __future__ import annotations

import re
import threading
from functools import cache

import sqlalchemy as sa
from alembic.config import Config
from alembic.runtime.environment import EnvironmentContext
from alembic.script import ScriptDirectory

#: Alembic knows one connection at a time, for all threads.
_ALONE = threading.Lock()
_TOKEN = re.compile(r"'(?:[^']|'')*'|\"(?:[^\"]|\"\")*\"|\w+|\S")

#: What SQLite makes by itself: another under such a name could be anything.
_BY_ITSELF = {
    "sqlite_sequence": "CREATE TABLE sqlite_sequence(name,seq)",
    "sqlite_stat1": "CREATE TABLE sqlite_stat1(tbl,idx,stat)",
    "sqlite_stat4": "CREATE TABLE sqlite_stat4(tbl,idx,neq,nlt,ndlt,sample)",
}

#: What a database holds: kind and name of each part, and its SQL in words.
Parts = dict[tuple[str, str], list[str]]


def script() -> tuple[Config, ScriptDirectory]:
    """Alembic's view of the steps."""
    config = Config()
    config.set_main_option("script_location", "nacreous.study.store:migrations")
    config.set_main_option("version_locations", "nacreous.study.store:migrations")
    config.set_main_option("path_separator", "newline")
    return config, ScriptDirectory.from_config(config)


def take(connection: sa.Connection, newest: str = "head") -> None:
    """Take the steps up to `newest` that a database lacks."""
    config, directory = script()
    with (
        _ALONE,
        EnvironmentContext(
            config, directory, fn=lambda revision, _: directory._upgrade_revs(newest, revision)
        ) as environment,
    ):
        environment.configure(connection=connection)
        environment.run_migrations()


@cache
def parts_made(revision: str) -> Parts:
    """The parts of an SQLite database that the steps up to a revision make."""
    engine = sa.create_engine("sqlite://")
    try:
        with engine.begin() as connection:
            take(connection, revision)
            return parts_of(connection)
    finally:
        engine.dispose()


def parts_of(connection: sa.Connection) -> Parts:
    """The parts of an SQLite database, but those that SQLite makes by itself.

    In words, for another version of what writes the SQL may set blanks and quotes otherwise.
    """
    found = connection.exec_driver_sql(
        "SELECT type, name, sql FROM sqlite_master ORDER BY type, name"
    ).all()
    return {
        (str(kind), str(name)): [_plain(word) for word in _TOKEN.findall(str(sql))]
        for kind, name, sql in found
        if not _by_itself(kind, name, sql)
    }


def _by_itself(kind: str, name: str, sql: str | None) -> bool:
    """Counters, statistics, and what keeps a constraint, which has no SQL of its own."""
    if kind == "table":
        return sql == _BY_ITSELF.get(name, "")
    return kind == "index" and sql is None


def _plain(word: str) -> str:
    return word[1:-1] if re.fullmatch(r'"\w+"', word) else word

"""What has no place in a store's SQLite file: it may come from anybody, and would act in ours."""

from __future__ import annotations

import sqlalchemy as sa

from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.study.store.schema import metadata

_TABLES = frozenset((*metadata.tables, "alembic_version"))


def check_own(connection: sa.Connection, place: str) -> None:
    """Refuse triggers, views, tables and indexes that no version of ours makes.

    A trigger or a view runs when we write or read; a virtual table, a generated column and an index
    of an expression do so too, under a name of ours. Raises `InputError` that names the first.
    """
    found = connection.exec_driver_sql(
        "SELECT type, name, tbl_name, sql FROM sqlite_master ORDER BY type, name"
    ).all()
    for kind, name, table, sql in found:
        if str(name).startswith("sqlite_"):  # SQLite's own, whose names nobody else may use
            continue
        if kind == "table" and name in _TABLES:
            _check_table(connection, place, name, str(sql))
        elif kind == "index" and table in _TABLES:
            _check_index(connection, place, name)
        else:
            raise _refused(place, f"the {kind} {name}")


def _check_table(connection: sa.Connection, place: str, table: str, sql: str) -> None:
    if not sql.upper().startswith("CREATE TABLE"):
        raise _refused(place, f"the virtual table {table}")
    known = {"version_num"}
    if table in metadata.tables:
        known = set(metadata.tables[table].columns.keys())
    for column in connection.exec_driver_sql(f'PRAGMA table_xinfo("{table}")'):
        if column.name not in known or column.hidden:
            raise _refused(place, f"the column {table}.{column.name}")


def _check_index(connection: sa.Connection, place: str, index: str) -> None:
    quoted = index.replace('"', '""')
    for column in connection.exec_driver_sql(f'PRAGMA index_xinfo("{quoted}")'):
        if column.cid == -2:  # an expression
            raise _refused(place, f"the index {index}")


def _refused(place: str, what: str) -> InputError:
    return InputError(
        f"{place}: holds {printable(what)}, which no store has; wanted: a store as Nacreous made it"
    )

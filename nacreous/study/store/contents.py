"""What the columns of a backup may hold: a file that was handed on may hold anything anywhere.

SQLite keeps text in a column of numbers, and bytes in one of text. Looked at in the database, row
by row, so that millions of answers take seconds and no memory: texts alone come to Python. Keys
into other tables are not looked at again, for `PRAGMA foreign_key_check` found each there.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Mapping
from datetime import datetime
from typing import Any, NamedTuple

import sqlalchemy as sa

from nacreous import json_text
from nacreous.problem import InputError
from nacreous.study.store.passwords import is_hash
from nacreous.study.store.schema import logins, metadata
from nacreous.study.store.studies import REGISTRATIONS, STATES
from nacreous.study.task.counting import KINDS
from nacreous.study.task.tasks import columns_of_tasks

__all__ = ["check_contents"]


class _Law(NamedTuple):
    """What a column may hold: a condition of SQL on {it}, and the same in words."""

    holds: str
    allowed: str


# Text comes to Python as bytes, for sqlite3 ends at what is no UTF-8.
_MOMENT = _Law(
    "is_moment(CAST({it} AS BLOB))", "a time as 2026-03-01T09:30:00.000000Z, or a day alone"
)
_TEXT = _Law("is_text(CAST({it} AS BLOB))", "text in UTF-8")
_WORDS: Mapping[str, tuple[str, ...]] = {
    "studies.state": STATES,
    "studies.registration": REGISTRATIONS,
    "answers.kind": KINDS,
    **{f"answers.{one.name}": one.values for one in columns_of_tasks() if one.values},
}
_LAWS: Mapping[str, _Law] = {
    **{
        name: _Law(f"{{it}} IN ({', '.join(map(repr, words))})", ", ".join(words))
        for name, words in _WORDS.items()
    },
    "answers.response_ms": _Law("{it} BETWEEN 0 AND 86400000", "0 to 86400000"),
    "answers.flags": _Law("{it} = '{{}}' OR is_object(CAST({it} AS BLOB))", "a JSON object"),
    "sessions.plan": _Law("is_plan(CAST({it} AS BLOB))", "a JSON list of trials"),
    **dict.fromkeys(
        ("sessions.groups", "sessions.parameters"),
        _Law("is_texts(CAST({it} AS BLOB))", "a JSON object of texts"),
    ),
    **dict.fromkeys(
        ("screens.content", "audit.detail"),
        _Law("is_object(CAST({it} AS BLOB))", "a JSON object"),
    ),
    "accounts.password": _Law("is_hash(CAST({it} AS BLOB))", "a hash as Nacreous makes it"),
}
#: How long a day and a time are, as `check.written` writes them.
_DAY, _TIME = len("2026-03-01"), len("2026-03-01T09:30:00.000000Z")
#: Of a plan's trials, as `nacreous.study.running.plans` writes them.
_TRIAL: Mapping[str, type] = {"number": int, "question": str, "block": int, "break_before": bool}


def check_contents(connection: sqlite3.Connection, place: str) -> None:
    """Refuse the first value that no column of a store has, by table, row and column.

    connection: to a backup whose schema is known, of whichever version. Raises `InputError`.
    """
    for name, function in _FUNCTIONS.items():
        connection.create_function(name, 1, function, deterministic=True)
    for table in metadata.sorted_tables:
        there = {row[1] for row in connection.execute(f'PRAGMA table_info("{table.name}")')}
        columns = [one for one in table.columns if one.name in there and not one.foreign_keys]
        if columns and table is not logins:
            _check_table(connection, place, table.name, columns)


def _check_table(
    connection: sqlite3.Connection, place: str, table: str, columns: list[sa.Column[Any]]
) -> None:
    cases = " ".join(
        f"WHEN NOT ({_condition(column)}) THEN {number}" for number, column in enumerate(columns)
    )
    found = connection.execute(
        f'SELECT rowid, bad FROM (SELECT rowid, CASE {cases} END AS bad FROM "{table}") '  # noqa: S608
        "WHERE bad IS NOT NULL LIMIT 1"
    ).fetchone()
    if found is None:
        return
    row, bad = found
    column = columns[bad]
    (value,) = connection.execute(
        f"SELECT CASE typeof(\"{column.name}\") WHEN 'text' "  # noqa: S608
        f'THEN CAST("{column.name}" AS BLOB) ELSE "{column.name}" END FROM "{table}" '
        "WHERE rowid = ?",
        (row,),
    ).fetchone()
    raise InputError(
        f"{place}: {table}, row {row}: {column.name} is {_shown(value)}; "
        f"allowed: {_law(column).allowed}{', or empty' if column.nullable else ''}"
    )


def _condition(column: sa.Column[Any]) -> str:
    """True of what may be there, and never NULL."""
    it = f'"{column.name}"'
    kinds = {
        sa.Double: ("real", "integer"),
        sa.Integer: ("integer",),
        sa.Boolean: ("integer",),
    }
    wanted = next((kinds[kind] for kind in kinds if isinstance(column.type, kind)), ("text",))
    of_kind = f"typeof({it}) IN ({', '.join(map(repr, wanted))})"
    held = f"CASE WHEN {of_kind} THEN {_law(column).holds.format(it=it)} ELSE 0 END"
    return f"({it} IS NULL OR {held})" if column.nullable else held


def _law(column: sa.Column[Any]) -> _Law:
    known = _LAWS.get(f"{column.table.name}.{column.name}")
    if known is not None:
        return known
    if isinstance(column.type, sa.Boolean):
        return _Law("{it} IN (0, 1)", "0 or 1")
    if isinstance(column.type, sa.Integer):
        most = 2**53 if column.primary_key else 2**31 - 1
        return _Law(f"{{it}} BETWEEN 0 AND {most}", f"a whole number, 0 to {most}")
    if column.name == "at" or column.name.endswith("_at"):
        return _MOMENT
    longest = getattr(column.type, "length", None)
    if longest is None:
        return _TEXT
    return _Law(f"length({{it}}) <= {longest} AND ({_TEXT.holds})", f"text of up to {longest}")


def _shown(value: Any) -> str:
    if isinstance(value, bytes):
        try:
            value = value.decode()
        except UnicodeDecodeError:
            return f"{ascii(value[:40])[1:]}, which is no text"
    made = ascii(value)
    return made if len(made) <= 60 else made[:57] + "..."


def _is_moment(text: bytes) -> bool:
    if len(text) == _TIME:
        shaped = text.endswith(b"Z") and text[_DAY] == ord("T")
    else:
        shaped = len(text) == _DAY and text.count(b"-") == 2
    try:
        return shaped and bool(datetime.fromisoformat(text.decode()))
    except ValueError:
        return False


def _is_text(text: bytes) -> bool:
    """UTF-8 without NUL, which PostgreSQL cannot hold."""
    try:
        text.decode()
    except UnicodeDecodeError:
        return False
    return b"\0" not in text


def _json(text: bytes) -> Any:
    """What JSON says; None, as of JSON's null, where it is none."""
    try:
        return json_text.loads(text.decode())
    except (ValueError, RecursionError):
        return None


def _is_object(text: bytes) -> bool:
    return isinstance(_json(text), dict)


def _is_texts(text: bytes) -> bool:
    made = _json(text)
    return isinstance(made, dict) and all(isinstance(value, str) for value in made.values())


def _is_plan(text: bytes) -> bool:
    made = _json(text)
    return isinstance(made, list) and all(
        isinstance(trial, dict)
        and all(isinstance(trial[name], kind) for name, kind in _TRIAL.items() if name in trial)
        for trial in made
    )


_FUNCTIONS: Mapping[str, Callable[[Any], bool]] = {
    "is_moment": _is_moment,
    "is_text": _is_text,
    "is_object": _is_object,
    "is_texts": _is_texts,
    "is_plan": _is_plan,
    "is_hash": lambda text: _is_text(text) and is_hash(text.decode()),
}

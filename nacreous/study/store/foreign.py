"""What has no place in a store's SQLite file: it may come from anybody, and would act in ours."""

from __future__ import annotations

from itertools import zip_longest
from typing import Any

import sqlalchemy as sa

from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.study.store.schema import metadata
from nacreous.study.store.steps import Parts, parts_made, parts_of

#: Tables whose rows are counted up.
_COUNTED = tuple(name for name, table in metadata.tables.items() if "seq" in table.c)
_MOST_ROWS = 2**53


def check_own(connection: sa.Connection, place: str, revision: str) -> None:
    """Refuse whatever the steps up to a revision do not make, and what they make and is not there.

    A trigger, a view, a virtual table, a generated column, a CHECK, a DEFAULT, a UNIQUE and an
    index of expressions or of some rows run or refuse when we write or read. What a lab added for
    speed, an index of plain columns, does neither. Nor are texts in UTF-16, which SQLite can keep.
    Raises `InputError` that names the first.
    """
    encoding = connection.exec_driver_sql("PRAGMA encoding").scalar_one()
    if encoding != "UTF-8":
        raise InputError(f"{place}: is in {encoding}; wanted: UTF-8, as Nacreous makes stores")
    found, made = parts_of(connection), parts_made(revision)
    for (kind, name), words in found.items():
        own = made.get((kind, name))
        if own is None and not (kind == "index" and _is_plain(connection, name, made)):
            raise _refused(place, f"the {kind} {name}")
        if own is not None and own != words:
            raise _refused(place, _difference(kind, name, words, own))
    for kind, name in made.keys() - found.keys():
        raise InputError(f"{place}: lacks the {kind} {name}; wanted: a store as Nacreous made it")
    _check_counters(connection, place, made)


def _is_plain(connection: sa.Connection, index: str, made: Parts) -> bool:
    """Of columns alone, of every row, and for speed alone."""
    table = connection.exec_driver_sql(
        "SELECT tbl_name FROM sqlite_master WHERE type = 'index' AND name = ?", (index,)
    ).scalar_one()
    if ("table", table) not in made:
        return False
    quoted = str(table).replace('"', '""')
    listed = {
        row.name: row for row in connection.exec_driver_sql(f'PRAGMA index_list("{quoted}")')
    }.get(index)
    if listed is None or listed.unique or listed.partial:
        return False
    quoted = index.replace('"', '""')
    expression = -2
    columns = connection.exec_driver_sql(f'PRAGMA index_xinfo("{quoted}")')
    return all(column.cid != expression for column in columns)


def _difference(kind: str, name: str, words: list[str], own: list[str]) -> str:
    """The part, and the word from which on it is another."""
    pairs = zip_longest(words, own, fillvalue="its end")
    first = next(word for word, wanted in pairs if word != wanted)
    return f"the {kind} {name}, changed at {first[:40]}"


def _check_counters(connection: sa.Connection, place: str, made: Parts) -> None:
    """After its last number SQLite refuses every row; nobody counts so far."""
    counted = [name for name in _COUNTED if ("table", name) in made]
    for name in ("sqlite_sequence", *counted):
        highest: sa.Select[tuple[Any]] = sa.select(sa.func.max(sa.column("seq"))).select_from(
            sa.table(name)
        )
        number = connection.execute(highest).scalar_one()
        if number is not None and not (isinstance(number, int) and number <= _MOST_ROWS):
            raise InputError(
                f"{place}: the highest number in {name} is {printable(str(number))[:40]}; "
                "allowed: up to 2^53"
            )


def _refused(place: str, what: str) -> InputError:
    return InputError(
        f"{place}: holds {printable(what)}, which no store has; wanted: a store as Nacreous made it"
    )

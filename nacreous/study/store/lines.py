"""Answers as text that the database itself joins: millions of them, and no Python object for each.

Python's own rows of two million answers take twice as long to read as the database takes to find
them, and leave its memory in pieces.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sqlalchemy as sa

from nacreous.study.store.schema import answers

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = ["tables"]


def tables(
    connection: sa.Connection,
    query: sa.Select[Any],
    kinds: Mapping[str, str],
    nullable: Collection[str],
    rows: int,
) -> Iterator[pa.Table]:
    """What a query of answers finds, in the order of arrival, from so many places at a time.

    query: whose columns bear the names of `kinds`, and which selects from `answers`. kinds: how
    each is held: "text" (an Arrow dictionary of the part), or Arrow's string, int64, float64 or
    bool. nullable: the columns that may be NULL.
    """
    columns = {column.name: column for column in query.selected_columns}
    fields = [(columns[name], kind, name in nullable) for name, kind in kinds.items()]
    line = (_printed if connection.dialect.name == "sqlite" else _concatenated)(fields)
    bounds = query.with_only_columns(sa.func.min(answers.c.seq), sa.func.max(answers.c.seq))
    first, last = connection.execute(bounds).one()
    if first is None:
        return
    low, high = (sa.bindparam(name, type_=sa.BigInteger) for name in ("low", "high"))
    part = query.with_only_columns(line.label("line")).order_by(answers.c.seq)
    part_lines = part.where(answers.c.seq >= low, answers.c.seq < high).subquery()
    joined = sa.select(sa.func.aggregate_strings(part_lines.c.line, "\n"))
    next_first = bounds.where(answers.c.seq >= low)
    start = first
    while start is not None and start <= last:
        text = connection.execute(joined, {"low": start, "high": start + rows}).scalar_one()
        start += rows
        if text is not None:
            yield _table(text, kinds)
        else:  # numbers may leave out as many as they like
            start = connection.execute(next_first, {"low": start}).one()[0]


#: Each a value, its kind, and whether it may be NULL.
_Fields = Sequence[tuple[sa.ColumnElement[Any], str, bool]]


def _printed(fields: _Fields) -> sa.ColumnElement[str]:
    """Values as CSV has them, by SQLite: one call is faster than many concatenations.

    Nothing stands for NULL, texts are between quotation marks, and numbers have all their digits.
    """
    forms = {"text": '"%w"', "string": '"%w"', "int64": "%lld", "float64": "%!.17g", "bool": "%d"}
    form, values = [], []
    for column, kind, nullable in fields:
        form.append("%s" if nullable else forms[kind])
        printed = sa.case((column.is_(None), ""), else_=sa.func.printf(forms[kind], column))
        values.append(printed if nullable else column)
    return sa.func.printf(",".join(form), *values)


def _concatenated(fields: _Fields) -> sa.ColumnElement[str]:
    """The same by PostgreSQL, whose numbers as text have all their digits."""

    def value(column: sa.ColumnElement[Any], kind: str) -> sa.ColumnElement[str]:
        quoted = sa.literal('"').concat(sa.func.replace(column, '"', '""')).concat('"')
        text = quoted if kind in ("text", "string") else sa.cast(column, sa.Text)
        return sa.func.coalesce(text, "")

    return sa.func.concat_ws(",", *(value(column, kind) for column, kind, _ in fields))


def _table(text: str, kinds: Mapping[str, str]) -> pa.Table:
    import pyarrow as pa
    from pyarrow import csv

    types = {
        name: pa.dictionary(pa.int32(), pa.string()) if kind == "text" else pa.type_for_alias(kind)
        for name, kind in kinds.items()
    }
    return csv.read_csv(
        pa.BufferReader(text.encode()),
        csv.ReadOptions(column_names=list(kinds), use_threads=False),
        csv.ParseOptions(newlines_in_values=True),
        csv.ConvertOptions(
            column_types=types,
            null_values=[""],
            strings_can_be_null=True,
            quoted_strings_can_be_null=False,
        ),
    )

"""CSV that a spreadsheet takes as text: a cell that would be a formula there has ' before it."""

from __future__ import annotations

import re
from typing import Any

__all__ = ["NOTE", "as_given", "as_written", "columns_as_given", "defused", "plain"]

#: For the code book.
NOTE = (
    "In CSV a text that begins with =, +, -, @, a tab or a line end, or with ' before one of "
    "these, has one ' more before it, so that no spreadsheet takes it for a formula; nacreous "
    "scale takes it away again."
)

# Full-width signs too, which spreadsheets in East Asian locales take for the others.
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_BEGINS = "'*[=+\\-@\\t\\r\\n\uff1d\uff0b\uff0d\uff20]"


def defused(table: Any) -> Any:
    """An Arrow table with every text column as CSV holds it.

    >>> import pyarrow as pa
    >>> defused(pa.table({"left": ["=1+1", "'@x", "a-b"], "trial": [-1, 0, 1]})).to_pydict()
    {'left': ["'=1+1", "''@x", 'a-b'], 'trial': [-1, 0, 1]}
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    for place, field in enumerate(table.schema):
        if pa.types.is_string(field.type):
            text = pc.replace_substring_regex(table[place], f"\\A({_BEGINS})", "'\\1")
            table = table.set_column(place, field, text)
    return table


def as_written(text: str) -> str:
    """A text as CSV holds it; a number is none that a spreadsheet would take for a formula.

    >>> as_written("=1+1"), as_written("'@x"), as_written("a-b"), as_written("-1")
    ("'=1+1", "''@x", 'a-b', '-1')
    """
    if not re.match(_BEGINS, text) or _NUMBER.fullmatch(text):
        return text
    return f"'{text}"


def columns_as_given(columns: list[Any]) -> list[Any]:
    """Arrow columns of text of a CSV file as they were before.

    >>> import pyarrow as pa
    >>> columns_as_given([pa.array(["'=1+1", "a", None])])[0].to_pylist()
    ['=1+1', 'a', None]
    """
    import pyarrow.compute as pc

    return [
        pc.replace_substring_regex(column, f"\\A'({_BEGINS})", "\\1")
        if pc.any(pc.starts_with(column, "'")).as_py()
        else column
        for column in columns
    ]


def plain(table: Any) -> Any:
    """An Arrow table without dictionaries, which CSV has not."""
    import pyarrow as pa

    for place, field in enumerate(table.schema):
        if pa.types.is_dictionary(field.type):
            text = table[place].cast(field.type.value_type)
            table = table.set_column(place, field.name, text)
    return table


def as_given(text: str) -> str:
    """A cell of such a CSV file as it was before; every other text as it is.

    >>> as_given("'=1+1"), as_given("''@x"), as_given("'s a pearl")
    ('=1+1', "'@x", "'s a pearl")
    """
    return text[1:] if re.match(f"'{_BEGINS}", text) else text

"""The decimal mark of a table, by its numbers that can be read in one way alone."""

from __future__ import annotations

from typing import Any

from nacreous.scaling.data.number_text import (
    DecimalMark,
    has_decimal_commas,
    has_decimal_points,
)
from nacreous.scaling.data.table import Table


def decimal_mark_of(table: Table) -> DecimalMark:
    """What parts decimals in a table; None where either mark may.

    Numbers such as 812.5 or 23,5 in any column tell. Without them semicolons between cells stand
    for a comma, for that is why they do; commas between cells, and tables without text, for a
    point. Tabs and bars tell nothing.
    """
    texts = [text for text in map(_text, table.columns.values()) if text is not None]
    points, commas = any(map(has_decimal_points, texts)), any(map(has_decimal_commas, texts))
    if points:
        return None if commas else "."
    if table.separator == ";":
        return ","
    return None if commas or table.separator in ("\t", "|") else "."


def _text(column: Any) -> Any:
    """The different cells of a column of text; None of any other."""
    import pyarrow as pa

    if pa.types.is_dictionary(column.type):
        column = column.dictionary
    text = pa.types.is_string(column.type) or pa.types.is_large_string(column.type)
    return column.unique() if text else None

"""Quotation marks around the cells of a CSV file: in pairs, and doubled within a cell."""

from __future__ import annotations

import csv
import io
import re

from nacreous.problem import InputError
from nacreous.scaling.data.header import Header

#: A mark behind a backslash within a cell in quotes, with more of the cell behind it. At the end of
#: a cell the backslash may be that of a folder.
_ESCAPED = re.compile(rb'(?:^|[,;\t|])"[^"]*\\"[^",;\t|\r\n]', re.MULTILINE)


def check_quotes(place: str, content: bytes, header: Header) -> None:
    """Refuse a quotation mark that is not closed, which would swallow rows."""
    text = io.StringIO(content.decode("utf-8"), newline="")
    reader = csv.reader(text, delimiter=header.separator, strict=True)
    row = header.rows
    try:
        for _ in reader:
            row += 1
    except csv.Error as problem:
        raise InputError(
            f"{place}: row {row + 1}: a quotation mark is not closed, or text follows it; "
            "allowed: quotation marks in pairs around a cell"
        ) from problem


def check_escapes(place: str, content: bytes) -> None:
    """Refuse quotation marks behind backslashes, of which a CSV reader makes other labels."""
    found = _ESCAPED.search(content) if b'\\"' in content else None
    if found:
        line = content[: found.end()].count(b"\n") + 1
        raise InputError(
            f"{place}: line {line}: a quotation mark stands behind a backslash; allowed: a doubled "
            'one within a cell, as in "a ""big"" pearl"'
        )


def has_corner_left_out(content: bytes, separator: str, names: list[str]) -> bool:
    """Whether rows have one cell more than the line of labels, in front, as R writes a matrix."""
    lines = io.StringIO(content[: 2**20].decode("utf-8", errors="ignore"), newline="")
    rows = [row for row in csv.reader(lines, delimiter=separator) if any(row)][:3]
    return len(rows) > 1 and {len(row) for row in rows[1:]} == {len(names) + 1}

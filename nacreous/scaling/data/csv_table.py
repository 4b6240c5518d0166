"""CSV files as columns of text: commas, semicolons or tabs, in UTF-8.

All cells stay text, so that the label "01" is not the label "1".
"""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling.data.fault import Faults

_BOMS = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}


class _Ragged(NamedTuple):
    row: int
    cells: int


def parse_csv(place: str, content: bytes, header: bool = True) -> list[tuple[str, Any]]:
    """The columns of a CSV file with their names from its first line ("f0", ... without one).

    The separator is whichever of comma, semicolon and tab the first line has most of. Blank lines
    are left out.
    """
    import pyarrow as pa

    check_text(place, content)
    content = content.lstrip(b"\r\n")
    first = re.split(rb"[\r\n]", content, maxsplit=1)[0]
    if not first.strip():
        raise InputError(f"{place}: is empty; allowed: a line of column names, then answers")
    separator = max((b",", b";", b"\t"), key=first.count).decode()
    names = _cells(first, separator)
    if header:
        _check_names(place, names)
    else:
        names = [f"f{index}" for index in range(len(names))]
    ragged: list[_Ragged] = []
    try:
        columns = _columns(content, names, separator, header, ragged)
    except pa.ArrowInvalid as problem:
        raise InputError(f"{place}: is no CSV file that can be read ({problem})") from problem
    _refuse(place, ragged, len(names))
    return list(zip(names, columns, strict=True))


def _columns(
    content: bytes, names: list[str], separator: str, header: bool, ragged: list[_Ragged]
) -> list[Any]:
    """The columns as text, empty cells null; rows of another length go to `ragged`."""
    import pyarrow as pa
    from pyarrow import csv

    def skip(row: Any) -> str:
        ragged.append(_Ragged(row.number or 0, row.actual_columns))
        return "skip"

    table = csv.read_csv(
        pa.BufferReader(content),
        # One thread: only so are the rows that do not fit numbered.
        read_options=csv.ReadOptions(use_threads=False, column_names=names, skip_rows=int(header)),
        parse_options=csv.ParseOptions(
            delimiter=separator, newlines_in_values=True, invalid_row_handler=skip
        ),
        convert_options=csv.ConvertOptions(
            column_types=dict.fromkeys(names, pa.large_string()),
            null_values=[""],
            strings_can_be_null=True,
            quoted_strings_can_be_null=True,
        ),
    )
    return list(table.columns)


def check_text(place: str, content: bytes) -> None:
    """Refuse what is no UTF-8 text, naming the line where that shows."""
    for mark, name in _BOMS.items():
        if content.startswith(mark):
            raise InputError(f"{place}: is {name} text; allowed: UTF-8 (save it as such)")
    if b"\0" in content[:65536]:
        raise InputError(f"{place}: is no text; allowed: CSV in UTF-8")
    try:
        content.decode("utf-8")
    except UnicodeDecodeError as problem:
        line = content.count(b"\n", 0, problem.start) + 1
        raise InputError(
            f"{place}: line {line} is not UTF-8 text; allowed: UTF-8 (save it as such)"
        ) from problem


def _cells(line: bytes, separator: str) -> list[str]:
    import csv as plain

    reader = plain.reader([line.decode("utf-8-sig")], delimiter=separator)
    return [cell.strip() for cell in next(reader)]


def _check_names(place: str, names: list[str]) -> None:
    for index, name in enumerate(names):
        if not name:
            raise InputError(f"{place}: column {index + 1} has no name; allowed: a name each")
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise InputError(f"{place}: has more than one column {twice[0]}; allowed: one of each")


def _refuse(place: str, ragged: list[_Ragged], wanted: int) -> None:
    faults = Faults(place)
    cells = {row.row: row.cells for row in ragged}
    rows = np.array(list(cells), np.int64)
    faults.say_of_rows(rows, lambda row: f"has {cells[row]} cells; allowed: {wanted}")
    faults.stop()

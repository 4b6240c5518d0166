"""Tables of answers from wherever they come: a file, a frame, or a dict of columns.

Arrow holds them, so that a million rows are never a million Python objects.
"""

from __future__ import annotations

import stat
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.file import named
from nacreous.missing import missing
from nacreous.number import said
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.comments import without_comments
from nacreous.scaling.data.csv_table import parse_csv
from nacreous.scaling.data.encoding import guessed_encoding, utf8_of
from nacreous.scaling.data.fault import Faults, listed
from nacreous.scaling.data.header import find_header, name_of
from nacreous.scaling.data.kind import plain_array, plain_values
from nacreous.scaling.data.packed import advice

#: The largest file that is opened: about 30 million answers.
MOST_BYTES = 2**30
#: The longest table that is taken.
MOST_ROWS = 100_000_000
ENDINGS = (".csv", ".tsv", ".txt", ".parquet")

_FRAMES = "a pandas, Polars or pyarrow table, a dict of columns, or a list of dicts, one a row"


@dataclass(frozen=True, eq=False)
class Table:
    """Named columns of equal length.

    `place` is the file's name, or "table"; `numbers`, int64 [row], are those by which messages call
    the rows: of a CSV file as spreadsheets count, its header being row 1, otherwise from 0. `texts`
    says of a column what Qualtrics writes below its name. `separator`: of the cells of a text file.
    `encoding_guessed`: of a file that does not say it.
    """

    place: str
    columns: Mapping[str, Any]
    numbers: NDArray[np.int64]
    texts: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    separator: str | None = None
    encoding_guessed: str | None = None

    @property
    def rows(self) -> int:
        """How many rows there are."""
        return len(self.numbers)

    def faults(self) -> Faults:
        """What is wrong with the table, to be collected."""
        return Faults(self.place, self.numbers)

    def take(self, kept: NDArray[np.bool_]) -> Table:
        """Some of the rows, bool [row]."""
        import pyarrow as pa

        mask = pa.array(kept)
        columns = {name: column.filter(mask) for name, column in self.columns.items()}
        return replace(self, columns=columns, numbers=self.numbers[kept])


def read_table(
    path: str | PathLike[str],
    wanted: Sequence[Collection[str]] = (),
    *,
    skip_rows: int = 0,
    encoding: str | None = None,
    rows: str = "answers",
    most_rows: int = MOST_ROWS,
) -> Table:
    """Read a text or .parquet file, or say in one line why that cannot be done.

    wanted, skip_rows, encoding: of a text file, as `parse_csv` takes them. rows: what messages call
    the rows, of which at most `most_rows` are taken.
    """
    file = named(path)
    place = printable(str(file))
    if file.suffix.lower() not in ENDINGS and not file.is_dir():
        if not file.suffix and not file.exists():
            raise missing(file, ", ".join(ENDINGS))
        given = printable(file.suffix) or "missing"
        allowed = f"{', '.join(ENDINGS)}{advice(file.suffix)}"
        raise InputError(f"{place}: the ending is {given}; allowed: {allowed}")
    content = read_bytes(file)
    if file.suffix.lower() == ".parquet":
        if skip_rows or encoding is not None:
            option = "skip_rows" if skip_rows else "encoding"
            raise InputError(f"{place}: {option} is given; allowed: with a text file")
        return _table(place, _parse_parquet(place, content), rows, most_rows)
    found = parse_csv(place, content, wanted, skip_rows=skip_rows, encoding=encoding)
    table = _table(place, list(found.columns), rows, most_rows)
    return replace(
        table,
        numbers=found.numbers,
        texts=found.texts,
        separator=found.separator,
        encoding_guessed=guessed_encoding(content) if encoding is None else None,
    )


def column_names(
    path: str | PathLike[str], wanted: Sequence[Collection[str]] = ()
) -> Sequence[str]:
    """The names of a table's columns; of what is none, nothing, for whoever reads it says why."""
    file = Path(path)
    ending = file.suffix.lower()
    try:
        if ending == ".parquet" and file.is_file():
            from pyarrow import parquet

            return list(parquet.read_schema(file).names)
        if ending in ENDINGS and file.is_file():
            content = utf8_of(str(file), read_bytes(file))
            content, comments = without_comments(str(file), content, wanted)
            return find_header(str(file), content, wanted, comments).names
    except (OSError, ValueError):
        pass
    return []


def read_bytes(file: Path) -> bytes:
    """The bytes of an ordinary file of at most `MOST_BYTES`."""
    place = printable(str(file))
    try:
        status = file.stat()
        if stat.S_ISDIR(status.st_mode):
            raise InputError(f"{place}: is a folder; a file is needed")
        if not stat.S_ISREG(status.st_mode):
            raise InputError(f"{place}: is no ordinary file")
        if status.st_size > MOST_BYTES:
            size = f"{status.st_size / 2**20:.0f} MiB"
            raise InputError(f"{place}: is {size} large; allowed: up to {MOST_BYTES >> 20} MiB")
        return file.read_bytes()
    except FileNotFoundError:
        raise missing(file) from None
    except (OSError, ValueError) as problem:
        if isinstance(problem, InputError):
            raise
        reason = problem.strerror if isinstance(problem, OSError) else problem
        raise InputError(f"{place}: cannot be read ({reason})") from problem


def is_table(data: object) -> bool:
    """Whether the data are a frame, a dict of columns, or rows, each a dict."""
    return isinstance(data, Mapping) or _is_frame(data) or _are_rows(data)


def table_of(data: object) -> Table:
    """The table in a frame of pandas, Polars or pyarrow, in a dict of columns, or in rows."""
    if isinstance(data, Mapping):
        return _table("table", list(data.items()))
    if isinstance(data, list | tuple) and _are_rows(data):
        return _table("table", _columns_of_rows(data))
    if not _is_frame(data):
        raise InputError(f"the table is {said(data)}; allowed: {_FRAMES}")
    frame: Any = data
    if hasattr(frame, "iloc"):  # pandas, whose columns may hold text and numbers mixed
        return _table("table", [(name, frame.iloc[:, i]) for i, name in enumerate(frame)])
    import pyarrow as pa

    if not isinstance(frame, pa.Table | pa.RecordBatch):
        frame = frame.to_arrow() if hasattr(frame, "to_arrow") else pa.table(frame)
    return _table("table", list(zip(frame.column_names, frame.columns, strict=True)))


def _is_frame(data: object) -> bool:
    return hasattr(data, "__arrow_c_stream__") and hasattr(data, "columns")  # a Series has none


def _are_rows(data: object) -> bool:
    return isinstance(data, list | tuple) and len(data) > 0 and isinstance(data[0], Mapping)


def _columns_of_rows(rows: Sequence[Any]) -> list[tuple[Any, Any]]:
    """The columns of rows as `csv.DictReader` gives them; a key that a row lacks is empty there."""
    for number, row in enumerate(rows):
        if not isinstance(row, Mapping):
            raise InputError(f"table: row {number} is {said(row)}; allowed: a dict, as row 0 is")
        if None in row:  # where csv.DictReader keeps what is beyond the header
            raise InputError(f"table: row {number} has more cells than columns; allowed: as many")
    names = dict.fromkeys(name for row in rows for name in row)
    return [(name, [row.get(name) for row in rows]) for name in names]


def _table(
    place: str,
    columns: list[tuple[Any, Any]],
    called: str = "answers",
    most_rows: int = MOST_ROWS,
) -> Table:
    names = [name_of(name) for name, _ in columns]
    _refuse_twice(place, names)
    arrays = {
        name: _array(place, name, values) for name, (_, values) in zip(names, columns, strict=True)
    }
    lengths = {name: len(array) for name, array in arrays.items()}
    if len(set(lengths.values())) > 1:
        both = ", ".join(f"{name} has {length}" for name, length in list(lengths.items())[:8])
        raise InputError(f"{place}: columns differ in length ({both}); allowed: equal lengths")
    rows = next(iter(lengths.values()), 0)
    if rows == 0:
        raise InputError(f"{place}: has no rows; allowed: 1 to {most_rows} {called}")
    if rows > most_rows:
        raise InputError(f"{place}: has {rows} rows; allowed: 1 to {most_rows} {called}")
    return Table(place, arrays, np.arange(rows))


def _refuse_twice(place: str, names: list[str]) -> None:
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise InputError(f"{place}: has more than one column {listed(twice)}; allowed: one of each")


def _array(place: str, name: str, values: Any) -> Any:
    """An Arrow array of a column, whatever held it."""
    import pyarrow as pa

    if isinstance(values, pa.ChunkedArray):
        return plain_array(values.combine_chunks())
    if isinstance(values, pa.Array):
        return plain_array(values)
    values = plain_values(values)
    lone = isinstance(values, str | bytes | Mapping) or not hasattr(values, "__iter__")
    if lone or (isinstance(values, np.ndarray) and values.ndim != 1):
        raise InputError(f"{place}: column {name} is {said(values)}; allowed: a list of values")
    values = values if hasattr(values, "__len__") else list(values)
    try:
        array = pa.array(values, from_pandas=True)
    except UnicodeEncodeError as problem:
        raise InputError(
            f"{place}: column {name} holds half a character; allowed: text"
        ) from problem
    except (pa.ArrowInvalid, pa.ArrowTypeError, pa.ArrowNotImplementedError, OverflowError):
        return pa.array([_mixed(place, name, row, cell) for row, cell in enumerate(values)])
    return plain_array(array.combine_chunks() if isinstance(array, pa.ChunkedArray) else array)


def _mixed(place: str, name: str, row: int, cell: Any) -> str | None:
    """A cell of a column that mixes kinds, such as the labels 1 and 2 with the word tie."""
    if cell is None or (isinstance(cell, float) and cell != cell):
        return None
    if isinstance(cell, str | int | np.integer):
        return str(cell)
    if isinstance(cell, float | np.floating) and float(cell).is_integer():
        return str(int(cell))
    raise InputError(f"{place}: row {row}: {name} is {said(cell)}; allowed: text or a whole number")


def _parse_parquet(place: str, content: bytes) -> list[tuple[str, Any]]:
    import pyarrow as pa
    from pyarrow import parquet

    try:
        names = parquet.read_schema(pa.BufferReader(content)).names
    except (pa.ArrowException, OSError, ValueError) as problem:
        raise InputError(f"{place}: is no whole Parquet file") from problem
    _refuse_twice(place, names)
    try:
        table = parquet.read_table(pa.BufferReader(content))
    except (pa.ArrowException, OSError, ValueError) as problem:
        raise InputError(f"{place}: is no whole Parquet file") from problem
    return list(zip(table.column_names, table.columns, strict=True))

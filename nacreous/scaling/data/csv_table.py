"""CSV files as columns of text: all cells stay text, for the label "01" is not the label "1"."""

from __future__ import annotations

import csv
import io
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nacreous.number import whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.comments import without_comments
from nacreous.scaling.data.encoding import utf8_of
from nacreous.scaling.data.fault import Faults, listed, quoted
from nacreous.scaling.data.header import Header, find_header, titles_above
from nacreous.scaling.data.names_line import (
    check_headless,
    check_label_twice,
    check_repeated_header,
)
from nacreous.scaling.data.quotation import check_escapes, check_quotes, has_corner_left_out
from nacreous.scaling.data.spreadsheet import as_given, columns_as_given

#: A row longer than this is read as one whose quotation mark is not closed.
_LONGEST_ROW = 2**26
#: What old programs write at the end of a file: Ctrl-Z, and a new page.
_ENDS = b"\x1a\x0c\r\n"


@dataclass(frozen=True, eq=False)
class CsvTable:
    """Columns of a CSV file by name, Arrow large_string with null for an empty cell.

    numbers: int64 [row], the number of each row as spreadsheets count. texts: by column, what
    Qualtrics says of it below its name. separator: of cells.
    """

    columns: list[tuple[str, Any]]
    numbers: NDArray[np.int64]
    texts: Mapping[str, str]
    separator: str


class _Misfit(NamedTuple):
    """A row of another length than the line of names."""

    row: int
    text: str
    cells: int


def parse_csv(
    place: str,
    content: bytes,
    wanted: Sequence[Collection[str]] = (),
    *,
    skip_rows: int = 0,
    encoding: str | None = None,
) -> CsvTable:
    """The columns of a CSV file with their names; rows that are empty in every cell are left out.

    wanted: sets of names of which the header has one (`find_header`). A column without a name is
    left out where it is empty or counts the rows, and is refused otherwise.
    """
    content = utf8_of(place, content, encoding).rstrip(_ENDS)
    check_escapes(place, content)
    skip_rows = whole_of("skip_rows", skip_rows, 0, 10_000)
    if not skip_rows:
        content, skip_rows = without_comments(place, content, wanted)
    header = find_header(place, content, wanted, skip_rows)
    columns, numbers = _body(place, content[header.begin :], header)
    kept = [at for at, name in enumerate(header.names) if name]
    for at, column in enumerate(columns):
        if at not in kept and not (header.row_names and at == 0 and _are_row_names(column)):
            _check_nameless(place, at, column, numbers, header.names)
    names = [as_given(header.names[at]) for at in kept]
    twice = sorted({name for name in names if names.count(name) > 1})
    if not twice:
        check_repeated_header(place, names, [columns[at] for at in kept], numbers)
    if wanted and not any({*map(str.casefold, names)} >= {*map(str.casefold, w)} for w in wanted):
        check_headless(place, header.rows, names, [columns[at] for at in kept])
        check_label_twice(place, header.rows, names, twice, {"chosen"}.union(*wanted))
    if twice:
        raise InputError(f"{place}: has more than one column {listed(twice)}; allowed: one of each")
    texts = dict(zip(map(as_given, header.names), header.texts, strict=False))
    found = [columns[at] for at in kept]
    return CsvTable(list(zip(names, found, strict=True)), numbers, texts, header.separator)


def parse_csv_cells(place: str, content: bytes) -> list[list[str]]:
    """The rows of a CSV file without a line of names, as text without space around it.

    Rows that are empty in every cell, and columns at the end that are, are left out.
    """
    content, _ = without_comments(place, utf8_of(place, content))
    titles, content = titles_above(content)
    header = find_header(place, content)
    below = content[header.top :]
    names = header.names[1:] if header.row_names else header.names
    if has_corner_left_out(below, header.separator, names):
        below = header.separator.encode() + below
        names = ["", *names]
    above = replace(header, rows=header.rows - 1, names=names)  # the first line is a row here
    columns, _ = _body(place, below, above)
    cells = [[(cell or "").strip() for cell in column.to_pylist()] for column in columns]
    while len(cells) > 1 and not any(cells[-1]):
        cells.pop()
    above_all = [[title] + [""] * (len(cells) - 1) for title in titles]
    return above_all + [list(row) for row in zip(*cells, strict=True)]


def _body(place: str, content: bytes, header: Header) -> tuple[list[Any], NDArray[np.int64]]:
    """Columns of text, empty cells null, and the rows' numbers."""
    import pyarrow as pa
    from pyarrow import csv as arrow

    misfits: list[_Misfit] = []

    def skip(row: Any) -> str:
        misfits.append(_Misfit(row.number or 0, row.text, row.actual_columns))
        return "skip"

    names = [str(at) for at in range(len(header.names))]
    if not content.strip(b"\r\n"):
        return [pa.array([], pa.large_string()) for _ in names], np.zeros(0, np.int64)
    try:
        table = arrow.read_csv(
            pa.BufferReader(content),
            # One thread: only so are the rows that do not fit numbered.
            read_options=arrow.ReadOptions(
                use_threads=False, column_names=names, block_size=_LONGEST_ROW
            ),
            parse_options=arrow.ParseOptions(
                delimiter=header.separator,
                newlines_in_values=True,
                ignore_empty_lines=False,
                invalid_row_handler=skip,
            ),
            convert_options=arrow.ConvertOptions(
                column_types=dict.fromkeys(names, pa.large_string()),
                null_values=[""],
                strings_can_be_null=True,
                quoted_strings_can_be_null=True,
            ),
        )
    except pa.ArrowException as problem:
        check_quotes(place, content, header)
        longest = f"a row is longer than {_LONGEST_ROW >> 20} MiB"
        raise InputError(f"{place}: {longest}; allowed: shorter ones") from problem
    columns = [column.combine_chunks() for column in table.columns]
    if _runs_over_lines(columns) or any("\n" in misfit.text for misfit in misfits):
        check_quotes(place, content, header)
    return _with_misfits(place, columns, misfits, header)


def _with_misfits(
    place: str, columns: list[Any], misfits: list[_Misfit], header: Header
) -> tuple[list[Any], NDArray[np.int64]]:
    """The rows in their order, those that only lack or add empty cells at the end among them."""
    import pyarrow as pa

    width = len(header.names)
    named = max((at + 1 for at, name in enumerate(header.names) if name), default=width)
    fitted: list[list[str]] = []
    faults = Faults(place)
    for misfit in misfits:
        cells = _cells(misfit, header.separator)
        kept = cells[:width] + [""] * (width - len(cells))
        short = len(cells) < named and any(cells)
        if short or any(cell.strip() for cell in cells[width:]):
            number = misfit.row + header.rows
            faults.say_of_rows(
                np.array([number]),
                lambda _, cells=cells: _misfit_said(cells, named),  # type: ignore[misc]
            )
        fitted.append(kept)
    if faults and named == 1:
        raise InputError(
            f"{place}: row {header.rows} has a single cell and rows below have more; allowed: the "
            "names of columns there, or skip rows above the names by skip_rows=N"
        )
    faults.stop()
    total = len(columns[0]) + len(misfits)
    own = np.array([misfit.row - 1 for misfit in misfits], np.int64)
    numbers = np.arange(total) + header.rows + 1
    if fitted:
        order = np.argsort(np.append(np.delete(np.arange(total), own), own), kind="stable")
        added = [
            pa.array([cell or None for cell in column], pa.large_string())
            for column in zip(*fitted, strict=True)
        ]
        columns = [
            pa.concat_arrays([column, more]).take(pa.array(order))
            for column, more in zip(columns, added, strict=True)
        ]
    filled = ~_blank(columns)
    if not filled.all():
        columns = [column.filter(pa.array(filled)) for column in columns]
    return columns_as_given(columns), numbers[filled]


def _misfit_said(cells: list[str], allowed: int) -> str:
    if len(cells) == 1:
        return f"has 1 cell, {quoted(cells[0])}; allowed: {allowed} (remove what is no answer)"
    return f"has {len(cells)} cells; allowed: {allowed}"


def _cells(misfit: _Misfit, separator: str) -> list[str]:
    try:
        return next(csv.reader(io.StringIO(misfit.text, newline=""), delimiter=separator), [])
    except csv.Error:  # a cell beyond 131072 characters, which is not looked into
        return [misfit.text] * misfit.cells


def _blank(columns: list[Any]) -> NDArray[np.bool_]:
    """For each row whether nothing stands in any cell."""
    import pyarrow.compute as pc

    rows = np.arange(len(columns[0]))
    for column in columns:
        text = pc.fill_null(pc.utf8_trim_whitespace(column.take(rows)), "")
        rows = rows[np.asarray(pc.equal(text, ""))]
    blank = np.zeros(len(columns[0]), bool)
    blank[rows] = True
    return blank


def _runs_over_lines(columns: list[Any]) -> bool:
    import pyarrow.compute as pc

    return any(
        pc.any(pc.match_substring(column, mark)).as_py() for column in columns for mark in "\n\r"
    )


def _check_nameless(
    place: str, at: int, column: Any, numbers: NDArray[np.int64], names: list[str]
) -> None:
    """Refuse a column without a name, unless it is empty or counts the rows as pandas does."""
    import pyarrow.compute as pc

    text = np.asarray(pc.fill_null(pc.utf8_trim_whitespace(column), ""), dtype=object)
    filled = np.flatnonzero(text != "")
    if len(filled) == 0:
        return
    if at == 0 and text[0] in ("0", "1"):
        counted = (np.arange(len(text)) + int(text[0])).astype(str)
        if np.array_equal(text, counted.astype(object)):
            return
    if at == 0 and text.tolist() == names[1:]:
        raise InputError(
            f"{place}: rows and columns have the same names ({listed(names[1:])}), as in a square "
            "of counts; allowed: answers, or read this by Comparisons.read_counts"
        )
    row = int(filled[0])
    raise InputError(
        f"{place}: column {at + 1} has no name, and row {numbers[row]} holds {quoted(text[row])} "
        "there; allowed: a name each"
    )


def _are_row_names(column: Any) -> bool:
    """Whether a first column numbers the rows, each its own, in any order."""
    import pyarrow.compute as pc

    numbers = pc.all(pc.match_substring_regex(column, "^[0-9]+$")).as_py()
    return bool(numbers) and column.null_count == 0 and len(column.unique()) == len(column)

"""Where a CSV file's column names stand, and what separates its cells."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from unicodedata import normalize

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.pair_name import pairs_in
from nacreous.scaling.data.second_line import has_second_line, joined_names

SEPARATORS = {",": "commas", ";": "semicolons", "\t": "tabs", "|": "bars"}
#: How far down column names are looked for, below rows that are skipped, and how much of a file
#: is looked at for them.
_MOST_ROWS = 25
_MOST_BYTES = 2**20


@dataclass(frozen=True)
class Header:
    """The first lines of a file.

    separator: of cells. names: of columns, "" where a column has none. rows: how many rows of the
    file stand above the first row of data. top, begin: the bytes at which the line of names and the
    first row of data begin. texts: what Qualtrics says of each column below its name. row_names:
    R's names of rows stand in front of each, and have no name of their own.
    """

    separator: str
    names: list[str]
    rows: int
    top: int
    begin: int
    texts: list[str]
    row_names: bool = False


@dataclass(frozen=True)
class _Row:
    """A row of the file as it is parsed: its cells, and how many bytes there are to its end."""

    cells: list[str]
    end: int

    @property
    def filled(self) -> int:
        return sum(bool(cell) for cell in self.cells)


def find_header(
    place: str, content: bytes, wanted: Sequence[Collection[str]] = (), skip_rows: int = 0
) -> Header:
    """The header of a file in UTF-8.

    wanted: sets of names, one of which a line of column names has. Above it only titles may stand,
    which fill one cell; anything else has to be skipped by skip_rows. Without such a line the first
    of several cells has the names, with as many below it, or else the first that is not blank.
    """
    text = content[:_MOST_BYTES].decode("utf-8", errors="ignore")
    said, after_said = _said_separator(text, skip_rows)
    said = said or _quoted_blanks(text, skip_rows)
    found = {mark: _rows(place, text, mark, skip_rows) for mark in ([said] if said else SEPARATORS)}
    begin = skip_rows + after_said
    hits = [
        (mark, at)
        for mark, rows in found.items()
        if (at := _named_row(rows, begin, wanted)) is not None
    ]
    if len(hits) == 1:
        mark, at = hits[0]
        _check_titles(place, found[mark], begin, at)
    else:
        if not said:
            _check_spaces(place, text, begin, wanted)
        marks, at = _table_below_titles(found, begin)
        mark = said or _likely_separator(place, {each: found[each] for each in marks}, at)
        if at == len(found[mark]) or not found[mark][at].filled:
            below = f" below the first {skip_rows} rows" if skip_rows else ""
            allowed = "allowed: a line of column names, then answers"
            raise InputError(f"{place}: is empty{below}; {allowed}")
    header = _header(found[mark], mark, at)
    named = [name for name in header.names if name]
    if named and all(re.fullmatch("'[^']*'", name) for name in named):
        raise InputError(
            f"{place}: row {at + 1} has its names in single quotation marks; allowed: double ones, "
            "or none"
        )
    if any(re.search(r"[\n\r]", name) for name in header.names):
        line = content[header.top : found[mark][at].end].decode("utf-8")
        try:
            list(csv.reader(io.StringIO(line, newline=""), delimiter=mark, strict=True))
        except csv.Error as problem:
            raise _unclosed(place, at + 1) from problem
    return header


def titles_above(content: bytes) -> tuple[list[str], bytes]:
    """Lines above the first that has several cells, blank ones left out, and what is below them."""
    lines = content.splitlines(keepends=True)
    marks = [*map(str.encode, SEPARATORS), b'" "']
    begin = next((at for at, line in enumerate(lines) if any(mark in line for mark in marks)), 0)
    titles = [line.decode().strip() for line in lines[:begin]]
    return [title for title in titles if title], b"".join(lines[begin:])


def _header(rows: list[_Row], mark: str, at: int) -> Header:
    names = rows[at].cells
    texts: list[str] = []
    last = at
    if at + 2 < len(rows) and _has_import_ids(rows[at + 2]):
        texts, last = rows[at + 1].cells, at + 2
    elif at + 1 < len(rows) and has_second_line(names, rows[at + 1].cells):
        names, last = joined_names(names, rows[at + 1].cells), at + 1
    top = rows[at - 1].end if at else 0
    row_names = _has_row_names(names, [row for row in rows[last + 1 :] if row.filled])
    names = [*[""] * row_names, *names]
    return Header(mark, names, last + 1, top, rows[last].end, texts, row_names)


def _has_import_ids(row: _Row) -> bool:
    return row.filled > 0 and all('"ImportId"' in cell for cell in row.cells if cell)


def _has_row_names(names: list[str], rows: list[_Row]) -> bool:
    """Whether each row has one cell more than the names, in front, as R's write.table writes it."""
    if not rows or not names[-1] or {len(row.cells) for row in rows} != {len(names) + 1}:
        return False
    first = [row.cells[0] for row in rows]
    numbered = all(cell.isdecimal() for cell in first) and len(set(first)) == len(first)
    return numbered and any(row.cells[-1] for row in rows)


def _quoted_blanks(text: str, skip_rows: int) -> str | None:
    """A blank where the first line is names in quotes that blanks part, as R writes them."""
    lines = (line.strip() for line in text.splitlines()[skip_rows:][:_MOST_ROWS])
    first = next(filter(None, lines), "")
    return " " if re.fullmatch(r'"[^"]*"(?: "[^"]*")+', first) else None


def _said_separator(text: str, skip_rows: int) -> tuple[str | None, int]:
    """The separator that a first line such as sep=; names, and how many rows end with it."""
    lines = io.StringIO(text, newline="").readlines()[skip_rows:]
    for number, line in enumerate(lines, 1):
        said = re.fullmatch(r'\ufeff?"?sep=(.)"?[,;\t]*', line.strip("\r\n "), re.IGNORECASE)
        if said:
            return said[1], number
        if line.strip("\r\n "):
            break
    return None, 0


def _rows(place: str, text: str, mark: str, skip_rows: int) -> list[_Row]:
    """The first rows and those that are skipped, blank ones too, for spreadsheets count them."""
    lines = io.StringIO(text, newline="").readlines()
    reader = csv.reader(lines, delimiter=mark)
    rows: list[_Row] = []
    end, read = 0, 0
    try:
        for cells in reader:
            end += sum(len(line.encode()) for line in lines[read : reader.line_num])
            read = reader.line_num
            rows.append(_Row([name_of(cell) for cell in cells], end))
            if len(rows) > skip_rows + _MOST_ROWS:
                break
    except csv.Error as problem:  # a cell beyond 131072 characters
        if not rows:
            raise _unclosed(place, 1) from problem
    return rows


def _unclosed(place: str, row: int) -> InputError:
    return InputError(
        f"{place}: row {row}: a quotation mark is not closed; allowed: quotation marks in pairs "
        "around a cell"
    )


def name_of(cell: object) -> str:
    """A column's name without space around it, in Unicode's form NFC."""
    return normalize("NFC", str(cell).strip().strip("\ufeff").strip())


def _named_row(rows: list[_Row], begin: int, wanted: Sequence[Collection[str]]) -> int | None:
    """The first row with such names, or with names of pairs: below these, left is an answer.

    Qualtrics says in the third row that the first has the names; SurveyMonkey has two rows of them.
    """
    for at, row in enumerate(rows[begin + 2 :], begin):
        if _has_import_ids(row) or has_second_line(rows[at].cells, rows[at + 1].cells):
            return at
    pairs: int | None = None
    for at, row in enumerate(rows[begin:], begin):
        names = {cell.casefold() for cell in row.cells}
        if any({name.casefold() for name in each} <= names for each in wanted):
            return at if pairs is None else pairs
        if pairs is None and row.filled > 1 and any(map(pairs_in, row.cells)):
            pairs = at
    return None


def _check_spaces(place: str, text: str, begin: int, wanted: Sequence[Collection[str]]) -> None:
    """Refuse names parted by spaces alone, which labels hold too."""
    lines = text.splitlines()[begin:][:_MOST_ROWS]
    words = [set(line.casefold().split(" ")) for line in lines]
    named = any({name.casefold() for name in each} <= names for names in words for each in wanted)
    if named or _are_parted_by_spaces([line for line in lines if line.strip()]):
        raise InputError(
            f"{place}: cells are separated by spaces; allowed: commas, semicolons, tabs or bars"
        )


def _are_parted_by_spaces(lines: list[str]) -> bool:
    """Whether all lines, those below a title at least, have as many words and no separator.

    Below names without one it may be a mark of decimals.
    """
    for rows, without_marks in ((lines, lines[:1]), (lines[1:], lines[1:])):
        sizes = {len(row.split()) for row in rows}
        marked = any(mark in line for line in without_marks for mark in SEPARATORS)
        if len(rows) > 1 and len(sizes) == 1 and min(sizes) > 2 and not marked:
            return True
    return False


def _check_titles(place: str, rows: list[_Row], begin: int, at: int) -> None:
    for row in range(begin, at):
        if rows[row].filled > 1:
            raise InputError(
                f"{place}: row {at + 1} holds the names of columns, and row {row + 1} above it "
                f"more than a title; allowed: names first, or skip_rows={at}"
            )


def _table_below_titles(found: dict[str, list[_Row]], begin: int) -> tuple[list[str], int]:
    """The first row of several cells that the next one has as many of, and by which separators.

    Above it stand titles. Without such a row, the first that is not blank, by any of them.
    """
    tables: dict[str, int] = {}
    for mark, rows in found.items():
        filled = [at for at, row in enumerate(rows) if at >= begin and row.filled]
        wide = [i for i, at in enumerate(filled) if rows[at].filled > 1][:1]
        for names, below in ((filled[i], filled[i + 1]) for i in wide if i + 1 < len(filled)):
            if len(rows[below].cells) - len(rows[names].cells) in (0, 1):  # R names each row
                tables[mark] = names
    if tables:
        first = min(tables.values())
        return [mark for mark, at in tables.items() if at == first], first
    firsts = [
        next((i for i, row in enumerate(rows) if i >= begin and row.filled), len(rows))
        for rows in found.values()
    ]
    return list(found), min(firsts)


def _likely_separator(place: str, found: dict[str, list[_Row]], begin: int) -> str:
    """What parts the first filled row into most cells."""
    sizes = {
        mark: next((len(row.cells) for row in rows[begin:] if row.filled), 0)
        for mark, rows in found.items()
    }
    most = max(sizes.values())
    likely = [mark for mark, size in sizes.items() if size == most]
    if most > 1 and len(likely) > 1:
        kinds = " or ".join(SEPARATORS[mark] for mark in likely)
        cell = next(row.cells[0] for row in found[likely[0]][begin:] if row.filled)
        raise InputError(
            f"{place}: cells may be separated by {kinds} in the line that begins with "
            f"{quoted(cell)}; allowed: one kind, or a first line sep={likely[0]}"
        )
    return likely[0]

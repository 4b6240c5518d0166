"""Lines above a table that begin with #: comments, of which PCIbex's name the columns."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Collection, Sequence

from nacreous.problem import InputError

#: A blank line, or one that begins with #, which a spreadsheet may have put in quotes. Alone in
#: the first of several cells # is the name of a column.
_LINE = re.compile(
    rb'[ \t]*(?P<comment>"?#(?!"?[,;\t|]+[^,;\t|\r\n])[^\r\n]*)?(?P<end>\r\n|\r|\n|\Z)'
)
_BELOW = re.compile(rb"(?:\A|[\r\n])#")
#: How PCIbex begins its list of columns, and how it names each: `# 3. Left.`
_LIST = re.compile(r"#\s*columns below this comment", re.IGNORECASE)
_ENTRY = re.compile(r"#\s*([0-9]+)\.\s*(\S.*?)\.?[\s,]*")
_MARKS = ",;\t|"


def without_comments(
    place: str, content: bytes, wanted: Sequence[Collection[str]] = ()
) -> tuple[bytes, int]:
    """A file in UTF-8 with blanks for the comments above its table, and how many lines those are.

    wanted: sets of names, one of which a line of column names has. A last comment with such names,
    or with as many cells as the line below it, is a line of names, without its #. So is PCIbex's
    list of columns.
    """
    lines, end = _above(content)
    if not any(lines):
        return content, 0
    below = re.split(r"[\r\n]", content[end : end + 2**16].decode("utf-8", errors="replace"))[0]
    names = _names_in(lines[-1], below, wanted)
    if names is None and not _has(below, wanted):
        names = _listed_names(place, lines, below, content[end:])
    blank = len(lines) - (names is not None)
    top = b"\n" * blank + (b"" if names is None else f"{names}\n".encode())
    return top + content[end:], blank


def _above(content: bytes) -> tuple[list[str], int]:
    """The comments above a table, "" for a blank line, and the byte at which the table begins."""
    lines: list[str] = []
    end = len(b"\xef\xbb\xbf") if content.startswith(b"\xef\xbb\xbf") else 0
    while (found := _LINE.match(content, end)) and found.end() > end:
        lines.append((found["comment"] or b"").decode("utf-8", errors="replace").strip('" \t'))
        end = found.end()
    return lines, end


def _names_in(line: str, below: str, wanted: Sequence[Collection[str]]) -> str | None:
    """The names of columns in a comment just above a table, if it has them and not the table."""
    names = line.lstrip("# \t")
    if _has(names, wanted):
        return names
    sizes = [(len(_cells(names, mark)), len(_cells(below, mark))) for mark in _MARKS]
    alike = any(size == size_below > 2 for size, size_below in sizes)
    return names if alike and not _has(below, wanted) else None


def _has(line: str, wanted: Sequence[Collection[str]]) -> bool:
    """Whether a line has the names of one of these sets, however they are parted."""
    for mark in _MARKS:
        cells = {cell.strip().casefold() for cell in _cells(line, mark)}
        if any({name.casefold() for name in each} <= cells for each in wanted):
            return True
    return False


def _cells(line: str, mark: str) -> list[str]:
    try:
        return next(csv.reader([line], delimiter=mark), [])
    except csv.Error:  # a cell beyond 131072 characters
        return [line]


def _listed_names(place: str, lines: Sequence[str], below: str, table: bytes) -> str | None:
    """The line of names of which PCIbex has a list, which it may begin anew further down."""
    begin = [at for at, line in enumerate(lines) if _LIST.match(line)]
    if not begin:
        return None
    entries = [found for line in lines[begin[-1] + 1 :] if (found := _ENTRY.fullmatch(line))]
    names = [entry[2] for entry in entries]
    again = _BELOW.search(table)
    if again:
        row = len(lines) + len(re.findall(rb"\r\n|\r|\n", table[: again.end()])) + 1
        raise InputError(
            f"{place}: row {row} is a comment below answers, where PCIbex's other columns begin; "
            "allowed: one list of columns, and the rows below it (remove the others)"
        )
    cells = len(_cells(below, ","))
    if [int(entry[1]) for entry in entries] != [*range(1, cells + 1)]:
        raise InputError(
            f"{place}: comments name {len(names)} columns, and row {len(lines) + 1} has {cells} "
            "cells; allowed: a line of column names above the answers, such as left,right,chosen"
        )
    text = io.StringIO()
    csv.writer(text, lineterminator="").writerow(names)
    return text.getvalue()

"""One column of a table as text, as numbers or as times, with its faults by row."""

from __future__ import annotations

import re
from collections.abc import Iterable
from datetime import datetime
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.deprecation import keep_former_names
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.fault import Faults, quoted
from nacreous.scaling.data.hidden import MAYBE_HIDDEN, hidden_in
from nacreous.scaling.data.label import LONGEST_LABEL, natural
from nacreous.scaling.data.table import Table
from nacreous.value import value_class

#: What programs write into a cell that holds nothing, in small letters.
NOTHING = frozenset({"null", "none", "nan", "na", "n/a", "undefined"})


@value_class
class Grouping:
    """A column that sorts answers into groups, such as `sex` or `cohort`.

    `levels` are its values in natural order; `code` is int64 [answer], an index into them, or -1
    where the cell is empty.
    """

    levels: tuple[str, ...]
    code: NDArray[np.int64]


def text_column(table: Table, name: str) -> Any:
    """Arrow large_string [row]: cells in NFC, without space around them; empty ones are null.

    Whole numbers are written without a point, for pandas turns 1 into 1.0 beside an empty cell.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    array = table.columns[name]
    if pa.types.is_dictionary(array.type):
        array = array.dictionary_decode()
    if pa.types.is_floating(array.type):
        array = _whole_where_possible(array)
    try:
        text = pc.utf8_trim_whitespace(pc.cast(array, pa.large_string()))
    except (pa.ArrowInvalid, pa.ArrowNotImplementedError) as problem:
        kind = f"column {name} holds values of the kind {array.type}"
        raise InputError(f"{table.place}: {kind}; allowed: text or whole numbers") from problem
    if not pc.all(pc.string_is_ascii(text)).as_py():
        text = pc.utf8_normalize(text, form="NFC")
    return pc.if_else(pc.equal(text, ""), pa.scalar(None, pa.large_string()), text)


def check_labels(table: Table, name: str, text: Any, faults: Faults) -> None:
    """Note empty cells, and labels that nobody could want."""
    import pyarrow.compute as pc

    empty = np.flatnonzero(np.asarray(text.is_null()))
    faults.say_of_rows(empty, lambda _: f"{name} is empty; allowed: a label")
    length = np.asarray(pc.fill_null(pc.utf8_length(text), 0))
    faults.say_of_rows(
        np.flatnonzero(length > LONGEST_LABEL),
        lambda row: f"{name} is {length[row]} characters long; allowed: 1 to {LONGEST_LABEL}",
    )
    hidden = [row for row in _maybe_hidden(text) if hidden_in(text[row].as_py())]
    faults.say_of_rows(
        np.array(hidden, np.int64),
        lambda row: f"{name} is {quoted(text[row])}; allowed: no {hidden_in(str(text[row]))} in it",
    )


def refuse_nothing(
    name: str, text: Any, faults: Faults, labels: Iterable[str] = frozenset()
) -> None:
    """Note the words that programs write into an empty cell, unless they are among the labels."""
    import pyarrow as pa
    import pyarrow.compute as pc

    word = pc.is_in(pc.utf8_lower(text), pa.array(sorted(NOTHING), text.type))
    word = pc.and_not(word, pc.is_in(text, pa.array(sorted(labels), text.type)))
    faults.say_of_rows(
        np.flatnonzero(np.asarray(pc.fill_null(word, False))),
        lambda row: (
            f"{name} is {quoted(text[row])}, as programs write an empty cell; allowed: a label"
        ),
    )


def _maybe_hidden(text: Any) -> list[int]:
    """Rows with a character that cannot be seen."""
    import pyarrow.compute as pc

    found = pc.fill_null(pc.match_substring_regex(text, MAYBE_HIDDEN), False)
    return np.flatnonzero(np.asarray(found)).tolist()


def codes_of(text: Any) -> tuple[tuple[str, ...], NDArray[np.int64]]:
    """The values of a text column in natural order, and for each row the index of its value.

    Empty cells have the index -1.
    """
    import pyarrow.compute as pc

    encoded = text.dictionary_encode()
    found = encoded.dictionary.to_pylist()
    # Beyond, they are numbers of sessions or the like, and nobody reads them in order.
    levels = natural(found) if len(found) <= 20_000 else sorted(found)
    place = {label: index for index, label in enumerate(levels)}
    order = np.array([place[label] for label in found] + [-1], np.int64)
    rows = np.asarray(pc.fill_null(encoded.indices, -1), dtype=np.int64)
    return tuple(levels), order[rows]


def group_column(table: Table, name: str) -> Grouping:
    r"""Any column as a group. Lines become spaces, and control characters \\u and their number."""
    import pyarrow as pa

    text = text_column(table, name)
    rows = _maybe_hidden(text)
    if rows:
        cells = text.to_pylist()
        for row in rows:
            cells[row] = printable(" ".join(cells[row].split()))
        text = pa.array(cells, pa.large_string())
    return Grouping(*codes_of(text))


def number_column(
    table: Table, name: str, role: str | None, faults: Faults, least: float
) -> NDArray[np.float64]:
    """float64 [row], finite and `least` or more; anything else is noted as a fault.

    Empty cells are NaN: that the time of one answer is unknown spoils no other. So are the words
    for nothing (`NOTHING`), and -1 where numbers are at least 0, which says that nobody answered.
    A list of one number, as PsychoPy writes it, is that number. A decimal comma is read where it
    cannot be one between thousands. role: of a column that may be left unused, or None.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    text = pc.replace_substring_regex(
        text_column(table, name), r"^\[\s*['\"]?([^,\[\]'\"]*)['\"]?\s*\]$", r"\1"
    )
    nothing = pc.is_in(pc.utf8_lower(text), pa.array([*sorted(NOTHING), ""], text.type))
    if least == 0:
        nothing = pc.or_(
            nothing, pc.fill_null(pc.match_substring_regex(text, r"^-1(\.0*)?$"), False)
        )
    text = pc.if_else(nothing, pa.scalar(None, text.type), text)
    number = r"^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$"
    pointed = _pointed(table, text)
    good = pc.fill_null(pc.match_substring_regex(pointed, number), True)
    value = pc.cast(pc.if_else(good, pointed, pa.scalar(None, text.type)), pa.float64())
    values = np.asarray(pc.fill_null(value, np.nan)).copy()
    bad = ~np.asarray(good) | np.isinf(values) | (values < least)
    allowed = "a number" if least == -np.inf else f"a number of at least {least:g}"
    if role in ("time", "trial"):
        allowed += " or a time in ISO 8601, such as 2026-03-01T09:30"
    say = faults.say_of_column if role else faults.say_of_rows
    unused = f", or {_unused(role)}" if role else ""
    say(
        np.flatnonzero(bad),
        lambda row: (
            f"{name} is {quoted(text[row])}; allowed: {allowed}{_comma_hint(text[row])}{unused}"
        ),
    )
    return values


def _pointed(table: Table, text: Any) -> Any:
    """Decimal commas as points, where the column's commas can be nothing else.

    1,250 may be a thousand and a quarter of one; 0,834 and 1,25 may not. Beside a decimal point a
    comma is none.
    """
    import pyarrow.compute as pc

    def some(pattern: str) -> bool:
        return bool(pc.any(pc.match_substring_regex(text, pattern)).as_py())

    comma = r"^[+-]?[0-9]+,[0-9]+$"
    sure = table.decimal_comma or some(r"^[+-]?(0[0-9]*|[0-9]{4,}),[0-9]+$")
    sure = sure or some(r"^[+-]?[0-9]+,([0-9]{1,2}|[0-9]{4,})$")
    if not some(comma) or not sure or some(r"\."):
        return text
    return pc.replace_substring_regex(text, r"^([+-]?[0-9]+),([0-9]+)$", r"\1.\2")


def _unused(role: str) -> str:
    """How a column that may be missing is left unused."""
    return f"{role}='' to leave the column unused"


def _comma_hint(cell: object) -> str:
    return " with a decimal point" if re.fullmatch(r"[^\[]*,.*", str(cell)) else ""


def time_column(table: Table, name: str, role: str, faults: Faults) -> NDArray[np.float64]:
    """float64 [row]: numbers as they are, dates and times as seconds since 1970, empty as NaN.

    Text is read as a number or as ISO 8601, such as 2026-03-01T09:30:00+09:00. Times without an
    offset are taken as they stand; they may not be mixed with those of another offset than 0.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    array = table.columns[name]
    if not pa.types.is_temporal(array.type):
        text = text_column(table, name)
        dated = pc.fill_null(pc.match_substring_regex(text, r"^[0-9]{4}-[0-9]{2}-[0-9]{2}"), False)
        if not pc.any(dated).as_py():
            return number_column(table, name, role, faults, -np.inf)
        return _instants(text, name, role, faults)
    try:
        instant = pc.cast(array, pa.timestamp("us"), safe=False)
    except (pa.ArrowInvalid, pa.ArrowNotImplementedError):  # a time of day
        faults.say(f"column {name} is of the kind {array.type}; allowed: numbers or ISO 8601")
        return np.full(table.rows, np.nan)
    seconds = np.asarray(pc.fill_null(pc.cast(instant, pa.int64()), 0)) / 1e6
    return np.where(np.asarray(array.is_null()), np.nan, seconds)


def _instants(text: Any, name: str, role: str, faults: Faults) -> NDArray[np.float64]:
    """Seconds since 1970 of times in ISO 8601."""
    cells = text.dictionary_encode()
    seconds = np.full(len(cells.dictionary) + 1, np.nan)
    bare = shifted = False
    bad: list[int] = []
    for at, cell in enumerate(cells.dictionary.to_pylist()):
        if cell.lower() in NOTHING:
            continue
        try:
            instant = datetime.fromisoformat(cell)
        except ValueError:
            bad.append(at)
            continue
        offset = instant.utcoffset()
        bare, shifted = bare or offset is None, shifted or bool(offset)
        seconds[at] = (instant.replace(tzinfo=None) - datetime(1970, 1, 1)).total_seconds()
        seconds[at] -= offset.total_seconds() if offset else 0.0
    code = np.asarray(cells.indices.fill_null(len(seconds) - 1), dtype=np.int64)
    faults.say_of_column(
        np.flatnonzero(np.isin(code, bad)),
        lambda row: (
            f"{name} is {quoted(text[row])}; allowed: a time in ISO 8601, such as "
            f"2026-03-01T09:30, or {_unused(role)}"
        ),
    )
    if bare and shifted:
        faults.say(
            f"column {name} has times with an offset and without; allowed: all or none, or "
            f"{_unused(role)}"
        )
    return seconds[code]


def _whole_where_possible(array: Any) -> Any:
    import pyarrow as pa
    import pyarrow.compute as pc

    array = pc.if_else(pc.is_nan(array), pa.scalar(None, array.type), array)
    values = np.asarray(pc.fill_null(pc.cast(array, pa.float64()), 0.0))
    if np.all((np.abs(values) < 2**53) & (values == np.rint(values))):
        return pc.cast(array, pa.int64())
    return array


keep_former_names(__name__, {"Group": "Grouping"}, "nacreous.scaling")

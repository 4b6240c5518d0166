"""One column of a table as text, as numbers or as times, with its faults by row."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.deprecation import keep_former_names
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.decimal_mark import decimal_mark_of
from nacreous.scaling.data.fault import Faults, quoted
from nacreous.scaling.data.hidden import MAYBE_HIDDEN, hidden_in
from nacreous.scaling.data.kind import kind_said
from nacreous.scaling.data.label import LONGEST_LABEL, natural
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.number_text import DecimalMark, numbers_of
from nacreous.scaling.data.table import Table
from nacreous.value import value_class


@value_class
class Grouping:
    """A column that sorts answers into groups, such as `sex` or `cohort`.

    `levels` are its values in natural order; `code` is int64 [answer], an index into them, or -1
    where the cell is empty. `nothing`: words that were read as an empty cell, such as NA.
    `decimal_mark`: of the table, "," or "."; None where either may be it, as where 1.250 stands
    between tabs.
    """

    levels: tuple[str, ...]
    code: NDArray[np.int64]
    nothing: tuple[str, ...] = ()
    decimal_mark: DecimalMark = "."

    def numbers(self, levels: Iterable[int]) -> NDArray[np.float64] | None:
        """float64, these levels as numbers; None where any of them is none.

        >>> Grouping(("20,5", "31"), np.array([0, 1])).numbers([0, 1])
        array([20.5, 31. ])
        """
        return numbers_of([self.levels[level] for level in levels], self.decimal_mark)


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
        raise _of_kind(table, name, array.type) from problem
    bytes_ = pa.types.is_binary(array.type) or pa.types.is_large_binary(array.type)
    bytes_ = bytes_ or pa.types.is_fixed_size_binary(array.type)
    if bytes_ and pc.any(pc.match_substring(text, "\0")).as_py():
        raise _of_kind(table, name, array.type)
    if not pc.all(pc.string_is_ascii(text)).as_py():
        text = pc.utf8_normalize(text, form="NFC")
    return pc.if_else(pc.equal(text, ""), pa.scalar(None, pa.large_string()), text)


def _of_kind(table: Table, name: str, kind: Any) -> InputError:
    held = f"column {name} holds {kind_said(kind)}"
    return InputError(f"{table.place}: {held}; allowed: text or whole numbers")


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


def group_column(table: Table, name: str, *, declared: bool = False) -> Grouping:
    r"""Any column as a group. Lines become spaces, and control characters \\u and their number.

    Words for nothing are empty cells, but for `none` beside words, as of a dish without a sauce;
    where the values are `declared`, as a study's are, each word is one of them.
    """
    import pyarrow as pa

    text = text_column(table, name)
    mark = _mark(table, name, text)
    text, words = (text, ()) if declared else _without_nothing(text, mark)
    rows = _maybe_hidden(text)
    if rows:
        cells = text.to_pylist()
        for row in rows:
            cells[row] = printable(" ".join(cells[row].split()))
        text = pa.array(cells, pa.large_string())
    return Grouping(*codes_of(text), nothing=words, decimal_mark=mark)


def _mark(table: Table, name: str, text: Any) -> DecimalMark:
    """The table's decimal mark, which is looked for where a cell may be a thousand."""
    import pyarrow as pa
    import pyarrow.compute as pc

    doubtful = pc.match_substring_regex(text.unique(), r"^[+-]?[1-9][0-9]{0,2}[.,][0-9]{3}$")
    if pa.types.is_floating(table.columns[name].type) or not pc.any(doubtful).as_py():
        return "."
    return decimal_mark_of(table)


def _without_nothing(text: Any, mark: DecimalMark) -> tuple[Any, tuple[str, ...]]:
    """The cells without words for nothing, and those words."""
    import pyarrow as pa
    import pyarrow.compute as pc

    nothing = is_nothing(text)
    words = [word for word in text.filter(pa.array(nothing)).unique().to_pylist() if word]
    others = text.filter(pa.array(~nothing)).unique().to_pylist()
    if "none" in words and others and numbers_of(others, mark) is None:
        words.remove("none")
    if not words:
        return text, ()
    blank = pc.is_in(text, pa.array(words, text.type))
    return pc.if_else(blank, pa.scalar(None, text.type), text), tuple(words)


def _whole_where_possible(array: Any) -> Any:
    import pyarrow as pa
    import pyarrow.compute as pc

    array = pc.if_else(pc.is_nan(array), pa.scalar(None, array.type), array)
    values = np.asarray(pc.fill_null(pc.cast(array, pa.float64()), 0.0))
    if np.all((np.abs(values) < 2**53) & (values == np.rint(values))):
        return pc.cast(array, pa.int64())
    return array


keep_former_names(__name__, {"Group": "Grouping"}, "nacreous.scaling")

"""Words that programs write where a cell holds nothing, or where they could not reckon it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from string import ascii_lowercase
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.fault import Faults, quoted

#: What programs and people write into a cell that holds nothing, in small letters.
NOTHING = frozenset(
    {
        *("null", "none", "nan", "na", "n/a", "n.a.", "undefined", "nat", "<na>", "#n/a", "#null!"),
        *(".", "-", "--", "–", "—", "−"),
        # What spreadsheets of other languages have for #N/A.
        *("#na", "#nv", "#n/d", "#n/d!", "#n/b", "#i/t", "#н/д", "#yok", "#saknas!", "#puuttuu!"),
        *("#hiányzik", "#není_k_dispozici"),
        # Databases: MySQL's and PostgreSQL's files, and their browsers.
        *("\\n", "(null)", "<null>", "[null]"),
        # Stata and SAS number their kinds of nothing; C's libraries write a sign, or 1.#.
        *(f".{letter}" for letter in "_" + ascii_lowercase),
        *("-nan", "+nan", "1.#ind", "-1.#ind", "1.#qnan", "-1.#qnan"),
    }
)
#: What is a label beside a plus, as of two poles.
_MINUS = frozenset("-–—−")
#: What spreadsheets show for a formula without a result, in any language, and where a column is too
#: narrow. LibreOffice numbers its own.
_ERROR = re.compile(r"#[¡¿]?[^\W\d_][\w/]*[!?]|#GETTING_DATA|#{3,}")
_NUMBERED_ERROR = re.compile(r"(?:Err|Fehler):[0-9]{3}")


def is_nothing(text: Any) -> NDArray[np.bool_]:
    """Bool [row], where a text column is empty or has a word for nothing (`NOTHING`).

    A dash is a label where a plus is one.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    plus = bool(pc.any(pc.is_in(text, pa.array(["+", "＋"], text.type))).as_py())
    words = NOTHING - _MINUS if plus else NOTHING
    word = pc.is_in(pc.utf8_lower(text), pa.array(sorted(words), text.type))
    return np.asarray(pc.or_(text.is_null(), pc.fill_null(word, True)))


def refuse_nothing(
    name: str, text: Any, faults: Faults, labels: Iterable[str] = frozenset()
) -> None:
    """Note the words that programs write into an empty cell, unless they are among the labels."""
    import pyarrow as pa
    import pyarrow.compute as pc

    label = np.asarray(pc.is_in(text, pa.array(sorted(labels), text.type)))
    faults.say_of_column(
        np.flatnonzero(is_nothing(text) & ~label & np.asarray(text.is_valid())),
        lambda row: (
            f"{name} is {quoted(text[row])}, as programs write an empty cell; allowed: a label"
        ),
    )


def is_error(cell: str) -> bool:
    """Whether a cell is what a spreadsheet shows for a formula without a result.

    >>> is_error("#DIV/0!"), is_error("#NOMBRE?"), is_error("#1")
    (True, True, False)
    """
    named = cell.upper() == cell and cell.lower() not in NOTHING and _ERROR.fullmatch(cell)
    return bool(named or _NUMBERED_ERROR.fullmatch(cell))


def refuse_errors(
    name: str,
    found: Sequence[str],
    code: NDArray[np.signedinteger[Any]],
    faults: Faults,
    labels: Iterable[str] = frozenset(),
    allowed: str = "a label",
) -> None:
    """Note a column that holds errors of a spreadsheet in one line, unless they are labels.

    found: the column's values. code: for each row the index of its value.
    """
    errors = [at for at, cell in enumerate(found) if is_error(cell) and cell not in {*labels}]
    faults.say_of_column(
        np.flatnonzero(np.isin(code, errors)),
        lambda row: (
            f"{name} is {quoted(found[code[row]])}, an error of a spreadsheet; allowed: {allowed}"
        ),
    )

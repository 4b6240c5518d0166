"""A table of judged differences checked: what is wrong is named by row and column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.column import check_labels, codes_of, text_column
from nacreous.scaling.data.fault import Faults, hint_of, listed, nearest, quoted
from nacreous.scaling.data.header import name_of
from nacreous.scaling.data.label import check_number, labels_of
from nacreous.scaling.data.likeness import check_alike
from nacreous.scaling.data.nothing import refuse_errors, refuse_nothing
from nacreous.scaling.data.rounded import refuse_rounded
from nacreous.scaling.data.table import Table

Index = NDArray[np.int64]
#: What `Quadruples` holds: stimuli, shown, outcome, people, person.
Judged = tuple[tuple[str, ...], Index, NDArray[np.int8], tuple[str, ...], Index | None]

FOUR = ("first_a", "first_b", "second_a", "second_b")
THREE = ("first", "middle", "second")
WORDS = ("first_word", "second_word")
#: What people write for "both alike", in small letters.
_TIES = {"tie", "ties", "tied", "equal", "same", "both", "neither", "none", "draw", "no difference"}


class QuadrupleNames(TypedDict, total=False):
    """What columns are called, where not as usual, and the words in `larger`."""

    first_a: str
    first_b: str
    second_a: str
    second_b: str
    first: str
    middle: str
    second: str
    larger: str
    person: str
    first_word: str
    second_word: str


def names_of(names: Mapping[str, Any], roles: tuple[str, ...]) -> dict[str, str]:
    """The columns by role and the two words, or one message about a role that is none."""
    known = {role: role for role in (*roles, "larger", "person")}
    known |= {"first_word": "first", "second_word": "second"}
    for role, name in names.items():
        if role not in known:
            raise InputError(f"{quoted(role)} is no role of a column; {hint_of(role, known)}")
        if not isinstance(name, str):
            raise InputError(f"{role} is {said(name)}; allowed: a name")
        known[role] = name.strip() if role in WORDS else name_of(name)
    columns = [name for role, name in known.items() if role not in WORDS]
    twice = next((name for name in columns if columns.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"the column {quoted(twice)} is named twice; allowed: one role each")
    if known["first_word"] == known["second_word"]:
        raise InputError(f"first_word and second_word are both {quoted(known['first_word'])}")
    return known


def judged(
    table: Table,
    words: dict[str, str],
    roles: tuple[str, ...],
    stimuli: Iterable[object] | None,
) -> Judged:
    """Check a table's rows and return what `Quadruples` holds."""
    faults = table.faults()
    _check_columns(table, words, roles, faults)
    faults.stop()
    labels, place = _stimuli(table, [words[role] for role in roles], stimuli, faults)
    people, person = _people(table, words["person"], faults)
    outcome = _outcomes(table, words, faults)
    if roles is THREE:
        place = place[:, [1, 0, 1, 2]]  # the middle against each of the others
    _refuse_no_pairs(labels, place, faults)
    faults.stop()
    return labels, place, outcome, people, person


def _check_columns(
    table: Table, words: dict[str, str], roles: tuple[str, ...], faults: Faults
) -> None:
    for role in (*roles, "larger"):
        if words[role] not in table.columns:
            others = [name for name in table.columns if name not in words.values()]
            near = nearest(words[role], others)
            hint = f"did you mean {near}?" if near else f"its columns: {listed(table.columns)}"
            faults.say(f"has no column {words[role]}; {hint}")
    if words["person"] == "person" and "person" not in table.columns:
        near = nearest("person", [name for name in table.columns if name not in words.values()])
        if near:
            faults.say(f"has a column {near}, which is not read; did you mean person?")
    elif words["person"] not in table.columns:
        faults.say(f"has no column {words['person']}; its columns: {listed(table.columns)}")


def _stimuli(
    table: Table, names: list[str], given: Iterable[object] | None, faults: Faults
) -> tuple[tuple[str, ...], Index]:
    """The labels in order, and int64 [row, column], where each cell stands among them."""
    import pyarrow as pa

    labels = None if given is None else labels_of(given)
    texts = [text_column(table, name) for name in names]
    for name, text in zip(names, texts, strict=True):
        check_labels(table, name, text, faults)
        refuse_nothing(name, text, faults, set(labels or ()))
    found, all_codes = codes_of(pa.concat_arrays(texts))
    codes = all_codes.reshape(len(names), table.rows)
    for name, code in zip(names, codes, strict=True):
        refuse_errors(name, found, code, faults, labels or ())
        refuse_rounded(name, found, code, faults, labels or ())
    faults.stop()
    check_alike(found, table.place)
    if labels is None:
        check_number(found, table.place)
        return found, np.ascontiguousarray(codes.T)
    order = np.array([labels.index(each) if each in labels else -1 for each in found], np.int64)
    for name, code in zip(names, codes, strict=True):
        faults.say_of_rows(
            np.flatnonzero(order[code] < 0),
            lambda row, name=name, code=code: (  # type: ignore[misc]
                f"{name} is {quoted(found[code[row]])}; allowed: {listed(labels)}"
            ),
        )
    faults.stop()
    return labels, np.ascontiguousarray(order[codes].T)


def _people(table: Table, name: str, faults: Faults) -> tuple[tuple[str, ...], Index | None]:
    if name not in table.columns:
        return (), None
    text = text_column(table, name)
    check_labels(table, name, text, faults)
    refuse_nothing(name, text, faults)
    people, person = codes_of(text)
    refuse_errors(name, people, person, faults)
    faults.stop()
    check_alike(people, table.place)
    return people, person


def _outcomes(table: Table, words: dict[str, str], faults: Faults) -> NDArray[np.int8]:
    """int8 [row], 1 where the first pair was judged the larger difference, -1 the second."""
    name, first, second = words["larger"], words["first_word"], words["second_word"]
    cells = text_column(table, name).to_pylist()
    allowed = f"allowed: {first}, {second}"
    outcome = np.zeros(table.rows, np.int8)
    for row, cell in enumerate(cells):
        outcome[row] = 1 if cell == first else -1 if cell == second else 0

    def verdict(row: int) -> str:
        cell = cells[row]
        if cell is None:
            return f"{name} is empty; {allowed}"
        if cell.lower() in _TIES:
            return f"{name} is {quoted(cell)}, a tie, which a difference scale has none; {allowed}"
        return f"{name} is {quoted(cell)}; {allowed}"

    faults.say_of_rows(np.flatnonzero(outcome == 0), verdict)
    return outcome


def _refuse_no_pairs(labels: tuple[str, ...], shown: Index, faults: Faults) -> None:
    """Note pairs of a stimulus with itself, and pairs that are compared with themselves."""
    for at, which in ((0, "first"), (2, "second")):
        itself = np.flatnonzero(shown[:, at] == shown[:, at + 1])
        faults.say_of_rows(
            itself,
            lambda row, at=at, which=which: (  # type: ignore[misc]
                f"the {which} pair is {quoted(labels[shown[row, at]])} twice; allowed: two stimuli"
            ),
        )
    pairs = np.sort(shown.reshape(-1, 2, 2), axis=2)
    alike = np.flatnonzero((pairs[:, 0] == pairs[:, 1]).all(axis=1))
    faults.say_of_rows(
        alike,
        lambda row: (
            f"both pairs are {listed(labels[each] for each in pairs[row, 0])}; allowed: two pairs"
        ),
    )

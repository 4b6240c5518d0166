"""Answers as a plain list of (winner, loser), a million of them without a loop in Python."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.fault import Faults, listed, quoted
from nacreous.scaling.data.hidden import hidden_in
from nacreous.scaling.data.label import (
    LONGEST_LABEL,
    check_number,
    label_of,
    labels_of,
    natural,
)
from nacreous.scaling.data.likeness import check_alike
from nacreous.scaling.data.table import is_table

_ALLOWED = "allowed: (winner, loser), each text or a whole number"


def codes_of_pairs(
    pairs: Any, stimuli: Iterable[object] | None
) -> tuple[tuple[str, ...], NDArray[np.int64]]:
    """The labels, and int64 [answer, 2] of indices into them: winner, loser."""
    found, codes = _found(pairs)
    labels, order = _labels(found, stimuli)
    faults = Faults("pairs")
    winner, loser = codes[:, 0], codes[:, 1]
    faults.say_of_rows(
        np.flatnonzero((order[codes] < 0).any(axis=1)),
        lambda row: (
            f"({quoted(found[winner[row]])}, {quoted(found[loser[row]])}) has an unknown label; "
            f"allowed: {listed(labels)}"
        ),
    )
    faults.stop()
    codes = order[codes]
    faults.say_of_rows(
        np.flatnonzero(codes[:, 0] == codes[:, 1]),
        lambda row: f"{quoted(labels[codes[row, 0]])} beats itself; allowed: two stimuli",
    )
    faults.stop()
    check_number(labels, "pairs")
    return labels, codes


def _found(pairs: Any) -> tuple[list[str], NDArray[np.int64]]:
    """The values in order of number or of appearance, and their indices [answer, 2]."""
    if isinstance(pairs, np.ndarray):
        if pairs.ndim != 2 or pairs.shape[1] != 2:
            raise InputError(f"pairs has the shape {pairs.shape}; allowed: (answers, 2)")
        if pairs.dtype.kind in "iu":
            return _numbers(np.ascontiguousarray(pairs).ravel())
        pairs = pairs.tolist()
    if is_table(pairs):
        raise InputError(
            f"pairs is {said(pairs)}; allowed: a list of (winner, loser), or a table with "
            "Answers.of_table"
        )
    if isinstance(pairs, str | bytes) or not isinstance(pairs, Iterable):
        raise InputError(f"pairs is {said(pairs)}; allowed: a list of (winner, loser)")
    rows = list(pairs)
    if not rows:
        raise InputError("pairs: has no rows; allowed: 1 or more of (winner, loser)")
    try:
        if set(map(len, rows)) == {2} and not _any_is(str, rows):
            found = _values(list(chain.from_iterable(rows)))
            if found is not None:
                return found
    except (TypeError, OverflowError):  # a row without length; a number beyond 64 bits
        pass
    raise _complaint(rows)


def _values(flat: list[Any]) -> tuple[list[str], NDArray[np.int64]] | None:
    """Numbers, texts or both; None where something else is among them."""
    kinds = set(map(type, flat))
    if kinds == {int} or all(issubclass(kind, np.integer) for kind in kinds):
        return _numbers(np.array(flat, np.int64))
    if not all(issubclass(kind, str | int | np.integer) and kind is not bool for kind in kinds):
        return None
    return _texts(flat if kinds == {str} else [str(value) for value in flat])


def _any_is(kind: type, rows: list[Any]) -> bool:
    return any(issubclass(each, kind) for each in set(map(type, rows)))


def _complaint(rows: list[Any]) -> InputError:
    faults = Faults("pairs")
    bad = np.array([row for row, pair in enumerate(rows) if not _is_pair(pair)], np.int64)
    faults.say_of_rows(bad, lambda row: f"is {said(rows[row])}; {_ALLOWED}")
    try:
        faults.stop()
    except InputError as problem:
        return problem
    return InputError(f"pairs: holds numbers beyond 2^63; {_ALLOWED}")


def _is_pair(pair: Any) -> bool:
    try:
        values = list(pair)
    except TypeError:
        return False
    good = all(isinstance(v, str | int | np.integer) and not isinstance(v, bool) for v in values)
    return good and len(values) == 2 and not isinstance(pair, str)


def _numbers(flat: NDArray[Any]) -> tuple[list[str], NDArray[np.int64]]:
    if len(flat) == 0:
        raise InputError("pairs: has no rows; allowed: 1 or more of (winner, loser)")
    low, high = int(flat.min()), int(flat.max())
    if high - low < 4 * len(flat) + 1000:  # counting is faster than sorting
        there = np.zeros(high - low + 1, np.int64)
        there[flat - low] = 1
        found = np.flatnonzero(there) + low
        codes = (np.cumsum(there) - 1)[flat - low]
    else:
        found, codes = np.unique(flat, return_inverse=True)
    return [str(number) for number in found.tolist()], codes.reshape(-1, 2)


def _texts(flat: list[str]) -> tuple[list[str], NDArray[np.int64]]:
    different = list(dict.fromkeys(flat))
    found = [label_of(label) for label in different]
    for label in found:
        if not 0 < len(label) <= LONGEST_LABEL:
            length = f"{len(label)} characters"
            raise InputError(f"pairs: holds a label of {length}; allowed: 1 to {LONGEST_LABEL}")
        if any("\ud800" <= letter <= "\udfff" for letter in label):
            raise InputError(f"pairs: {quoted(label)} holds half a character; allowed: text")
        hidden = hidden_in(label)
        if hidden:
            raise InputError(f"pairs: holds {quoted(label)}; allowed: no {hidden} in a label")
    check_alike(dict.fromkeys(found), "pairs")
    place = {label: index for index, label in enumerate(different)}
    codes = np.fromiter(map(place.__getitem__, flat), np.int64, len(flat))
    return found, codes.reshape(-1, 2)


def _labels(
    found: list[str], stimuli: Iterable[object] | None
) -> tuple[tuple[str, ...], NDArray[np.int64]]:
    """The final labels, and for each found value its index among them, or -1."""
    labels = tuple(natural(set(found))) if stimuli is None else labels_of(stimuli)
    place = {label: index for index, label in enumerate(labels)}
    return labels, np.array([place.get(label, -1) for label in found], np.int64)

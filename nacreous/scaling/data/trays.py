"""Trays as lists of labels, checked cell by cell: what lay on each, and what was put in order."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
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

__all__ = ["MOST_ON_A_TRAY", "Trays", "trays_of_extremes", "trays_of_lists"]

#: Every pair of a tray takes memory, and nobody ranks more **(ours)**.
MOST_ON_A_TRAY = 200
_ORDER = "allowed: a list of labels, the best first"
_EXTREMES = "allowed: (all that lay on the tray, the best, the worst)"


@dataclass(frozen=True, eq=False)
class Trays:
    """Checked trays: indices of stimuli tray after tray, ordered ones first, and whose they are."""

    stimuli: tuple[str, ...]
    items: NDArray[np.int64]
    sizes: NDArray[np.int64]
    ordered: NDArray[np.int64]
    people: tuple[str, ...]
    person: NDArray[np.int64] | None


def trays_of_lists(
    rankings: Iterable[Sequence[object]],
    shown: Iterable[Sequence[object]] | None,
    person: Iterable[object] | None,
    stimuli: Iterable[object] | None,
) -> Trays:
    """The best first; `shown` has what lay there besides."""
    faults = Faults("rankings")
    rows = _rows_of("rankings", rankings, "a list of lists of labels, the best first")
    orders = [_labels(faults, row, cells, _ORDER) for row, cells in enumerate(rows)]
    faults.stop()
    trays = orders
    if shown is not None:
        others = Faults("shown")
        lain = _rows_of("shown", shown, "a list of lists of labels", len(rows))
        trays = [
            _labels(others, row, cells, "allowed: a list of labels")
            for row, cells in enumerate(lain)
        ]
        others.stop()
        for row, (order, tray) in enumerate(zip(orders, trays, strict=True)):
            for column, label in enumerate(order):
                if label not in tray:
                    what = f"{quoted(label)} did not lie on the tray; allowed: {listed(tray)}"
                    _say(faults, row, column, what)
        faults.stop()
    more = "" if shown is not None else ", or shown= with all that lay there"
    for row, (order, tray) in enumerate(zip(orders, trays, strict=True)):
        _check_size(faults, row, len(tray), more)
        if not order:
            _say(faults, row, None, "has no label; allowed: 1 or more, the best first")
    faults.stop()
    whole = [
        [*order, *(label for label in tray if label not in order)]
        for order, tray in zip(orders, trays, strict=True)
    ]
    return _joined("rankings", whole, list(map(len, orders)), person, stimuli)


def trays_of_extremes(
    answers: Iterable[tuple[Sequence[object], object, object]],
    person: Iterable[object] | None,
    stimuli: Iterable[object] | None,
) -> Trays:
    """The best first and the worst last."""
    faults = Faults("answers")
    whole: list[list[str]] = []
    for row, answer in enumerate(_rows_of("answers", answers, f"a list of {_EXTREMES[9:]}")):
        if not isinstance(answer, list | tuple) or len(answer) != 3:
            _say(faults, row, None, f"is {said(answer)}; {_EXTREMES}")
            continue
        tray = _labels(faults, row, answer[0], "allowed: a list of labels")
        _check_size(faults, row, len(tray), "")
        ends = []
        for name, cell in zip(("the best", "the worst"), answer[1:], strict=True):
            wrong = _wrong(cell)
            if wrong is None and _text(cell) not in tray:
                wrong = f"is {quoted(cell)}, which did not lie on the tray; allowed: {listed(tray)}"
            if wrong:
                _say(faults, row, None, f"{name} {wrong}")
            ends.append("" if wrong else _text(cell))
        if ends[0] and ends[0] == ends[1]:
            _say(faults, row, None, f"{quoted(ends[0])} is best and worst; allowed: two stimuli")
        whole.append([ends[0], *(label for label in tray if label not in ends), ends[1]])
    faults.stop()
    return _joined("answers", whole, [2] * len(whole), person, stimuli)


def _rows_of(name: str, rows: Any, allowed: str, count: int | None = None) -> list[Any]:
    if isinstance(rows, str | bytes) or not isinstance(rows, Iterable):
        raise InputError(f"{name} is {said(rows)}; allowed: {allowed}")
    found = list(rows)
    if not found:
        raise InputError(f"{name}: has no rows; allowed: 1 or more, one a tray")
    if count is not None and len(found) != count:
        raise InputError(f"{name} has {len(found)} rows; allowed: {count}, one a tray")
    return found


def _labels(faults: Faults, row: int, cells: Any, allowed: str) -> list[str]:
    """The labels of a row, each once."""
    if isinstance(cells, np.ndarray):
        cells = cells.tolist()
    if not isinstance(cells, list | tuple):
        _say(faults, row, None, f"is {said(cells)}; {allowed}")
        return []
    found: list[str] = []
    for column, cell in enumerate(cells):
        wrong = _wrong(cell)
        label = "" if wrong else _text(cell)
        if wrong is None and label in found:
            wrong = f"is {quoted(label)} again; allowed: each stimulus once on a tray"
        if wrong:
            _say(faults, row, column, wrong)
        else:
            found.append(label)
    return found


def _check_size(faults: Faults, row: int, size: int, more: str) -> None:
    if not 2 <= size <= MOST_ON_A_TRAY:
        allowed = f"allowed: 2 to {MOST_ON_A_TRAY}{more}"
        _say(faults, row, None, f"has {size} {'label' if size == 1 else 'labels'}; {allowed}")


def _wrong(cell: Any) -> str | None:
    """What is wrong with a label, or None."""
    if isinstance(cell, list | tuple | set | frozenset):
        return f"is {said(cell)}; allowed: one label, for ties cannot be taken"
    if isinstance(cell, bool | np.bool_) or not isinstance(cell, str | int | np.integer):
        return f"is {said(cell)}; allowed: text or a whole number"
    text = _text(cell)
    if not 0 < len(text) <= LONGEST_LABEL:
        return f"is {len(text)} characters long; allowed: 1 to {LONGEST_LABEL}"
    hidden = hidden_in(text)
    return f"is {quoted(text)}; allowed: no {hidden} in it" if hidden else None


def _text(cell: Any) -> str:
    return label_of(str(cell))


def _say(faults: Faults, row: int, column: int | None, wrong: str) -> None:
    where = "" if column is None else f"column {column}: "
    faults.say_of_rows(np.array([row]), lambda _: f"{where}{wrong}")


def _joined(
    place: str,
    trays: list[list[str]],
    ordered: list[int],
    person: Iterable[object] | None,
    stimuli: Iterable[object] | None,
) -> Trays:
    """Labels as indices, and people beside them."""
    labels = _known(place, trays, stimuli)
    index = {label: at for at, label in enumerate(labels)}
    people, code = _people(person, len(trays))
    return Trays(
        labels,
        np.array([index[label] for tray in trays for label in tray], np.int64),
        np.array(list(map(len, trays)), np.int64),
        np.array(ordered, np.int64),
        people,
        code,
    )


def _known(place: str, trays: list[list[str]], stimuli: Iterable[object] | None) -> tuple[str, ...]:
    """All labels in natural order, or those of a caller, who allows no others."""
    met = dict.fromkeys(label for tray in trays for label in tray)
    if stimuli is None:
        check_number(tuple(met), place)
        check_alike(met, place)
        return tuple(natural(met))
    labels = labels_of(stimuli)
    faults = Faults(place)
    for row, tray in enumerate(trays):
        for label in tray:
            if label not in labels:
                _say(faults, row, None, f"{quoted(label)} is unknown; allowed: {listed(labels)}")
    faults.stop()
    return labels


def _people(
    person: Iterable[object] | None, trays: int
) -> tuple[tuple[str, ...], NDArray[np.int64] | None]:
    """Labels of people, and who ranked each tray."""
    if person is None:
        return (), None
    rows = _rows_of("person", person, "a list of labels, one a tray", trays)
    faults = Faults("person")
    for row, cell in enumerate(rows):
        if wrong := _wrong(cell):
            _say(faults, row, None, wrong)
    faults.stop()
    labels = list(map(_text, rows))
    check_alike(dict.fromkeys(labels), "person")
    people = tuple(natural(set(labels)))
    index = {label: at for at, label in enumerate(people)}
    return people, np.array([index[label] for label in labels], np.int64)

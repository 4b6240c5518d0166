"""What an answer to a pair means: the only place that reads left, right and tie out of rows."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypedDict, cast

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.column import Grouping
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.label import label_of, natural
from nacreous.study.task.row import Row, Tallied
from nacreous.unchanging import released

if TYPE_CHECKING:
    from nacreous.scaling import Answers
    from nacreous.scaling.report.settings import Settings

__all__ = ["CHOICES", "answers", "chosen_of", "comparisons", "pair_of", "settings", "sides_of"]

CHOICES = ("left", "right", "tie")


class _PairColumns(TypedDict):
    """What the store keeps of a pair: two labels, and "left", "right" or "tie"."""

    left: str
    right: str
    chosen: str


def _columns(row: Row | Tallied) -> _PairColumns:
    return cast("_PairColumns", row)


def sides_of(row: Row | Tallied) -> tuple[str, str]:
    """The labels on the left and on the right, in the form in which labels are compared.

    Stores of earlier versions keep them as their study files wrote them.
    """
    pair = _columns(row)
    return label_of(pair["left"]), label_of(pair["right"])


def pair_of(row: Row | Tallied) -> frozenset[str]:
    """The labels of both, on whichever side."""
    return frozenset(sides_of(row))


def chosen_of(row: Row | Tallied) -> str | None:
    """The label of what was chosen, None for a tie.

    >>> chosen_of({"left": "a", "right": "b", "chosen": "right"})
    'b'
    """
    chosen = _columns(row)["chosen"]
    left, right = sides_of(row)
    return None if chosen == "tie" else left if chosen == "left" else right


def settings(chosen_by: str | None) -> Settings:
    """How a report fits answers to pairs that were chosen so (`Pairs.chosen_by`).

    The most telling ones stretch the most likely scale and want the prior under which they were
    chosen; ones drawn by lot are left without a prior, and bias reduction holds them.

    >>> settings("greedy").prior, settings("drawn").method
    ('hierarchical', 'bias-reduced')
    """
    from nacreous.scaling.report.settings import Settings

    known = {
        None: Settings(),
        "greedy": Settings(prior="hierarchical"),
        "drawn": Settings(method="bias-reduced"),
    }
    if chosen_by not in known:
        raise InputError(
            f"pairs_chosen_by is {said(chosen_by)}; allowed: greedy, drawn, beforehand"
        )
    return known[chosen_by]


def answers(columns: Mapping[str, Any], groups: Mapping[str, Grouping]) -> Answers:
    """Columns as `nacreous.scaling` takes them, left, right, chosen, person, trial, response_ms.

    People are named by number, erased ones by their random names. Trials give the order. Labels are
    as they can be shown; one such as NA, left or tie is a label here. Each text is checked once,
    however many answers have it.
    """
    from nacreous.scaling import Answers

    names = ("left", "right")
    sides = [_coded(columns[name]) for name in names]
    person = _coded(columns["person"])
    cells, row = _distinct([codes for _, codes in sides])
    shown = [[printable(text) for text in texts] for texts, _ in sides]
    pairs = {
        name: [texts[at] for at in cell]
        for name, texts, cell in zip(names, shown, cells, strict=True)
    }
    stimuli = natural({*pairs["left"], *pairs["right"]})
    pairs["chosen"] = pairs["left"]  # by label; what was chosen is known without any word
    pair = Answers.of_table(pairs, stimuli=stimuli, repeats=True)
    first = {name: [column[0]] * len(person[0]) for name, column in pairs.items()}
    people = Answers.of_table({**first, "person": person[0]}, stimuli=stimuli, repeats=True)
    if people.person is None:
        raise AssertionError("the table has a column of people")
    times_ms = _floats(columns["response_ms"])
    return replace(
        pair,
        left=released(pair.left[row]),
        right=released(pair.right[row]),
        outcome=_outcomes(*_coded(columns["chosen"])),
        people=people.people,
        person=released(people.person[person[1]]),
        groups=groups,
        response_s=released(times_ms / 1000),
        time=_floats(columns["trial"]),
    )


def _outcomes(words: list[str], code: NDArray[np.int64]) -> NDArray[np.int8]:
    """1 where the left one was chosen, -1 the right one, 0 neither."""
    said_by = dict(zip(CHOICES, (1, -1, 0), strict=True))
    used = [words[at] for at in np.unique(code[code >= 0])] + [""] * bool(np.any(code < 0))
    for word in used:
        if word not in said_by:
            allowed = ", ".join(CHOICES)
            raise InputError(f"chosen is {said(printable(word))}; allowed: {allowed}")
    return np.array([said_by.get(word, 0) for word in words], np.int8)[code]


def _floats(column: Any) -> NDArray[np.float64]:
    """A column of numbers, NaN where there is none."""
    import pyarrow as pa

    numbers = column if hasattr(column, "type") else pa.array(column, pa.float64())
    return np.asarray(numbers.cast(pa.float64()).fill_null(np.nan))


def _coded(column: Any) -> tuple[list[str], NDArray[np.int64]]:
    """The texts of a column, and each row's place among them; -1 where it is empty."""
    import pyarrow as pa

    text = column if hasattr(column, "type") else pa.array(column, pa.string())
    whole = text.combine_chunks() if isinstance(text, pa.ChunkedArray) else text
    coded = whole if pa.types.is_dictionary(whole.type) else whole.dictionary_encode()
    return coded.dictionary.to_pylist(), np.asarray(coded.indices.fill_null(-1))


def _distinct(
    codes: Sequence[NDArray[np.int64]],
) -> tuple[list[list[int]], NDArray[Any]]:
    """The different rows of some columns, column by column, and which of them each row is."""
    sizes = [int(column.max(initial=-1)) + 1 for column in codes]
    key = np.zeros(len(codes[0]), np.int64)
    for column, size in zip(codes, sizes, strict=True):
        key *= size
        key += column
    row: NDArray[Any]
    if math.prod(sizes) <= len(key) + 1000:  # counting takes less memory than sorting
        there = np.bincount(key, minlength=math.prod(sizes)) > 0
        found, row = np.flatnonzero(there), (np.cumsum(there, dtype=np.int32) - 1)[key]
    else:
        found, row = np.unique(key, return_inverse=True)
    cells = []
    for size in reversed(sizes):
        cells.append((found % size).tolist())
        found = found // size
    return cells[::-1], row


def comparisons(labels: Sequence[str], tally: Iterable[Tallied]) -> dict[str, Comparisons]:
    """The counts of each question that has any, from equal answers counted.

    People's answers alone; a program's where a question has no others, so that a rehearsal goes as
    the study will **(ours)**.

    >>> row = {"question": "q", "left": "a", "right": "b", "chosen": "left", "count": 3}
    >>> comparisons(["a", "b"], [{**row, "simulated": True}])
    {'q': Comparisons(3 answers, 2 stimuli, 1 pair)}
    >>> people = {**row, "chosen": "tie", "count": 1, "simulated": False}
    >>> comparisons(["a", "b"], [{**row, "simulated": True}, people])
    {'q': Comparisons(1 answers, 2 stimuli, 1 pair)}
    """
    by_question: dict[str, list[Tallied]] = {}
    for row in tally:
        by_question.setdefault(row["question"], []).append(row)
    return {question: _counted(labels, rows) for question, rows in by_question.items()}


def _counted(labels: Sequence[str], rows: list[Tallied]) -> Comparisons:
    people = [row for row in rows if not row["simulated"]]
    index = {label: place for place, label in enumerate(labels)}
    wins, ties = np.zeros((2, len(labels), len(labels)))
    for row in people or rows:
        left, right = (index[label] for label in sides_of(row))
        chosen = chosen_of(row)
        if chosen is None:
            ties[[left, right], [right, left]] += row["count"]
        else:
            won = index[chosen]
            wins[won, left + right - won] += row["count"]
    return Comparisons.of_counts(wins, ties, [printable(label) for label in labels])

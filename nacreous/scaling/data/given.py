"""Answers or counts in whatever form they are given: read once, in the same way for everything."""

from __future__ import annotations

from os import PathLike
from typing import Any

import numpy as np

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.table import is_table

__all__ = ["answers_of", "answers_or_counts", "comparisons_of", "counted"]


def comparisons_of(data: Any) -> Comparisons:
    """Whatever holds answers, counted by pair.

    `Comparisons`, `Answers`, a path to a file of answers, a table of answers (pandas, Polars,
    pyarrow, dict of columns left, right, chosen, list of rows as dicts), a square matrix of counts
    (nested lists, NumPy, a DataFrame), or a list of tuples (winner, loser). An array [answer, 2] of
    other than 2 rows is a list of pairs too.

    >>> comparisons_of([("a", "b"), ("b", "c")])
    Comparisons(2 answers, 3 stimuli, 2 pairs)
    """
    return counted(data)[1]


def counted(data: Any) -> tuple[Answers | None, Comparisons]:
    """The answers that data hold, None where they are counts or pairs, and their counts.

    A list of pairs knows nothing that its counts do not.

    >>> counted({"left": ["a"], "right": ["b"], "chosen": ["a"], "person": ["mika"]})
    (Answers(1 answers, 2 stimuli, 1 person), Comparisons(1 answers, 2 stimuli, 1 pair))
    """
    if isinstance(data, Comparisons):
        return None, data
    answers = _read(data)
    if answers is not None:
        return answers, answers.comparisons()
    if is_table(data) or not _are_pairs(data):
        return None, Comparisons.of_counts(data)
    return None, Answers.of_pairs(data).comparisons()


def answers_or_counts(data: Any) -> Answers | Comparisons:
    """What `comparisons_of` takes as answers, where it holds them with their people, or as counts.

    >>> answers_or_counts([("a", "b"), ("b", "c")])
    Comparisons(2 answers, 3 stimuli, 2 pairs)
    """
    answers, comparisons = counted(data)
    return comparisons if answers is None else answers


def answers_of(data: Any) -> Answers:
    """The answers themselves of what `comparisons_of` takes.

    Raises `InputError` for counts, which do not say who gave which answer when.

    >>> answers_of({"left": ["a"], "right": ["b"], "chosen": ["a"], "person": ["mika"]})
    Answers(1 answers, 2 stimuli, 1 person)
    >>> answers_of([[0, 3], [2, 0]])
    Traceback (most recent call last):
    nacreous.problem.InputError: the data are counts, which do not hold each answer; wanted: ...
    """
    answers = None if isinstance(data, Comparisons) else _read(data)
    if answers is not None:
        return answers
    if isinstance(data, Comparisons) or is_table(data) or not _are_pairs(data):
        raise InputError(
            "the data are counts, which do not hold each answer; wanted: answers, such as "
            "Answers.read(path) or Answers.of_table(table) make"
        )
    return Answers.of_pairs(data)


def _read(data: Any) -> Answers | None:
    """The answers of a file or a table, or given as such; None for any other data."""
    if isinstance(data, Answers):
        return data
    if isinstance(data, str | PathLike):
        return Answers.read(data)
    return Answers.of_table(data) if is_table(data) and not _is_matrix(data) else None


def _is_matrix(table: Any) -> bool:
    """Whether a frame is a square of counts; a table of answers has three columns with names."""
    names = list(getattr(table, "columns", ()))
    if isinstance(table, dict) or {"left", "right", "chosen"} & {str(name) for name in names}:
        return False
    return len(table) == len(names)


def _are_pairs(data: Any) -> bool:
    if isinstance(data, np.ndarray):
        return data.ndim == 2 and data.shape[1] == 2 and data.shape[0] != 2
    if not isinstance(data, list | tuple):
        raise InputError(
            f"the data are {said(data)}; allowed: answers, comparisons, a table, a matrix of "
            "counts, or a list of (winner, loser)"
        )
    if not data or isinstance(data[0], tuple):
        return True
    return isinstance(data[0], list) and len(data[0]) == 2 and len(data) != 2

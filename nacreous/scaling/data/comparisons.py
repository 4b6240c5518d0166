"""Counts of answers by pair: all that an estimator needs."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.file import named
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.encoding import guessed_encoding
from nacreous.scaling.data.label import check_visible, labels_of, numbered
from nacreous.scaling.data.matrix import (
    check_counts,
    check_proportions,
    check_ties,
    labelled_matrix,
    read_matrix,
)
from nacreous.scaling.data.table import read_bytes
from nacreous.value import value_class


@value_class
class Comparisons:
    """How often each was chosen, by pair. Each pair of (left, right) has at most one row.

    - `stimuli`: labels
    - `left`, `right`: int64 [row], indices into `stimuli`; where not `sided`, left < right
    - `left_wins`, `right_wins`, `ties`: float64 [row], 0 or more, not all 0
    - `sided`: left and right are places before the eye
    - `encoding_guessed`: as which a file was read that does not say how its letters are written

    Rows stand in the order of (left, right).

    >>> Comparisons.of_counts([[0, 3], [1, 0]])
    Comparisons(4 answers, 2 stimuli, 1 pair)
    """

    stimuli: tuple[str, ...]
    left: NDArray[np.int64]
    right: NDArray[np.int64]
    left_wins: NDArray[np.float64]
    right_wins: NDArray[np.float64]
    ties: NDArray[np.float64]
    sided: bool
    encoding_guessed: str | None = None

    def __post_init__(self) -> None:
        """Refuse labels with characters that a terminal would obey."""
        check_visible(self.stimuli, "stimuli")

    @classmethod
    def of_counts(
        cls, counts: Any, ties: Any = None, stimuli: Iterable[object] | None = None
    ) -> Comparisons:
        """From whole counts [n, n]: `counts[i, j]` times i was preferred to j.

        `ties[i, j]`, symmetric, is how often neither was. The diagonal is 0 (or, in counts, NaN or
        empty, as it is often printed). Labels are `stimuli`, those of a DataFrame, or "1" to "n".

        >>> Comparisons.of_counts([[0, 3], [1.5, 0]])
        Traceback (most recent call last):
        nacreous.problem.InputError: counts[1, 0] is 1.5; allowed: a whole number, 0 or more
        """
        values, own = labelled_matrix("counts", counts)
        matrix = check_counts("counts", values)
        tied = np.zeros_like(matrix) if ties is None else check_ties(ties, len(matrix))
        return cls._of_matrix(matrix, tied, stimuli if stimuli is not None else own)

    @classmethod
    def of_proportions(
        cls, proportions: Any, answers: float, stimuli: Iterable[object] | None = None
    ) -> Comparisons:
        """From proportions [n, n] of `answers` people a pair: what papers print.

        `proportions[i, j]` is the share that preferred i to j; p and its mirror add up to 1 within
        0.011, which rounding to two decimals may cost, and are brought to 1. Counts may then be
        fractions. The diagonal is not looked at.

        >>> Comparisons.of_proportions([[0.5, 0.77], [0.23, 0.5]], answers=100).matrix
        array([[ 0., 77.],
               [23.,  0.]])
        """
        values, own = labelled_matrix("proportions", proportions)
        shares = check_proportions("proportions", values, answers)
        matrix = shares * float(answers)
        return cls._of_matrix(
            matrix, np.zeros_like(matrix), stimuli if stimuli is not None else own
        )

    @classmethod
    def read_counts(cls, path: str | PathLike[str]) -> Comparisons:
        """Read a square matrix of counts from a .csv file, with labels in a first line or without.

        With labels, they may stand in the first column too, in another order, and a row and a
        column of sums at the end. Where a stimulus meets itself the cell is empty, 0 or a dash.
        Raises `InputError` with file, row and column for everything else.

        >>> Comparisons.read_counts("no such counts.csv")
        Traceback (most recent call last):
        nacreous.problem.InputError: no such counts.csv: does not exist
        """
        values, labels = read_matrix(named(path))
        matrix = check_counts(printable(str(path)), values, labels or numbered(len(values)))
        found = cls._of_matrix(matrix, np.zeros_like(matrix), labels)
        return replace(found, encoding_guessed=guessed_encoding(read_bytes(Path(path))))

    @classmethod
    def _of_matrix(
        cls, wins: NDArray[np.float64], ties: NDArray[np.float64], stimuli: Iterable[object] | None
    ) -> Comparisons:
        labels = numbered(len(wins)) if stimuli is None else labels_of(stimuli, len(wins))
        left, right = np.nonzero(np.triu(wins + wins.T + ties, 1))
        if len(left) == 0:
            raise InputError("counts holds no answers; allowed: 1 or more")
        found = (wins[left, right], wins[right, left], ties[left, right])
        return cls(labels, left, right, *found, sided=False)

    @classmethod
    def of_outcomes(
        cls,
        stimuli: tuple[str, ...],
        left: NDArray[np.signedinteger[Any]],
        right: NDArray[np.signedinteger[Any]],
        outcome: NDArray[np.int8],
        sided: bool,
    ) -> Comparisons:
        """Count answers that are valid already: indices, and 1 left, -1 right, 0 tie.

        Indices of four bytes take half the memory; they do for up to 26,754 stimuli.
        """
        count = len(stimuli)
        if not sided:
            swapped = left > right
            left, right = np.where(swapped, right, left), np.where(swapped, left, right)
            outcome = np.where(swapped, -outcome, outcome)
        key = (left * count + right) * 3 + (outcome + 1)
        if 3 * count**2 <= 4 * len(key) + 1000:  # counting is faster than sorting
            counts = np.bincount(key, minlength=3 * count**2)
            found = np.flatnonzero(counts)
            counts = counts[found]
        else:
            found, counts = np.unique(key, return_counts=True)
        pairs, row = np.unique(found // 3, return_inverse=True)
        table = np.zeros((3, len(pairs)))
        table[found % 3, row] = counts
        return cls(stimuli, pairs // count, pairs % count, table[2], table[0], table[1], sided)

    def __len__(self) -> int:
        """How many pairs there are, each side of the eye its own where `sided`."""
        return len(self.left)

    def __repr__(self) -> str:
        """In one line how much is here."""
        pairs = f"{len(self)} {'pair' if len(self) == 1 else 'pairs'}"
        return f"Comparisons({self.total:g} answers, {len(self.stimuli)} stimuli, {pairs})"

    @property
    def total(self) -> float:
        """How many answers there are, ties included."""
        return float(self.left_wins.sum() + self.right_wins.sum() + self.ties.sum())

    @property
    def matrix(self) -> NDArray[np.float64]:
        """float64 [n, n]: how often i was chosen over j, whichever side it was on."""
        wins = np.zeros((len(self.stimuli), len(self.stimuli)))
        wins[self.left, self.right] += self.left_wins
        wins[self.right, self.left] += self.right_wins
        return wins

    @property
    def tie_matrix(self) -> NDArray[np.float64]:
        """float64 [n, n], symmetric: how often neither of i and j was chosen."""
        ties = np.zeros((len(self.stimuli), len(self.stimuli)))
        ties[self.left, self.right] += self.ties
        ties[self.right, self.left] += self.ties
        return ties

    def unsided(self) -> Comparisons:
        """The same counts with each pair in one row, whichever side its stimuli were on."""
        if not self.sided:
            return self
        swapped = self.left > self.right
        first = np.where(swapped, self.right, self.left)
        second = np.where(swapped, self.left, self.right)
        count = len(self.stimuli)
        pairs, row = np.unique(first * count + second, return_inverse=True)
        columns = (
            np.where(swapped, self.right_wins, self.left_wins),
            np.where(swapped, self.left_wins, self.right_wins),
            self.ties,
        )
        left_wins, right_wins, ties = (
            np.asarray(np.bincount(row, weights=column, minlength=len(pairs)), np.float64)
            for column in columns
        )
        return Comparisons(
            self.stimuli, pairs // count, pairs % count, left_wins, right_wins, ties, sided=False
        )

"""Answers to pairs as numbers: who, which two, which one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.label import label_of
from nacreous.study.task.asked import Asked
from nacreous.study.task.pair.keys import PairKeys
from nacreous.study.task.pair.reading import CHOICES

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = ["PairData"]

_OUTCOME = dict(zip(CHOICES, (1, -1, 0), strict=True))


@dataclass(frozen=True)
class PairData:
    """One row an answer, in the order of arrival; every field is an array of that length.

    person: the person's number. question, left, right: places among the study's questions and
    labels. outcome: 1 left chosen, -1 right, 0 neither. repeat: whether the pair was asked again.
    simulated; counts: whether the person is not left out. response_ms: NaN where unknown.
    """

    person: NDArray[np.int32]
    question: NDArray[np.int16]
    left: NDArray[np.int16]
    right: NDArray[np.int16]
    outcome: NDArray[np.int8]
    repeat: NDArray[np.bool_]
    simulated: NDArray[np.bool_]
    counts: NDArray[np.bool_]
    response_ms: NDArray[np.float64]

    @classmethod
    def of_rows(cls, rows: pa.Table, asked: Asked[PairKeys]) -> PairData:
        """From an Arrow table of data, as `Task.flags` takes it."""
        labels = {label: place for place, label in enumerate(asked.labels)}
        questions = {question: place for place, question in enumerate(asked.questions)}
        sides = [
            _coded(rows[side], lambda label: labels[label_of(label)], np.int16)
            for side in ("left", "right")
        ]
        return cls(
            person=_numbers(rows["number"], np.int32),
            question=_coded(rows["question"], questions.__getitem__, np.int16),
            left=sides[0],
            right=sides[1],
            outcome=_coded(rows["chosen"], _OUTCOME.__getitem__, np.int8),
            repeat=_coded(rows["kind"], lambda kind: kind == "repeat", np.bool_),
            simulated=_numbers(rows["simulated"], np.bool_),
            counts=np.asarray(rows["excluded"].is_null()),
            response_ms=_numbers(rows["response_ms"], np.float64),
        )

    def take(self, rows: NDArray[Any]) -> PairData:
        """Some rows: a mask, or positions."""
        return PairData(**{one.name: getattr(self, one.name)[rows] for one in fields(self)})

    def by_person(self) -> Iterator[tuple[int, PairData]]:
        """Each person's number and answers."""
        order = np.argsort(self.person, kind="stable")
        answers = np.bincount(self.person)
        ends = np.cumsum(answers)
        for person in np.flatnonzero(answers).tolist():
            yield person, self.take(order[ends[person] - answers[person] : ends[person]])

    def pair(self, stimuli: int) -> NDArray[np.int64]:
        """The same number for a pair on whichever side, from how many stimuli there are."""
        low, high = np.minimum(self.left, self.right), np.maximum(self.left, self.right)
        return low.astype(np.int64) * stimuli + high

    @property
    def first_won(self) -> NDArray[np.int8]:
        """The outcome for the one of a pair that comes first among the labels."""
        return np.where(self.left < self.right, self.outcome, -self.outcome)


def _numbers(column: Any, kind: type) -> NDArray[Any]:
    """NaN where a float is unknown."""
    return np.asarray(column.to_numpy(), dtype=kind)


def _coded(column: Any, code: Any, kind: type) -> NDArray[Any]:
    """A column of text as numbers, each text looked at once."""
    import pyarrow as pa

    whole = column.combine_chunks()
    coded = whole if pa.types.is_dictionary(whole.type) else whole.dictionary_encode()
    values: NDArray[Any] = np.zeros(len(coded.dictionary), kind)
    for place in coded.indices.unique().to_pylist():  # a dictionary may hold texts of other rows
        values[place] = code(coded.dictionary[place].as_py())
    found: NDArray[Any] = values[np.asarray(coded.indices)]
    return found

"""What a task declares: what a trial shows, what may be answered, and what an answer means."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from nacreous.study.task.asked import Asked
from nacreous.study.task.column import Column
from nacreous.study.task.flag import Flag
from nacreous.study.task.response import Given
from nacreous.study.task.row import Row, Tallied

if TYPE_CHECKING:
    import pyarrow as pa

    from nacreous.scaling import Answers
    from nacreous.scaling.data.column import Grouping
    from nacreous.scaling.report.settings import Settings

__all__ = ["Items", "SoFar", "Task"]

K = TypeVar("K")

#: The answers so far by question, counted as the task itself wants them.
SoFar = Mapping[str, Any]


@dataclass(frozen=True)
class Items:
    """What one participant is shown under a question, before it is put in order.

    stimuli: int64 [item, place], indices of labels. The first `repeated` items are shown once more,
    as `Task.again` has them.
    """

    stimuli: NDArray[np.int64]
    repeated: int


class Task(ABC, Generic[K]):
    """A way to ask people about stimuli. K: the type of its keys in a study's file.

    - `name`: in stores and on the wire
    - `called`: in English, as an export describes it
    - `places`: where a trial shows a stimulus; each is a column of the store
    - `given`: what may be answered, as a type that pydantic reads
    - `columns`: of an export, for what was shown and what was answered
    """

    name: ClassVar[str]
    called: ClassVar[str]
    places: ClassVar[tuple[str, ...]]
    given: ClassVar[Any]
    columns: ClassVar[tuple[Column, ...]]

    @abstractmethod
    def items(
        self, asked: Asked[K], number: int, questions: Sequence[str], so_far: SoFar
    ) -> list[Items]:
        """The items of participant `number` under each question, in the order of asking."""

    @abstractmethod
    def again(self, stimuli: tuple[int, ...]) -> tuple[int, ...]:
        """The stimuli of a trial, by place, as they are shown a second time."""

    @abstractmethod
    def catches(self, asked: Asked[K], question: str) -> list[tuple[int, ...]]:
        """The stimuli, by place, of each trial of a question whose answer is known."""

    @abstractmethod
    def check(self, asked: Asked[K], given: Given) -> None:
        """Raise `InputError` for what this study does not let anyone answer."""

    @abstractmethod
    def missed(self, asked: Asked[K], row: Row) -> bool:
        """Whether a catch was answered otherwise than by what is known."""

    @abstractmethod
    def answers(self, columns: Mapping[str, Any], groups: Mapping[str, Grouping]) -> Answers:
        """Answers as a scale takes them, with groups by name.

        columns: lists or Arrow arrays by name: those of the task, and person (a label), trial,
        response_ms.
        """

    @abstractmethod
    def adapts(self, asked: Asked[K]) -> bool:
        """Whether items hang on the answers so far."""

    @abstractmethod
    def chosen_by(self, asked: Asked[K]) -> str | None:
        """How items are chosen by the answers so far, as an export calls it; None: not by them."""

    @abstractmethod
    def settings(self, chosen_by: str | None) -> Settings:
        """How a report fits answers to items so chosen. Raises `InputError` for other words."""

    @abstractmethod
    def so_far(self, asked: Asked[K], tally: Sequence[Tallied]) -> SoFar:
        """What `items` wants to know of the answers so far, from the counts that count."""

    @abstractmethod
    def flags(self, asked: Asked[K], rows: pa.Table) -> dict[int, list[Flag]]:
        """What a person's data say of each other, by the person's number.

        rows: data alone, of people who have a number, in the order of arrival, with the columns
        number, kind, question, response_ms, simulated, excluded, and those of the task.
        """

    @abstractmethod
    def simulate(self, values: Sequence[float], sigma: float, random: np.random.Generator) -> Given:
        """What a simulated observer answers; values: on the scale, by place; sigma: its noise."""

"""A pair: what its trial shows, what may be answered, and what "left" then means."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.study.memory import give_back
from nacreous.study.task.asked import Asked
from nacreous.study.task.column import Column
from nacreous.study.task.flag import Flag
from nacreous.study.task.pair import choice, consistent, reading
from nacreous.study.task.pair.data import PairData
from nacreous.study.task.pair.keys import PairKeys
from nacreous.study.task.response import Given
from nacreous.study.task.row import Row, Tallied
from nacreous.study.task.task import Items, SoFar, Task

if TYPE_CHECKING:
    import pyarrow as pa

    from nacreous.scaling import Answers
    from nacreous.scaling.data.column import Grouping
    from nacreous.scaling.report.settings import Settings

__all__ = ["PAIR", "Pair"]


class Pair(Task[PairKeys]):
    """Two stimuli, of which one is chosen, or neither where a study allows ties.

    >>> PAIR.simulate([9.0, 0.0], 1.0, np.random.default_rng(1))
    'left'
    """

    name = "pair"
    called = "paired comparisons"
    places = ("left", "right")
    given = Literal["left", "right", "tie"]
    columns = (
        Column("left", "Label of the stimulus shown on the left."),
        Column("right", "Label of the stimulus shown on the right."),
        Column("chosen", "Which was chosen.", None, reading.CHOICES),
    )

    def items(
        self, asked: Asked[PairKeys], number: int, questions: Sequence[str], so_far: SoFar
    ) -> list[Items]:
        """Pairs, left and right as they are shown first."""
        return choice.choices(asked, number, questions, so_far)

    def again(self, stimuli: tuple[int, ...]) -> tuple[int, ...]:
        """The sides exchanged."""
        return stimuli[::-1]

    def catches(self, asked: Asked[PairKeys], question: str) -> list[tuple[int, ...]]:
        """The expected one on the left."""
        index = {label: place for place, label in enumerate(asked.labels)}
        return [
            (index[catch.expected], index[catch.against])
            for catch in asked.keys.catches
            if (catch.question or asked.questions[0]) == question
        ]

    def check(self, asked: Asked[PairKeys], given: Given) -> None:
        """One of the sides, or "tie" where the study has ties."""
        if given not in reading.CHOICES:
            allowed = ", ".join(reading.CHOICES)
            raise InputError(f"chosen is {ascii(given)[:60]}; allowed: {allowed}")
        if given == "tie" and not asked.keys.ties:
            raise InputError("chosen is 'tie'; allowed in this study: left, right")

    def missed(self, asked: Asked[PairKeys], row: Row) -> bool:
        """Whether the expected one was not chosen; a tie misses it too."""
        shown = reading.pair_of(row)
        expected = [
            catch.expected
            for catch in asked.keys.catches
            if (catch.question or asked.questions[0]) == row["question"]
            and {catch.expected, catch.against} == shown
        ]
        return reading.chosen_of(row) not in expected[-1:]

    def answers(self, columns: Mapping[str, Any], groups: Mapping[str, Grouping]) -> Answers:
        """As `nacreous.scaling` takes them."""
        return reading.answers(columns, groups)

    def adapts(self, asked: Asked[PairKeys]) -> bool:
        """Whether pairs are chosen while the study runs."""
        return self.chosen_by(asked) is not None

    def chosen_by(self, asked: Asked[PairKeys]) -> str | None:
        """The most telling pairs, or such drawn by lot."""
        return asked.keys.pairs.chosen_by

    def settings(self, chosen_by: str | None) -> Settings:
        """Of pairs chosen by the answers so far, a fit that these do not stretch."""
        return reading.settings(chosen_by)

    def so_far(self, asked: Asked[PairKeys], tally: Sequence[Tallied]) -> dict[str, Comparisons]:
        """How often each was chosen over each, by question."""
        return reading.comparisons(asked.labels, tally)

    def flags(self, asked: Asked[PairKeys], rows: pa.Table) -> dict[int, list[Flag]]:
        """Repeats, sides, circles and haste."""
        data = PairData.of_rows(rows, asked)
        del rows  # twice as large as what was made of it
        give_back()
        return consistent.consistency_flags(data, asked)

    def simulate(
        self, values: Sequence[float], sigma: float, random: np.random.Generator
    ) -> Literal["left", "right"]:
        """By Thurstone's case V: left with probability Phi((v_left - v_right) / sigma)."""
        left, right = values
        lead = (left - right) / sigma + random.standard_normal()
        return "left" if lead > 0 else "right"


#: The one pair; it holds nothing.
PAIR = Pair()

"""Choices in circles: a over b, b over c, and yet c over a, held against what chance makes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from nacreous.study.task.asked import Asked
from nacreous.study.task.flag import RATE, Flag
from nacreous.study.task.pair.chance import circles_by_chance
from nacreous.study.task.pair.expected import Shares
from nacreous.study.task.pair.keys import PairKeys
from nacreous.study.task.pair.reading import answers
from nacreous.study.task.row import Row

__all__ = ["circle_flags"]


def circle_flags(
    rows: Sequence[Row], asked: Asked[PairKeys], shares: Shares
) -> dict[int, list[Flag]]:
    """Too many circular triads, by person's number; all questions of a person count together.

    Only of people who have compared every pair under a question, for others have too few triads.
    """
    circular: dict[int, float] = {}
    most: dict[int, int] = {}
    by_chance: dict[int, np.typing.NDArray[np.int64]] = {}
    for place, (key, expected) in enumerate(shares.items()):
        complete = list(_complete(rows, asked, key))
        drawn = circles_by_chance(expected, place) if complete else np.zeros(0, np.int64)
        for number, found, possible in complete:
            circular[number] = circular.get(number, 0.0) + found
            most[number] = most.get(number, 0) + possible
            by_chance[number] = by_chance.get(number, 0) + drawn
    flags = {}
    for number, found in circular.items():
        as_many = by_chance[number] >= found
        if (1 + np.sum(as_many)) / (1 + len(as_many)) <= RATE:
            flags[number] = [Flag("circles", f"{found:g}/{most[number]}")]
    return flags


def _complete(
    rows: Sequence[Row], asked: Asked[PairKeys], key: tuple[str, bool]
) -> Iterator[tuple[int, float, int]]:
    """Who has compared all pairs under a question, their circular triads, the most there can be."""
    from nacreous.scaling import triads_by_person

    question, simulated = key
    own = [
        row
        for row in rows
        if row["kind"] == "pair" and row["question"] == question and row["simulated"] == simulated
    ]
    count = len(asked.labels)
    if count < 3 or not own:
        return
    for person in triads_by_person(answers(own, {})):
        triads = person.triads
        if triads.zeta is not None and len(triads.wins) == count:
            yield int(person.person), triads.circular, triads.most

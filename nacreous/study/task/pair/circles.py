"""Choices in circles: a over b, b over c, and yet c over a, held against what chance makes."""

from __future__ import annotations

from collections.abc import Iterator
from math import comb

import numpy as np

from nacreous.scaling.check.triads import circular_of, most_circular
from nacreous.study.task.asked import Asked
from nacreous.study.task.flag import RATE, Flag
from nacreous.study.task.pair.chance import circles_by_chance
from nacreous.study.task.pair.data import PairData
from nacreous.study.task.pair.expected import Shares
from nacreous.study.task.pair.keys import PairKeys

__all__ = ["circle_flags"]


def circle_flags(data: PairData, asked: Asked[PairKeys], shares: Shares) -> dict[int, list[Flag]]:
    """Too many circular triads, by person's number; all questions of a person count together.

    Only of people who have compared every pair under a question, for others have too few triads.
    """
    circular: dict[int, float] = {}
    most: dict[int, int] = {}
    by_chance: dict[int, np.typing.NDArray[np.int64]] = {}
    for place, ((question, simulated), expected) in enumerate(shares.items()):
        of = asked.questions.index(question)
        complete = list(_complete(data, len(asked.labels), of, simulated))
        drawn = circles_by_chance(expected, place) if complete else np.zeros(0, np.int64)
        for number, found in complete:
            circular[number] = circular.get(number, 0.0) + found
            most[number] = most.get(number, 0) + most_circular(len(asked.labels))
            by_chance[number] = by_chance.get(number, 0) + drawn
    flags = {}
    for number, found in circular.items():
        as_many = by_chance[number] >= found
        if (1 + np.sum(as_many)) / (1 + len(as_many)) <= RATE:
            flags[number] = [Flag("circles", f"{found:g}/{most[number]}")]
    return flags


def _complete(
    data: PairData, count: int, question: int, simulated: bool
) -> Iterator[tuple[int, float]]:
    """Who has compared all pairs of so many stimuli under a question, and their circular triads."""
    if count < 3:
        return
    for number, all_answers in data.by_person():
        here = (all_answers.question == question) & (all_answers.simulated == simulated)
        own = all_answers.take(np.flatnonzero(here & ~all_answers.repeat))
        if len(own.person) < comb(count, 2):
            continue
        pairs, at = np.unique(own.pair(count), return_inverse=True)
        if len(pairs) < comb(count, 2):
            continue
        lead = np.bincount(at, own.first_won)
        beats = np.where(lead == 0, 0.5, lead > 0)
        wins = np.bincount(pairs // count, beats, count).astype(np.float64)
        wins += np.bincount(pairs % count, 1 - beats, count)
        yield number, circular_of(wins, int(np.count_nonzero(lead == 0)))

"""One trial: a question about two stimuli."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

__all__ = ["Kind", "Trial", "repetitions"]

Kind = Literal["training", "pair", "repeat", "catch"]


@dataclass(frozen=True)
class Trial:
    """A question about two stimuli, at its place in the sitting.

    number: counted from 0. question: its id. left, right: labels. kind: a "repeat" is a pair shown
    before, the sides exchanged; answers to "training" do not count. block: 0 for the training,
    then one more after each break and with each new question. break_before: whether a break comes
    first.
    """

    number: int
    question: str
    left: str
    right: str
    kind: Kind
    block: int
    break_before: bool


def repetitions(trials: Sequence[Trial]) -> int:
    """How often a stimulus is in a trial and in the next one too; 0 where that can be.

    With fewer than five stimuli it cannot: of three, any two pairs share one.

    >>> trials = [
    ...     Trial(0, "deeper", "a", "b", "pair", 1, False),
    ...     Trial(1, "deeper", "b", "c", "pair", 1, False),
    ... ]
    >>> repetitions(trials)
    1
    """
    return sum(
        not {now.left, now.right}.isdisjoint((after.left, after.right))
        for now, after in pairwise(trials)
    )

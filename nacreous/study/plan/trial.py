"""One trial: a question about some stimuli."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from nacreous.study.task.counting import Kind

__all__ = ["Trial", "repetitions"]


@dataclass(frozen=True)
class Trial:
    """A question about some stimuli, at its place in the sitting.

    number: counted from 0. question: its id. stimuli: labels, in the order of the task's
    places; of a pair left and right. kind: a "repeat" was shown before, a pair then with its sides
    exchanged; answers to "training" do not count. block: 0 for the training,
    then one more after each break and with each new question. break_before: whether a break comes
    first.
    """

    number: int
    question: str
    stimuli: tuple[str, ...]
    kind: Kind
    block: int
    break_before: bool


def repetitions(trials: Sequence[Trial]) -> int:
    """How often a stimulus is in a trial and in the next one too; 0 where that can be.

    Pairs of fewer than five stimuli cannot: of three, any two pairs share one.

    >>> trials = [
    ...     Trial(0, "deeper", ("a", "b"), "pair", 1, False),
    ...     Trial(1, "deeper", ("b", "c"), "pair", 1, False),
    ... ]
    >>> repetitions(trials)
    1
    """
    return sum(not set(now.stimuli).isdisjoint(after.stimuli) for now, after in pairwise(trials))

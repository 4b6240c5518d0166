"""What a task is told of the study in which it is asked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

__all__ = ["Asked"]

K = TypeVar("K")


@dataclass(frozen=True)
class Asked(Generic[K]):
    """A study as a task sees it.

    seed: of every lot. labels: of all stimuli, in the order of the file. questions: their ids.
    keys: the task's own, as its folder declares them.
    """

    seed: int
    labels: tuple[str, ...]
    questions: tuple[str, ...]
    keys: K

"""What a study's file says of its pairs."""

from __future__ import annotations

from dataclasses import dataclass

from nacreous.study.task.pair.catch import Catch
from nacreous.study.task.pair.pairs import Pairs

__all__ = ["PairKeys"]


@dataclass(frozen=True)
class PairKeys:
    """The keys of pairs. ties: whether "no difference" may be answered."""

    pairs: Pairs
    catches: tuple[Catch, ...]
    ties: bool

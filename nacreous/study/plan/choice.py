"""Which pairs a participant sees, and which of each stands on the left."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.planning.design import random_design
from nacreous.scaling.planning.selection import next_pairs
from nacreous.scaling.planning.sequence import balanced_sides
from nacreous.study.design.design import Design
from nacreous.study.plan.random_streams import PAIRS, TELLING, stream

__all__ = ["Choice", "choices", "chosen"]

Pairs = NDArray[np.int64]


@dataclass(frozen=True)
class Choice:
    """Pairs as int64 [pair, 2], left and right when shown first, as indices of labels.

    The first `repeated` of them are shown once more, the sides exchanged.
    """

    pairs: Pairs
    repeated: int

    def mirrored(self) -> Choice:
        """The same with left and right exchanged."""
        return Choice(self.pairs[:, ::-1], self.repeated)


def choices(
    design: Design, number: int, questions: list[str], so_far: Mapping[str, Comparisons]
) -> list[Choice]:
    """The pairs of a participant under each question, in the order in which they are asked."""
    if design.pairs.kind == "adaptive":
        random = stream(design, TELLING, number)
        return [_telling(design, so_far.get(question), random) for question in questions]
    # Under every other question mirrored, which evens out the one that an odd number leaves.
    choice = chosen(design, number)
    return [choice.mirrored() if place % 2 else choice for place in range(len(questions))]


def chosen(design: Design, number: int) -> Choice:
    """The pairs of a participant; those of numbers 2k and 2k + 1 are the same, mirrored.

    Pairs shown twice have each stimulus once on either side. The others are placed so that each
    stimulus is as often on the left as on the right, or once more where their number is odd.
    """
    random = stream(design, PAIRS, number // 2)
    choice = _placed(design, _undirected(design, random), random)
    return choice.mirrored() if number % 2 else choice


def _telling(design: Design, counts: Comparisons | None, random: np.random.Generator) -> Choice:
    """The pairs that tell most after the answers so far, placed as the others are.

    Without answers they are pairs that join all stimuli, drawn by lot.
    """
    if counts is None:
        return _placed(design, _drawn(design, random), random)
    index = {label: place for place, label in enumerate(design.labels)}
    found = next_pairs(
        counts,
        design.pairs.number or 1,
        stimuli=design.labels,
        seed=int(random.integers(2**62)),
        distinct=True,
    )
    pairs = [sorted((index[pair.left], index[pair.right])) for pair in found]
    return _placed(design, np.array(pairs, dtype=np.int64), random)


def _placed(design: Design, pairs: Pairs, random: np.random.Generator) -> Choice:
    pairs = random.permutation(pairs, axis=0)
    repeated = design.pairs.repeated(len(pairs))
    parts = [part for part in (pairs[:repeated], pairs[repeated:]) if len(part)]
    count = len(design.labels)
    sided = np.concatenate([balanced_sides(part, count, random) for part in parts])
    return Choice(sided, repeated)


def _undirected(design: Design, random: np.random.Generator) -> Pairs:
    if design.pairs.kind == "all":
        return np.stack(np.triu_indices(len(design.labels), 1), axis=1).astype(np.int64)
    return _drawn(design, random)


def _drawn(design: Design, random: np.random.Generator) -> Pairs:
    """Pairs by lot that join all stimuli."""
    number = design.pairs.number or 1
    drawn = random_design(len(design.labels), number, int(random.integers(2**62)))
    return np.sort(np.stack([drawn.left, drawn.right], axis=1), axis=1)

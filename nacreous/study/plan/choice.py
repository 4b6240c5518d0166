"""Which pairs a participant sees, and which of each stands on the left."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.planning.design import random_design
from nacreous.scaling.planning.sequence import balanced_sides
from nacreous.study.design.design import Design
from nacreous.study.plan.stream import PAIRS, stream

__all__ = ["Choice", "chosen"]

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


def chosen(design: Design, number: int) -> Choice:
    """The pairs of a participant; those of numbers 2k and 2k + 1 are the same, mirrored.

    Pairs shown twice have each stimulus once on either side. The others are placed so that each
    stimulus is as often on the left as on the right, or once more where their number is odd.
    """
    random = stream(design, PAIRS, number // 2)
    count = len(design.labels)
    pairs = random.permutation(_undirected(design, count, random), axis=0)
    repeated = design.pairs.repeated(len(pairs))
    parts = [part for part in (pairs[:repeated], pairs[repeated:]) if len(part)]
    sided = np.concatenate([balanced_sides(part, count, random) for part in parts])
    choice = Choice(sided, repeated)
    return choice.mirrored() if number % 2 else choice


def _undirected(design: Design, count: int, random: np.random.Generator) -> Pairs:
    kind = design.pairs.kind
    if kind == "adaptive":
        raise InputError(
            'pairs.kind is "adaptive", for which there is no plan yet; allowed for now: "all", '
            '"incomplete"'
        )
    if kind == "all" or design.pairs.number is None:
        return np.stack(np.triu_indices(count, 1), axis=1).astype(np.int64)
    drawn = random_design(count, design.pairs.number, int(random.integers(2**62)))
    return np.sort(np.stack([drawn.left, drawn.right], axis=1), axis=1)

"""Which pairs a participant sees, and which of each stands on the left."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.planning.design import random_design
from nacreous.scaling.planning.selection import next_pairs
from nacreous.scaling.planning.sequence import balanced_sides
from nacreous.study.random_streams import PAIRS, TELLING, stream
from nacreous.study.task.asked import Asked
from nacreous.study.task.pair.keys import PairKeys
from nacreous.study.task.task import Items

__all__ = ["choices", "chosen"]

Pairs = NDArray[np.int64]


def choices(
    asked: Asked[PairKeys],
    number: int,
    questions: Sequence[str],
    so_far: Mapping[str, Comparisons],
) -> list[Items]:
    """The pairs of a participant under each question, in the order in which they are asked."""
    if asked.keys.pairs.chosen_by is not None:
        random = stream(asked.seed, TELLING, number)
        return [_telling(asked, so_far.get(question), random) for question in questions]
    # Under every other question mirrored, which evens out the one that an odd number leaves.
    choice = chosen(asked, number)
    return [_mirrored(choice) if place % 2 else choice for place in range(len(questions))]


def chosen(asked: Asked[PairKeys], number: int) -> Items:
    """The pairs of a participant; those of numbers 2k and 2k + 1 are the same, mirrored.

    Pairs shown twice have each stimulus once on either side. The others are placed so that each
    stimulus is as often on the left as on the right, or once more where their number is odd.
    """
    random = stream(asked.seed, PAIRS, number // 2)
    choice = _placed(asked, _undirected(asked, random), random)
    return _mirrored(choice) if number % 2 else choice


def _mirrored(choice: Items) -> Items:
    """The same with left and right exchanged."""
    return Items(choice.stimuli[:, ::-1], choice.repeated)


def _telling(
    asked: Asked[PairKeys], counts: Comparisons | None, random: np.random.Generator
) -> Items:
    """The pairs that tell much after the answers so far, placed as the others are.

    Without answers they are pairs that join all stimuli, drawn by lot.
    """
    if counts is None:
        return _placed(asked, _drawn(asked, random), random)
    index = {label: place for place, label in enumerate(asked.labels)}
    found = next_pairs(
        counts,
        asked.keys.pairs.number or 1,
        stimuli=asked.labels,
        method=asked.keys.pairs.chosen_by or "greedy",
        seed=int(random.integers(2**62)),
        distinct=True,
    )
    pairs = [sorted((index[pair.left], index[pair.right])) for pair in found]
    return _placed(asked, np.array(pairs, dtype=np.int64), random)


def _placed(asked: Asked[PairKeys], pairs: Pairs, random: np.random.Generator) -> Items:
    pairs = random.permutation(pairs, axis=0)
    repeated = asked.keys.pairs.repeated(len(pairs))
    parts = [part for part in (pairs[:repeated], pairs[repeated:]) if len(part)]
    count = len(asked.labels)
    sided = np.concatenate([balanced_sides(part, count, random) for part in parts])
    return Items(sided, repeated)


def _undirected(asked: Asked[PairKeys], random: np.random.Generator) -> Pairs:
    if asked.keys.pairs.kind == "all":
        return np.stack(np.triu_indices(len(asked.labels), 1), axis=1).astype(np.int64)
    return _drawn(asked, random)


def _drawn(asked: Asked[PairKeys], random: np.random.Generator) -> Pairs:
    """Pairs by lot that join all stimuli."""
    number = asked.keys.pairs.number or 1
    drawn = random_design(len(asked.labels), number, int(random.integers(2**62)))
    return np.sort(np.stack([drawn.left, drawn.right], axis=1), axis=1)

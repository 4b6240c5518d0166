"""Answers or counts of several groups, put together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.given import comparisons_of
from nacreous.unchanging import released

__all__ = ["pooled"]


def pooled(groups: Mapping[str, Any], same_people: bool = False) -> Answers | Comparisons:
    """All groups' data as one; as answers where all of them are and know their people.

    same_people: whether a label that is in two groups is one person.
    """
    parts = [data for data in groups.values() if isinstance(data, Answers)]
    if len(parts) == len(groups) and all(part.person is not None for part in parts):
        return _answers(parts, list(groups), same_people)
    return _comparisons([comparisons_of(data) for data in groups.values()])


def _answers(parts: list[Answers], names: list[str], same_people: bool) -> Answers:
    number: dict[str, int] = {}
    person = []
    for name, part in zip(names, parts, strict=True):
        labels = [label if same_people else f"{name}: {label}" for label in part.people]
        own = np.array([number.setdefault(label, len(number)) for label in labels], np.int64)
        if part.person is not None:
            person.append(own[part.person])
    return Answers(
        stimuli=parts[0].stimuli,
        left=released(np.concatenate([part.left for part in parts])),
        right=released(np.concatenate([part.right for part in parts])),
        outcome=released(np.concatenate([part.outcome for part in parts])),
        people=tuple(number),
        person=released(np.concatenate(person)),
        groups={},
        response_s=None,
        time=None,
        sided=all(part.sided for part in parts),
    )


def _comparisons(parts: list[Comparisons]) -> Comparisons:
    """Counts added pair by pair."""
    stimuli, size = parts[0].stimuli, len(parts[0].stimuli)
    sided = all(part.sided for part in parts)
    left, right, left_wins, right_wins, ties = (
        np.concatenate([getattr(part, name) for part in parts])
        for name in ("left", "right", "left_wins", "right_wins", "ties")
    )
    if not sided:
        turned = left > right
        left, right = np.where(turned, right, left), np.where(turned, left, right)
        left_wins, right_wins = (
            np.where(turned, right_wins, left_wins),
            np.where(turned, left_wins, right_wins),
        )
    pairs, row = np.unique(left * size + right, return_inverse=True)

    def added(counts: np.ndarray) -> np.ndarray:
        return np.bincount(row, counts, len(pairs))

    return Comparisons(
        stimuli=stimuli,
        left=pairs // size,
        right=pairs % size,
        left_wins=added(left_wins),
        right_wins=added(right_wins),
        ties=added(ties),
        sided=sided,
    )

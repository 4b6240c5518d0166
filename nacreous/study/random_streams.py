"""Random numbers of a study, each kind from a stream of its own."""

from __future__ import annotations

import numpy as np

from nacreous.number import whole_of

__all__ = ["ALLOCATION", "ORDER", "PAIRS", "TELLING", "numbered", "stream"]

#: What a stream is for. New ones come at the end, so that the others stay what they are.
PAIRS, ORDER, ALLOCATION, TELLING = range(4)
#: More participants than any study has.
_MOST_PEOPLE = 10_000_000


def stream(seed: int, purpose: int, number: int) -> np.random.Generator:
    """The random numbers of a study's seed for one purpose and one participant, or one group."""
    return np.random.default_rng([seed, purpose, number])


def numbered(number: int) -> int:
    """A participant's number, checked.

    >>> numbered(-1)
    Traceback (most recent call last):
    nacreous.problem.InputError: number is -1; allowed: a whole number, 0 to 9999999
    """
    return whole_of("number", number, 0, _MOST_PEOPLE - 1)

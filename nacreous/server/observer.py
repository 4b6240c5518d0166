"""A simulated observer: what somebody who is not there would choose."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

import numpy as np

__all__ = ["Choice", "choices"]

#: The median of the response times that are made up **(ours)**, and their spread as a logarithm.
_MEDIAN_MS, _SPREAD = 1800.0, 0.45


class Choice(NamedTuple):
    """What was chosen at a trial, and after how long."""

    trial: int
    chosen: str
    response_ms: int


def choices(
    trials: Iterable[tuple[int, str, str]],
    values: Mapping[str, float],
    number: int,
    *,
    seed: int,
    sigma: float,
) -> Iterator[Choice]:
    """Choices by Thurstone's case V, of participant `number`; same seed and number, same choices.

    trials: number, left and right of each. values: of left and right, on the scale. sigma: the
    noise of a comparison, in its unit: left is chosen with probability
    Phi((v_left - v_right) / sigma). Raises `KeyError` for what has no value.

    >>> [one] = choices([(0, "a", "b")], {"a": 9.0, "b": 0.0}, 0, seed=1, sigma=1.0)
    >>> one.chosen
    'left'
    """
    random = np.random.default_rng([seed, 1, number])
    for trial, left, right in trials:
        lead = (values[left] - values[right]) / sigma + random.standard_normal()
        response_ms = round(_MEDIAN_MS * float(np.exp(_SPREAD * random.standard_normal())))
        yield Choice(trial, "left" if lead > 0 else "right", response_ms)

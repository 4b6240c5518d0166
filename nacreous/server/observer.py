"""A simulated observer: what somebody who is not there would answer."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from nacreous.study.task.response import Response
from nacreous.study.task.task import Task

__all__ = ["responses"]

#: The median of the response times that are made up **(ours)**, and their spread as a logarithm.
_MEDIAN_MS, _SPREAD = 1800.0, 0.45


def responses(
    task: Task[Any],
    trials: Iterable[Sequence[str]],
    values: Mapping[str, float],
    number: int,
    *,
    seed: int,
    sigma: float,
) -> Iterator[Response]:
    """The responses of participant `number`; same seed and number, same responses.

    trials: what each shows, by place. values: of what is shown, on the scale. sigma: the noise of
    an answer, in its unit, as `Task.simulate` has it. Raises `KeyError` for what has no value.

    >>> from nacreous.study.task.tasks import TASKS
    >>> [one] = responses(
    ...     TASKS["pair"], [("a", "b")], {"a": 9.0, "b": 0.0}, 0, seed=1, sigma=1.0
    ... )
    >>> one.given, one.simulated
    ('left', True)
    """
    random = np.random.default_rng([seed, 1, number])
    for shown in trials:
        given = task.simulate([values[stimulus] for stimulus in shown], sigma, random)
        response_ms = round(_MEDIAN_MS * float(np.exp(_SPREAD * random.standard_normal())))
        yield Response(given, response_ms, simulated=True)

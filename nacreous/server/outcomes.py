"""What takes seconds to work out: in a thread, one at a time, and kept while nothing changes."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Hashable
from typing import Any, TypeVar

# What marks and scales are worked out with takes a second to load; now, and not among answers.
import scipy.stats  # noqa: F401
from starlette.concurrency import run_in_threadpool

T = TypeVar("T")


class Outcomes:
    """Values by a key, each with the state of the store for which it was worked out.

    >>> async def twice():
    ...     outcomes = Outcomes()
    ...     first = await outcomes.get("scale", 12, lambda: ["a scale of 12 answers"])
    ...     return first is await outcomes.get("scale", 12, lambda: ["worked out again"])
    >>> asyncio.run(twice())
    True
    """

    def __init__(self) -> None:
        self._one = asyncio.Lock()
        self._kept: dict[Hashable, tuple[Hashable, float, Any]] = {}

    async def get(
        self, key: Hashable, state: Hashable, work: Callable[[], T], stale_s: float = 0.0
    ) -> T:
        """The value for this state, or one that is `stale_s` old at most."""
        async with self._one:
            kept = self._kept.get(key)
            now = time.monotonic()
            if kept is not None and (kept[0] == state or now - kept[1] < stale_s):
                value: T = kept[2]
                return value
            value = await run_in_threadpool(work)
            self._kept[key] = (state, time.monotonic(), value)
            return value

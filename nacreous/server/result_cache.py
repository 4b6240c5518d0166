"""What takes seconds to work out: one thing at a time, and kept while nothing changes."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable, Hashable
from dataclasses import dataclass
from typing import Any, TypeVar

T = TypeVar("T")

#: So many times as long as it took to work out is a value good for, while answers come in: pages
#: that look every few seconds take a sixth of a processor at most.
_GOOD_FOR = 5


@dataclass(frozen=True)
class _Kept:
    """A value, the state of the store for which it was worked out, and until when it is good."""

    value: Any
    state: Hashable
    until: float

    def is_due(self, state: Hashable) -> bool:
        """Whether it is to be worked out anew."""
        return self.state != state and time.monotonic() >= self.until


class ResultCache:
    """Values by a key, for the pages that look at them.

    >>> async def scale():
    ...     return ["a scale"]
    >>> async def twice():
    ...     cache = ResultCache()
    ...     first = await cache.get("scale", 12, scale)
    ...     return first is await cache.get("scale", 12, scale)
    >>> asyncio.run(twice())
    True
    """

    def __init__(self) -> None:
        self._one = asyncio.Lock()
        self._kept: dict[Hashable, _Kept] = {}
        self._beside: dict[Hashable, asyncio.Task[Any]] = {}

    async def get(
        self,
        key: Hashable,
        state: Hashable,
        work: Callable[[], Awaitable[T]],
        good_for: int = _GOOD_FOR,
    ) -> T:
        """The value for this state, or for one that was a moment ago; of this with good_for 0.

        Where something else is being worked out, as a report of a large study is for long, what may
        be of a moment ago is not waited for.
        """
        kept = self._kept.get(key)
        if kept is not None and good_for and self._one.locked():
            last: T = kept.value
            return last
        async with self._one:
            kept = self._kept.get(key)
            if kept is None or kept.is_due(state):
                begin = time.monotonic()
                made = await work()
                end = time.monotonic()
                kept = self._kept[key] = _Kept(made, state, end + good_for * (end - begin))
            value: T = kept.value
            return value

    def so_far(self, key: Hashable, state: Hashable, work: Callable[[], Awaitable[T]]) -> T | None:
        """The value that is there, of whatever moment, at once; None before there is one.

        Where `get` would work it out, that is begun, and goes on beside whoever asked. If it fails,
        who asks next hears why, and after that it is tried again.
        """
        beside = self._beside.get(key)
        if beside is None or beside.done():
            if beside is not None:
                self._beside.pop(key).result()
            kept = self._kept.get(key)
            if kept is None or kept.is_due(state):
                self._beside[key] = asyncio.create_task(self.get(key, state, work))
        kept = self._kept.get(key)
        return None if kept is None else kept.value

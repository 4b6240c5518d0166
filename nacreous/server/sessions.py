"""Who answers, remembered for some seconds, so that an answer waits for no reading."""

from __future__ import annotations

import hashlib
import time
from collections import OrderedDict
from collections.abc import Callable
from threading import Lock

from anyio import CapacityLimiter, to_thread

from nacreous.study.running import Running
from nacreous.study.store import Session

#: How long, in seconds. What this server changes is forgotten at once; whether somebody may still
#: answer whom another program erased is asked again where the answer is stored.
_FRESH_S = 10.0
_MOST = 8192
#: Readings at once: as many as keep the processors busy, and no more connections than that.
_READINGS = 4


class Sessions:
    """Sessions by token, of which a hash is kept. Safe to share among threads."""

    def __init__(self, running: Running, clock: Callable[[], float] = time.monotonic) -> None:
        self._running = running
        self._clock = clock
        self._lock = Lock()
        self._kept: OrderedDict[bytes, tuple[float, Session]] = OrderedDict()
        self._changes = 0
        self._readings: CapacityLimiter | None = None

    async def find(self, token: str) -> Session:
        """The session as it was a moment ago, or as it is now."""
        session = self.get(token)
        if session is not None:
            return session
        if self._readings is None:
            self._readings = CapacityLimiter(_READINGS)  # which belongs to an event loop
        return await to_thread.run_sync(self.read, token, limiter=self._readings)

    def get(self, token: str) -> Session | None:
        """The session, if it was read a moment ago."""
        with self._lock:
            since, session = self._kept.get(_hash(token), (0.0, None))
        return session if self._clock() - since < _FRESH_S else None

    def read(self, token: str) -> Session:
        """The session as it is now. Reads the store: for threads alone."""
        before = self._changes
        since = self._clock()
        session = self._running.session_of(token)
        with self._lock:
            if self._changes == before:  # or it was changed while it was read
                self._kept[_hash(token)] = (since, session)
                self._kept.move_to_end(_hash(token))
                if len(self._kept) > _MOST:
                    self._kept.popitem(last=False)
        return session

    def forget(self, token: str | None = None) -> None:
        """After a change: of one session, or of any."""
        with self._lock:
            self._changes += 1
            if token is None:
                self._kept.clear()
            else:
                self._kept.pop(_hash(token), None)


def _hash(token: str) -> bytes:
    return hashlib.sha256(token.encode()).digest()

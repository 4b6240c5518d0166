"""One connection of a browser: the head of each request comes soon, and is short."""

from __future__ import annotations

import asyncio
from typing import Any

from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

#: Seconds until the head of a request is there, from the connection or its first byte.
SLOWEST_HEAD_S = 20.0
#: Bytes of a head that comes in pieces; whole at once it may have as many as are read at once.
LARGEST_HEAD = 32_768


class Connection(HttpToolsProtocol):
    """uvicorn's connection, which would wait for ever for a head, and for one of any length."""

    _waiting: asyncio.TimerHandle | None = None
    _head = 0

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Somebody is there; a request is wanted."""
        super().connection_made(transport)
        self._await_head()

    def connection_lost(self, exc: Exception | None) -> None:
        """Nobody is there any more."""
        self._stop_waiting()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Read on; a head that is still not whole counts."""
        super().data_received(data)
        if self._waiting is not None:
            self._head += len(data)
            if self._head > LARGEST_HEAD:
                self._close()

    def on_message_begin(self) -> None:
        """The first byte of a request."""
        super().on_message_begin()
        self._await_head()

    def on_headers_complete(self) -> None:
        """The head is whole."""
        self._stop_waiting()
        super().on_headers_complete()

    def _await_head(self) -> None:
        self._stop_waiting()
        self._waiting = self.loop.call_later(SLOWEST_HEAD_S, self._close)

    def _stop_waiting(self) -> None:
        self._head = 0
        if self._waiting is not None:
            self._waiting.cancel()
            self._waiting = None

    def _close(self, *_: Any) -> None:
        self._stop_waiting()
        self.transport.abort()

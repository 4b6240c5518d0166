"""The body of a request, read whole and never more than is allowed."""

from __future__ import annotations

import asyncio

from starlette.datastructures import Headers
from starlette.requests import ClientDisconnect
from starlette.types import Receive

from nacreous.server.refusal import Refusal

#: Bytes of a body at most, and seconds until it is there.
LARGEST = 65_536
SLOWEST_S = 10.0

#: The connection is not used again, for the rest of the body is still on its way.
_CLOSE = {"Connection": "close"}


async def read_body(headers: Headers, receive: Receive) -> bytes:
    """All of it; refused as soon as it is known to be too long, or when it takes too long."""
    declared = headers.get("content-length", "")
    if declared.isascii() and declared.isdigit() and int(declared[:20]) > LARGEST:
        raise _too_large()
    try:
        async with asyncio.timeout(SLOWEST_S):
            return await _read(receive)
    except TimeoutError:
        told = f"the body did not come within {SLOWEST_S:.0f} s"
        raise Refusal(408, "input", told, _CLOSE) from None


async def _read(receive: Receive) -> bytes:
    parts = bytearray()
    while True:
        message = await receive()
        if message["type"] == "http.disconnect":
            raise ClientDisconnect
        parts += message.get("body", b"")
        if len(parts) > LARGEST:
            raise _too_large()
        if not message.get("more_body", False):
            return bytes(parts)


def _too_large() -> Refusal:
    return Refusal(413, "input", f"the body is too large; allowed: {LARGEST} bytes", _CLOSE)

"""What every request passes on its way in, and every response on its way out."""

from __future__ import annotations

import logging

from starlette.datastructures import Headers
from starlette.requests import ClientDisconnect
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from nacreous.server.body import read_body
from nacreous.server.headers import guard
from nacreous.server.origin import SAFE, check_content, check_origin
from nacreous.server.refusal import Refusal, refusal_of
from nacreous.server.service import Service

_LOG = logging.getLogger(__name__)


class GuardMiddleware:
    """Reads changes whole and sees where they come from; tells every problem in one form."""

    def __init__(self, app: ASGIApp, service: Service) -> None:
        self._app = app
        self._service = service

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Let one request through."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        scope.setdefault("state", {})
        started = False

        async def guarded(message: Message) -> None:
            nonlocal started
            if message["type"] == "http.response.start":
                started = True
                guard(message, https=self._service.is_https(scope))
            await send(message)

        try:
            self._service.hosts.check(Headers(scope=scope), scope.get("server"))
            if scope["method"] not in SAFE:
                receive = await self._checked(scope, receive)
            await self._app(scope, receive, guarded)
        except ClientDisconnect:
            return
        except Exception as problem:
            if started:
                raise
            response = await self._service.refuse(scope, _told(problem))
            await response(scope, receive, guarded)

    async def _checked(self, scope: Scope, receive: Receive) -> Receive:
        """A change: from our own pages, of a bearable size, and JSON."""
        headers = Headers(scope=scope)
        check_origin(headers, scope["scheme"], self._service.origin)
        body = await read_body(headers, receive)
        check_content(headers, body)
        unread = [body]

        async def replay() -> Message:
            if unread:
                return {"type": "http.request", "body": unread.pop(), "more_body": False}
            return await receive()

        return replay


def _told(problem: Exception) -> Refusal:
    refusal = refusal_of(problem)
    if refusal is None:
        _LOG.error("a request failed", exc_info=problem)
        return Refusal(500, "fault", "something went wrong in the server; its log says what")
    return refusal

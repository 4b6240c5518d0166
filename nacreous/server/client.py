"""One line to a study's server, for programs: asks again where a browser would."""

from __future__ import annotations

import http.client
import json
import time
from typing import Any
from urllib.parse import urlsplit

from nacreous.problem import InputError

__all__ = ["Client", "RefusedError"]

#: How long somebody who is asked to wait goes on asking.
_PATIENCE_S = 300.0
_TIMEOUT_S = 30.0
#: Broken connections in a row after which nobody is there.
_MOST_BROKEN = 5


class RefusedError(InputError):
    """The server said no. `status`: of HTTP."""

    def __init__(self, problem: str, status: int) -> None:
        super().__init__(problem)
        self.status = status


class Client:
    """A connection that is kept open; not to be shared among threads.

    >>> Client("gopher://lab").ask("GET", "/api/study")
    Traceback (most recent call last):
    nacreous.problem.InputError: url is 'gopher://lab'; allowed: http://... or https://...
    """

    def __init__(self, url: str) -> None:
        parts = urlsplit(url)
        try:
            port = parts.port
        except ValueError:
            port = 0
        if parts.scheme not in ("http", "https") or not parts.hostname or port == 0:
            raise InputError(f"url is {url!a}; allowed: http://... or https://...")
        kind = (
            http.client.HTTPSConnection if parts.scheme == "https" else http.client.HTTPConnection
        )
        self.url = url
        self._base = parts.path.rstrip("/")
        self._line = kind(parts.hostname, port, timeout=_TIMEOUT_S)

    def close(self) -> None:
        """Hang up."""
        self._line.close()

    def ask(self, method: str, path: str, token: str | None = None, content: Any = None) -> Any:
        """What the server answers, from JSON; None where it answers nothing.

        Waits and asks again where the server is busy, and where a connection breaks: so this is for
        what may be asked twice. Raises `RefusedError` where the server refuses, `InputError` where
        nobody is there.
        """
        until = time.monotonic() + _PATIENCE_S
        broken = 0
        while True:
            try:
                status, wait_s, answer = self._once(method, path, token, content)
            except (OSError, http.client.HTTPException) as problem:
                self._line.close()
                broken += 1
                if broken == _MOST_BROKEN:
                    reason = getattr(problem, "strerror", None) or type(problem).__name__
                    raise InputError(f"{self.url}: nobody answers ({reason})") from None
                time.sleep(0.1 * 2**broken)
                continue
            broken = 0
            if status < 400:
                return answer
            if status not in (429, 503) or time.monotonic() + wait_s > until:
                raise RefusedError(f"{self.url}: {_said(answer, status)}", status)
            time.sleep(wait_s)

    def _once(
        self, method: str, path: str, token: str | None, content: Any
    ) -> tuple[int, float, Any]:
        """Status, seconds to wait, and what was answered."""
        headers = {"Accept": "application/json"}
        body = None
        if method != "GET":
            body = json.dumps({} if content is None else content)
            headers["Content-Type"] = "application/json"
        if token is not None:
            headers["Authorization"] = f"Bearer {token}"
        self._line.request(method, self._base + path, body, headers)
        response = self._line.getresponse()
        text = response.read()
        try:
            wait_s = float(response.headers.get("Retry-After", "1"))
        except ValueError:
            wait_s = 1.0
        try:
            return response.status, wait_s, json.loads(text) if text else None
        except ValueError:
            return response.status, wait_s, None


def _said(answer: Any, status: int) -> str:
    problem = answer.get("problem") if isinstance(answer, dict) else None
    return str(problem) if problem else f"answers {status}, which no study's server does"

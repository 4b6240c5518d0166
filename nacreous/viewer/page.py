"""The page's files, as an application that a server serves: read once, and nothing else."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from starlette.datastructures import Headers
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from nacreous.problem import InputError
from nacreous.server.built import cure
from nacreous.server.headers import POLICY as STUDY_POLICY

__all__ = ["FOLDER", "POLICY", "Page"]

#: Where the page is built.
FOLDER = Path(__file__).parent / "page"

_INDEX = "index.html"
#: As on the study's pages, but that WebAssembly runs and that other pages may show this one.
POLICY = STUDY_POLICY.replace(
    "script-src 'self'", "script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'"
).replace("; frame-ancestors 'none'", "")

_ALWAYS = {
    "Content-Security-Policy": POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Permissions-Policy": "camera=(), microphone=(), geolocation=()",
}
#: Of our own: what a system takes .js or .wasm for may be changed by any program on it.
_KINDS = {
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".ico": "image/x-icon",
    ".jpg": "image/jpeg",
    ".js": "text/javascript; charset=utf-8",
    ".json": "application/json",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".txt": "text/plain; charset=utf-8",
    ".wasm": "application/wasm",
    ".webp": "image/webp",
    ".woff2": "font/woff2",
}
#: This machine, as its own browsers call it: another site's name that leads here is none of these,
#: or a page elsewhere could count as ours.
_HOST = re.compile(r"(?:127\.0\.0\.1|localhost|\[::1\])(?::[0-9]{1,5})?", re.IGNORECASE)
#: Names of assets have their hash in them.
_FOR_EVER = "public, max-age=31536000, immutable"


class Page:
    """An ASGI application of every file of the built page, in memory, by its path."""

    def __init__(self, folder: Path = FOLDER) -> None:
        self._files: Mapping[str, bytes] = {
            path.relative_to(folder).as_posix(): path.read_bytes()
            for path in folder.rglob("*")
            if path.is_file()
        }
        if _INDEX not in self._files:
            raise InputError(
                f"the viewer's files are missing ({folder / _INDEX} does not exist): "
                f"{cure('viewer')}"
            )

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request."""
        if scope["type"] == "http":
            await self._response(scope)(scope, receive, send)

    def _response(self, scope: Scope) -> Response:
        called = Headers(scope=scope).getlist("host")
        if len(called) > 1 or not all(map(_HOST.fullmatch, called)):
            return _plain(400, "Host is not this machine's; wanted: 127.0.0.1 or localhost")
        if scope["method"] not in ("GET", "HEAD"):
            return _plain(405, "wanted: GET or HEAD")
        name = scope["path"].removeprefix("/") or _INDEX
        if name not in self._files:
            return _plain(404, "there is no such file")
        kept = _FOR_EVER if name.startswith("assets/") else "no-cache"
        kind = _KINDS.get(PurePosixPath(name).suffix.lower(), "application/octet-stream")
        headers = {**_ALWAYS, "Content-Type": kind, "Cache-Control": kept}
        return Response(self._files[name], headers=headers)


def _plain(status: int, text: str) -> Response:
    headers = {**_ALWAYS, "Content-Type": _KINDS[".txt"], "Cache-Control": "no-store"}
    return Response(f"{text}\n", status, headers)

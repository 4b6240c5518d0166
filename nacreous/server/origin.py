"""Where a request comes from: a change is taken from the server's own pages alone."""

from __future__ import annotations

import contextlib
from urllib.parse import urlsplit

from starlette.datastructures import Headers

from nacreous.server.refusal import Refusal

#: Methods that change nothing.
SAFE = frozenset(("GET", "HEAD", "OPTIONS", "TRACE"))
#: Ports that browsers leave out.
_USUAL = {"http": 80, "https": 443}


def origin_of(url: str) -> str:
    """Scheme, host and port, as browsers write them: no port that goes without saying, ASCII alone.

    >>> origin_of("https://pearls.example:443/study/"), origin_of("http://真珠.example:8000")
    ('https://pearls.example', 'http://xn--5dy32e.example:8000')
    """
    parts = urlsplit(url.lower())
    host = parts.hostname or ""
    if not host.isascii():
        with contextlib.suppress(UnicodeError):  # no name that anybody has
            host = host.encode("idna").decode()
    host = f"[{host}]" if ":" in host else host
    port = "" if parts.port in (None, _USUAL.get(parts.scheme)) else f":{parts.port}"
    return f"{parts.scheme}://{host}{port}"


def check_origin(headers: Headers, scheme: str, public: str | None) -> None:
    """Refuse a change that another site's page asks for.

    scheme: of this request. public: the server's own origin, where people reach it elsewhere too. A
    program that is no browser says nothing of its origin, and carries nobody's cookie unasked.
    """
    if headers.get("sec-fetch-site", "same-origin") not in ("same-origin", "none"):
        raise Refusal(403, "not-allowed", "asked by another site's page; wanted: this server's own")
    given = headers.get("origin")
    own = f"{scheme}://{headers.get('host', '')}".lower()
    if given is not None and given.lower() not in (own, public):
        raise Refusal(403, "not-allowed", "Origin is another site; wanted: this server's own")


def check_content(headers: Headers, body: bytes) -> None:
    """Refuse what is not JSON by its own account, as a form of another site would be."""
    given = headers.get("content-type")
    if given is None and not body:
        return
    if (given or "").partition(";")[0].strip().lower() != "application/json":
        raise Refusal(415, "input", "Content-Type is not JSON; allowed: application/json")

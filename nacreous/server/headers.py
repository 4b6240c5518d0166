"""The headers of every response: what a browser must not do with it."""

from __future__ import annotations

from starlette.types import Message

POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "img-src 'self' blob:",
        "connect-src 'self'",
        "font-src 'self'",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    )
)

ALWAYS = (
    (b"content-security-policy", POLICY.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"no-referrer"),
    (b"cross-origin-opener-policy", b"same-origin"),
    (b"cross-origin-resource-policy", b"same-origin"),
    (b"permissions-policy", b"camera=(), microphone=(), geolocation=()"),
)

_KEPT = b"cache-control"
#: A year in which a browser asks by HTTPS alone.
_ONLY_HTTPS = (b"strict-transport-security", b"max-age=31536000")


def guard(start: Message, *, https: bool) -> None:
    """Add them to a response that starts; what says nothing about keeping it is not to be kept."""
    headers = [*start.get("headers", ()), *ALWAYS]
    if all(name.lower() != _KEPT for name, _ in headers):
        headers.append((_KEPT, b"no-store"))
    if https:
        headers.append(_ONLY_HTTPS)
    start["headers"] = headers

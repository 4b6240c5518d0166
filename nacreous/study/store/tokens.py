"""Tokens: unguessable, told once, and kept as hashes only."""

from __future__ import annotations

import hashlib
import re
import secrets

from nacreous.study.store.refusal import UnknownToken

#: 256 bits, as `draw` makes them.
_FRESH = re.compile("[A-Za-z0-9_-]{43}")
#: Capitals and digits that nobody takes for another.
_PLAIN = "ABCDEFGHJKLMNPQRSTUVWXYZ23456789"


def draw() -> str:
    """A new token of 256 random bits.

    >>> len(draw()), draw() == draw()
    (43, False)
    """
    return secrets.token_urlsafe(32)


def draw_code() -> str:
    """A completion code of a person's own, 48 random bits, without letters that look alike.

    >>> len(draw_code()), draw_code() == draw_code()
    (10, False)
    """
    return "".join(secrets.choice(_PLAIN) for _ in range(10))


def fresh(token: object) -> str:
    """A token that may become somebody's: of the form that `draw` gives, so that none is weak."""
    if not isinstance(token, str) or not _FRESH.fullmatch(token):
        raise unknown()
    return token


def hash_of(token: object) -> str:
    """What is kept of a token."""
    if not isinstance(token, str) or not 1 <= len(token) <= 200 or not token.isascii():
        raise unknown()
    return hashlib.sha256(token.encode()).hexdigest()


def unknown() -> UnknownToken:
    """For a token that nobody holds; the token itself is told to no log."""
    return UnknownToken("token is unknown; wanted: one that was given out and not revoked")

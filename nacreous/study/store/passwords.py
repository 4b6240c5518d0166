"""Passwords: checked, and kept as argon2id hashes."""

from __future__ import annotations

import unicodedata

from argon2 import PasswordHasher, extract_parameters
from argon2.exceptions import Argon2Error, VerifyMismatchError

from nacreous.problem import InputError

#: Characters of a password.
LEAST, MOST = 12, 200
# OWASP's least for argon2id, 19 MiB and two passes: twenty logins at once fill no small machine.
_HASHER = PasswordHasher(time_cost=2, memory_cost=19 * 1024, parallelism=1)
# Nobody's: compared with where a name is unknown, so that an answer takes as long.
_NOBODY = (
    "$argon2id$v=19$m=19456,t=2,p=1$gTmq98zd8KaUN3/75b5RWA$"
    "4UFZGFEo7YIVokNOA2CXsAeIxAXgRHBKVygzCQbZ/ms"
)


def hashed(password: object) -> str:
    """The argon2id hash of a new password, with its salt. Takes some 20 ms.

    >>> hashed("too short")
    Traceback (most recent call last):
    nacreous.problem.InputError: password is 9 characters long; allowed: 12 to 200
    """
    text = _normal(password)
    if not LEAST <= len(text) <= MOST:
        raise InputError(f"password is {len(text)} characters long; allowed: {LEAST} to {MOST}")
    return _HASHER.hash(text)


def matches(kept: str | None, password: object) -> bool:
    """Whether this is the password; as long in coming where there is none to compare with."""
    try:
        text = _normal(password)
    except InputError:
        text = ""
    try:
        _HASHER.verify(kept or _NOBODY, text[: MOST + 1])
    except VerifyMismatchError:
        return False
    return kept is not None


def is_hash(kept: str) -> bool:
    """Whether text is a hash as `hashed` makes it, no dearer to compare with.

    >>> is_hash("nacre"), is_hash(hashed("nacre, layer on layer"))
    (False, True)
    """
    try:
        return extract_parameters(kept) == extract_parameters(_NOBODY)
    except (Argon2Error, LookupError, ValueError):
        return False


def _normal(password: object) -> str:
    """The same text however the keyboard composed it (NFKC); a message never shows it."""
    if not isinstance(password, str):
        raise InputError("password is no text; allowed: text")
    text = unicodedata.normalize("NFKC", password)
    if any("\ud800" <= letter <= "\udfff" for letter in text):
        raise InputError("password holds half a letter; allowed: whole ones")
    return text

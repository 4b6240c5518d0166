"""What the machine under a store refuses, said in one line."""

from __future__ import annotations

import errno
from collections.abc import Iterator
from contextlib import contextmanager

import sqlalchemy as sa
from sqlalchemy.exc import DBAPIError, SQLAlchemyError

from nacreous.problem import InputError


class StoreError(OSError):
    """The disk is full, the database is gone or locked: nothing wrong with what was given.

    What was not acknowledged may be given again, under the same key, as often as one likes; the
    store itself is whole. `filename` is the store's place, without a password.

    >>> raise StoreError("the disk is full", "answers.sqlite")
    Traceback (most recent call last):
    nacreous.study.store.fault.StoreError: answers.sqlite: the disk is full
    """

    def __init__(self, what: str, place: str) -> None:
        super().__init__(errno.EIO, what, place)

    def __str__(self) -> str:
        """One line: where, and what."""
        return f"{self.filename}: {self.strerror}"


#: By a part of what the drivers say, in small letters.
_KNOWN = {
    "disk is full": "the disk is full; nothing more is stored until there is room",
    "no space left": "the disk is full; nothing more is stored until there is room",
    "could not extend": "the disk is full; nothing more is stored until there is room",
    "database is locked": "another program keeps the database locked",
    "disk i/o error": "the disk cannot be read or written (full, gone, or beyond a limit)",
    "readonly database": "cannot be written: read-only",
    "unable to open": "cannot be opened",
    "malformed": "the database is damaged; restore a backup",
    "queuepool limit": "too many readers at once",
}

_CONNECTION = "the database cannot be reached, or the connection was lost"


def place_of(engine: sa.Engine) -> str:
    """Where a store is, for messages: the file, or the URL without its password."""
    if engine.dialect.name == "sqlite":
        return str(engine.url.database)
    return engine.url.render_as_string(hide_password=True)


def said(problem: SQLAlchemyError) -> str:
    """What a driver's error means, in one line."""
    cause = problem.orig if isinstance(problem, DBAPIError) else problem
    text = " ".join(str(cause).split())
    for part, meaning in _KNOWN.items():
        if part in text.lower():
            return meaning
    lost = isinstance(problem, DBAPIError) and problem.connection_invalidated
    if lost or any(word in text.lower() for word in ("connection", "connect", "server closed")):
        return _CONNECTION
    return f"the database refuses: {text[:300]}"


@contextmanager
def translated(place: str) -> Iterator[None]:
    """Turn the drivers' errors into `StoreError`; a file of another kind is an `InputError`."""
    try:
        yield
    except SQLAlchemyError as problem:
        if "file is not a database" in str(problem):
            raise InputError(f"{place}: is no store; wanted: a store, or a new file") from problem
        raise StoreError(said(problem), place) from problem

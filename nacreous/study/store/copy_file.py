"""A copy of a store, as one SQLite file: opened to be read, with nothing left beside it."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import quote_from_bytes

import sqlalchemy as sa

from nacreous.study.store.engine import BESIDE

__all__ = ["read_only", "reading_engine"]

#: Where a file says how it is to be read, and by how: 2 is with a log (SQLite's "Database File
#: Format", 1.3).
_READ_VERSION, _WITH_LOG = 19, 2


def reading_engine(path: Path) -> sa.Engine:
    """The engine that reads a SQLite file and writes nothing, whatever its name holds."""
    # A URL of SQLAlchemy undoes the quoting of its path, so that SQLite would open another file.
    return sa.create_engine("sqlite://", creator=lambda: _opened(path), poolclass=sa.NullPool)


@contextlib.contextmanager
def read_only(path: Path) -> Iterator[sqlite3.Connection]:
    """A connection that reads a SQLite file and writes nothing."""
    with contextlib.closing(_opened(path)) as connection:
        connection.execute("PRAGMA trusted_schema = OFF")  # it may be anybody's
        yield connection


def _opened(path: Path) -> sqlite3.Connection:
    file = path.resolve()
    # A reader of a file with a log makes one where there is none, and cannot take it away again.
    still = "&immutable=1" if _lies_alone(file) and _has_log(file) else ""
    uri = f"file:{quote_from_bytes(bytes(file))}?mode=ro{still}"
    return sqlite3.connect(uri, uri=True)


def _lies_alone(file: Path) -> bool:
    """Without the log that a program in the middle of its work keeps beside it."""
    return not any(Path(f"{file}{end}").exists() for end in BESIDE)


def _has_log(file: Path) -> bool:
    try:
        with file.open("rb") as opened:
            return opened.read(_READ_VERSION + 1)[_READ_VERSION:] == bytes([_WITH_LOG])
    except OSError:  # SQLite says what is wrong with it
        return False


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

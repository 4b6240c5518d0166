"""An earlier backup, which a newer one may replace; another store may not be replaced."""

from __future__ import annotations

import os
from collections.abc import Collection
from pathlib import Path

import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.study.design.manifest import RECORD
from nacreous.study.store.copy_file import reading_engine
from nacreous.study.store.engine import FILE
from nacreous.study.store.migrate import check_revision
from nacreous.study.store.schema import studies

__all__ = ["hashes", "require_earlier_backup"]


def require_earlier_backup(output: Path, known: Collection[str]) -> None:
    """Refuse to write over anything but an empty file and a store of these `known` studies.

    Another program's file stays as it is, and so does what a link leads to; a store in use has the
    record of its study beside it.
    """
    if output.is_symlink():
        raise InputError(
            f"{output}: is a link to {os.path.realpath(output)}; wanted: a new file, or an earlier "
            "backup by its own name"
        )
    if not output.is_file() or not output.stat().st_size:
        return
    if output.name == FILE and (output.parent / RECORD).is_file():
        raise InputError(f"{output}: is the store of a frozen study; wanted: another place")
    engine = reading_engine(output)
    try:
        with engine.connect() as reading:
            others = hashes(reading) - set(known)
            ours = bool(others) or check_revision(reading, str(output)) is not None
    except (sa.exc.DatabaseError, InputError):  # another program's, a damaged one, a newer one
        ours = False
    finally:
        engine.dispose()
    if not ours:
        raise InputError(
            f"{output}: is no backup that this version of Nacreous knows, and is not written over; "
            "wanted: a new file, or an earlier backup of this store"
        )
    if others:
        raise InputError(
            f"{output}: holds study {min(others)[:12]}, which is not in this store; wanted: a new "
            "file, or an earlier backup of this store"
        )


def hashes(connection: sa.Connection) -> set[str]:
    """Of the studies of a store."""
    return set(connection.execute(sa.select(studies.c.hash)).scalars())

"""An earlier backup, which a newer one may replace; another store may not be replaced."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

import sqlalchemy as sa

from nacreous.problem import InputError
from nacreous.study.design.manifest import RECORD
from nacreous.study.store.copy_file import reading_engine
from nacreous.study.store.engine import FILE
from nacreous.study.store.schema import studies

__all__ = ["hashes", "require_earlier_backup"]


def require_earlier_backup(output: Path, known: Collection[str]) -> None:
    """Refuse to write over a store in use, or one that holds another study than these `known`."""
    if not output.is_file():
        return
    if output.name == FILE and (output.parent / RECORD).is_file():
        raise InputError(f"{output}: is the store of a frozen study; wanted: another place")
    engine = reading_engine(output)
    try:
        with engine.connect() as reading:
            others = hashes(reading) - set(known)
    except sa.exc.DatabaseError:  # no store
        return
    finally:
        engine.dispose()
    if others:
        raise InputError(
            f"{output}: holds study {min(others)[:12]}, which is not in this store; wanted: a new "
            "file, or an earlier backup of this store"
        )


def hashes(connection: sa.Connection) -> set[str]:
    """Of the studies of a store."""
    return set(connection.execute(sa.select(studies.c.hash)).scalars())

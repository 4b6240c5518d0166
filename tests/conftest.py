"""Stores to test with: every test that takes `place` runs on SQLite and on PostgreSQL."""

from collections.abc import Iterator
from itertools import count
from pathlib import Path

import pytest
from database import Server, start

_NAMES = count()


@pytest.fixture(scope="session")
def postgresql() -> Iterator[Server]:
    """A PostgreSQL server of our own, on a unix socket in a temporary folder."""
    with start() as server:
        yield server


@pytest.fixture(params=["sqlite", "postgresql"])
def place(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """Where an empty store can be made."""
    if request.param == "sqlite":
        return str(tmp_path / "answers.sqlite")
    server: Server = request.getfixturevalue("postgresql")
    return server.create(f"store_{next(_NAMES)}")

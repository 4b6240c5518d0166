"""Stores to test with: what takes `place` runs on SQLite and on PostgreSQL."""

from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from fastapi import FastAPI

from nacreous.server.app import create_app
from nacreous.server.service import Service
from nacreous.study.design import open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store
from tests.support.database import Server, start
from tests.support.server_process import in_thread, prepare, small_study, some_pages


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
    return server.emptied("store")


@pytest.fixture
def app(place: str, tmp_path: Path) -> Iterator[FastAPI]:
    """A small study's application; anybody may enter."""
    folder = small_study(tmp_path / "study")
    prepare(folder, place)
    with Store.open(place) as store:
        yield create_app(Running(store, open_frozen(folder)), built=some_pages(tmp_path / "pages"))


@pytest.fixture
def service(app: FastAPI) -> Service:
    """What its routes share: the study and its store."""
    return app.state.service


@pytest.fixture
def server(app: FastAPI) -> Iterator[httpx.Client]:
    """A client of its server, which runs on a thread of this process."""
    with in_thread(app) as url, httpx.Client(base_url=url, verify=False, timeout=60) as client:
        yield client

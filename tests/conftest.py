"""Stores and a browser to test with: what takes `place` runs on SQLite and on PostgreSQL."""

from collections.abc import Iterator
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING

import httpx
import pytest
from database import Server, start
from fastapi import FastAPI
from server_process import in_thread, prepare, served, small_study, some_pages

from nacreous.server.app import create_app
from nacreous.server.service import Service
from nacreous.study.design import open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store

if TYPE_CHECKING:
    from browser import Site
    from playwright.sync_api import Browser

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
    with in_thread(app) as url, httpx.Client(base_url=url, verify=False) as client:
        yield client


@pytest.fixture(scope="module")
def browser() -> Iterator["Browser"]:
    """Chromium. Of one module alone: Playwright's event loop is in the way of others' own."""
    from browser import chromium

    with chromium() as running:
        yield running


@pytest.fixture(scope="module")
def plain(browser: "Browser", tmp_path_factory: pytest.TempPathFactory) -> Iterator["Site"]:
    """A study of nothing but pairs, served to whoever comes."""
    from browser import PLAIN, Site, frozen

    folder = frozen(PLAIN, tmp_path_factory.mktemp("plain") / "study")
    with served(folder) as server:
        yield Site(folder, server.url, browser)


@pytest.fixture(scope="module")
def whole(browser: "Browser", tmp_path_factory: pytest.TempPathFactory) -> Iterator["Site"]:
    """A study with everything that a participant can see."""
    from browser import WHOLE, Site, frozen

    folder = frozen(WHOLE, tmp_path_factory.mktemp("whole") / "study")
    with served(folder) as server:
        yield Site(folder, server.url, browser)

"""A browser, and studies served to it."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from nacreous.viewer import FOLDER
from tests.pages.browser import PLAIN, WHOLE, Site, chromium, frozen
from tests.pages.viewer_host import hosted
from tests.support.server_process import served


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Chromium. Of one module alone: Playwright's event loop is in the way of others' own."""
    with chromium() as running:
        yield running


@pytest.fixture(scope="module")
def plain(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    """A study of nothing but pairs, served to whoever comes."""
    folder = frozen(PLAIN, tmp_path_factory.mktemp("plain") / "study")
    with served(folder) as server:
        yield Site(folder, server.url, browser)


@pytest.fixture(scope="module")
def whole(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    """A study with everything that a participant can see."""
    folder = frozen(WHOLE, tmp_path_factory.mktemp("whole") / "study")
    with served(folder) as server:
        yield Site(folder, server.url, browser)


@pytest.fixture(scope="module")
def host() -> Iterator[str]:
    """A web host that knows nothing of the viewer's page."""
    if not (FOLDER / "index.html").is_file():
        pytest.skip("the viewer's page is not built:   ./just viewer   (needs Node.js and npm)")
    with hosted() as address:
        yield address

"""Draw the pictures of the viewer for README and docs from the page itself.

python -m tests.pages.viewer_pictures docs/pictures
"""

import sys
from pathlib import Path

from playwright.sync_api import Browser, Page

import nacreous as nc
from nacreous.viewer.link import fragment
from tests.pages.browser import chromium
from tests.pages.viewer_host import hosted

LAPTOP = {"width": 1440, "height": 900}
TELEPHONE = {"width": 390, "height": 844}


def at_rest(page: Page) -> None:
    """Wait for whole pictures, small ones included."""
    for stage in page.locator(".pearl").all():
        stage.wait_for()
    page.wait_for_selector(".pearl[data-stage=refined]", timeout=120_000)
    page.wait_for_timeout(20_000)  # presets are drawn one after the other
    page.mouse.move(0, 0)


def opened(browser: Browser, address: str, size: dict[str, int], language: str) -> Page:
    """The viewer at a blue-green Akoya on white cloth."""
    link = fragment(nc.Pearl.load("akoya-rg"), nc.Scene.load("north-window-white"))
    page = browser.new_page(viewport=size)  # type: ignore[arg-type]
    page.goto(f"{address}/?lang={language}#{link}")
    return page


def main() -> None:
    """Draw all."""
    folder = Path(sys.argv[1])
    with hosted() as address, chromium() as browser:
        page = opened(browser, address, LAPTOP, "en")
        at_rest(page)
        page.screenshot(path=folder / "viewer.png")
        page.click("#tab-instruments")
        page.wait_for_timeout(5_000)
        page.screenshot(path=folder / "viewer-instruments.png")
        page.click("#tab-pearl")
        page.click(".beside")
        page.fill("[data-key='nacre.harvest'] .typed input", "2024-08-15")
        page.click("#tab-compare")
        at_rest(page)
        page.screenshot(path=folder / "viewer-compare.png")
        phone = opened(browser, address, TELEPHONE, "ja")
        at_rest(phone)
        phone.screenshot(path=folder / "viewer-phone.png")


if __name__ == "__main__":
    main()

"""A browser for tests of the pages, and a participant who goes through a study in it."""

import re
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, sync_playwright

from nacreous.server.pages import FOLDER
from nacreous.study.design import freeze

#: The experiment of 1996 in small, with every check: 21 pairs, 4 repeats, 3 for practice.
WHOLE = """\
name = "whole"
seed = 1996
consent = { en = "Taking part is voluntary.", ja = "参加は任意です。" }
instructions = { en = "Choose the one that looks more like a pearl.", ja = "真珠らしいほうを選んでください。" }
questions = [{ id = "pearl-like", text = { en = "Which looks more like a pearl?", ja = "どちらがより真珠らしく見えますか。" } }]
stimuli = [{ pearl = "paper", scene = "paper", cut = "seven-crops" }]
display = { size_px = 512, samples = 1, width_mm = 40 }
pairs = { kind = "all", repeats = 4 }
sitting = { training = 3, break_every = 15, minimum_viewing_ms = 120, ties = true }
screen = { vision = ["contrast", "colour"] }

[[groups]]
name = "trade"
values = ["yes", "no"]
how = "recorded"
question = { en = "Do you work with pearls?", ja = "真珠に関わるお仕事をされていますか。" }
choices = [{ en = "Yes", ja = "はい" }, { en = "No", ja = "いいえ" }]

[[groups]]
name = "real-pearl"
values = ["shown", "not-shown"]
notes = [
    { en = "You are given a real pearl. Look at it as long as you like.", ja = "本物の真珠をお渡しします。ご自由にご覧ください。" },
    { en = "You will see pictures alone.", ja = "画像だけをご覧いただきます。" },
]
"""

#: Nothing but pairs: 10 trials, so that faults have time to happen.
PLAIN = """\
name = "plain"
purpose = "demo"
languages = ["en"]
seed = 5
questions = [{ id = "deeper", text = { en = "Which is deeper?" } }]
display = { size_px = 64, samples = 1 }
pairs = { kind = "all", repeats = 4 }
sitting = { training = 0, minimum_viewing_ms = 0 }
screen = { card = false, distance = false, levels = false, full_screen = false }

[[stimuli]]
label = "r"
pearl = "akoya-r"
[[stimuli]]
label = "g"
pearl = "akoya-g"
[[stimuli]]
label = "rg"
pearl = "akoya-rg"
[[stimuli]]
label = "thin"
pearl = "akoya-thin"
"""

_FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)


def program() -> str:
    """Chromium, or a word about why the test is left out."""
    if not (FOLDER / "index.html").is_file():
        pytest.skip("the study's pages are not built (./just pages, which needs Node.js)")
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if found := shutil.which(name):
            return found
    pytest.skip("there is no Chromium here (sudo apt install chromium)")


@contextmanager
def chromium() -> Iterator[Browser]:
    """A browser without a window."""
    path = program()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=_FLAGS)
        yield browser
        browser.close()


@cache
def _frozen(text: str) -> Path:
    """A study, frozen once in a process."""
    folder = Path(tempfile.mkdtemp(prefix="nacreous-pages-"))
    (folder / "study.toml").write_text(text, encoding="utf-8")
    freeze(folder / "study.toml", folder / "study")
    return folder / "study"


def frozen(text: str, folder: Path) -> Path:
    """The same in a folder that is not there yet."""
    shutil.copytree(_frozen(text), folder)
    return folder


class Guarded:
    """A context whose pages may neither complain nor ask anybody but the server.

    expected: what a page may say in the console, where a test makes it fail.
    """

    def __init__(self, context: BrowserContext, url: str, expected: str = "$^") -> None:
        self.context = context
        self.url = url
        self.complaints: list[str] = []
        self._expected = expected
        context.on("console", self._console)
        context.on("weberror", lambda error: self.complaints.append(str(error.error)))
        context.on("request", self._request)

    def _console(self, message: Any) -> None:
        if message.type in ("error", "warning") and not re.search(self._expected, message.text):
            self.complaints.append(message.text)

    def _request(self, request: Any) -> None:
        if not request.url.startswith((self.url + "/", "blob:" + self.url)):
            self.complaints.append(f"a request to {request.url}")

    def open(self, path: str = "/") -> "Participant":
        page = self.context.new_page()
        page.goto(self.url + path)
        return Participant(page)


@contextmanager
def guarded(browser: Browser, url: str, expected: str = "$^", **options: Any) -> Iterator[Guarded]:
    """A context of its own; at its end nothing may have been complained of."""
    options = {"viewport": {"width": 1280, "height": 800}, "locale": "en-GB", **options}
    context = browser.new_context(**options)
    context.set_default_timeout(15_000)
    guard = Guarded(context, url, expected)
    yield guard
    context.close()
    assert guard.complaints == []


class Participant:
    """Somebody in front of one page. `seen` is called at every page with its name."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.seen: Callable[[str], None] = lambda name: None

    def at(self, name: str) -> None:
        """Wait for a page by its name."""
        self.page.wait_for_selector(f".page-{name} .sheet")
        self.seen(name)

    def go(self, name: str) -> None:
        """Wait for a page and press the button to go on with."""
        self.at(name)
        self.page.click(f".page-{name} button.main")

    def agree(self, language: str = "en") -> None:
        """From the first page past consent."""
        self.page.wait_for_selector(".page-language, .page-consent")
        if self.page.query_selector(".page-language"):
            self.at("language")
            self.page.click(f"button[lang={language}]")
        self.at("consent")
        self.page.check("#agreed")
        self.page.click(".page-consent button.main")

    def check_screen(self) -> None:
        """Every step of the screen check, each as it is meant."""
        self.go("screen")
        self.go("full")
        self.go("card")
        self.at("blind-spot")
        for _ in range(3):
            self.page.click("button.main")
            self.page.wait_for_timeout(150)
            self.page.click("button.main")
        self.at("gamma")
        self.page.fill("input[type=range]", "186")
        self.page.click("button.main")
        self.at("dark")
        self.page.click(".patches button >> nth=2")
        self.at("contrast")
        for gap in ("up", "right", "down", "left", "up", "up", "up", "up", "up", "up"):
            self.page.click(f".rings .{gap}")
        self.at("colour")
        for _ in range(7):
            self.page.click(".digits .none")

    def shown(self) -> str:
        """Wait for a pair that can be answered; gives the words of its progress."""
        self.page.wait_for_selector(".pictures:not(.hidden):not(.over)")
        return self.page.inner_text(".pair .progress > span >> nth=0")

    def answer(self, chosen: str, settle_ms: int = 130) -> None:
        """Answer the pair that is shown by a click."""
        self.page.wait_for_timeout(settle_ms)
        place = {"left": ".picture >> nth=0", "right": ".picture >> nth=1", "tie": ".below .quiet"}
        progress = self.page.query_selector(".pair")
        self.page.click(place[chosen])
        if progress is not None:
            progress.wait_for_element_state("hidden")

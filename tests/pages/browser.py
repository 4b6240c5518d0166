"""A browser for tests of the pages, and a participant who goes through a study in it."""

import json
import re
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, sync_playwright

from nacreous.server.pages import FOLDER
from nacreous.study.design import freeze
from nacreous.study.store import Session, Store

#: The experiment of 1996 in small, with every check: 21 pairs, 2 more for practice.
WHOLE = """\
name = "whole"
seed = 1996
consent = { en = "Taking part is voluntary.", ja = "参加は任意です。" }
instructions = { en = "Choose one by touch, click or key.", ja = "一つを選んでください。" }
stimuli = [{ pearl = "paper", scene = "paper", cut = "seven-crops" }]
display = { size_px = 512, samples = 1, width_mm = 40 }
screen = { vision = ["contrast", "colour"], least_distance_mm = 100 }

[sitting]
training = 2
break_every = 15
adaptation_s = 1
minimum_viewing_ms = 120
ties = true

[[questions]]
id = "pearl-like"
text = { en = "Which looks more like a pearl?", ja = "どちらがより真珠らしく見えますか。" }

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
    { en = "You are given a real pearl to look at.", ja = "本物の真珠をお渡しします。" },
    { en = "You will see pictures alone.", ja = "画像だけをご覧いただきます。" },
]
"""

#: Nothing but pairs, 6 of them.
PLAIN = """\
name = "plain"
purpose = "demo"
languages = ["en"]
seed = 5
questions = [{ id = "deeper", text = { en = "Which is deeper?" } }]
display = { size_px = 64, samples = 1 }
sitting = { training = 0, minimum_viewing_ms = 0, adaptation_s = 0 }
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

#: Two pictures that can be chosen from; and where each answer is given.
PAIR = ".pictures:not(.hidden):not(.over)"
PLACES = {"left": ".picture >> nth=0", "right": ".picture >> nth=1", "tie": ".below .quiet"}

#: What looks for obstacles to people who use a keyboard or a screen reader.
AXE = Path(__file__).parent.parent.parent / "studio/node_modules/axe-core/axe.min.js"

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
        pytest.skip("the study's pages are not built:   ./just pages   (needs Node.js and npm)")
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if found := shutil.which(name):
            return found
    pytest.skip("no Chromium here:   sudo apt install chromium fonts-noto-cjk")


@contextmanager
def chromium() -> Iterator[Browser]:
    """A browser without a window."""
    path = program()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=_FLAGS)
        yield browser
        browser.close()


@cache
def _frozen(text: str) -> TemporaryDirectory[str]:
    """A study, frozen once in a process, which removes it when it ends."""
    temporary = TemporaryDirectory(prefix="nacreous-pages-")
    folder = Path(temporary.name)
    (folder / "study.toml").write_text(text, encoding="utf-8")
    freeze(folder / "study.toml", folder / "study")
    return temporary


def frozen(text: str, folder: Path) -> Path:
    """The same in a folder that is not there yet."""
    shutil.copytree(Path(_frozen(text).name) / "study", folder)
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


@dataclass
class Site:
    """A study that is served, and a browser for it."""

    folder: Path
    url: str
    browser: Browser

    def visited(self, **options: Any) -> AbstractContextManager[Guarded]:
        """Somebody's own context."""
        return guarded(self.browser, self.url, **options)

    def stored(self, at_least: int = 0) -> tuple[Session, list[dict[str, Any]]]:
        """The last session in the store, and its answers, once there are so many."""
        return stored(self.folder, at_least)


@contextmanager
def guarded(browser: Browser, url: str, expected: str = "$^", **options: Any) -> Iterator[Guarded]:
    """A context of its own; at its end nothing may have been complained of."""
    options = {"viewport": {"width": 1280, "height": 800}, "locale": "en-GB", **options}
    context = browser.new_context(**options)
    context.set_default_timeout(60_000)
    guard = Guarded(context, url, expected)
    yield guard
    context.close()
    assert guard.complaints == [], guard.complaints


class Participant:
    """Somebody in front of one page. `seen` is called at every page with its name."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.seen: Callable[[str], None] = lambda name: None

    def at(self, name: str) -> None:
        """Wait for a page by its name."""
        self.until(f".page-{name} .sheet")
        self.seen(name)

    def go(self, name: str) -> None:
        """Wait for a page and press the button to go on with."""
        self.at(name)
        self.page.click(f".page-{name} button.main")

    def agree(self, language: str | None = None) -> None:
        """From the first page past consent; language: where one is asked for."""
        if language is not None:
            self.at("language")
            self.page.click(f"button[lang={language}]")
        self.at("consent")
        self.page.check("#agreed")
        self.page.click(".page-consent button.main")

    def check_screen(self) -> None:
        """Every step of the screen check, each as it is meant; 4.5 px a millimetre."""
        self.go("screen")
        self.go("full")
        self.at("card")
        self.page.fill("input[type=range]", str(4.5 * 85.6 // 0.5 * 0.5))
        self.page.click("button.main")
        self.at("blind-spot")
        for _ in range(3):
            self.page.click("button.main")
            self.page.wait_for_timeout(100)
            self.page.click("button.main")
        self.at("gamma")
        self.page.fill("input[type=range]", "186")
        self.page.click("button.main")
        self.at("dark")
        self.page.click(".patches button >> nth=2")
        self.at("contrast")
        for _ in range(10):
            self.page.click(".rings .up")
        self.at("colour")
        for _ in range(7):
            self.page.click(".digits .none")

    def trials(self, choose: Callable[[int], str]) -> list[str]:
        """From where the pairs begin to the thanks; gives what was answered."""
        given: list[str] = []
        while (name := self.wait()) != "thanks":
            if name == "pair":
                given.append(choose(len(given)))
                self.answer(given[-1])
            else:
                self.go(name)
        return given

    def wait(self) -> str:
        """Wait until there is a pair to answer or a page to leave; gives its name."""
        names = ("instructions", "training-over", "break", "resumed", "thanks")
        sheets = ", ".join(f".page-{name} .sheet" for name in names)
        self.until(f"{PAIR}, {sheets}")
        found = [name for name in names if self.page.query_selector(f".page-{name}")]
        name = found[0] if found else "pair"
        if name in ("pair", "thanks"):
            self.seen(name)
        return name

    def until(self, selector: str) -> None:
        """Wait for an element, looking at every frame: Playwright itself looks less often."""
        look = "selector => document.querySelector(selector) !== null"
        self.page.wait_for_function(look, arg=selector, timeout=60_000)

    def answer(self, chosen: str, settle_ms: int = 125) -> None:
        """Answer the pair that is shown by a click, and wait until it is gone."""
        self.until(PAIR)
        pair = self.page.query_selector(".pair")
        assert pair is not None
        self.page.wait_for_timeout(settle_ms)
        self.page.click(PLACES[chosen])
        pair.wait_for_element_state("hidden")


def violations(page: Page) -> list[str]:
    """What axe says against a page."""
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = page.evaluate("axe.run({ resultTypes: ['violations'] })")
    return [
        f"{one['id']}: {one['help']}: {[node['html'][:120] for node in one['nodes']]}"
        for one in found["violations"]
    ]


def stored(folder: Path, at_least: int = 0) -> tuple[Session, list[dict[str, Any]]]:
    """The last session in a study's store, and its answers, once there are so many.

    A page goes on before the server has said that it keeps the answer.
    """
    deadline = time.monotonic() + 30.0
    while True:
        with Store.open(folder) as store:
            study = store.study()
            session = store.sessions(study)[-1]
            rows = store.answers(study, session.id)
        if len(rows) >= at_least:
            return session, [{**row, "flags": json.loads(row["flags"])} for row in rows]
        assert time.monotonic() < deadline, f"{len(rows)} answers are stored, not {at_least}"
        time.sleep(0.05)

"""The pictures' grey on every page: words that read on it, and time to get used to it again."""

from __future__ import annotations

import re
import time
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.pages.browser import (
    AXE,
    PAIR,
    PLAIN,
    WHOLE,
    Guarded,
    Participant,
    frozen,
    guarded,
    violations,
)
from tests.pages.page_pictures import screen
from tests.support.server_process import served

#: Of what the page shows at a place: the page's own colour.
BEHIND = "getComputedStyle(document.body).backgroundColor"
GREYS = (0, 60, 119, 180, 255)
DARK = {"dark"}  # dark tones are looked for on black, whatever the study's grey


def on_grey(text: str, code: int) -> str:
    """A study on another grey; on black no ring can be shown."""
    text = text.replace("samples = 1", f"samples = 1, background_code = {code}")
    return text if code >= 60 else text.replace('"contrast", ', "")


def walked(person: Participant) -> None:
    """The whole way, with breaks."""
    person.agree("en")
    person.at("groups")
    person.page.click("label >> nth=0")
    person.go("groups")
    person.go("notes")
    screen(person)
    person.trials(lambda trial: "left")


@pytest.mark.parametrize("code", [60, 119, 230])
def test_every_page_has_the_studys_grey_and_words_that_read_on_it(
    browser: Browser, tmp_path: Path, code: int
) -> None:
    """Contrast of 4.5 to 1, by axe; where the pointer is too, which changes how a button looks."""
    found: dict[str, str] = {}
    faults: dict[str, list[str]] = {}

    def seen(name: str) -> None:
        if name in found:
            return
        found[name] = person.page.evaluate(BEHIND)
        if AXE.is_file():
            if person.page.query_selector(".actions button.main"):
                person.page.hover(".actions button.main")
            faults[name] = violations(person.page)

    folder = frozen(on_grey(WHOLE, code), tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open()
        person.seen = seen
        walked(person)
    assert {"consent", "instructions", "break", "pair", "thanks"} <= set(found)
    grey = f"rgb({code}, {code}, {code})"
    assert {name for name, colour in found.items() if colour != grey} == DARK & set(found)
    assert {name: of for name, of in faults.items() if of} == {}


@pytest.mark.parametrize("code", GREYS)
def test_the_focus_is_seen_on_every_grey(browser: Browser, tmp_path: Path, code: int) -> None:
    """The ring is black or white, 3 to 1 and more against the grey around it (WCAG 2.4.13)."""
    folder = frozen(on_grey(PLAIN, code), tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open()
        person.at("consent")
        for _ in range(3):
            person.page.keyboard.press("Tab")
            ring = person.page.evaluate(
                """() => {
                    const style = getComputedStyle(document.activeElement);
                    return [style.outlineStyle, style.outlineWidth, style.outlineColor];
                }"""
            )
            light = 0 if code >= 119 else 255
            assert ring == ["solid", "3px", f"rgb({light}, {light}, {light})"]


def with_breaks(seconds: float) -> str:
    """Three pairs, a break, three pairs."""
    return PLAIN.replace("adaptation_s = 0", f"adaptation_s = {seconds}, break_every = 3")


def to_the_break(guard: Guarded) -> Participant:
    person = guard.open()
    person.agree()
    person.go("instructions")
    for _ in range(3):
        person.answer("left")
    person.go("break")
    person.until(".page-adapt .adapting")
    return person


def test_after_a_break_nobody_answers_before_the_eyes_are_used_to_the_grey(
    browser: Browser, tmp_path: Path
) -> None:
    folder = frozen(with_breaks(2), tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = to_the_break(guard)
        began = time.monotonic()
        assert re.fullmatch("[12] s", person.page.inner_text(".adapting .count"))
        assert person.page.query_selector_all("button, img, input, a") == []
        if AXE.is_file():
            assert violations(person.page) == []
        for key in ("Enter", "Space", "ArrowLeft", "Escape"):
            person.page.keyboard.press(key)
        person.page.mouse.click(300, 300)
        assert person.page.query_selector(".page-adapt") is not None
        person.until(PAIR)
        assert time.monotonic() - began > 1.5
        person.answer("right")
        person.until(PAIR)
        person.page.reload()
        person.go("resumed")  # who comes back has looked elsewhere too
        person.until(".page-adapt .adapting")
        person.until(PAIR)


def test_time_in_which_the_grey_is_not_seen_does_not_count(
    browser: Browser, tmp_path: Path
) -> None:
    folder = frozen(with_breaks(40), tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        guard.context.add_init_script(
            "Object.defineProperty(document, 'hidden', { get: () => window.away === true })"
        )
        person = to_the_break(guard)
        person.page.evaluate("window.away = true")
        person.page.wait_for_timeout(300)
        left = person.page.inner_text(".count")
        person.page.wait_for_timeout(1500)
        assert person.page.inner_text(".count") == left
        person.page.evaluate("window.away = false")
        person.page.wait_for_timeout(1500)
        assert int(person.page.inner_text(".count")[:-2]) < int(left[:-2])


def test_where_nothing_may_move_the_count_goes_in_steps_of_ten(
    browser: Browser, tmp_path: Path
) -> None:
    folder = frozen(with_breaks(40), tmp_path / "study")
    with (
        served(folder) as server,
        guarded(browser, server.url, reduced_motion="reduce") as guard,
    ):
        person = to_the_break(guard)
        person.page.wait_for_timeout(1200)
        assert person.page.inner_text(".count") == "40 s"


@pytest.mark.parametrize(
    ("answered", "said"), [(1, "practice, pair 2 of 2"), (2, "pair 1 of 21"), (5, "pair 4 of 21")]
)
def test_who_comes_back_is_told_the_number_that_the_pair_itself_bears(
    browser: Browser, tmp_path: Path, answered: int, said: str
) -> None:
    """Practice is counted by itself, as under the pairs."""
    plain = WHOLE.replace('vision = ["contrast", "colour"]', "card = false, full_screen = false")
    plain = plain.replace("least_distance_mm = 100", "distance = false, levels = false")
    folder = frozen(plain, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open()
        person.agree("en")
        person.at("groups")
        person.page.click("label >> nth=0")
        for name in ("groups", "notes", "instructions"):
            person.go(name)
        for place in range(answered):
            if place == 2:
                person.go("training-over")
            person.answer("left")
        person.until(PAIR if answered != 2 else ".page-training-over")
        person.page.reload()
        person.at("resumed")
        assert said in person.page.inner_text(".sheet")
        person.go("resumed")
        person.until(PAIR)
        own = person.page.inner_text(".pair .progress")
        assert own.startswith(said.replace("practice, pair", "Practice:").replace("pair ", ""))

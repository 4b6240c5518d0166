"""The pictures' grey on every page: words that read on it, and time to get used to it again."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Route

from tests.pages.browser import (
    AXE,
    PAIR,
    PLAIN,
    WHOLE,
    Guarded,
    Participant,
    Site,
    frozen,
    guarded,
    violations,
)
from tests.pages.page_pictures import screen
from tests.support.server_process import served

#: The page's own colour.
BEHIND = "getComputedStyle(document.body).backgroundColor"
#: On which all that a participant sees is shown, but for dark tones, which are looked for on black.
DARK = {"dark"}


def told(change: Callable[[dict[str, Any]], dict[str, Any]]) -> Callable[[Route], None]:
    """Answers /api/study as the server does, but for some facts."""

    def answer(route: Route) -> None:
        response = route.fetch()
        route.fulfill(response=response, body=json.dumps(change(response.json())))

    return answer


def to_the_pairs(person: Participant) -> None:
    person.agree("en")
    person.at("groups")
    person.page.click("label >> nth=0")
    person.go("groups")
    person.go("notes")


@pytest.mark.parametrize("code", [60, 230])
def test_every_page_has_the_studys_grey_and_words_that_read_on_it(
    browser: Browser, tmp_path: Path, code: int
) -> None:
    """Contrast of 4.5 to 1, by axe; under the pointer too, which changes how a button looks.

    The usual grey is that of test_participant.py.
    """
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

    study = WHOLE.replace("samples = 1", f"samples = 1, background_code = {code}")
    study = study.replace("break_every = 15", "break_every = 5")
    study += '\n[pairs]\nkind = "incomplete"\nnumber = 7\n'
    folder = frozen(study, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open()
        person.seen = seen
        to_the_pairs(person)
        screen(person)
        person.trials(lambda trial: "left")
    assert {"consent", "instructions", "break", "pair", "thanks"} <= set(found)
    grey = f"rgb({code}, {code}, {code})"
    assert {name for name, colour in found.items() if colour != grey} == DARK & set(found)
    assert {name: of for name, of in faults.items() if of} == {}


@pytest.mark.parametrize("code", [0, 60, 119, 180, 255])
def test_the_focus_is_seen_on_every_grey(plain: Site, code: int) -> None:
    """The ring is black or white, 3 to 1 and more against the grey around it (WCAG 2.4.13)."""
    with plain.visited() as guard:
        guard.context.route("**/api/study", told(lambda study: {**study, "background_code": code}))
        person = guard.open()
        person.at("consent")
        assert person.page.evaluate(BEHIND) == f"rgb({code}, {code}, {code})"
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


@pytest.fixture(scope="module")
def paused(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    """Two pairs, a break, two pairs, a break, two pairs; two seconds to get used to the grey."""
    study = PLAIN.replace("adaptation_s = 0", "adaptation_s = 2, break_every = 2")
    folder = frozen(study, tmp_path_factory.mktemp("paused") / "study")
    with served(folder) as server:
        yield Site(folder, server.url, browser)


def to_the_break(guard: Guarded, seconds: float | None = None) -> Participant:
    """seconds: another time than the study's."""
    if seconds is not None:

        def longer(study: dict[str, Any]) -> dict[str, Any]:
            return {**study, "sitting": {**study["sitting"], "adaptation_s": seconds}}

        guard.context.route("**/api/study", told(longer))
    person = guard.open()
    person.agree()
    person.go("instructions")
    for _ in range(2):
        person.answer("left")
    person.go("break")
    person.until(".page-adapt .adapting")
    return person


def test_after_a_break_nobody_answers_before_the_eyes_are_used_to_the_grey(paused: Site) -> None:
    with paused.visited() as guard:
        person = to_the_break(guard)
        began = time.monotonic()
        assert re.fullmatch("[12] s", person.page.inner_text(".adapting .count"))
        assert person.page.query_selector_all("button, img, input, a") == []
        for key in ("Enter", "Space", "ArrowLeft", "Escape"):
            person.page.keyboard.press(key)
        person.page.mouse.click(300, 300)
        if AXE.is_file():
            assert violations(person.page) == []
        person.until(PAIR)
        assert time.monotonic() - began > 1.5
        person.answer("right")
        person.until(PAIR)
        person.page.reload()
        person.go("resumed")  # who comes back has looked elsewhere too
        person.until(".page-adapt .adapting")
        person.until(PAIR)


def test_time_in_which_the_grey_is_not_seen_does_not_count(paused: Site) -> None:
    with paused.visited() as guard:
        guard.context.add_init_script(
            "Object.defineProperty(document, 'hidden', { get: () => window.away === true })"
        )
        person = to_the_break(guard, 40)
        person.page.evaluate("window.away = true")
        person.page.wait_for_timeout(300)
        left = person.page.inner_text(".count")
        person.page.wait_for_timeout(1500)
        assert person.page.inner_text(".count") == left
        person.page.evaluate("window.away = false")
        person.page.wait_for_timeout(1500)
        assert int(person.page.inner_text(".count")[:-2]) < int(left[:-2])


def test_where_nothing_may_move_the_count_goes_in_steps_of_ten(paused: Site) -> None:
    with paused.visited(reduced_motion="reduce") as guard:
        person = to_the_break(guard, 40)
        person.page.wait_for_timeout(1200)
        assert person.page.inner_text(".count") == "40 s"


def test_who_comes_back_is_told_the_number_that_the_pair_itself_bears(
    browser: Browser, tmp_path: Path
) -> None:
    """Practice is counted by itself, as under the pairs."""
    study = WHOLE.replace('vision = ["contrast", "colour"]', "card = false, full_screen = false")
    study = study.replace("least_distance_mm = 100", "distance = false, levels = false")
    study = study.replace("adaptation_s = 1", "adaptation_s = 0")
    folder = frozen(study, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open()
        to_the_pairs(person)
        person.go("instructions")
        for said, own in (
            ("practice, pair 2 of 2", "Practice: 2 of 2"),
            ("pair 1 of 21", "1 of 21"),
            ("pair 2 of 21", "2 of 21"),
        ):
            person.answer("left")
            person.until(f"{PAIR}, .page-training-over")
            person.page.reload()
            person.at("resumed")
            assert said in person.page.inner_text(".sheet")
            person.go("resumed")
            person.until(PAIR)
            assert person.page.inner_text(".pair .progress > span >> nth=0") == own

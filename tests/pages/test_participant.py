"""A whole study in a real browser, by clicks: what is stored is what was clicked."""

import re
from dataclasses import dataclass
from typing import Any

import pytest

from nacreous.study.store import Session
from tests.pages.browser import AXE, PAIR, PLAIN, frozen, guarded, stored, violations
from tests.support.server_process import served

CYCLE = ("left", "right", "right", "tie", "left")


def by_turns(trial: int) -> str:
    return CYCLE[trial % len(CYCLE)]


@dataclass
class Walk:
    """A way through the whole study: what was clicked, seen and stored."""

    language: str
    given: list[str]
    pages: list[str]
    obstacles: dict[str, list[str]]
    sizes: list[dict[str, float]]
    last: str
    session: Session
    answers: list[dict[str, Any]]


@pytest.fixture(scope="module", params=["en", "ja"])
def walk(whole, request):
    """By clicks, in each language, from a Japanese browser; axe looks at each page."""
    pages, obstacles, sizes = [], {}, []

    def seen(name):
        if name not in pages and AXE.is_file():
            obstacles[name] = violations(person.page)
        if name == "pair":
            images = person.page.query_selector_all(".picture img")
            sizes[:] = [image.bounding_box() for image in images]
        pages.append(name)

    with whole.visited(locale="ja-JP") as guard:
        person = guard.open()
        person.seen = seen
        person.agree(request.param)
        person.at("groups")
        person.page.click("label >> nth=1")
        person.go("groups")
        person.go("notes")
        person.check_screen()
        given = person.trials(by_turns)
        last = person.page.inner_text("main")
        assert person.page.evaluate("document.documentElement.lang") == request.param
    return Walk(request.param, given, pages, obstacles, sizes, last, *whole.stored())


def test_the_answers_stored_are_the_clicks_made(walk):
    assert [row["trial"] for row in walk.answers] == list(range(23))
    assert [row["chosen"] for row in walk.answers] == walk.given
    assert not any(row["simulated"] or row["flags"] for row in walk.answers)
    assert all(120 <= row["response_ms"] < 5000 for row in walk.answers)
    assert walk.session.finished_at is not None
    assert ("答" if walk.language == "ja" else "stored") in walk.last


def test_what_a_person_says_of_themselves_is_stored(walk):
    assert walk.session.language == walk.language
    assert walk.session.groups["trade"] == "no"
    assert walk.session.groups["real-pearl"] in ("shown", "not-shown")


def test_pages_come_in_their_order(walk):
    before = ["language", "consent", "groups", "groups", "notes", "screen", "full", "card"]
    assert walk.pages[:8] == before
    middle = ["training-over", "break"]
    assert [name for name in walk.pages if name in middle] == middle
    assert walk.pages.count("pair") == 23


def test_what_the_screen_is_like_is_stored(walk):
    screen = walk.session.screen
    assert screen["flags"] == ["contrast-vision", "colour-vision"]
    assert screen["full_screen"] is True
    assert screen["card"]["px_per_mm"] == pytest.approx(4.5, abs=0.01)
    assert screen["gamma"] == pytest.approx(2.2, abs=0.01)
    assert (screen["darkest_step"], screen["distance_by"]) == (6, "blind-spot")
    assert 120 < screen["distance_mm"] < 200  # the dot was stopped at once
    assert re.fullmatch(r"Chromium \d+", screen["agent"])


def test_axe_finds_no_obstacle_on_any_page(walk):
    if not AXE.is_file():
        pytest.skip("no axe-core here:   ./just pages   (needs Node.js and npm)")
    assert set(walk.obstacles) == set(walk.pages)
    assert {name: found for name, found in walk.obstacles.items() if found} == {}


def test_pictures_have_the_size_that_the_card_gave(walk):
    wanted = pytest.approx(40 * walk.session.screen["card"]["px_per_mm"], abs=0.2)
    assert [(size["width"], size["height"]) for size in walk.sizes] == [(wanted, wanted)] * 2
    assert walk.sizes[0]["y"] == walk.sizes[1]["y"]


def test_the_card_is_dragged_by_its_corner(whole):
    with whole.visited() as guard:
        person = guard.open()
        person.agree("en")
        person.at("groups")
        person.page.click("label >> nth=0")
        for name in ("groups", "notes", "screen", "full"):
            person.go(name)
        person.at("card")
        handle = person.page.locator(".handle").bounding_box()
        x, y = handle["x"] + 20, handle["y"] + 20
        person.page.mouse.move(x, y)
        person.page.mouse.down()
        person.page.mouse.move(x + 40, y, steps=4)
        person.page.mouse.up()
        width = person.page.locator(".card").bounding_box()["width"]
    assert width == pytest.approx(85.6 * 96 / 25.4 + 40, abs=1)


#: A key and a click in the very frame in which the pair is shown, however slow the machine is.
EARLY = """selector => new Promise(done => {
    const look = () => {
        if (document.querySelector(selector) === null) return requestAnimationFrame(look);
        document.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
        document.querySelectorAll(".picture")[1].click();
        done();
    };
    look();
})"""


def test_what_happens_around_an_answer_is_marked(browser, tmp_path):
    study = PLAIN.replace("minimum_viewing_ms = 0", "minimum_viewing_ms = 400")
    folder = frozen(study, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open()
        person.agree()
        person.go("instructions")
        person.page.evaluate(EARLY, PAIR)
        assert person.page.inner_text(".hint") == "Please look a moment longer."
        person.answer("right", settle_ms=450)
        person.until(PAIR)
        person.page.evaluate("window.dispatchEvent(new Event('blur'))")
        person.answer("left", settle_ms=450)
        person.page.set_viewport_size({"width": 400, "height": 700})
        person.answer("left", settle_ms=450)
        box = person.page.wait_for_selector(".picture img >> nth=1").bounding_box()
        assert box["x"] + box["width"] <= 400
        person.answer("left", settle_ms=450)
        _, answers = stored(folder, at_least=4)
    flags = [row["flags"] for row in answers[:4]]
    assert flags[:2] == [{"early": 2}, {"away": 1}]
    assert flags[3]["shrunk"] == pytest.approx((376 - 12) / (2 * 60 * 96 / 25.4), abs=0.01)
    assert all(row["response_ms"] >= 400 for row in answers)


@pytest.mark.parametrize("mode", ["visual", "data-only"])
def test_a_simulation_says_so_in_every_answer(plain, whole, mode):
    site = plain if mode == "visual" else whole
    with site.visited() as guard:
        guard.open(f"/?simulate={mode}").until(".page-thanks .sheet")
    session, answers = site.stored()
    assert len(answers) == (6 if mode == "visual" else 23)
    assert all(row["simulated"] for row in answers)
    assert session.screen["simulated"] is True
    assert session.finished_at is not None
    if mode == "data-only":
        assert session.screen["flags"] == ["not-full-screen"]  # it sees rings and digits

"""A telephone in the hand: the card's corner in sight, and no word of keys that are not there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import pytest
from playwright.sync_api import Browser

from tests.pages.browser import PAIR, WHOLE, Participant, Site, frozen
from tests.pages.page_pictures import screen
from tests.support.server_process import served

KEYS = re.compile(r"\b(keys?|Esc|space bar|arrows?)\b|キー|Esc|[←→↓]")


@pytest.fixture(scope="module")
def site(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    """The whole study; its own words say nothing of keys, and the usual distances pass."""
    study = WHOLE.replace("Choose one by touch, click or key.", "Choose one.")
    study = study.replace(", least_distance_mm = 100", "")
    folder = frozen(study, tmp_path_factory.mktemp("phone") / "study")
    with served(folder) as server:
        yield Site(folder, server.url, browser)


def phone(width: int, height: int) -> dict[str, Any]:
    view = {"width": width, "height": height}
    return {"viewport": view, "has_touch": True, "is_mobile": True}


def to_the_screen(person: Participant, language: str) -> None:
    person.agree(language)
    person.at("groups")
    person.page.click("label >> nth=0")
    person.go("groups")
    person.go("notes")


def to_the_card(person: Participant, language: str) -> None:
    to_the_screen(person, language)
    person.go("screen")
    person.at("full")
    person.page.click("button.quiet")
    person.until(".page-window, .page-card")
    if person.page.query_selector(".page-window"):
        person.page.click(".actions button")
    person.at("card")


#: A study whose screens are not checked.
NO_CHECK = "card = false, distance = false, levels = false, full_screen = false, vision = []"
SIZES = [(390, 844), (360, 640), (844, 390), (1280, 800)]
#: What a browser's bars leave of small telephones.
SIZES += [(667, 250), (568, 280), (320, 420)]


@pytest.mark.parametrize("language", ["en", "ja"])
def test_the_corner_of_the_card_and_its_controls_are_in_sight_at_every_size(
    site: Site, language: str
) -> None:
    """Without scrolling, from the least drawing to the greatest, which a telephone's card needs."""
    with site.visited(**phone(*SIZES[0])) as guard:
        person = guard.open()
        to_the_card(person, language)
        for width, height in SIZES:
            person.page.set_viewport_size({"width": width, "height": height})
            person.page.wait_for_timeout(200)
            assert person.page.evaluate("document.documentElement.scrollWidth") <= width
            least, most = (
                float(person.page.get_attribute("input", name) or 0) for name in ("min", "max")
            )
            for value in (least, (least + most) / 2, most):
                slide(person, value)
                assert_in_sight(person, width, height)
            assert_read(person)
            short_mm = 53.98 if width < 640 or height < 500 else 85.6
            # CSS pixels a millimetre of most telephones, and of a small one on its side
            assert most / short_mm > (6.4 if height < 300 else 5.7) or (width, height) == (320, 420)
            turn = person.page.locator(".said p >> nth=2")
            assert turn.is_visible() is (most / short_mm < 6.5 and width < height)


def assert_read(person: Participant) -> None:
    """No line of the words stands over another."""
    lines = person.page.locator(".said > *:visible").evaluate_all(
        "found => found.map(one => one.getBoundingClientRect()).map(box => [box.top, box.bottom])"
    )
    assert all(one[1] <= other[0] for one, other in pairwise(lines)), lines


def slide(person: Participant, value: float) -> None:
    person.page.eval_on_selector(
        "input[type=range]",
        "(slider, value) => { slider.value = value; slider.dispatchEvent(new Event('input')); }",
        str(value),
    )


def assert_in_sight(person: Participant, width: int, height: int) -> None:
    """Inside the window, and under nothing else."""
    for part in (".handle", "input[type=range]", "button.main", "button.quiet"):
        box = person.page.locator(part).bounding_box()
        assert box is not None
        inside = box["x"] >= 0 and box["x"] + box["width"] <= width + 0.5
        inside = inside and box["y"] >= 0 and box["y"] + box["height"] <= height + 0.5
        assert inside, f"{part} is at {box} in {width} x {height}"
        middle = [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]
        reached = "([x, y, at]) => document.elementFromPoint(x, y)?.closest(at) !== null"
        assert person.page.evaluate(reached, [*middle, part]), f"{part} is covered"


def test_the_card_keeps_its_size_when_the_telephone_is_turned(site: Site) -> None:
    with site.visited(**phone(390, 844)) as guard:
        person = guard.open()
        to_the_card(person, "en")
        slide(person, 324)
        before = person.page.locator(".card").bounding_box()
        person.page.set_viewport_size({"width": 844, "height": 390})
        person.page.wait_for_timeout(200)
        after = person.page.locator(".card").bounding_box()
        assert before is not None
        assert after is not None
        assert after["width"] == pytest.approx(before["width"], abs=0.5)


def test_no_word_of_a_study_runs_out_of_a_narrow_page(
    browser: Browser, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """Addresses, values and questions without a blank, at the width of a small telephone."""
    address = "https://ethics.university.example/" + "perceived-depth-of-pearls-v3" * 4
    study = WHOLE.replace("Taking part is voluntary.", address)
    study = study.replace("Choose one by touch, click or key.", address)
    study = study.replace("Which looks more like a pearl?", address)
    study = study.replace("Do you work with pearls?", address).replace(
        'en = "Yes"', f'en = "{address}"'
    )
    study = study.replace("You are given a real pearl to look at.", address)
    study = study.replace("You will see pictures alone.", address)
    study = study.replace('vision = ["contrast", "colour"], least_distance_mm = 100', NO_CHECK)
    folder = frozen(study, tmp_path_factory.mktemp("words") / "study")
    seen: list[str] = []
    with (
        served(folder) as server,
        Site(folder, server.url, browser).visited(**phone(320, 568)) as guard,
    ):
        person = guard.open()

        def inside(name: str) -> None:
            seen.append(name)
            out = person.page.locator("main :visible").evaluate_all(
                "found => found.filter(one => one.getBoundingClientRect().right > 321"
                " || one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0"
                " && getComputedStyle(one).display !== 'inline'"
                " && one.textContent.includes('ethics')).map(one => one.outerHTML.slice(0, 99))"
            )
            assert out == [], name

        person.page.click("button[lang=en]")
        person.at("consent")
        inside("consent")
        person.page.check("#agreed")
        person.page.click(".page-consent button.main")
        person.at("groups")
        inside("groups")
        person.page.click("label >> nth=0")
        person.go("groups")
        person.at("notes")
        inside("notes")
        person.go("notes")
        person.at("window")
        person.page.click(".actions button")
        person.at("instructions")
        inside("instructions")
        person.go("instructions")
        person.until(PAIR)
        inside("pair")
    assert len(seen) == 5


@pytest.mark.parametrize("language", ["en", "ja"])
def test_no_page_speaks_of_keys_where_there_are_none(site: Site, language: str) -> None:
    said: dict[str, list[str]] = {}
    with site.visited(**phone(390, 844)) as guard:
        person = guard.open()

        def seen(name: str) -> None:
            said[name] = [found[0] for found in KEYS.finditer(person.page.inner_text("main"))]
            assert person.page.evaluate("document.documentElement.scrollWidth") <= 390, name

        person.seen = seen
        to_the_screen(person, language)
        screen(person)
        person.at("instructions")
        person.go("instructions")
        person.until(PAIR)
        seen("pair")
    assert {"full", "card", "blind-spot", "contrast", "colour", "pair"} <= set(said)
    assert {name: words for name, words in said.items() if words} == {}


def test_keys_are_spoken_of_where_they_may_be(site: Site) -> None:
    with site.visited() as guard:
        person = guard.open()
        to_the_screen(person, "en")
        person.go("screen")
        person.at("full")
        assert "Esc" in person.page.inner_text("main")


def follow(person: Participant, wait_ms: int) -> None:
    for _ in range(3):
        person.page.click("button.main")
        person.page.wait_for_timeout(wait_ms)
        person.page.click("button.main")


@pytest.mark.parametrize("settled", [True, False])
def test_a_distance_at_which_nobody_sits_is_asked_for_again_and_then_marked(
    site: Site, settled: bool
) -> None:
    """The dot stopped at once means 13 cm; somebody who does it again keeps the mark."""
    with site.visited() as guard:
        person = guard.open()
        to_the_screen(person, "en")
        person.go("screen")
        person.go("full")
        person.go("card")
        person.at("blind-spot")
        follow(person, 100)
        assert re.search(r"1\d cm .* can hardly be", person.page.inner_text(".now"))
        assert person.page.query_selector(".page-blind-spot") is not None
        follow(person, 1400 if settled else 100)
        person.go("gamma")
        person.at("dark")
        person.page.click(".patches button >> nth=2")
        person.at("contrast")
        for _ in range(10):
            person.page.click(".rings .up")
        person.at("colour")
        for _ in range(7):
            person.page.click(".digits .none")
        person.at("instructions")
    checked = site.stored()[0].screen
    assert checked is not None
    assert ("distance" in checked["flags"]) is not settled
    assert len(checked["distance_tries_mm"]) == 3


def test_a_typed_distance_at_which_nobody_sits_is_asked_for_again(site: Site) -> None:
    with site.visited() as guard:
        person = guard.open()
        to_the_screen(person, "en")
        person.go("screen")
        person.go("full")
        person.go("card")
        person.at("blind-spot")
        person.page.click("button.quiet")
        person.at("distance")
        person.page.fill("#distance", "290")
        person.page.click("button.main")
        assert "290 cm can hardly be" in person.page.inner_text(".missing")
        person.page.click("button.main")
        person.at("gamma")

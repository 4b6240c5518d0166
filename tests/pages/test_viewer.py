"""The viewer in a browser: from a static host, in a frame, by mouse and by keyboard."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, FilePayload, Page, expect

import nacreous as nc
from nacreous.study.design import Design
from tests.pages.browser import Guarded, guarded, violations

SIDE_PX = 256
TABS = ("presets", "pearl", "scene", "compare", "instruments")
DONE = ".pearl[data-stage=refined]"
expect.set_options(timeout=60_000)  # machines that test are busy

#: The codes on a canvas, as numbers.
CODES = """canvas => Array.from(
    canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data)"""


#: Opens what is folded away; whether there was any.
UNFOLD = """() => {
    const folded = [...document.querySelectorAll("details:not([open]) > summary")];
    folded.forEach(one => one.click());
    return folded.length > 0;
}"""


#: Controls that a message lies over.
COVERED = """() => {
    const messages = [...document.querySelectorAll(".message")];
    const over = one => {
        const box = one.getBoundingClientRect();
        return box.width > 0 && messages.some(message => {
            const other = message.getBoundingClientRect();
            return other.left < box.right && box.left < other.right
                && other.top < box.bottom && box.top < other.bottom;
        });
    };
    const controls = [...document.querySelectorAll("button, select, input, .handle, summary")];
    return controls.filter(one => one.closest(".messages") === null && over(one))
        .map(one => one.outerHTML);
}"""
BAD = FilePayload(name="bad.toml", mimeType="text/plain", buffer=b"depth = 3")


@pytest.fixture(scope="module")
def visitor(browser: Browser, host: str) -> Iterator[Guarded]:
    with guarded(browser, host, viewport={"width": 1440, "height": 900}) as guard:
        yield guard


@pytest.fixture
def page(visitor: Guarded) -> Iterator[Page]:
    """The page with its first pearl, in the smallest size."""
    opened = visitor.open("/?lang=en").page
    opened.locator(".facts select").select_option(str(SIDE_PX))
    yield opened
    opened.close()


def shows(page: Page, key: str, value: str) -> None:
    expect(page.locator(f"[data-key='{key}'] .typed input")).to_have_value(value)


def test_the_refined_picture_is_the_offline_one_byte_for_byte(page: Page) -> None:
    page.locator(f"{DONE}[width='{SIDE_PX}']").wait_for()
    shown = np.array(page.eval_on_selector(".pearl", CODES)).reshape(SIDE_PX, SIDE_PX, 4)
    made = nc.render("akoya-rg", scene="north-window-black", size=SIDE_PX, samples=16)
    np.testing.assert_array_equal(shown[:, :, :3], made.develop()[0])
    assert (shown[:, :, 3] == 255).all()


def test_hand_wheel_and_keys_turn_and_zoom_and_are_undone(page: Page) -> None:
    page.click("#tab-scene")
    box = page.locator(".pearl").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y + 20)
    page.mouse.up()
    shows(page, "camera.azimuth_deg", "-21")
    shows(page, "camera.elevation_deg", "32")
    page.mouse.wheel(0, -300)
    shows(page, "camera.field_mm", "10.64")  # of 1.5 times the pearl
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    shows(page, "camera.azimuth_deg", "0")
    page.keyboard.press("Control+Shift+z")
    shows(page, "camera.azimuth_deg", "-21")
    page.mouse.dblclick(x, y)
    shows(page, "camera.azimuth_deg", "0")
    page.focus(".pearl")
    page.keyboard.press("ArrowRight")
    shows(page, "camera.azimuth_deg", "4.9")
    page.focus(".handle")
    page.keyboard.press("ArrowLeft")
    shows(page, "windows.0.azimuth_deg", "-80")


def test_two_pearls_are_compared_and_go_into_a_study(page: Page, tmp_path: Path) -> None:
    page.click(".beside")
    page.fill("[data-key='nacre.harvest'] .typed input", "2024-08-15")
    page.click("#tab-compare")
    page.get_by_text("Wipe").click()
    page.get_by_text("Add A and B").click()
    expect(page.locator(".tray li")).to_have_count(2)
    with page.expect_download() as offered:
        page.get_by_text("Send to study").click()
    offered.value.save_as(tmp_path / "study.toml")
    study = Design.load(tmp_path / "study.toml")
    assert [one.overrides for one in study.stimuli] == [(), ('nacre.harvest="2024-08-15"',)]
    page.locator(DONE).nth(1).wait_for()


def test_a_link_and_files_bring_the_same_pearl_again(
    page: Page, visitor: Guarded, tmp_path: Path
) -> None:
    page.fill("[data-key='shininess'] .typed input", "0.31")
    expect(page).to_have_url(re.compile("#1[.]"))
    other = visitor.open("/?lang=ja" + page.url[page.url.index("#") :]).page
    expect(other.locator("[data-key='shininess'] .typed input")).to_have_value("0.31")
    page.locator(".menu .tool").click()
    with page.expect_download() as offered:
        page.get_by_text("Pearl file").click()
    offered.value.save_as(tmp_path / "pearl.toml")
    assert nc.Pearl.load(tmp_path / "pearl.toml").shininess == 0.31
    other.close()


def test_what_is_wrong_is_told_once_and_goes_with_its_cause(page: Page) -> None:
    """At its knob; over the picture where the knob is not to be seen."""
    failed = page.locator(".failed")
    page.fill("[data-key='nacre.harvest'] .typed input", "9999-12-31")
    expect(page.locator(".complaint")).to_have_text(
        re.compile('^Harvest is "9999-12-31"; allowed: 1 day to 20 years after Seeding')
    )
    expect(failed).to_contain_text("See the knob: Harvest")
    expect(failed).not_to_contain_text("9999")
    page.click("#tab-scene")
    expect(failed).to_contain_text('Harvest is "9999-12-31"; allowed: ')
    page.get_by_role("button", name="Start over").click()
    expect(failed).to_have_count(0)


def test_why_a_number_was_not_taken_stays_until_the_next(page: Page) -> None:
    why = page.locator("[data-key='shininess'] .range")
    page.fill("[data-key='shininess'] .typed input", "７")
    page.keyboard.press("Enter")
    shows(page, "shininess", "0.65")
    expect(why).to_have_text("“７” was not taken; allowed: 0 to 1")
    page.fill("[data-key='shininess'] .typed input", "０．３")
    page.keyboard.press("Enter")
    shows(page, "shininess", "0.3")
    expect(why).to_be_empty()


def test_what_is_damaged_is_told_once_and_changes_nothing(page: Page, visitor: Guarded) -> None:
    page.set_input_files("input[type=file]", [BAD])
    expect(page.locator(".message.wrong li")).to_have_text(
        ["bad.toml: depth is 3; allowed: 0 to 1"]
    )
    shows(page, "depth", "0.45")
    linked = visitor.open("/?lang=en#1.AAAA").page
    expect(linked.locator(".message.wrong li")).to_have_count(1)
    linked.locator(DONE).wait_for()
    linked.close()


@pytest.mark.parametrize("width", [1440, 390])
@pytest.mark.parametrize("language", ["en", "ja"])
def test_nothing_is_in_anybodys_way(browser: Browser, host: str, width: int, language: str) -> None:
    size = {"width": width, "height": 844}
    with guarded(browser, host, viewport=size, bypass_csp=True) as guard:
        page = guard.open(f"/?lang={language}").page
        page.set_input_files("input[type=file]", [BAD])
        page.locator(".message.wrong").wait_for()
        assert page.evaluate(COVERED) == []
        for tab in TABS[width > 1000 :]:
            page.click(f"#tab-{tab}")
            while page.evaluate(UNFOLD):
                pass
            assert violations(page) == []
            wide = page.evaluate("document.documentElement.scrollWidth")
            assert wide <= width, f"{tab} is {wide} px wide"


def test_the_page_works_in_a_frame_of_another(browser: Browser, host: str) -> None:
    with guarded(browser, host) as guard:
        outer = guard.context.new_page()
        outer.set_content(f"<iframe src={json.dumps(host + '/?lang=en')} width=1200 height=800>")
        outer.frame_locator("iframe").locator(DONE).wait_for()

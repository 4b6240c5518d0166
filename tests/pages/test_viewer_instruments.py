"""The viewer's instruments: the numbers that it copies are the package's own."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

import nacreous as nc
from nacreous.image import field_mm
from nacreous.measure import measure
from nacreous.nacre import columns_of, diary
from nacreous.optics import energies
from nacreous.spec import Growth, Pearl
from tests.pages.browser import guarded

SIDE_PX = 256
SHOWN = ("akoya-rg", "north-window-black")
expect.set_options(timeout=60_000)  # machines that test are busy


@pytest.fixture(scope="module")
def page(browser: Browser, host: str) -> Iterator[Page]:
    """The instruments beside the first pearl, in the smallest size."""
    with guarded(browser, host, viewport={"width": 1440, "height": 900}) as guard:
        guard.context.grant_permissions(["clipboard-read", "clipboard-write"])
        opened = guard.open("/?lang=en").page
        opened.locator(".facts select").select_option(str(SIDE_PX))
        opened.click("#tab-instruments")
        yield opened


def copied(page: Page) -> list[list[str]]:
    """What was copied, as rows of cells; the clipboard is emptied for the next."""
    page.wait_for_function("async () => (await navigator.clipboard.readText()) !== ''")
    text = page.evaluate("navigator.clipboard.readText()")
    page.evaluate("navigator.clipboard.writeText('')")
    return [line.split("\t") for line in text.split("\n")]


def test_spectra_at_the_point_are_the_films_at_its_angle(page: Page) -> None:
    page.focus(".probe")
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    column, row = int(0.6 * SIDE_PX), SIDE_PX // 2
    page.locator(f"[data-column='{column}'][data-row='{row}']").wait_for()
    page.keyboard.press("Enter")
    (_, degrees), _, *spectra = copied(page)
    pearl = Pearl.load("akoya-rg")
    aside = np.hypot(column + 0.5 - SIDE_PX / 2, 0.5) * field_mm(*SHOWN) / SIDE_PX
    assert np.sin(np.radians(float(degrees))) == pytest.approx(2 * aside / pearl.diameter_mm, 0.05)
    nm, R, T = np.array(spectra, float).T
    found = [energies(one, [np.radians(float(degrees))], nm) for one in columns_of(pearl)]
    np.testing.assert_allclose(R, np.mean([one.R[0] for one in found], 0), atol=1e-5)
    np.testing.assert_allclose(T, np.mean([one.T[0] for one in found], 0), atol=1e-5)


def test_layers_have_the_days_on_which_they_grew(page: Page) -> None:
    page.get_by_label("Copy numbers: Layers and days").click()
    _, *rows = copied(page)
    nacre = Pearl.load("akoya-rg").nacre
    assert isinstance(nacre, Growth)
    grown = diary(nacre)
    assert [date for _, _, date in rows] == [day.isoformat() for day in reversed(grown.date)]
    thickness_nm = np.array([float(nm) for _, nm, _ in rows])
    np.testing.assert_allclose(thickness_nm, grown.thickness_nm[::-1], rtol=1e-12)


def test_measures_are_those_of_the_same_picture(page: Page) -> None:
    page.locator("[data-fresh=true]").wait_for()
    page.get_by_label("Copy numbers: Measures").click()
    rows = copied(page)
    page_says = {row[0]: row[1:] for row in rows}
    picture = nc.render(SHOWN[0], scene=SHOWN[1], size=SIDE_PX, samples=16)
    found = measure(picture, mm_per_pixel=field_mm(*SHOWN) / SIDE_PX)
    assert found.roundness is not None
    assert found.colour is not None
    assert found.interference is not None
    assert found.lamp is not None
    assert found.blemishes is not None
    for name, number in {
        "diameter": found.size.mean,
        "roundness": found.roundness,
        "lightness": found.colour.lightness,
        "orient": found.interference.orient,
        "score": found.interference.score,
        "halfWidth": found.lamp.half_width_deg,
        "gloss": found.lamp.contrast_gloss,
        "blemishArea": found.blemishes.area,
    }.items():
        value, error, _ = page_says[name]
        assert float(value) == pytest.approx(number.value, rel=1e-4, abs=1e-6), name
        if number.error is not None:
            assert float(error) == pytest.approx(number.error, rel=1e-2, abs=1e-6), name
    refused = {row[1]: row[2] for row in rows if row[0] == "refused"}
    assert found.refused.items() <= refused.items()


def test_a_value_is_copied_by_enter(page: Page) -> None:
    value = page.locator("[data-quantity=diameter]")
    value.focus()
    page.keyboard.press("Enter")
    assert copied(page) == [[value.inner_text()]]


def test_what_cannot_be_made_is_said_once_and_not_waited_for(page: Page) -> None:
    page.click("#tab-pearl")
    page.fill("[data-key='nacre.harvest'] .typed input", "2999-12-31")
    page.click("#tab-instruments")
    expect(page.locator(".panel .nothing")).to_contain_text("See the knob: Harvest")
    expect(page.locator(".panel")).not_to_contain_text("Measuring")
    expect(page.locator(".panel")).not_to_contain_text("nacre.")

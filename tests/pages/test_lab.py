"""The laboratory in a browser: a study steered and watched, in both languages, for everyone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

from nacreous.study.design import open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Response, Store
from tests.pages.browser import Guarded, chromium, guarded
from tests.support.gathering import by_scale, frozen_study, take_part
from tests.support.server_process import NAME, PASSWORD, Served, served

SCALE = {"a": 1.0, "b": 0.5, "c": 0.0, "d": -0.5, "e": -1.0}
TABS = ("overview", "people", "scale", "invitations", "log")
AXE = Path(__file__).parent.parent.parent / "studio" / "node_modules" / "axe-core" / "axe.min.js"
expect.set_options(timeout=20_000)  # machines that test are busy

#: What a browser says of a refusal that a test brings about.
REFUSED = r"status of (401|429)|Failed to load resource"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as made:
        yield made


@pytest.fixture(scope="module")
def frozen(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A study in which twelve made-up people and twelve simulated ones have taken part."""
    folder = tmp_path_factory.mktemp("lab")
    made = frozen_study(
        folder,
        name="colours",
        pairs={"repeats": 2},
        catches=[{"expected": "a", "against": "e"}],
        groups=[{"name": "lamp", "values": ["warm", "cold"]}],
        screen={"card": False, "distance": False, "levels": False, "full_screen": False},
    )
    with Store.open(made.folder) as store:
        running = Running(store, made)
        store.set_registration(running.study, "open", "test")
        for simulated in (False, True):
            random = np.random.default_rng(4 + simulated)
            for _ in range(12):
                take_part(running, by_scale(SCALE, random), simulated=simulated)
        take_part(running, lambda _: "left", flags={"away": 3})
    return made.folder


@pytest.fixture(scope="module")
def server(frozen: Path) -> Iterator[Served]:
    with served(frozen) as made:
        yield made


@pytest.fixture
def guard(browser: Browser, server: Served) -> Iterator[Guarded]:
    with guarded(browser, server.url, viewport={"width": 1440, "height": 900}) as made:
        yield made


def entered(guard: Guarded, tab: str = "overview") -> Page:
    """The page, after a login by the keyboard alone."""
    page = guard.context.new_page()
    page.goto(f"{guard.url}/lab#{tab}")
    expect(page.locator("#name")).to_be_focused()
    page.keyboard.type(NAME)
    page.keyboard.press("Tab")
    page.keyboard.type(PASSWORD)
    page.keyboard.press("Enter")
    page.wait_for_selector("nav a[aria-current]")
    return page


def go(page: Page, tab: str) -> None:
    page.click(f"nav a[href='#{tab}']")
    page.wait_for_selector(f"nav a[href='#{tab}'][aria-current]")


def violations(page: Page) -> list[str]:
    """What axe finds."""
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = page.evaluate("async () => (await axe.run()).violations")
    return [f"{one['id']}: {[node['target'] for node in one['nodes']]}" for one in found]


def figure(page: Page, name: str) -> str:
    return page.locator(".figure", has_text=re.compile(name)).locator("dd").inner_text()


def test_a_wrong_password_is_told_and_the_right_one_opens(browser: Browser, server: Served) -> None:
    with guarded(browser, server.url, REFUSED) as guard:
        page = guard.context.new_page()
        page.goto(f"{guard.url}/lab")
        page.fill("#name", NAME)
        page.fill("#password", "not the password")
        page.click("button[type=submit]")
        expect(page.locator(".trouble")).to_have_text("The name or the password is wrong.")
        page.fill("#password", PASSWORD)
        page.keyboard.press("Enter")
        expect(page.locator("h1")).to_have_text("colours")
        page.reload()
        expect(page.locator("h1")).to_have_text("colours")
        page.click("text=Log out")
        expect(page.locator("#password")).to_be_visible()


def test_figures_are_those_of_the_store_and_simulated_ones_stand_apart(
    guard: Guarded, frozen: Path
) -> None:
    page = entered(guard)
    page.wait_for_selector(".figure")
    with Store.open(frozen) as store:
        found = store.progress(store.study())
    people = found.entered - 12
    assert figure(page, "entered").split() == [str(people), "and", "12", "simulated"]
    said = figure(page, "answers").split()
    assert said == [str(found.answers - found.simulated), "and", str(found.simulated), "simulated"]


def test_progress_moves_while_somebody_answers(guard: Guarded, frozen: Path) -> None:
    page = entered(guard, "people")
    rows = page.locator("tbody tr:not(.why)")
    expect(rows.first).to_be_visible()
    before = rows.count()
    with Store.open(frozen) as store:
        running = Running(store, open_frozen(frozen))
        token = "t" * 43
        session = running.enter(token, "en", {})
        store.consent(session.id)
        session = running.session_of(token)
        for trial in running.plan(session)[:4]:  # three of them for practice, as the page counts
            running.hand_in(session, trial.number, Response("left")).result()
        expect(rows).to_have_count(before + 1)
        row = page.locator("tbody tr", has=page.locator(f"th:text-is('{session.number}')"))
        expect(row.locator(".count")).to_have_text("1 of 13")
        for trial in running.plan(session)[4:6]:
            running.hand_in(session, trial.number, Response("left")).result()
        expect(row.locator(".count")).to_have_text("3 of 13")


def test_flags_are_explained_on_demand_by_keyboard(guard: Guarded) -> None:
    page = entered(guard, "people")
    button = page.locator("#flags-of-24")
    expect(button).to_contain_text("mostly left")
    button.focus()
    page.keyboard.press("Enter")
    expect(page.locator("tr.why")).to_contain_text("chosen 12 of 12 times")
    expect(button).to_be_focused()
    expect(button).to_have_attribute("aria-expanded", "true")
    page.keyboard.press("Enter")
    expect(page.locator("tr.why")).to_have_count(0)


def test_a_person_is_excluded_with_a_reason_and_readmitted(guard: Guarded, frozen: Path) -> None:
    page = entered(guard, "people")
    page.click("#exclude-24")
    expect(page.locator("#reason")).to_be_focused()
    page.keyboard.press("Enter")  # not without a reason
    expect(page.locator("dialog")).to_be_visible()
    page.keyboard.type("always left <b>")
    page.keyboard.press("Enter")
    expect(page.locator("tr.excluded")).to_contain_text("Excluded: always left <b>")
    with Store.open(frozen) as store:
        reasons = {one.number: one.excluded_reason for one in store.sessions(store.study())}
        assert reasons[24] == "always left <b>"
    page.click("#readmit-24")
    expect(page.locator("tr.excluded")).to_have_count(0)
    page.click("#exclude-24")
    page.keyboard.press("Escape")
    expect(page.locator("dialog")).to_have_count(0)
    expect(page.locator("tr.excluded")).to_have_count(0)


def test_a_study_is_paused_closed_and_reopened(guard: Guarded, frozen: Path) -> None:
    page = entered(guard)
    state = page.locator("header .badge")
    page.click("#to-paused")
    expect(state).to_have_text("Paused")
    page.click("#to-open")
    expect(state).to_have_text("Open")
    page.click("#to-closed")
    page.click("dialog button.main")
    expect(state).to_have_text("Closed")
    page.click("#to-open")
    expect(state).to_have_text("Open")
    page.check("#registration-invited")
    expect(page.locator("text=Each person needs a link")).to_be_visible()
    page.check("#registration-open")
    expect(page.locator("code")).to_have_text(f"{guard.url}/")
    with Store.open(frozen) as store:
        what = [event.what for event in store.events(store.study())]
    assert {"study paused", "study closed", "study open", "registration invited"} <= set(what)


def test_invitations_are_made_copied_used_and_revoked(guard: Guarded, frozen: Path) -> None:
    guard.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = entered(guard, "invitations")
    page.fill("#count", "2")
    page.fill("#label", "graders of Ise")
    page.click("text=Make links")
    links = page.locator(".links code")
    expect(links).to_have_count(2)
    first = links.first.inner_text()
    assert first.startswith(f"{guard.url}/#")
    page.locator(".links button").first.click()
    expect(page.locator(".links button").first).to_have_text("Copied")
    assert page.evaluate("navigator.clipboard.readText()") == first
    page.locator(".links button", has_text="QR code").first.click()
    expect(page.locator("dialog svg.code")).to_be_visible()
    expect(page.locator("dialog code")).to_have_text(first)
    assert violations(page) == []
    page.keyboard.press("Escape")
    expect(page.locator("dialog")).to_have_count(0)
    page.click("text=Copy all")
    page.wait_for_function(
        "async text => (await navigator.clipboard.readText()) === text",
        arg="\n".join(links.all_inner_texts()),
    )
    with Store.open(frozen) as store:
        Running(store, open_frozen(frozen)).enter(first.partition("#")[2], "en", {})
    expect(page.locator("tbody tr", has_text="used by person")).to_have_count(1)
    page.locator("tbody button").first.click()
    page.click("dialog button.main")
    expect(page.locator("tbody tr", has_text="revoked")).to_have_count(1)
    page.click("text=I have them")
    expect(links).to_have_count(0)


def test_the_scale_of_people_and_of_simulated_ones_are_kept_apart(guard: Guarded) -> None:
    page = entered(guard, "scale")
    chart = page.locator("svg.chart")
    expect(chart).to_be_visible()
    assert "simulated" not in (chart.get_attribute("class") or "")
    assert page.locator("svg .label").all_text_contents() == list("abcde")
    pictures = page.locator("svg image").evaluate_all(
        "images => Promise.all(images.map(async one =>"
        " (await fetch(one.getAttribute('href'))).headers.get('Content-Type')))"
    )
    assert pictures == ["image/png"] * 5
    page.check("#whose-simulated")
    marked = page.locator("svg.chart.simulated")
    expect(marked.locator(".mark")).to_have_text("SIMULATED")
    expect(page.locator(".note")).to_contain_text("No person gave these answers")
    page.click("summary")
    expect(page.locator(".numbers tbody tr")).to_have_count(5)


def test_reports_and_answers_are_brought_as_files(guard: Guarded, tmp_path: Path) -> None:
    page = entered(guard)
    reports = page.locator(".take", has_text="Which is deeper?")
    for place, language, said in ((0, "Japanese", "どちらが深い?"), (1, "English", "(simulated)")):
        with page.expect_download(timeout=60_000) as waiting:
            reports.nth(place).get_by_text(f"Report in {language}").click()
        text = waiting.value.path().read_text(encoding="utf-8")
        assert said in text[: text.index("</title>")]
    with page.expect_download() as waiting:
        page.click("text=All answers as a table")
    assert waiting.value.suggested_filename == "answers.csv"
    lines = waiting.value.path().read_text(encoding="utf-8").splitlines()
    assert len(lines) > 25 * 13
    assert '"simulated"' in lines[0]


def test_the_log_says_who_did_what_and_tells_no_password(guard: Guarded) -> None:
    page = entered(guard, "log")
    expect(page.locator("tbody")).to_contain_text("registration open")
    expect(page.locator("tbody")).not_to_contain_text(PASSWORD)


def test_a_login_that_ended_is_made_again_without_losing_the_page(
    browser: Browser, server: Served, frozen: Path
) -> None:
    with guarded(browser, server.url, REFUSED) as guard:
        page = entered(guard, "invitations")
        page.fill("#label", "half typed")
        with Store.open(frozen) as store:
            store.set_password(NAME, PASSWORD, "test")  # ends every login under the name
        dialog = page.locator("dialog.ended")
        expect(dialog).to_be_visible()
        assert violations(page) == []
        page.keyboard.press("Escape")
        expect(dialog).to_be_visible()
        page.fill("dialog #password", PASSWORD)
        page.keyboard.press("Enter")
        expect(dialog).to_have_count(0)
        expect(page.locator("#label")).to_have_value("half typed")
        page.click("text=Make links")
        expect(page.locator(".links code")).to_have_count(1)


def test_a_server_that_is_gone_is_told_until_it_is_back(browser: Browser, server: Served) -> None:
    with guarded(browser, server.url, "ERR_|Failed to load") as guard:
        page = entered(guard)
        page.wait_for_selector(".figure")
        guard.context.set_offline(True)
        expect(page.locator(".banner")).to_contain_text("The server does not answer")
        assert figure(page, "entered") != ""
        guard.context.set_offline(False)
        expect(page.locator(".banner")).to_have_count(0, timeout=60_000)


@pytest.mark.parametrize(
    ("language", "width"), [("en", 1440), ("ja", 1440), ("en", 800), ("ja", 360)]
)
def test_every_view_is_for_everyone(
    browser: Browser, server: Served, language: str, width: int
) -> None:
    if not AXE.is_file():
        pytest.skip("no axe-core here:   ./just pages   (needs Node.js and npm)")
    locale = {"en": "en-GB", "ja": "ja-JP"}[language]
    view = {"width": width, "height": 700}
    with guarded(browser, server.url, viewport=view, locale=locale) as guard:
        page = guard.context.new_page()
        page.goto(f"{guard.url}/lab")
        page.wait_for_selector("#password")
        found = {"login": violations(page)}
        page.close()
        page = entered(guard)
        assert page.evaluate("document.documentElement.lang") == language
        for tab in TABS:
            go(page, tab)
            page.wait_for_selector(
                {"overview": ".figure", "scale": "svg.chart"}.get(tab, "main h2")
            )
            page.wait_for_timeout(300)
            if tab == "people":
                page.click("#flags-of-24")
                page.click("#exclude-24")
                found["dialog"] = violations(page)
                page.keyboard.press("Escape")
            found[tab] = violations(page)
            wide = page.evaluate("document.documentElement.scrollWidth")
            assert wide <= width, f"{tab} is {wide} px wide"
        assert {name: of for name, of in found.items() if of} == {}


CUT = """() => [...document.querySelectorAll('.scroll td, .scroll th')].filter(cell => {
    const { left, right, width } = cell.getBoundingClientRect();
    return width > 1 && (left < 0 || right > innerWidth || cell.scrollWidth > cell.clientWidth);
}).map(cell => cell.textContent)"""


@pytest.mark.parametrize("locale", ["en-GB", "ja-JP"])
def test_tables_are_whole_on_a_telephone_and_each_value_bears_its_name(
    browser: Browser, server: Served, locale: str
) -> None:
    view = {"width": 390, "height": 844}
    with guarded(browser, server.url, viewport=view, locale=locale) as guard:
        page = entered(guard, "people")
        for tab in ("people", "scale", "invitations", "log"):
            go(page, tab)
            page.wait_for_selector(".scroll tbody tr", state="attached")
            if tab == "scale":
                page.click("summary")
            assert page.evaluate(CUT) == [], tab
            named = page.evaluate(
                "[...document.querySelectorAll('.scroll thead th')].map(one => one.textContent)"
            )
            told = page.evaluate(
                "[...document.querySelector('.scroll tbody tr').cells].map(one =>"
                " getComputedStyle(one, '::before').content)"
            )
            assert told == [f'"{name}"' for name in named]


def test_the_language_changes_in_place(guard: Guarded) -> None:
    page = entered(guard, "people")
    page.select_option("#shown", "flagged")
    page.click("text=日本語")
    expect(page.locator("nav a[aria-current]")).to_have_text("参加者")
    assert page.locator("#shown").input_value() == "flagged"
    expect(page.locator("tbody tr")).to_have_count(page.locator("button.chips").count())
    page.reload()
    expect(page.locator("nav a[aria-current]")).to_have_text("参加者")

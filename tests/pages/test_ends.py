"""Pages with which a sitting ends or cannot begin: kind words, a way on, no obstacle for axe."""

import json
import re

import pytest

from nacreous.study.store import Store
from tests.pages.browser import AXE, PAIR, PLAIN, frozen, guarded, stored, violations
from tests.support.server_process import served

FAILING = "Failed to load resource"


def told(change):
    """Answers /api/study as the server does, but for some facts."""

    def answer(route):
        response = route.fetch()
        route.fulfill(response=response, body=json.dumps({**response.json(), **change}))

    return answer


def assert_kind(person):
    """A title and a sentence, and nothing that axe finds."""
    assert person.page.inner_text("h1") != ""
    assert len(person.page.inner_text(".sheet p")) > 15
    if AXE.is_file():
        assert violations(person.page) == []


@pytest.mark.parametrize("locale", ["en-GB", "ja-JP"])
@pytest.mark.parametrize(
    ("end", "change"),
    [
        ("paused", {"state": "paused"}),
        ("closed", {"state": "closed"}),
        ("invited", {"registration": "invited"}),
    ],
)
def test_who_cannot_enter_is_told_why(plain, locale, end, change):
    with plain.visited(locale=locale) as guard:
        guard.context.route(
            "**/api/study",
            told({**change, "languages": ["en", "ja"], "consent": {"ja": "", "en": ""}}),
        )
        person = guard.open()
        person.at(end)
        assert person.page.evaluate("document.documentElement.lang") == locale[:2]
        assert_kind(person)


@pytest.mark.parametrize("locale", ["en-GB", "ja-JP"])
def test_who_declines_leaves_nothing_behind(whole, locale):
    with whole.visited(locale=locale) as guard:
        person = guard.open()
        requests = []
        guard.context.on("request", lambda request: requests.append(request.method))
        person.at("language")
        person.page.click(f"button[lang={locale[:2]}]")
        person.at("consent")
        person.page.click(".page-consent .actions .quiet")
        person.at("declined")
        assert_kind(person)
        assert set(requests) <= {"GET"}
        person.page.click("button.main")
        person.at("language")


@pytest.fixture
def invitations(plain):
    """Two of them, to a study that lets nobody else in."""
    with Store.open(plain.folder) as store:
        store.set_registration(store.study(), "invited", "test")
        yield store.invite(store.study(), 2, "two people", "test")
        store.set_registration(store.study(), "open", "test")


def test_an_invitation_lets_one_person_in(plain, invitations):
    token, other = invitations
    with plain.visited(expected=FAILING) as guard:
        cut = guard.open(f"/#{token[:-4]}")
        cut.agree()
        cut.at("unknown")
        assert_kind(cut)
        cut.page.goto(f"{plain.url}/#{token}")  # only what is behind the # changes
        cut.agree()
        cut.go("instructions")
        assert cut.page.url == f"{plain.url}/"  # the token is in no address that is sent on
        cut.answer("left")
        cut.page.reload()
        assert cut.wait() == "resumed"
        first, _ = plain.stored()
        cut.page.close()
        second = guard.open(f"/#{other}")
        second.agree()
        second.go("instructions")
        second.until(PAIR)
    session, answers = plain.stored()
    assert (session.number, answers) == (first.number + 1, [])


def test_a_person_whose_token_is_revoked_is_told(plain):
    with plain.visited(expected=FAILING) as guard:
        person = guard.open()
        person.agree()
        person.go("instructions")
        session, _ = plain.stored()
        with Store.open(plain.folder) as store:
            store.revoke(session.id, "test")
        person.answer("left")
        person.at("unknown")
        assert_kind(person)


def test_stopping_and_withdrawing(browser, tmp_path):
    study = PLAIN.replace("training = 0", "training = 0, break_every = 2")
    folder = frozen(study, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open()
        person.agree()
        person.go("instructions")
        for _ in range(2):
            person.answer("left")
        for way in ("back", "later", "withdraw"):
            person.until(".page-break .sheet, .page-resumed .sheet")
            person.page.click(".actions .quiet")
            person.at("stop")
            assert_kind(person)
            person.page.click(f".actions button >> nth={('back', 'later', 'withdraw').index(way)}")
            if way == "later":
                person.go("later")
        person.at("withdrawn")
        assert_kind(person)
    session, answers = stored(folder)
    assert session.excluded_reason == "withdrew"
    assert len(answers) == 2


def test_a_screen_that_is_refused_may_be_checked_again(browser, tmp_path):
    study = PLAIN.replace('["en"]', '["en", "ja"]').replace(
        '"Which is deeper?"', '"Which is deeper?", ja = "どちらが深い?"'
    )
    study = study.replace("full_screen = false", 'full_screen = false, if_smaller = "refuse"')
    folder = frozen(study, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url, locale="ja-JP") as guard:
        person = guard.open()
        person.page.set_viewport_size({"width": 700, "height": 700})
        person.agree("ja")
        person.at("window")
        assert re.search("1024.*700", person.page.inner_text(".sheet"), re.S)
        assert_kind(person)
        person.page.click(".actions button")
        person.at("refused")
        assert_kind(person)
        person.page.set_viewport_size({"width": 1100, "height": 700})
        person.page.click("button.main")
        person.at("instructions")
    assert stored(folder)[0].screen["flags"] == []


BACK = """
[entry]
parameters = ["PROLIFIC_PID"]

[completion]
own_code = true
return_url = "https://platform.example/done?cc={CODE}&id={PROLIFIC_PID}"
"""


@pytest.mark.parametrize("language", ["en", "ja"])
def test_who_has_finished_is_given_the_code_and_the_way_back_and_nobody_before(
    browser, tmp_path, language
):
    study = PLAIN.replace('["en"]', '["en", "ja"]').replace(
        '"Which is deeper?"', '"Which is deeper?", ja = "どちらが深い?"'
    )
    folder = frozen(study + BACK, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        person = guard.open("/?PROLIFIC_PID=5f%2F0&utm_source=mail")
        person.agree(language)
        person.go("instructions")
        first, _ = stored(folder)
        assert first.parameters == {"PROLIFIC_PID": "5f/0"}
        assert first.completion_code not in person.page.content()
        person.trials(lambda trial: "left")
        for _ in range(2):
            person.at("thanks")
            assert_kind(person)
            assert person.page.inner_text(".completion") == first.completion_code
            address = f"https://platform.example/done?cc={first.completion_code}&id=5f%2F0"
            assert person.page.get_attribute("a.button", "href") == address
            assert person.page.query_selector_all(".actions button") == []
            person.page.reload()
        other = guard.open("/?PROLIFIC_PID=other")  # at the same computer
        person.page.close()
        other.page.reload()
        other.agree(language)
        other.at("instructions")
    second, _ = stored(folder)
    assert (second.number, second.parameters) == (first.number + 1, {"PROLIFIC_PID": "other"})


def test_an_address_that_cannot_be_kept_is_said_to_be_no_good_before_anything_is_asked(
    browser, tmp_path
):
    folder = frozen(PLAIN + BACK, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url) as guard:
        for value in ("7" * 201, "5f%0a0c", "5f%E2%80%AE", "5f%00"):
            person = guard.open(f"/?PROLIFIC_PID={value}")
            person.at("unknown")
            assert_kind(person)
            person.page.close()


def test_another_person_may_begin_at_the_same_computer(plain):
    with plain.visited() as guard:
        person = guard.open()
        person.agree()
        person.trials(lambda trial: "left")
        first, _ = plain.stored()
        person.page.reload()
        person.at("thanks")
        assert_kind(person)
        person.page.click(".actions button")
        person.agree()
        person.at("instructions")
    second, answers = plain.stored()
    assert (second.number, answers) == (first.number + 1, [])

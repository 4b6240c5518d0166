"""What can go wrong between a browser and its server: no answer is lost, none counts twice."""

import time

import pytest

from nacreous.study.store import Store
from tests.pages.browser import PAIR, PLAIN, Site, frozen, guarded
from tests.support.server_process import served

#: What Chromium says of requests that a test makes fail.
FAILING = "Failed to load resource|net::ERR_"


def begun(guard, path="/"):
    """Somebody who has read the instructions."""
    person = guard.open(path)
    person.agree()
    person.go("instructions")
    return person


def by_turns(trial):
    return ("left", "right", "right")[trial % 3]


def assert_all_there(site, given):
    """Each answer once, in order, as it was given."""
    _, answers = site.stored()
    assert [row["trial"] for row in answers] == list(range(6))
    assert [row["chosen"] for row in answers] == given
    return answers


def test_half_a_minute_without_network_and_with_errors(plain):
    with plain.visited(expected=FAILING) as guard:
        person = begun(guard)
        given = []

        def answer(count, seconds):
            until = time.monotonic() + seconds
            for _ in range(count):
                given.append(by_turns(len(given)))
                person.answer(given[-1])
                person.page.wait_for_timeout(1000 * (until - time.monotonic()) / (count + 1))
            person.page.wait_for_timeout(max(0, 1000 * (until - time.monotonic())))

        answer(1, 1)
        guard.context.set_offline(True)
        answer(3, 15)
        assert "Not connected" in person.page.inner_text(".notice")
        guard.context.route("**/api/answers/*", lambda route: route.fulfill(status=500))
        guard.context.set_offline(False)
        answer(2, 15)
        assert "5 answers" in person.page.inner_text(".page-sending")
        guard.context.unroute("**/api/answers/*")
        assert person.wait() == "thanks"
        assert person.page.inner_text(".notice") == ""
    assert_all_there(plain, given)


def test_a_receipt_that_is_lost_and_a_tab_that_is_closed(plain):
    with plain.visited(expected=FAILING) as guard:
        person = begun(guard)
        given = [by_turns(trial) for trial in range(4)]
        for chosen in given[:2]:
            person.answer(chosen)

        def lose_receipt(route):
            route.fetch()
            route.abort()

        guard.context.route("**/api/answers/2", lose_receipt)
        for chosen in given[2:]:
            person.answer(chosen)
        person.until(PAIR)
        person.page.close()
        guard.context.unroute("**/api/answers/2")
        again = guard.open()
        assert again.wait() == "resumed"
        assert "pair 5 of 6" in again.page.inner_text("main")
        given += again.trials(lambda trial: by_turns(trial + 4))
    assert_all_there(plain, given)


def test_answers_left_behind_go_with_the_next_person(plain):
    with plain.visited(expected=FAILING) as guard:
        first = begun(guard)
        first.answer("left")
        plain.stored(at_least=1)
        guard.context.route("**/api/answers/*", lambda route: route.abort())
        first.answer("right")
        first.answer("right")
        first.until(PAIR)
        left, answers = plain.stored()
        assert len(answers) == 1
        first.page.close()
        guard.context.unroute("**/api/answers/*")
        with Store.open(plain.folder) as store:
            [token] = store.invite(store.study(), 1, "the next", "test")
            begun(guard, f"/#{token}").trials(by_turns)
            rows = store.answers(store.study(), left.id)
    assert [row["chosen"] for row in rows] == ["left", "right", "right"]
    assert_all_there(plain, [by_turns(trial) for trial in range(6)])


def test_a_server_that_is_killed_and_started_again(browser, tmp_path):
    folder = frozen(PLAIN, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url, FAILING) as guard:
        site = Site(folder, server.url, browser)
        person = begun(guard)
        given = ["left", "right", "left"]
        for chosen in given:
            person.answer(chosen)
        server.kill()
        for chosen in ("right", "left"):
            person.answer(chosen)
            given.append(chosen)
        port = server.url.rsplit(":", 1)[1]
        with served(folder, "--port", port):
            given += person.trials(by_turns)
    assert_all_there(site, given)


def test_a_clock_that_jumps_changes_no_response_time(plain):
    with plain.visited() as guard:
        guard.context.add_init_script(
            """
            const Real = Date;
            const jump = () => (Math.random() - 0.5) * 864e5;
            window.Date = class extends Real {
              constructor(...told) { told.length ? super(...told) : super(Real.now() + jump()); }
              static now() { return Real.now() + jump(); }
            };
            """
        )
        given = begun(guard).trials(by_turns)
    answers = assert_all_there(plain, given)
    assert all(100 <= row["response_ms"] < 5000 for row in answers)


def test_of_two_tabs_one_goes_on(plain):
    with plain.visited() as guard:
        first = begun(guard)
        first.answer("left")
        second = guard.open()
        second.at("tabs")
        first.answer("right")
        first.until(PAIR)
        first.page.close()
        second.page.click("button.main")
        given = ["left", "right", *second.trials(by_turns)]
    assert_all_there(plain, given)


def test_an_answer_that_the_server_has_otherwise_stays(plain):
    with plain.visited(expected=FAILING) as guard:
        person = begun(guard)

        def meddle(route):
            other = {**route.request.post_data_json, "chosen": "right"}
            route.fetch(post_data=other)
            route.continue_()

        guard.context.route("**/api/answers/0", meddle)
        given = person.trials(lambda trial: "left")
    assert_all_there(plain, ["right", *given[1:]])


@pytest.mark.parametrize("broken", ["absent", "full"])
def test_a_browser_that_keeps_nothing_is_served_all_the_same(plain, broken):
    script = {
        "absent": "Object.defineProperty(window, 'indexedDB', { value: undefined });",
        "full": "IDBObjectStore.prototype.add = () => { throw new Error('the disk is full'); };",
    }[broken]
    with plain.visited() as guard:
        guard.context.add_init_script(script)
        person = begun(guard)
        assert ("#" in person.page.url) == (broken == "absent")
        given = ["left", "right"]
        for chosen in given:
            person.answer(chosen)
        person.until(PAIR)
        plain.stored(at_least=len(given))
        person.page.reload()
        given += person.trials(by_turns)
    answers = assert_all_there(plain, given)
    assert all(row["flags"] == {"not_kept": True} for row in answers)


def test_answers_of_an_earlier_sitting_never_get_into_another_one(browser, tmp_path):
    folder = frozen(PLAIN, tmp_path / "study")
    with served(folder) as server, guarded(browser, server.url, FAILING) as guard:
        with Store.open(folder) as store:
            [token] = store.invite(store.study(), 1, "somebody", "test")
        first = begun(guard, f"/#{token}")
        for _ in range(2):
            first.answer("left")
        first.until(PAIR)
        with Store.open(folder) as store:
            [session] = store.sessions(store.study())
            store.erase(session.id, "test")
        first.page.goto(f"{server.url}/#{token}")  # it makes another sitting, with another plan
        first.agree()
        first.go("instructions")
        first.answer("right")
        first.until(PAIR)
    with Store.open(folder) as store:
        _, again = store.sessions(store.study())
        answers = store.answers(store.study(), again.id)
    assert [(row["trial"], row["chosen"]) for row in answers] == [(0, "right")]


def test_a_page_that_was_left_open_for_two_days_goes_on(plain):
    with plain.visited() as guard:
        page = guard.open()
        page.page.clock.install()
        page.page.reload()
        page.agree()
        page.go("instructions")
        page.answer("left")
        page.until(PAIR)
        page.page.clock.fast_forward(2 * 86_400_000)
        given = ["left", *page.trials(by_turns)]
    times = [row["response_ms"] for row in assert_all_there(plain, given)]
    assert [time is None for time in times] == [n == 1 for n in range(6)]

"""Requests that no page of ours makes: refused, in the audit log, and nothing is changed."""

import threading
from concurrent.futures import ThreadPoolExecutor

import httpx
import pytest

from nacreous.server.rates import LIMITS
from nacreous.server.service import Service
from tests.server.attack import told, unchanged
from tests.server.people import WINDOW, Experimenter, Person

SQL = "'; DROP TABLE answers; --"


@pytest.mark.parametrize("token", ["A" * 43, "A" * 201, "../../etc", SQL, "é" * 43, "x y"])
def test_a_forged_token(server: httpx.Client, service: Service, token: str) -> None:
    wanted = {"Authorization": f"Bearer {token}".encode()}
    with unchanged(service, logged=6):
        for method, path, body in (
            ("GET", "sitting", None),
            ("POST", "consent", None),
            ("POST", "screen", {"content": WINDOW}),
            ("PUT", "answers/0", {"chosen": "left"}),
            ("POST", "finish", None),
            ("POST", "withdraw", None),
        ):
            asked = server.request(method, f"/api/{path}", json=body, headers=wanted)
            assert told(asked) == (401, "token")
            assert asked.headers["www-authenticate"] == "Bearer"


def test_nobody_enters_with_a_token_that_can_be_guessed(
    server: httpx.Client, service: Service
) -> None:
    weak = ("1", "token", "A" * 42, "A" * 44)
    with unchanged(service, logged=len(weak)):
        for token in weak:
            assert told(Person(server, token).enter()) == (401, "token")


def test_a_token_that_was_taken_away(server: httpx.Client, service: Service) -> None:
    person, lab = Person.consented(server), Experimenter.login(server)
    person.answer(0)
    assert lab.post("people/0/revoke").status_code == 204
    with unchanged(service, logged=3):
        assert told(person.answer(0)) == (401, "token")
        assert told(person.answer(1)) == (401, "token")
        assert told(person.get("sitting")) == (401, "token")


def test_a_person_whom_another_program_erased(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    person.answer(0)
    service.store.erase(service.running.session_of(person.token).id, "lab")
    with unchanged(service, logged=2):
        assert told(person.answer(1)) == (403, "not-allowed")
        assert told(person.get("sitting")) == (401, "token")
    service.sessions.forget()  # or some seconds later
    assert told(person.answer(1)) == (401, "token")


def test_answers_out_of_turn(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    person.answer(0)
    with unchanged(service, logged=3):
        assert told(person.answer(2)) == (409, "turn")
        assert told(person.answer(4)) == (409, "turn")
        assert told(person.post("finish")) == (409, "turn")


def test_answers_to_trials_that_there_are_not(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    trials = (5, 99, 2**31 - 1, 2**31, 10**30, -1, "0x1", "1.5", "x", "%00")
    with unchanged(service, logged=len(trials)):
        for trial in trials:
            assert told(person.answer(trial)) == (400, "input"), trial


def test_another_answer_under_the_same_key(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    person.answer(0, "left")
    with unchanged(service, logged=3):
        assert told(person.answer(0, "right")) == (409, "conflict")
        assert told(person.answer(0, "left", response_ms=1)) == (409, "conflict")
        assert told(person.answer(0, "left", simulated=True)) == (409, "conflict")
    kept = [event for event in service.store.events() if event.what == "answer refused"]
    assert [event.detail["answer"]["chosen"] for event in kept] == ["right", "left", "left"]


def test_the_same_key_from_many_at_once(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    with ThreadPoolExecutor(16) as many:
        sides = ["left", "right"] * 16
        statuses = list(many.map(lambda side: person.answer(0, side).status_code, sides))
    assert sorted(statuses) == [200] * 16 + [409] * 16
    (row,) = service.store.answers(service.running.study)
    assert row["chosen"] in ("left", "right")


def test_what_a_client_claims_about_its_trial(server: httpx.Client, service: Service) -> None:
    person, other = Person.consented(server), Person.consented(server)
    session = service.running.session_of(other.token).id
    claims = (
        {"kind": "pair"},
        {"left": "secret-g"},
        {"question": "deeper"},
        {"trial": 3},
        {"session": session},
        {"received_at": "2020-01-01T00:00:00Z"},
        {"simulated": "yes"},
        {"chosen": "tie"},
        {"chosen": "both"},
        {"chosen": ["left"]},
        {"response_ms": -1},
        {"response_ms": 86_400_001},
        {"response_ms": "1"},
        {"shown_at": "yesterday"},
        {"shown_at": "2026-03-01T09:30:00"},
        {"flags": []},
        {"flags": {str(n): n for n in range(51)}},
    )
    with unchanged(service, logged=len(claims)):
        for claim in claims:
            assert told(person.answer(0, **claim)) == (400, "input"), claim


def test_groups_that_are_drawn_cannot_be_chosen(server: httpx.Client, service: Service) -> None:
    person = Person.new(server)
    with unchanged(service, logged=3):
        for groups in ({"trade": "yes", "lamp": "warm"}, {}, {"trade": "perhaps"}):
            assert told(person.enter(groups=groups)) == (400, "input")


def test_nothing_before_consent(server: httpx.Client, service: Service) -> None:
    person = Person.new(server)
    assert person.enter().json()["pictures"] == {}
    picture = service.running.frozen.stimuli[0].sha256
    with unchanged(service, logged=3):
        assert told(person.answer(0)) == (403, "not-allowed")
        assert told(person.get(f"pictures/{picture}")) == (403, "not-allowed")
        assert told(person.post("screen", {"content": WINDOW})) == (403, "not-allowed")


def test_pictures_that_are_not_due(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    picture = service.running.frozen.stimuli[0].sha256
    with unchanged(service, logged=5):
        assert told(person.get(f"pictures/{'0' * 64}")) == (403, "not-allowed")
        assert told(person.get(f"pictures/{picture.upper()}")) == (400, "input")
        assert told(person.get(f"pictures/{picture}.png")) == (400, "input")
        assert told(person.get("pictures/study.json")) == (400, "input")
        assert told(server.get(f"/api/pictures/{picture}")) == (401, "token")
    assert person.get(f"pictures/{picture}").status_code == 200


ELSEWHERE = (
    {"Origin": "https://evil.example"},
    {"Origin": "null"},
    {"Origin": "http://127.0.0.1"},  # another port is another origin
    {"Sec-Fetch-Site": "cross-site"},
    {"Sec-Fetch-Site": "same-site"},
)


def test_another_sites_page_changes_nothing(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    lab = Experimenter.login(server)
    word = {"X-CSRF-Token": lab.csrf}
    with unchanged(service, logged=3 * len(ELSEWHERE)):
        for headers in ELSEWHERE:
            for path, more, body in (
                ("/api/withdraw", person.headers, None),
                ("/lab/api/state", word, {"state": "closed"}),
                ("/lab/api/login", {}, {"name": "lab", "password": "x"}),
            ):
                asked = server.post(path, json=body, headers={**headers, **more})
                assert told(asked) == (403, "not-allowed"), headers


def test_our_own_page_may(server: httpx.Client) -> None:
    person = Person.new(server)
    person.headers.update({"Origin": str(server.base_url), "Sec-Fetch-Site": "same-origin"})
    assert person.enter().status_code == 201


def test_a_form_is_no_json(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    kinds = ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data", "", "json")
    with unchanged(service, logged=len(kinds)):
        for kind in kinds:
            headers = {**person.headers, "Content-Type": kind}
            asked = server.put("/api/answers/0", content=b'{"chosen": "left"}', headers=headers)
            assert told(asked) == (415, "input"), kind


def test_other_methods_do_nothing(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    with unchanged(service, logged=0):
        for method in ("HEAD", "OPTIONS", "TRACE", "PATCH", "DELETE", "PROPFIND"):
            for path in ("/api/answers/0", "/api/withdraw", "/lab/api/state", "/lab/api/logout"):
                asked = server.request(method, path, headers=person.headers)
                assert asked.status_code == 405
                assert asked.headers["allow"] in ("PUT", "POST")


def test_whoever_is_refused_too_often_is_told_and_fills_no_log(
    server: httpx.Client, service: Service
) -> None:
    person, neighbour = Person.consented(server), Person.consented(server)
    most = LIMITS["refusals"][0]
    with unchanged(service, logged=2 * most):
        statuses = [person.answer(4).status_code for _ in range(most + 5)]
        assert statuses == [409] * most + [429] * 5
        statuses = [server.get("/api/sitting").status_code for _ in range(most + 5)]
        assert statuses == [401] * most + [429] * 5
    assert int(person.answer(4).headers["retry-after"]) in range(1, 61)
    assert person.answer(0).status_code == 200  # what is right is still taken
    assert neighbour.answer(0).status_code == 200


def test_nobody_fills_the_study_with_people(
    server: httpx.Client, service: Service, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(LIMITS, "entries of an address", (3, 60.0))
    statuses = [Person.new(server).enter().status_code for _ in range(5)]
    assert statuses == [201] * 3 + [429] * 2
    assert service.store.progress(service.running.study).entered == 3


def test_attacks_from_many_sides_leave_no_thread_behind(server: httpx.Client) -> None:
    before = threading.active_count()
    with ThreadPoolExecutor(8) as many:
        list(many.map(lambda _: server.get("/api/sitting").status_code, range(80)))
    assert threading.active_count() <= before + 40

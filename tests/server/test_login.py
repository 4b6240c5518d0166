"""Experimenters' logins: the cookie, the second word, guessing names and passwords."""

import time
from pathlib import Path

import httpx
import pytest

from nacreous.server.login import COOKIE
from nacreous.server.rates import LIMITS, Rates
from nacreous.server.service import Service
from tests.server.people import Experimenter, Person
from tests.support.server_process import NAME, PASSWORD

LOGIN = "/lab/api/login"
CHANGES = (
    ("logout", None),
    ("state", {"state": "closed"}),
    ("registration", {"registration": "invited"}),
    ("invitations", {"count": 1, "label": "x"}),
    ("invitations/1/revoke", None),
    ("people/0/exclude", {"reason": "x"}),
    ("people/0/readmit", None),
    ("people/0/revoke", None),
)
READS = ("me", "progress", "scale", "report", "answers.csv", "people.csv", "invitations", "events")


@pytest.fixture
def place(tmp_path: Path) -> str:  # nothing here depends on the database
    return str(tmp_path / "answers.sqlite")


def attempt(server: httpx.Client, name: str = NAME, password: str = PASSWORD) -> httpx.Response:
    return server.post(LOGIN, json={"name": name, "password": password})


def test_the_cookie_is_for_this_server_and_no_script(server: httpx.Client) -> None:
    told = attempt(server)
    value, *attributes = told.headers["set-cookie"].split("; ")
    assert value.startswith(f"{COOKIE}=")
    assert len(value) > len(COOKIE) + 40
    assert {one.lower() for one in attributes} == {"httponly", "path=/lab", "samesite=strict"}
    assert value.partition("=")[2] not in told.text
    assert told.json()["name"] == NAME


SECRET = "the quick brown fox jumps over"


@pytest.mark.parametrize(
    "body",
    [
        {"name": NAME, "password": 9 * SECRET},
        {"name": NAME, "password": [SECRET]},
        [NAME, SECRET],
        SECRET,
    ],
)
def test_a_password_that_cannot_be_read_is_in_no_answer_and_no_log(
    server: httpx.Client, service: Service, body: object
) -> None:
    told = server.post(LOGIN, json=body)
    assert told.status_code == 400
    assert SECRET[:10] not in told.text
    [*_, noted] = service.store.events(service.running.study)
    assert noted.what == "refused"
    assert SECRET[:10] not in str(noted.detail)


def test_me_tells_the_same_word_after_a_page_was_loaded_again(server: httpx.Client) -> None:
    lab = Experimenter.login(server)
    assert lab.get("me").json() == {"name": NAME, "csrf": lab.csrf}
    other = attempt(server).json()["csrf"]
    assert other != lab.csrf


def test_nothing_is_told_or_changed_without_a_login(server: httpx.Client, service: Service) -> None:
    before = service.store.progress(service.running.study)
    for what in (*READS, f"pictures/{'0' * 64}"):
        told = server.get(f"/lab/api/{what}")
        assert (told.status_code, told.json()["kind"]) == (401, "token"), what
    for what, body in CHANGES:
        told = server.post(f"/lab/api/{what}", json=body, headers={"X-CSRF-Token": "0" * 64})
        assert (told.status_code, told.json()["kind"]) == (401, "token"), what
    assert service.store.progress(service.running.study) == before
    assert service.store.invitations(service.running.study) == []


def test_no_change_without_the_second_word(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    lab = Experimenter.login(server)
    other = httpx.Client(base_url=server.base_url)
    wrong = Experimenter.login(other).csrf
    for what, body in CHANGES:
        for word in ({}, {"X-CSRF-Token": ""}, {"X-CSRF-Token": wrong}):
            told = server.post(f"/lab/api/{what}", json=body, headers=word)
            assert (told.status_code, told.json()["kind"]) == (403, "not-allowed"), what
    other.close()
    assert lab.get("me").status_code == 200
    assert lab.get("progress").json()["state"] == "open"
    assert person.answer(0).status_code == 200
    assert service.store.invitations(service.running.study) == []


def test_after_logging_out_the_cookie_is_worthless(server: httpx.Client) -> None:
    lab = Experimenter.login(server)
    token = server.cookies[COOKIE]
    told = lab.post("logout")
    assert told.status_code == 204
    assert "max-age=0" in told.headers["set-cookie"].lower()
    server.cookies.clear()
    assert server.get("/lab/api/me", headers={"Cookie": f"{COOKIE}={token}"}).status_code == 401


def test_a_forged_cookie_is_refused(server: httpx.Client) -> None:
    for cookie in ("", "x", "x" * 5000, '"', "\\000", "é", "a b", "' OR 1=1 --"):
        headers = {"Cookie": f"{COOKIE}={cookie}".encode()}
        assert server.get("/lab/api/me", headers=headers).status_code == 401


def test_a_participants_token_is_no_login_and_a_login_no_token(server: httpx.Client) -> None:
    person = Person.consented(server)
    told = server.get("/lab/api/me", headers={"Cookie": f"{COOKIE}={person.token}"})
    assert told.status_code == 401
    Experimenter.login(server)
    thief = Person(server, server.cookies[COOKIE])
    assert thief.get("sitting").status_code == 401


def test_guessing_is_slowed_down_by_address_and_forgiven_in_time(
    server: httpx.Client, service: Service
) -> None:
    now = [1000.0]
    service.rates = Rates(clock=lambda: now[0])
    assert [attempt(server, password=f"guess {n}").status_code for n in range(5)] == [401] * 5
    told = attempt(server)  # even if it is right
    assert (told.status_code, told.json()["kind"]) == (429, "busy")
    assert told.headers["retry-after"] == "60"
    now[0] += 61
    assert [attempt(server).status_code for _ in range(20)] == [200] * 20  # who is right may


def test_guessing_one_name_is_slowed_down_from_wherever_it_comes(
    server: httpx.Client, service: Service, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(LIMITS, "logins of an address", (1000, 60.0))
    tries = [attempt(server, password="a wrong one").status_code for _ in range(11)]
    assert tries == [401] * 10 + [429]
    assert attempt(server, name="somebody-else").status_code == 401
    refused = [event for event in service.store.events() if event.what == "refused"]
    assert len(refused) == 12
    assert {event.detail["asked"] for event in refused} == {f"POST {LOGIN}"}


def test_neither_time_nor_words_tell_whether_there_is_such_a_name(
    server: httpx.Client, service: Service, monkeypatch: pytest.MonkeyPatch
) -> None:
    for limit in ("logins of an address", "logins of a name", "refusals"):
        monkeypatch.setitem(LIMITS, limit, (1000, 60.0))

    times: dict[str, list[float]] = {NAME: [], "nobody": []}
    told = set()
    for _ in range(12):  # by turns, for other programs take their share of the machine
        for name, taken_s in times.items():
            begin = time.perf_counter()
            told.add(attempt(server, name, "not the password").text)
            taken_s.append(time.perf_counter() - begin)
    assert len(told) == 1
    # Without a password to compare with, it would be a tenth.
    assert 1 / 3 < min(times[NAME]) / min(times["nobody"]) < 3


def test_no_password_and_no_token_is_in_the_audit_log(
    server: httpx.Client, service: Service
) -> None:
    attempt(server, password="my other secret")
    Experimenter.login(server)
    person = Person.consented(server)
    person.answer(9)
    Person(server, "stolen-token-that-is-nobodys").answer(0)
    log = repr(service.store.events())
    for secret in ("my other secret", PASSWORD, person.token, "stolen", server.cookies[COOKIE]):
        assert secret not in log
    assert "127.0.0.1" not in log

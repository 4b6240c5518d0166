"""A study by HTTP: a whole sitting, what is told and what is not, and the experimenters' side."""

import io
import json

import httpx
import polars as pl
import pytest

from nacreous.server.service import Service
from nacreous.server.sessions import Sessions
from nacreous.study.store import Session, StoreError
from tests.server.people import WINDOW, Experimenter, Person


def test_a_whole_sitting(server: httpx.Client, service: Service) -> None:
    person = Person.new(server)
    told = person.enter()
    assert told.status_code == 201
    assert (told.json()["consented"], told.json()["trials"]) == (False, [])
    assert person.post("consent").status_code == 204
    assert person.post("screen", {"content": WINDOW}).json() == {"flags": [], "refused": False}
    sitting = person.sitting()
    assert (sitting["number"], sitting["answered"], sitting["screened"]) == (0, 0, True)
    for trial in sitting["trials"]:
        for side in ("left", "right"):
            picture = person.get(f"pictures/{trial[side]}")
            assert picture.headers["content-type"] == "image/png"
            assert picture.content.startswith(b"\x89PNG")
        receipt = person.answer(trial["trial"]).json()
        assert (receipt["trial"], receipt["again"]) == (trial["trial"], False)
    assert person.sitting()["answered"] == len(sitting["trials"]) == 5
    assert person.sitting()["ending"] == {"code": None, "return_url": None}
    assert person.post("finish").status_code == 204
    assert person.sitting()["finished"]
    store, study = service.store, service.running.study
    found = store.progress(study)
    assert (found.finished, found.answers) == (1, 5)
    kinds = [row["kind"] for row in store.answers(study)]
    assert sorted(kinds) == ["catch", "pair", "pair", "pair", "training"]


def test_a_parameter_that_is_not_kept_stands_in_no_log(
    server: httpx.Client, service: Service
) -> None:
    for value in ("Kokichi", "Kokichi" * 40, "Kokichi\x1b"):
        told = Person.new(server).enter(parameters={"PROLIFIC_PID": value})
        assert (told.status_code, told.json()["kind"]) == (400, "input")
        assert "PROLIFIC_PID" in told.json()["problem"]
    events = service.store.events(service.running.study)
    assert sum(event.what == "refused" for event in events) == 3
    assert "Kokichi" not in str(events)


def test_a_screen_check_is_refused_by_quantity_and_kept_whole(
    server: httpx.Client, service: Service
) -> None:
    person = Person.consented(server)
    told = person.post("screen", {"content": {**WINDOW, "gamma": -1}})
    assert told.status_code == 400
    problem = "content.gamma is -1; wanted: Input should be greater than or equal to 0"
    assert told.json() == {"problem": problem, "kind": "input"}
    content = {**WINDOW, "gamma": 2.2, "lux": [80, None]}
    assert person.post("screen", {"content": content}).status_code == 200
    [session] = service.store.sessions(service.running.study)
    assert session.screen == {**content, "flags": []}


def test_a_browser_that_lost_its_page_goes_on_where_it_was(server: httpx.Client) -> None:
    person = Person.consented(server)
    first = person.sitting()
    person.answer(0)
    again = person.enter(language="ja", groups={"trade": "no"})
    assert again.status_code == 200
    assert again.json() == {**first, "answered": 1}
    receipt = person.answer(0)
    assert (receipt.status_code, receipt.json()["again"]) == (200, True)


def test_nothing_told_to_participants_says_what_is_shown(server: httpx.Client) -> None:
    person = Person.consented(server)
    told = server.get("/api/study").text + json.dumps(person.sitting())
    for secret in ("secret", "catch", "akoya", "expected", "lamp", "seed"):
        assert secret not in told
    trial = person.sitting()["trials"][1]
    assert set(trial) == {"trial", "question", "left", "right", "training", "break_before"}


def test_every_visitor_gets_a_token_of_their_own(server: httpx.Client) -> None:
    tokens = {server.get("/api/study").json()["token"] for _ in range(20)}
    assert len(tokens) == 20
    assert {len(token) for token in tokens} == {43}


def test_an_invitation_lets_one_person_in(server: httpx.Client) -> None:
    lab = Experimenter.login(server)
    assert lab.post("registration", {"registration": "invited"}).status_code == 204
    stranger = Person.new(server).enter()
    assert (stranger.status_code, stranger.json()["kind"]) == (403, "not-allowed")
    told = lab.post("invitations", {"count": 2, "label": "seat 3"}).json()["links"]
    assert told[0].startswith(f"{server.base_url}/#")
    guest = Person(server, told[0].partition("#")[2])
    assert guest.enter().status_code == 201
    first, second = lab.get("invitations").json()
    assert (first["number"], first["label"], second["number"]) == (0, "seat 3", None)
    assert lab.post(f"invitations/{second['id']}/revoke").status_code == 204
    late = Person(server, told[1].partition("#")[2]).enter()
    assert (late.status_code, late.json()["kind"]) == (403, "not-allowed")


def test_experimenters_see_how_far_it_is(server: httpx.Client) -> None:
    person = Person.consented(server)
    for trial in range(5):
        person.answer(trial, simulated=True)
    person.post("finish")
    lab = Experimenter.login(server)
    told = lab.get("progress").json()
    assert (told["entered"], told["finished"], told["simulated"], told["trials"]) == (1, 1, 5, 5)
    (row,) = told["people"]
    # The first of five is practice, which is told nowhere as an answer.
    assert (row["number"], row["answers"], row["trials"], row["simulated"]) == (0, 4, 4, True)
    assert row["groups"] == {"trade": "yes", "lamp": row["groups"]["lamp"]}
    scale = lab.get("scale?simulated=true").json()
    assert scale.get("simulated", True)
    assert "problem" in lab.get("scale").json()


def test_answers_go_out_as_csv(server: httpx.Client) -> None:
    person = Person.consented(server)
    person.answer(0, "right", shown_at="2026-03-01T09:30:00+09:00")
    lab = Experimenter.login(server)
    told = lab.get("answers.csv")
    assert told.headers["content-disposition"] == 'attachment; filename="answers.csv"'
    for table in ("answers.csv", "people.csv"):
        plain, marked = (lab.get(f"{table}{end}").content for end in ("", "?bom=true"))
        assert marked == b"\xef\xbb\xbf" + plain
    (row,) = pl.read_csv(io.BytesIO(told.content)).to_dicts()
    assert (row["chosen"], row["kind"], row["trade"]) == ("right", "training", "yes")
    assert row["shown_at"] == "2026-03-01T00:30:00.000000Z"


def test_who_is_left_out_is_marked_and_comes_back(server: httpx.Client) -> None:
    Person.consented(server)
    lab = Experimenter.login(server)
    assert lab.post("people/0/exclude", {"reason": "slept"}).status_code == 204
    assert lab.get("progress").json()["people"][0]["excluded"] == "slept"
    assert lab.post("people/0/readmit").status_code == 204
    assert lab.get("progress").json()["people"][0]["excluded"] is None
    events = lab.get("events?last=2").json()
    assert [(event["who"], event["what"]) for event in events] == [
        ("lab", "excluded"),
        ("lab", "readmitted"),
    ]
    assert events[0]["detail"] == {"reason": "slept"}


@pytest.mark.parametrize("state", ["paused", "closed"])
def test_a_study_that_is_not_open_lets_nobody_in(server: httpx.Client, state: str) -> None:
    person = Person.consented(server)
    lab = Experimenter.login(server)
    assert lab.post("state", {"state": state}).status_code == 204
    assert server.get("/api/study").json()["state"] == state
    assert Person.new(server).enter().status_code == 403
    assert person.answer(0).status_code == 200
    lab.post("state", {"state": "open"})
    assert Person.new(server).enter().status_code == 201


def test_who_withdraws_is_not_counted_and_not_readmitted(server: httpx.Client) -> None:
    person = Person.consented(server)
    person.answer(0)
    assert person.post("withdraw").status_code == 204
    assert person.answer(1).json()["kind"] == "not-allowed"
    lab = Experimenter.login(server)
    assert lab.get("progress").json()["people"][0]["excluded"] == "withdrew"
    assert lab.post("people/0/readmit").status_code == 403


def test_a_store_that_refuses_is_said_to_do_so(
    server: httpx.Client, service: Service, monkeypatch: pytest.MonkeyPatch
) -> None:
    person = Person.consented(server)
    person.answer(0)

    def full(*_: object, **__: object) -> None:
        raise StoreError("the disk is full", "answers.sqlite")

    with monkeypatch.context() as patch:
        patch.setattr(service.running, "hand_in", full)
        told = person.answer(1)
        assert (told.status_code, told.json()["kind"]) == (503, "store")
        assert told.headers["retry-after"] == "2"
        patch.setattr(service.store, "audit", full)  # nothing can be noted either
        assert person.get("pictures/x").status_code == 400
    assert person.answer(1).status_code == 200


def test_a_change_is_known_at_once(server: httpx.Client) -> None:
    person, lab = Person.consented(server), Experimenter.login(server)
    assert person.answer(0).status_code == 200  # from here on it is remembered who answers
    assert lab.post("people/0/revoke").status_code == 204
    assert person.answer(1).status_code == 401
    other = Person.consented(server)
    assert other.answer(0).status_code == 200
    assert other.post("withdraw").status_code == 204
    assert other.answer(1).status_code == 403


def test_what_was_changed_while_it_was_read_is_not_remembered(service: Service) -> None:
    [token] = service.store.invite(service.running.study, 1, "x", "test")
    session = service.running.enter(token, "en", {"trade": "yes"})

    class Slow:
        def session_of(self, token: str) -> Session:
            read = service.running.session_of(token)
            service.store.consent(session.id)
            sessions.forget(token)
            return read

    sessions = Sessions(Slow())
    assert sessions.read(token).consented_at is None
    assert sessions.get(token) is None
    now = [0.0]
    sessions = Sessions(service.running, clock=lambda: now[0])
    assert sessions.read(token).consented_at is not None
    now[0] = 9.9
    assert sessions.get(token) is not None
    now[0] = 10.0
    assert sessions.get(token) is None


def test_pages_and_their_assets(server: httpx.Client) -> None:
    for path in ("/", "/lab"):
        page = server.get(path)
        assert page.headers["content-type"] == "text/html; charset=utf-8"
        assert page.headers["cache-control"] == "no-cache"
    asset = server.get("/assets/main-1a2b3c.js")
    assert asset.headers["content-type"] == "text/javascript; charset=utf-8"
    assert "immutable" in asset.headers["cache-control"]
    assert server.head("/").headers["content-length"] == str(len(server.get("/").content))

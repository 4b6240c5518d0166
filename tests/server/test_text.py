"""Text and JSON that no page of ours sends: refused, or nothing but text."""

import json
from urllib.parse import quote

import httpx

from nacreous.server.service import Service
from tests.server.attack import told, unchanged
from tests.server.people import Experimenter, Person

JSON = {"Content-Type": "application/json"}
SQL = "'; DROP TABLE answers; --"
HTML = '<script>alert(1)</script><img src=x onerror="alert(1)">'

BODIES = (
    b"",
    b"{",
    b"null",
    b"[]",
    b'"left"',
    b'{"chosen": "left", "response_ms": NaN}',
    b'{"chosen": "left", "response_ms": Infinity}',
    b'{"chosen": "left", "response_ms": 1e999}',
    b'{"chosen": "left", "flags": {"x": NaN}}',
    b'{"chosen": "left", "flags": {"x": -Infinity}}',
    b'{"chosen": "left", "flags": {"\\ud800": 1}}',
    b'{"chosen": "left", "flags": {"x": "\\udfff"}}',
    b'{"chosen": "left\\u0000"}',
    b'{"chosen": "left", "flags": {"x": "\xff\xfe"}}',
    b'{"chosen": "left", "flags": ' + b'{"x":' * 5000 + b"1" + b"}" * 5001,
    b'{"chosen": "left", "flags": {"x": ' + b"[" * 30_000 + b"]" * 30_000 + b"}}",
    b"[" * 60_000,
    b'{"chosen": "left", "response_ms": ' + b"9" * 60_000 + b"}",
    '{"chosen": "left"}'.encode("utf-16"),
)


def test_json_that_is_none_or_too_much(server: httpx.Client, service: Service) -> None:
    person = Person.consented(server)
    with unchanged(service, logged=len(BODIES)):
        for body in BODIES:
            asked = server.put("/api/answers/0", content=body, headers={**person.headers, **JSON})
            assert told(asked) == (400, "input"), body[:40]


def test_text_that_means_something_elsewhere_is_only_text(
    server: httpx.Client, service: Service
) -> None:
    person = Person.consented(server)
    lab = Experimenter.login(server)
    for trial, text in enumerate((SQL, HTML, "a\r\nSet-Cookie: b=c", "=cmd|' /C calc'!A0")):
        assert person.answer(trial, flags={text: text}).status_code == 200
        assert lab.post("people/0/exclude", {"reason": text}).status_code == 204
        shown = lab.get("progress")
        assert shown.json()["people"][0]["excluded"] == text
        assert shown.headers["content-type"] == "application/json"
        assert lab.post("invitations", {"count": 1, "label": text}).status_code == 200
        assert lab.get("invitations").json()[-1]["label"] == text
        assert "set-cookie" not in shown.headers
    rows = service.store.answers(service.running.study)
    assert [json.loads(row["flags"]) for row in rows][:2] == [{SQL: SQL}, {HTML: HTML}]
    assert lab.get("answers.csv").status_code == 200


def test_text_that_cannot_be_kept(server: httpx.Client, service: Service) -> None:
    Person.consented(server)
    person, lab = Person.new(server), Experimenter.login(server)
    for text in ("a\0b", "", "x" * 1001):
        with unchanged(service, logged=5):
            for entry in ({"language": text}, {"groups": {"trade": text}}, {"groups": {text: ""}}):
                assert told(person.enter(**entry)) == (400, "input")
            assert told(lab.post("people/0/exclude", {"reason": text})) == (400, "input")
            asked = lab.post("invitations", {"count": 1, "label": text})
            assert told(asked) == (400, "input")


def test_a_refusal_and_its_line_in_the_log_have_no_control_character(
    server: httpx.Client, service: Service
) -> None:
    person = Person.consented(server)
    lab = Experimenter.login(server)
    hidden = "\x1b[31m\u202e\x9b"
    path = quote(hidden)
    asked = [
        server.put(f"/api/answers/{path}", json={}, headers=person.headers),
        lab.get(f"scale?question={path}"),
        person.answer(0, chosen=hidden),
        person.answer(0, flags={hidden: 1}, unknown=hidden),
    ]
    for response in asked:
        assert response.status_code >= 400
        assert all(letter.isprintable() for letter in response.json()["problem"])
    refused = [event for event in service.store.events() if event.what == "refused"]
    assert refused
    told = "".join(str(value) for event in refused for value in event.detail.values())
    assert all(letter.isprintable() for letter in told)

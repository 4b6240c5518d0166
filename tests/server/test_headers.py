"""What every response tells a browser not to do."""

from pathlib import Path

import httpx
import pytest

from nacreous.server.service import Service
from tests.server.people import Experimenter, Person

POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; "
    "connect-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'"
)
ALWAYS = {
    "content-security-policy": POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), microphone=(), geolocation=()",
}


@pytest.fixture
def place(tmp_path: Path) -> str:  # nothing here depends on the database
    return str(tmp_path / "answers.sqlite")


def responses(server: httpx.Client) -> list[httpx.Response]:
    person = Person.consented(server)
    picture = person.sitting()["trials"][0]["left"]
    lab = Experimenter.login(server)
    return [
        *(server.get(path) for path in ("/", "/lab", "/assets/main-1a2b3c.js", "/assets/none.js")),
        *(server.get(path) for path in ("/openapi.json", "/none", "/api/study", "/api/sitting")),
        *(person.get(what) for what in ("sitting", f"pictures/{picture}", "pictures/x")),
        *(lab.get(what) for what in ("progress", "answers.csv", "report", "events?last=0")),
        *(server.request(method, "/") for method in ("HEAD", "OPTIONS", "DELETE")),
        person.answer(0),
        person.answer(4),
        person.post("enter", {"language": "en", "groups": {}, "more": 1}),
        server.post("/api/consent", content=b"x" * 70_000),
        server.post("/api/consent", content=b"x", headers={"Content-Type": "text/plain"}),
        server.post("/api/consent", headers={"Origin": "http://elsewhere.example"}),
    ]


def test_every_response_has_them(server: httpx.Client) -> None:
    found = responses(server)
    statuses = {response.status_code for response in found}
    assert statuses >= {200, 400, 401, 403, 404, 405, 409, 413, 415}
    for response in found:
        told = {name: response.headers.get(name) for name in ALWAYS}
        assert told == ALWAYS, response.request
        assert "strict-transport-security" not in response.headers
        assert "server" not in response.headers
        for name, _ in response.headers.multi_items():
            assert response.headers.get_list(name) == [response.headers[name]]


def test_a_fault_of_the_programs_has_them_too_and_tells_nothing(
    server: httpx.Client, service: Service, monkeypatch: pytest.MonkeyPatch, caplog
) -> None:
    def broken(*_: object) -> None:
        raise RuntimeError("secret-path/answers.sqlite")

    monkeypatch.setattr(service, "told", broken)
    told = server.get("/api/study")
    assert (told.status_code, told.json()["kind"]) == (500, "fault")
    assert "secret-path" not in told.text
    assert "secret-path" in caplog.text
    assert {name: told.headers.get(name) for name in ALWAYS} == ALWAYS


def test_nothing_is_kept_but_what_never_changes(server: httpx.Client) -> None:
    for response in responses(server):
        path, kept = response.request.url.path, response.headers["cache-control"]
        if response.status_code != 200:
            assert kept == "no-store", path
        elif path.startswith("/api/pictures/"):
            assert kept == "private, max-age=31536000, immutable"
        elif path.startswith("/assets/"):
            assert kept == "public, max-age=31536000, immutable"
        else:
            assert kept == ("no-cache" if path in ("/", "/lab") else "no-store"), path


def test_what_is_no_page_of_ours_is_an_attachment(server: httpx.Client) -> None:
    person = Person.consented(server)
    person.answer(0)
    lab = Experimenter.login(server)
    assert lab.get("answers.csv").headers["content-disposition"].startswith("attachment")


def test_there_are_no_pages_that_load_from_elsewhere(server: httpx.Client) -> None:
    for path in ("/docs", "/redoc", "/docs/oauth2-redirect", "/static/x"):
        assert server.get(path).status_code == 404


def test_the_laboratory_is_found_with_a_slash_too(server: httpx.Client) -> None:
    assert server.get("/lab/").text == server.get("/lab").text
    assert server.get("/lab/else").status_code == 404

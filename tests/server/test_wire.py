"""Bytes that no browser sends: too many, too slow, two requests in one, paths that lead out."""

import json
import socket
import time
from collections.abc import Iterator
from contextlib import closing, suppress
from pathlib import Path

import httpx
import pytest

from nacreous.server import body
from nacreous.server.connection import LARGEST_HEAD
from nacreous.server.service import Service
from tests.server.people import Person


class Wire:
    """One connection; what is read of it is read with a time limit."""

    def __init__(self, url: httpx.URL) -> None:
        self.host = f"{url.host}:{url.port}"
        self.socket = socket.create_connection((url.host, url.port), timeout=20)

    def send(self, *parts: bytes) -> None:
        self.socket.sendall(b"".join(parts))

    def ask(self, line: str, *headers: str, body: bytes = b"") -> tuple[int, str, bytes]:
        lines = [line, f"Host: {self.host}", *headers, "", ""]
        self.send("\r\n".join(lines).encode("latin-1"), body)
        return self.read()

    def read(self) -> tuple[int, str, bytes]:
        """Status, head and body of one response."""
        told = b""
        while b"\r\n\r\n" not in told:
            part = self.socket.recv(65_536)
            assert part, f"closed after {told!r}"
            told += part
        head, _, content = told.partition(b"\r\n\r\n")
        (length,) = [
            int(line.partition(b":")[2])
            for line in head.lower().splitlines()
            if line.startswith(b"content-length:")
        ]
        while len(content) < length:
            content += self.socket.recv(65_536)
        return int(head.split()[1]), head.decode("latin-1"), content

    def close(self) -> None:
        self.socket.close()

    def is_closed(self) -> bool:
        """Whether the server ends it, sooner or later."""
        try:
            return self.socket.recv(1) == b""
        except ConnectionError:
            return True


@pytest.fixture
def wire(server: httpx.Client) -> Iterator[Wire]:
    with closing(Wire(server.base_url)) as made:
        yield made


@pytest.fixture
def place(tmp_path: Path) -> str:  # nothing here depends on the database
    return str(tmp_path / "answers.sqlite")


PUT = "PUT /api/answers/0 HTTP/1.1"
JSON = "Content-Type: application/json"


def answers(service: Service) -> int:
    return service.store.progress(service.running.study).answers


def test_a_body_that_says_it_is_too_large_is_not_read(wire: Wire, service: Service) -> None:
    status, head, content = wire.ask(PUT, JSON, f"Content-Length: {10**12}")
    assert (status, json.loads(content)["kind"]) == (413, "input")
    assert "connection: close" in head.lower()
    assert wire.is_closed()
    refused = [event for event in service.store.events() if event.what == "refused"]
    assert [event.detail["status"] for event in refused] == [413]


def test_a_body_in_pieces_is_counted(wire: Wire) -> None:
    wire.send(
        f"{PUT}\r\nHost: {wire.host}\r\n{JSON}\r\nTransfer-Encoding: chunked\r\n\r\n".encode()
    )
    piece = b"1000\r\n" + b" " * 0x1000 + b"\r\n"
    with suppress(ConnectionError):
        for _ in range(17):
            wire.send(piece)
    assert wire.read()[0] == 413
    assert wire.is_closed()


def test_the_largest_body_is_taken(server: httpx.Client) -> None:
    person = Person.consented(server)
    blank = b'{"chosen": "left"}'.ljust(body.LARGEST)
    headers = {**person.headers, "Content-Type": "application/json"}
    assert server.put("/api/answers/0", content=blank, headers=headers).status_code == 200
    told = server.put("/api/answers/0", content=blank + b" ", headers=headers)
    assert told.status_code == 413


def test_a_body_that_does_not_come_is_not_waited_for(
    wire: Wire, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(body, "SLOWEST_S", 0.3)
    wire.send(f"{PUT}\r\nHost: {wire.host}\r\n{JSON}\r\nContent-Length: 100\r\n\r\n".encode())
    for _ in range(5):  # a byte now and then keeps nothing alive
        time.sleep(0.05)
        wire.send(b" ")
    assert wire.read()[0] == 408
    assert wire.is_closed()


def test_a_head_that_does_not_come_is_not_waited_for(
    server: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("nacreous.server.connection.SLOWEST_HEAD_S", 0.3)
    with closing(Wire(server.base_url)) as silent, closing(Wire(server.base_url)) as slow:
        slow.send(b"GET / HTTP/1.1\r\nX-")
        assert slow.is_closed()
        assert silent.is_closed()
    assert server.get("/").status_code == 200


def test_a_head_without_end_is_not_read(wire: Wire) -> None:
    wire.send(b"GET / HTTP/1.1\r\nX-Long: ")
    with suppress(ConnectionError):
        for _ in range(8):
            wire.send(b"x" * (LARGEST_HEAD // 4))
            time.sleep(0.01)
    assert wire.is_closed()


def test_who_goes_away_in_the_middle_leaves_nothing(
    wire: Wire, server: httpx.Client, service: Service, caplog
) -> None:
    person = Person.consented(server)
    token = f"Authorization: Bearer {person.token}"
    wire.send(f"{PUT}\r\nHost: {wire.host}\r\n{token}\r\n{JSON}\r\n".encode())
    wire.send(b'Content-Length: 100\r\n\r\n{"chosen": "left"')
    wire.socket.close()
    time.sleep(0.2)
    assert answers(service) == 0
    assert person.answer(0).status_code == 200
    assert caplog.text == ""


PATHS = (
    "/assets/../index.html",
    "/assets/%2e%2e/index.html",
    "/assets/..%2findex.html",
    "/assets/%252e%252e%252findex.html",
    "/assets/..\\index.html",
    "/assets//etc/passwd",
    "/assets/%2fetc%2fpasswd",
    "/assets/main-1a2b3c.js%00.html",
    "/assets/",
    "/assets",
    "/index.html",
    "/lab.html",
    "//index.html",
    "/../../../../etc/passwd",
    "/api/pictures/..%2f..%2fstudy.json",
    "/api/pictures/../study.json",
    "/study.json",
    "/answers.sqlite",
    "/lab//",
)


def test_no_path_leads_out(server: httpx.Client) -> None:
    for path in PATHS:
        with closing(Wire(server.base_url)) as wire:
            status, _, content = wire.ask(f"GET {path} HTTP/1.1")
            assert (status, json.loads(content)["kind"]) == (404, "missing"), path


def test_a_path_puts_nothing_into_the_head(wire: Wire) -> None:
    for path in ("/%0d%0aX-Put: y", "/assets/%0d%0aX-Put: y", "/api/x%0aX-Put:%20y"):
        status, head, _ = wire.ask(f"GET {path.replace(' ', '%20')} HTTP/1.1")
        assert status == 404
        assert "x-put" not in head.lower()


def test_two_lengths_are_one_too_many(wire: Wire, service: Service) -> None:
    status, _, _ = wire.ask(
        PUT, JSON, "Content-Length: 4", "Transfer-Encoding: chunked", body=b"0\r\n\r\nGET /"
    )
    assert status == 400
    assert wire.is_closed()
    assert answers(service) == 0


NO_HTTP = (
    b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03",
    b"GET / HTTP/9.9\r\n\r\n",
    b"\x00" * 100,
    b"GET / HTTP/1.1\r\nHost: a\r\nContent-Length: x\r\n\r\n",
    b"GET / HTTP/1.1\r\nX y: a\r\n\r\n",
)


def test_what_is_no_http_is_ended(server: httpx.Client) -> None:
    for sent in NO_HTTP:
        with closing(Wire(server.base_url)) as wire:
            wire.send(sent)
            told = wire.socket.recv(100)
            assert told == b"" or told.startswith(b"HTTP/1.1 400 "), sent
    assert server.get("/").status_code == 200


def test_there_are_no_web_sockets(wire: Wire) -> None:
    status, _, _ = wire.ask(
        "GET /api/study HTTP/1.1",
        "Connection: Upgrade",
        "Upgrade: websocket",
        "Sec-WebSocket-Version: 13",
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
    )
    assert status in (200, 400)


def test_a_forwarded_address_is_believed_of_this_machine_alone() -> None:
    from nacreous.server.listening import server_of

    config = server_of(None).config  # type: ignore[arg-type]
    assert (config.proxy_headers, config.forwarded_allow_ips) == (True, "127.0.0.1,::1")

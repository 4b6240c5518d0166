"""A server answers to its own names alone, and its links begin with none but those."""

from pathlib import Path

import httpx
import pytest
from starlette.datastructures import Headers

from nacreous.problem import InputError
from nacreous.server.app import create_app
from nacreous.server.hosts import Hosts, host_of
from nacreous.server.refusal import Refusal
from nacreous.server.service import Service
from tests.server.people import Experimenter, Person
from tests.support.server_process import in_thread, some_pages


@pytest.fixture
def place(tmp_path: Path) -> str:  # nothing here depends on the database
    return str(tmp_path / "answers.sqlite")


def answers_to(hosts: Hosts, *called: str, server: object = ("192.0.2.10", 8000)) -> bool:
    headers = Headers(raw=[(b"host", name.encode("latin-1")) for name in called])
    try:
        hosts.check(headers, server)
    except Refusal as refusal:
        return (refusal.status, refusal.kind) != (400, "input")
    return True


OTHERS = (
    *("evil.example", "localhost.evil.example", "evil.example:8000", "192.0.2.11", "", " ", "a b"),
    *("localhost@evil.example", "evil.example/localhost", "localhost:x", "localhost:8000:1"),
    *("[::2]", "::1:x", "[localhost]", "127.0.0.1.evil.example", "2130706433", "0177.0.0.1"),
    *(
        "localhost#",
        "localhost?",
        "pearls.example.evil.example",
        "%6cocalhost",
        "127.0.0.1%x",
        "localhost\\",
    ),
)


@pytest.mark.parametrize("called", OTHERS)
def test_no_other_name_is_ours(called: str) -> None:
    assert not answers_to(Hosts(["pearls.example"]), called)


def test_our_own_names_are_this_machine_where_one_came_in_and_what_was_given() -> None:
    hosts = Hosts(["Pearls.example:443", "真珠.example", "2001:db8::1"])
    for called in (
        *("localhost", "LocalHost:8000", "127.0.0.1:8000", "[::1]:8000", "[::1]", "localhost."),
        *("192.0.2.10", "192.0.2.10:9", "pearls.example", "pearls.EXAMPLE:8000"),
        *("xn--5dy32e.example", "[2001:db8::1]:80", "[2001:0db8:0::1]"),
    ):
        assert answers_to(hosts, called), called
    assert answers_to(hosts, "192.0.2.10", server=("::ffff:192.0.2.10", 8000))
    assert answers_to(hosts, "[fe80::2]:8000", server=("fe80::2%eth0", 8000))
    assert answers_to(hosts, "localhost", server=None)
    assert not answers_to(hosts, "192.0.2.10", server=None)
    assert not answers_to(hosts, "localhost", "localhost"), "two at once are none"
    assert answers_to(hosts), "a program that is no browser names nobody"


@pytest.mark.parametrize("given", ["", "http://a", "a b", "a/b", "*", "a:b", "-a", "[a]", "a@b"])
def test_a_host_that_is_none_is_refused(given: str) -> None:
    with pytest.raises(InputError, match=r"^host is "):
        host_of(given)


def test_every_route_and_page_refuses_another_sites_name(
    server: httpx.Client, service: Service
) -> None:
    person = Person.consented(server)
    lab = Experimenter.login(server)
    for method, path in (
        *(("GET", "/"), ("GET", "/lab"), ("GET", "/api/study"), ("GET", "/openapi.json")),
        *(("GET", "/lab/api/progress"), ("POST", "/lab/api/invitations"), ("POST", "/api/finish")),
    ):
        headers = {"Host": "evil.example", "X-CSRF-Token": lab.csrf, **person.headers}
        told = server.request(method, path, headers=headers, json={"count": 1, "label": "x"})
        assert told.status_code == 400, path
        assert told.json()["problem"].startswith("Host is 'evil.example', which is not")
    assert service.store.invitations(service.running.study) == []


def test_links_begin_with_the_url_that_was_given_whatever_the_request_calls_us(
    service: Service, tmp_path: Path
) -> None:
    pages = some_pages(tmp_path / "others")
    app = create_app(
        service.running, url="https://pearls.example", built=pages, hosts=["lab-pc.local"]
    )
    with in_thread(app) as url, httpx.Client(base_url=url, timeout=60) as client:
        csrf = Experimenter.login(client).csrf
        cookie = client.cookies["nacreous_lab"]
        for called in ("pearls.example", "lab-pc.local:8000", "localhost"):
            told = client.post(
                "/lab/api/invitations",
                json={"count": 1, "label": "x"},
                headers={"Host": called, "X-CSRF-Token": csrf, "Cookie": f"nacreous_lab={cookie}"},
            )
            assert told.json()["links"][0].startswith("https://pearls.example/#"), told.text

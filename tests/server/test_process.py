"""`nacreous study serve` and `account` as commands: started, stopped, killed, refused."""

import io
import os
import pty
import socket
import subprocess
import sys
from pathlib import Path

import httpx
import pytest

from nacreous.cli import main
from nacreous.problem import InputError
from nacreous.server import built, pages
from nacreous.server.app import create_app
from nacreous.study.design import open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store, UnknownToken
from tests.server.people import Experimenter, Person
from tests.support.server_process import served, small_study, some_pages

ROOT = Path(__file__).parents[2]
GOOD = "twelve letters"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return small_study(tmp_path / "my-study")


def nacreous(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "nacreous", "study", *(str(one) for one in arguments)]
    options = {"stdin": subprocess.DEVNULL, **options}
    return subprocess.run(command, capture_output=True, text=True, timeout=60, **options)


def test_it_says_where_it_serves_and_stops_at_ctrl_c(folder: Path, place: str) -> None:
    with served(folder, place=place) as server:
        assert f"{folder}: serving at {server.url}/" in server.lines
        assert f"{folder}: experimenters: {server.url}/lab" in server.lines
        with httpx.Client(base_url=server.url, timeout=60) as client:
            assert Person.consented(client).answer(0).status_code == 200
            assert "server" not in client.get("/").headers
        assert server.stop() == 0
        assert server.process.stdout.read() == ""
    with Store.open(place) as store:
        assert store.progress(store.study()).answers == 1


def test_nothing_acknowledged_is_lost_when_it_is_killed(folder: Path, place: str) -> None:
    with (
        served(folder, place=place) as server,
        httpx.Client(base_url=server.url, timeout=60) as client,
    ):
        person = Person.consented(client)
        receipts = [person.answer(trial).json() for trial in range(3)]
        Experimenter.login(client)
        server.kill()
    with (
        served(folder, place=place) as server,
        httpx.Client(base_url=server.url, timeout=60) as client,
    ):
        person = Person(client, person.token)
        assert person.sitting()["answered"] == 3
        assert person.answer(2).json() == {**receipts[2], "again": True}
        assert person.answer(3).json()["again"] is False


def test_behind_a_proxy_it_goes_by_the_public_address(folder: Path) -> None:
    with served(folder, "--url", "https://pearls.example/") as server:
        with httpx.Client(base_url=server.url, timeout=60) as client:
            told = client.post(
                "/lab/api/login",
                json={"name": "lab", "password": "correct horse battery staple"},
                headers={"Origin": "https://pearls.example"},
            )
            assert "; Secure" in told.headers["set-cookie"]
            assert told.headers["strict-transport-security"] == "max-age=31536000"
            cookie = told.headers["set-cookie"].partition(";")[0]
            links = client.post(
                "/lab/api/invitations",
                json={"count": 3, "label": "x"},
                headers={"Cookie": cookie, "X-CSRF-Token": told.json()["csrf"]},
            ).json()["links"]
            assert links[0].startswith("https://pearls.example/#")
            entered = []
            for link, origin in zip(
                links, ("https://pearls.example", server.url, "http://pearls.example"), strict=True
            ):
                person = Person(client, link.partition("#")[2])
                person.headers["Origin"] = origin
                entered.append(person.enter().status_code)
            assert entered == [201, 201, 403]
        assert server.stop() == 0


def test_the_first_time_it_says_what_is_missing(folder: Path) -> None:
    with served(folder, prepared=False) as server:
        told = server.process.stdout.readline() + server.process.stdout.readline()
        assert server.stop() == 0
    assert f"nacreous study account {folder} NAME" in told
    assert "only invited people may enter" in told


def test_sigterm_is_an_ordinary_end(folder: Path) -> None:
    with served(folder) as server:
        server.process.terminate()
        assert server.process.wait(30) == 0


def test_mistakes_are_one_line(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO())
    monkeypatch.setattr(pages, "FOLDER", some_pages(tmp_path / "pages"))
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        for arguments, told in (
            (("serve", tmp_path), "holds no study.json; wanted: a folder that nacreous study new"),
            (
                ("serve", folder, "--port", port),
                f"port is {port}, which is in use; wanted",
            ),
            (("serve", folder, "--port", 65536), "port is 65536; allowed: 0 to 65535"),
            (("serve", folder, "--host", "no.such.host.invalid"), "host is 'no.such.host.invalid'"),
            (
                ("serve", folder, "--host", "203.0.113.1"),
                "host is 203.0.113.1; wanted: one",
            ),
            (("serve", folder, "--url", "ftp://x"), "url is 'ftp://x'; allowed: http://HOST or"),
            (("serve", folder, "--url", "http://x/y"), "url is 'http://x/y'; allowed: http://HOST"),
            (("serve", folder, "--store", "mysql://x"), "store is mysql:...; allowed: a path, or"),
            (("serve", folder, "--store", tmp_path / "a" / "b"), "the folder"),
            (("account", folder, "NAME"), "name is 'NAME'; allowed: 1 to 40 of a to z"),
            (("account", folder, "lab"), "password is 0 characters long; allowed: 12 to 200"),
            (("account", folder, "lab", "--remove"), "there is no account 'lab'"),
        ):
            assert main(["study", *(str(one) for one in arguments)]) == 2
            out, said = capsys.readouterr()
            assert out == ""
            assert said.startswith("nacreous: ")
            assert told in said
            assert said.count("\n") == 1


@pytest.mark.parametrize(
    ("place", "cure"),
    [
        (ROOT, "build them by   ./just pages"),
        (Path("/usr/lib/python3"), "installed without them; install a wheel that has them"),
    ],
)
def test_pages_that_are_missing_are_advised_as_can_help(
    monkeypatch: pytest.MonkeyPatch, folder: Path, tmp_path: Path, place: Path, cure: str
) -> None:
    monkeypatch.setattr(built, "CLONE", place)
    with Store.open(folder) as store:
        running = Running(store, open_frozen(folder))
        with pytest.raises(InputError, match=f"the study's pages are missing .*: .*{cure}"):
            create_app(running, built=tmp_path)


def test_a_password_is_piped_in_drawn_or_removed(folder: Path) -> None:
    done = nacreous("account", folder, "lab", stdin=None, input=f"{GOOD}\n")
    assert (done.returncode, done.stdout) == (0, "lab: may log in\n")
    drawn = nacreous("account", folder, "m.k", "--generate").stdout
    with Store.open(folder) as store:
        assert store.login_of(store.login("lab", GOOD)) == "lab"
        assert store.login("m.k", drawn.strip().rpartition("password: ")[2])
        assert nacreous("account", folder, "lab", "--remove").returncode == 0
        with pytest.raises(UnknownToken):
            store.login("lab", GOOD)
        assert store.accounts() == ["m.k"]


@pytest.mark.skipif(sys.platform == "win32", reason="no terminals of this kind")
def test_on_a_terminal_the_password_is_asked_for_twice_and_not_shown(folder: Path) -> None:
    def typed(first: str, second: str) -> tuple[int, str]:
        child, terminal = pty.fork()
        if child == 0:
            os.execv(sys.executable, [sys.executable, "-m", "nacreous", *command])
        told = b""
        for prompt, text in ((b"new password for lab: ", first), (b"the same again: ", second)):
            while not told.endswith(prompt):
                told += os.read(terminal, 1000)
            os.write(terminal, f"{text}\n".encode())
        while part := _read(terminal):
            told += part
        _, status = os.waitpid(child, 0)
        os.close(terminal)
        return os.waitstatus_to_exitcode(status), told.decode()

    command = ["study", "account", str(folder), "lab"]
    code, told = typed(GOOD, "another one!")
    assert (code, "the two passwords differ; nothing was changed" in told) == (2, True)
    code, told = typed(GOOD, GOOD)
    assert (code, GOOD in told) == (0, False)


def _read(terminal: int) -> bytes:
    try:
        return os.read(terminal, 1000)
    except OSError:  # the other side has closed it
        return b""

"""`nacreous view`: what it serves, to whom, and what it says where it cannot."""

import asyncio
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from nacreous import cli
from nacreous.problem import InputError
from nacreous.server import built
from nacreous.server.headers import POLICY as STUDY_POLICY
from nacreous.viewer.page import FOLDER, POLICY, Page

FILES = {
    "index.html": b"<!doctype html>",
    "assets/viewer-1.js": b"export {};",
    "assets/nacreous-1.wasm": b"\0asm",
    "assets/viewer-1.css": b"body {}",
}
#: Runs the command with a page of its own.
COMMAND = """
import sys
from pathlib import Path
import nacreous.viewer
from nacreous.cli import main
page = nacreous.viewer.Page
nacreous.viewer.Page = lambda: page(Path(sys.argv[1]))
sys.exit(main(["view", *sys.argv[2:]]))
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A built page in small."""
    for name, content in FILES.items():
        path = tmp_path / "page" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return tmp_path / "page"


def ask(page: Page, path: str, method: str = "GET", **headers: str) -> httpx.Response:
    async def asked() -> httpx.Response:
        transport = httpx.ASGITransport(app=page)
        async with httpx.AsyncClient(transport=transport, base_url="http://127.0.0.1:8") as client:
            return await client.request(method, path, headers=headers)

    return asyncio.run(asked())


def test_every_file_has_its_kind_and_is_kept_as_its_name_allows(folder: Path) -> None:
    kinds = {
        "/": "text/html; charset=utf-8",
        "/index.html": "text/html; charset=utf-8",
        "/assets/viewer-1.js": "text/javascript; charset=utf-8",
        "/assets/viewer-1.css": "text/css; charset=utf-8",
        "/assets/nacreous-1.wasm": "application/wasm",
    }
    page = Page(folder)
    for path, kind in kinds.items():
        for method in ("GET", "HEAD"):
            answer = ask(page, path, method)
            assert (answer.status_code, answer.headers["content-type"]) == (200, kind)
            kept = "immutable" if path.startswith("/assets") else "no-cache"
            assert kept in answer.headers["cache-control"]
            assert answer.headers["x-content-type-options"] == "nosniff"
            assert answer.headers["content-security-policy"] == POLICY
        assert ask(page, path).content == FILES[path.removeprefix("/") or "index.html"]


def test_nothing_beside_the_page_is_served(folder: Path) -> None:
    (folder.parent / "secret.txt").write_text("secret")
    page = Page(folder)
    for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/assets", "/assets/", "/index.html/"):
        assert ask(page, path).status_code == 404
    assert ask(page, "/", "POST").status_code == 405


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost:80", "LOCALHOST", "[::1]:8"])
def test_this_machine_is_answered(folder: Path, host: str) -> None:
    assert ask(Page(folder), "/", host=host).status_code == 200


@pytest.mark.parametrize("host", ["pearls.example", "127.0.0.1.example", "localhost:x", "", "::1"])
def test_a_name_of_another_that_leads_here_is_refused(folder: Path, host: str) -> None:
    assert ask(Page(folder), "/", host=host).status_code == 400


def test_the_policy_is_the_studys_but_for_webassembly_workers_and_frames() -> None:
    study, viewer = set(STUDY_POLICY.split("; ")), set(POLICY.split("; "))
    assert study - viewer == {"script-src 'self'", "frame-ancestors 'none'"}
    assert viewer - study == {"script-src 'self' 'wasm-unsafe-eval'", "worker-src 'self'"}


def test_a_static_host_gets_the_same_policy_from_the_page_itself() -> None:
    index = FOLDER / "index.html"
    if not index.is_file():
        pytest.skip("the viewer is not built here:   ./just viewer")
    page = index.read_text(encoding="utf-8")
    (found,) = re.findall(r'Content-Security-Policy"\s+content="([^"]*)"', page)
    assert set(found.split("; ")) == set(POLICY.split("; "))


def test_the_page_stays_small() -> None:
    """Under 1.5 MB as servers send it; the codecs of pictures come only for whoever opens one."""
    import gzip

    if not (FOLDER / "index.html").is_file():
        pytest.skip("the viewer is not built here:   ./just viewer")
    files = [path for path in FOLDER.rglob("*") if path.is_file()]
    sent = {path.name: len(gzip.compress(path.read_bytes())) for path in files}
    later = {name for name in sent if name.startswith("nacreous_files_bg")}
    assert len(later) == 1
    assert sum(size for name, size in sent.items() if name not in later) < 1_000_000
    assert sum(sent[name] for name in later) < 1_000_000


def test_a_clone_is_told_to_build_the_page_and_a_wheel_is_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(
        InputError, match=r"viewer's files are missing .*: build them by   \./just viewer$"
    ):
        Page(tmp_path)
    monkeypatch.setattr(built, "CLONE", tmp_path)
    with pytest.raises(InputError, match="installed without them") as problem:
        Page(tmp_path)
    assert "just" not in str(problem.value)
    assert "\n" not in str(problem.value)


@pytest.fixture
def start(folder: Path) -> Iterator[Any]:
    """Starts the command; gives the process and the line it says."""
    running: list[subprocess.Popen[str]] = []

    def started(*words: str) -> tuple[subprocess.Popen[str], str]:
        process = subprocess.Popen(
            [sys.executable, "-c", COMMAND, str(folder), *words, "--no-browser"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        running.append(process)
        assert process.stdout
        return process, process.stdout.readline()

    yield started
    for process in running:
        process.kill()
        process.communicate()


def test_it_says_its_address_serves_and_ends_by_ctrl_c(start: Any) -> None:
    process, line = start("akoya-rg", "--scene", "booth", "--set", "depth=0.8")
    found = re.fullmatch(
        r"viewer: (http://127\.0\.0\.1:\d+/)#1\.[\w-]+   \(Ctrl-C ends it\)\n", line
    )
    assert found, line
    assert httpx.get(found[1]).content == FILES["index.html"]
    process.send_signal(signal.SIGINT)
    rest, problems = process.communicate(timeout=60)
    assert (process.returncode, rest, problems) == (0, "", "")


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["nopearl"], '"nopearl" is neither a file nor a pearl preset; '),
        (["paper", "--set", "depth=7"], "--set: depth is 7; allowed: 0 to 1"),
        (["paper", "--port", "70000"], "port is 70000; allowed: 0 to 65535"),
        (["grained.toml"], "grained.toml: names the file wool.png, which a page cannot read; "),
        (["paper", "--scene", "rows.toml"], "rows.toml: names the file mine.toml, "),
        (["paper", "--scene", "two.toml"], 'scene scene: a row has "*1"; allowed: "*0" to "*0"'),
    ],
)
def test_what_the_page_cannot_show_is_refused_in_a_line(
    words: list[str],
    line: str,
    folder: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "grained.toml").write_text('texture.source = "wool.png"')
    (tmp_path / "rows.toml").write_text('[[rows]]\npearls = ["*", "mine.toml"]')
    (tmp_path / "two.toml").write_text('[[rows]]\npearls = ["*1"]')
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("nacreous.viewer.Page", lambda: Page(folder))
    assert cli.main(["view", "--no-browser", *words]) == 2
    assert capsys.readouterr().err.startswith(f"nacreous: {line}")

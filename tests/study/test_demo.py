"""`nacreous study demo`: one command, a whole study, and nothing left behind."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from http.cookiejar import CookieJar
from pathlib import Path

import pytest

from nacreous.study.design import Design, open_frozen
from nacreous.study.plan import trials
from nacreous.study.store import Store
from tests.support import server_process

#: With pages that say nothing where none are built.
DEMO = [sys.executable, server_process.__file__, "study", "demo", "--no-browser"]


@contextmanager
def running(temporary: Path, *options: str) -> Iterator[tuple[subprocess.Popen[str], list[str]]]:
    """The demonstration, once it says that Ctrl-C ends it; and what it said."""
    process = subprocess.Popen(
        [*DEMO, *options],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "TMPDIR": str(temporary)},
    )
    assert process.stdout is not None
    lines: list[str] = []
    try:
        for line in process.stdout:
            lines.append(line.rstrip("\n"))
            if line.startswith("Ctrl-C"):
                break
        yield process, lines
    finally:
        if process.poll() is None:
            process.kill()
        process.wait(30)
        process.stdout.close()


def interrupted(process: subprocess.Popen[str]) -> str:
    """Ctrl-C; what was said at the end of an ordinary end."""
    process.send_signal(signal.SIGINT)
    assert process.stdout is not None
    rest = process.stdout.read()
    assert process.wait(30) == 0, rest
    return rest


def test_it_says_what_to_open_serves_it_and_leaves_nothing(tmp_path: Path) -> None:
    with running(tmp_path) as (process, lines):
        said = "\n".join(lines)
        found = re.search(r"(http://127\.0\.0\.1:\d+)/lab +name: (\S+) +password: (\S+)", said)
        assert found, said
        url, name, password = found.groups()
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(CookieJar()))
        with opener.open(f"{url}/api/study") as told:
            study = json.load(told)
        assert (study["purpose"], study["registration"]) == ("demo", "open")
        body = json.dumps({"name": name, "password": password}).encode()
        login = urllib.request.Request(
            f"{url}/lab/api/login", body, {"Content-Type": "application/json"}
        )
        opener.open(login).close()
        with opener.open(f"{url}/lab/api/progress") as told:
            progress = json.load(told)
        assert (progress["finished"], progress["simulated"]) == (20, progress["answers"])
        with opener.open(f"{url}/lab/api/scale?question=deeper&simulated=true") as told:
            assert json.load(told)["people"] == 20
        with opener.open(f"{url}/lab/api/scale?question=deeper&simulated=false") as told:
            assert "no answers" in json.load(told)["problem"]
        assert any(tmp_path.glob("nacreous-demo-*"))
        assert "temporary folder is removed" in interrupted(process)
    assert not any(tmp_path.glob("nacreous-demo-*"))


def test_a_folder_that_was_asked_for_is_kept(tmp_path: Path) -> None:
    folder = tmp_path / "kept"
    with running(tmp_path, "--folder", str(folder)) as (process, _):
        assert f"nacreous study serve {folder}" in interrupted(process)
    frozen = open_frozen(folder)
    with Store.open(folder) as store:
        assert store.progress(frozen.study_hash).finished == 20
    again = subprocess.run(
        [*DEMO, "--folder", str(folder)],
        capture_output=True,
        text=True,
    )
    assert again.returncode == 2
    assert "frozen already" in again.stderr


def test_ctrl_c_before_it_serves_leaves_nothing_either(tmp_path: Path) -> None:
    process = subprocess.Popen(
        DEMO,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "TMPDIR": str(tmp_path)},
    )
    until = time.monotonic() + 60
    while not any(tmp_path.glob("nacreous-demo-*")) and time.monotonic() < until:
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=60)
    assert process.returncode in (0, 130), said
    assert "Traceback" not in said
    assert not any(tmp_path.glob("nacreous-demo-*"))


def test_a_port_in_use_is_said_before_anything_is_made(tmp_path: Path) -> None:
    import socket

    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        done = subprocess.run(
            [*DEMO, "--port", port],
            capture_output=True,
            text=True,
            env={**os.environ, "TMPDIR": str(tmp_path)},
        )
    assert done.returncode == 2
    assert f"port is {port}, which is in use" in done.stderr
    assert not any(tmp_path.glob("nacreous-demo-*"))


@pytest.mark.parametrize("language", ["en", "ja"])
def test_the_demonstration_is_one_and_takes_a_minute(language: str) -> None:
    design = Design.load("demo")
    assert design.purpose == "demo"
    assert design.labels == ("R", "RG", "G", "dull", "thin")
    assert len(trials(design, 0)) == 14
    assert design.consent.in_language(language)
    assert design.questions[0].text.in_language(language)

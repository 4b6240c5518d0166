"""A small study, and a server of it: in this process for most tests, in one of its own for others.

    python server_process.py study serve FOLDER ...

is `nacreous study serve` with pages that say nothing where none are built.
"""

import os
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from fastapi import FastAPI

from nacreous.server import pages
from nacreous.server.listening import address_of, listen, server_of
from nacreous.study.design import freeze, open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store

ROOT = Path(__file__).parent.parent.parent
NAME, PASSWORD = "lab", "correct horse battery staple"

STUDY = """\
name = "small"
purpose = "demo"
seed = 5
questions = [{ id = "deeper", text = { en = "Which is deeper?", ja = "どちらが深い?" } }]
display = { size_px = 32, samples = 1 }
sitting = { training = 1 }
screen = { card = false, distance = false, levels = false, full_screen = false }

[[stimuli]]
label = "secret-r"
pearl = "akoya-r"
[[stimuli]]
label = "secret-g"
pearl = "akoya-g"
[[stimuli]]
label = "secret-rg"
pearl = "akoya-rg"

[[catches]]
expected = "secret-rg"
against = "secret-g"

[[groups]]
name = "trade"
values = ["yes", "no"]
how = "recorded"
question = { en = "Do you work with pearls?", ja = "真珠に関わるお仕事をされていますか。" }

[[groups]]
name = "lamp"
values = ["warm", "cold"]
"""


@cache
def _frozen() -> TemporaryDirectory[str]:
    """The study, frozen once in a process, which removes it when it ends."""
    temporary = TemporaryDirectory(prefix="nacreous-study-")
    folder = Path(temporary.name)
    (folder / "small.toml").write_text(STUDY, encoding="utf-8")
    freeze(folder / "small.toml", folder / "study")
    return temporary


def small_study(folder: Path) -> Path:
    """A frozen study of three stimuli in a folder that is not there yet: 5 trials a person."""
    shutil.copytree(Path(_frozen().name) / "study", folder)
    return folder


def some_pages(folder: Path) -> Path:
    """Pages that say nothing, built in a folder that is not there yet."""
    (folder / "assets").mkdir(parents=True)
    for name in ("index.html", "lab.html"):
        (folder / name).write_text(f"<!doctype html><title>{name}</title>\n", encoding="utf-8")
    (folder / "assets" / "main-1a2b3c.js").write_text("export {};\n", encoding="utf-8")
    return folder


@contextmanager
def in_thread(app: FastAPI) -> Iterator[str]:
    """Serve on any free port, from a thread of this process; gives the URL."""
    server = server_of(app)
    with listen("127.0.0.1", 0) as listening:
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
        thread.start()
        try:
            yield address_of(listening)
        finally:
            server.should_exit = True
            thread.join(30)


@dataclass
class Served:
    """A process that serves; `url` is without a slash at its end."""

    process: subprocess.Popen[str]
    url: str
    lines: list[str]

    def stop(self) -> int:
        """Ctrl-C; gives the exit code."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(30)

    def kill(self) -> None:
        """No time for anything."""
        self.process.kill()
        self.process.wait(30)


def prepare(folder: Path, place: str | None = None) -> None:
    """Let anybody enter, and make one account (NAME, PASSWORD)."""
    with Store.open(place or folder) as store:
        running = Running(store, open_frozen(folder))
        store.set_registration(running.study, "open", "test")
        if not store.accounts():
            store.set_password(NAME, PASSWORD, "test")


@contextmanager
def served(
    folder: Path,
    *options: str,
    place: str | None = None,
    prepared: bool = True,
    program: str = __file__,
) -> Iterator[Served]:
    """Serve a frozen study on any free port; if it is prepared, anybody may enter.

    A process that is killed cannot remove what it keeps in the temporary folder: it has its own.
    """
    if prepared:
        prepare(folder, place)
    with TemporaryDirectory(prefix="nacreous-served-", ignore_cleanup_errors=True) as temporary:
        yield from _serving(folder, options, place, program, temporary)


def _serving(
    folder: Path, options: tuple[str, ...], place: str | None, program: str, temporary: str
) -> Iterator[Served]:
    port = () if "--port" in options else ("--port", "0")
    command = [sys.executable, program, "study", "serve", str(folder), *port, *options]
    process = subprocess.Popen(
        [*command, *(("--store", place) if place else ())],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env=_environment() | {"TMPDIR": temporary},
    )
    try:
        yield _started(process)
    finally:
        if process.poll() is None:
            process.kill()
            process.wait(30)
        assert process.stdout is not None
        process.stdout.close()


def _environment() -> dict[str, str]:
    """Ours without a store of its user's; programs find the helpers of tests as tests do."""
    ours = {name: text for name, text in os.environ.items() if name != "NACREOUS_STORE"}
    return {**ours, "PYTHONPATH": str(ROOT)}


def _started(process: subprocess.Popen[str]) -> Served:
    """Wait until it says where it serves."""
    assert process.stdout is not None
    lines = []
    for line in process.stdout:
        lines.append(line.rstrip("\n"))
        if " experimenters: " in line:
            url = line.split(" experimenters: ")[1].strip().removesuffix("/lab")
            return Served(process, url, lines)
    raise AssertionError("the server did not start:\n" + "\n".join(lines))


def main() -> int:
    from nacreous.cli import main as nacreous

    with TemporaryDirectory(prefix="nacreous-pages-") as folder:
        if not (pages.FOLDER / "index.html").exists():
            pages.FOLDER = some_pages(Path(folder) / "pages")
        return nacreous(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())

"""How fast `nacreous study serve` takes answers: five hundred people, each every two seconds.

    python benchmarks/server.py [--people 500] [--seconds 40]

The server is a process of its own, and so is who asks; both share this machine. A time runs from
when an answer is due to when its receipt is there, so one that waits for another counts too.
"Machine" is how busy all cores were, with whatever else went on. Beside the participants an
experimenter's page asks for the progress every three seconds.
"""

import argparse
import asyncio
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import uvloop

from nacreous.study.design import freeze, open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store

sys.path.insert(0, str(Path(__file__).parent.parent))
from tests.support import database

EVERY_S = 2.0
LAB_EVERY_S = 3.0
#: The server starts a second process, which is then ready.
SETTLING_S = 8.0
NAME, PASSWORD = "lab", "correct horse battery staple"

#: Ten stimuli: 45 pairs and 3 for training.
STUDY = """\
name = "load"
purpose = "demo"
questions = [{ id = "deeper", text = { en = "Which is deeper?", ja = "どちらが深い?" } }]
display = { size_px = 32, samples = 1 }
""" + "".join(
    f'[[stimuli]]\nlabel = "{step}"\npearl = "paper"\noverrides = ["depth={step / 10}"]\n'
    for step in range(1, 11)
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--people", type=int, default=500)
    parser.add_argument("--seconds", type=float, default=40)
    parser.add_argument("--load", help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.load:
        uvloop.run(Load(args.load, json.load(sys.stdin), args.seconds).run())
        return
    columns = ("store", "answers", "a second", "p50", "p95", "p99", "longest", "errors")
    print(
        "|", *(f"{name} |" for name in (*columns, "processors an answer", "machine", "peak memory"))
    )
    print("|", "---|" * 11)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "load.toml").write_text(STUDY, encoding="utf-8")
        study = Path(folder) / "study"
        freeze(Path(folder) / "load.toml", study)
        measure("SQLite", study, str(study), args)
        if database.binaries() is None:
            print("PostgreSQL is left out (no initdb):   sudo apt install postgresql")
            return
        with postgresql() as place:
            measure("PostgreSQL", study, place, args)


@contextmanager
def postgresql() -> Iterator[str]:
    """A database from Debian's package, as the tests start it, but that waits for its disk."""
    with database.start() as server:
        server.stop()
        server.start(fsync="on")
        yield server.create("load")


def measure(name: str, study: Path, place: str, args: argparse.Namespace) -> None:
    tokens = people(study, place, args.people)
    command = [sys.executable, "-m", "nacreous", "study", "serve", str(study), "--port", "0"]
    with subprocess.Popen(
        [*command, "--store", place], stdout=subprocess.PIPE, text=True
    ) as server:
        try:
            url = address(server)
            time.sleep(SETTLING_S)
            before_s, busy_s, idle_s = processor_s(server.pid), *machine_s()
            command = [sys.executable, __file__, "--load", url, "--seconds", str(args.seconds)]
            done = subprocess.run(
                command, input=json.dumps(tokens), stdout=subprocess.PIPE, text=True, check=True
            )
            found = json.loads(done.stdout)
            used_s = processor_s(server.pid) - before_s
            busy_s, idle_s = (
                after - before for after, before in zip(machine_s(), (busy_s, idle_s), strict=True)
            )
            memory_mb = [peak_mb(process) for process in (server.pid, *children(server.pid))]
            row(name, found, used_s, busy_s / (busy_s + idle_s), memory_mb)
        finally:
            server.terminate()


def people(study: Path, place: str, count: int) -> list[str]:
    """The tokens of people who have entered and consented."""
    with Store.open(place) as store:
        running = Running(store, open_frozen(study))
        store.set_password(NAME, PASSWORD, "benchmark")
        tokens = store.invite(running.study, count, "benchmark", "benchmark")
        for token in tokens:
            store.consent(running.enter(token, "en", {}).id)
    return tokens


def address(server: "subprocess.Popen[str]") -> str:
    assert server.stdout is not None
    for line in server.stdout:
        if " serving at " in line:
            return line.split(" serving at ")[1].strip()
    raise SystemExit("the server did not start")


def processor_s(process: int) -> float:
    """Of all cores together, of the server alone."""
    fields = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def machine_s() -> tuple[float, float]:
    """Busy and idle, of all cores together, whoever it is that uses them."""
    line = Path("/proc/stat").read_text(encoding="utf-8").partition("\n")[0]
    ticks = [int(field) for field in line.split()[1:]]
    idle = ticks[3] + ticks[4]
    return sum(ticks) - idle, idle


def children(process: int) -> list[int]:
    """The processes that a process has started."""
    found = Path(f"/proc/{process}/task").glob("*/children")
    return [int(child) for path in found for child in path.read_text(encoding="utf-8").split()]


def peak_mb(process: int) -> float:
    """The most that was ever in memory, what is shared with other processes included."""
    status = Path(f"/proc/{process}/status").read_text(encoding="utf-8")
    [line] = [line for line in status.splitlines() if line.startswith("VmHWM:")]
    return int(line.split()[1]) / 1024


def row(name: str, found: dict, used_s: float, busy: float, memory_mb: list[float]) -> None:
    times_ms = np.array(found["times_s"]) * 1000
    p50, p95, p99 = np.percentile(times_ms, [50, 95, 99])
    print(
        f"| {name} | {len(times_ms)} | {len(times_ms) / found['wall_s']:.0f} | {p50:.0f} ms "
        f"| {p95:.0f} ms | {p99:.0f} ms | {times_ms.max():.0f} ms | {found['errors']} "
        f"| {used_s / len(times_ms) * 1000:.2f} ms | {busy:.0%} "
        f"| {' + '.join(f'{one:.0f}' for one in memory_mb)} MB |",
        flush=True,
    )


class Load:
    """All participants and one experimenter, on one thread."""

    def __init__(self, url: str, tokens: list[str], seconds: float) -> None:
        self.host, _, port = url.removeprefix("http://").strip("/").partition(":")
        self.port = int(port)
        self.tokens, self.seconds = tokens, seconds
        self.times_s: list[float] = []
        self.errors = 0

    async def run(self) -> None:
        """Ask for so long, and print what was found."""
        begin = time.monotonic() + 1
        everyone = [
            self.participant(token, begin + EVERY_S * place / len(self.tokens))
            for place, token in enumerate(self.tokens)
        ]
        await asyncio.gather(*everyone, self.experimenter(begin))
        wall_s = time.monotonic() - begin
        print(json.dumps({"times_s": self.times_s, "errors": self.errors, "wall_s": wall_s}))

    async def participant(self, token: str, begin: float) -> None:
        """Answer a trial every two seconds."""
        await asyncio.sleep(begin - 0.5 - time.monotonic())
        reader, writer = await asyncio.open_connection(self.host, self.port)
        for trial in range(int(self.seconds / EVERY_S)):
            due = begin + EVERY_S * trial
            await asyncio.sleep(due - time.monotonic())
            body = json.dumps({"chosen": ("left", "right")[trial % 2], "response_ms": 1840.5})
            head = f"Authorization: Bearer {token}\r\n"
            status, _, _ = await self.ask(
                reader, writer, "PUT", f"/api/answers/{trial}", head, body
            )
            self.times_s.append(time.monotonic() - due)
            self.errors += status != 200
        writer.close()

    async def experimenter(self, begin: float) -> None:
        """Log in, and look every three seconds."""
        reader, writer = await asyncio.open_connection(self.host, self.port)
        body = json.dumps({"name": NAME, "password": PASSWORD})
        _, head, _ = await self.ask(reader, writer, "POST", "/lab/api/login", "", body)
        [cookie] = [line for line in head.splitlines() if line.startswith("set-cookie: ")]
        cookie = f"Cookie: {cookie.removeprefix('set-cookie: ').partition(';')[0]}\r\n"
        for look in range(int(self.seconds / LAB_EVERY_S)):
            await asyncio.sleep(begin + LAB_EVERY_S * look - time.monotonic())
            status, _, _ = await self.ask(reader, writer, "GET", "/lab/api/progress", cookie)
            self.errors += status != 200
        writer.close()

    async def ask(self, reader, writer, method: str, path: str, head: str, body: str = ""):
        """Status, head and body of one response."""
        length = (
            f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n" if body else ""
        )
        writer.write(
            f"{method} {path} HTTP/1.1\r\nHost: {self.host}:{self.port}\r\n"
            f"{head}{length}\r\n{body}".encode()
        )
        told = (await reader.readuntil(b"\r\n\r\n")).decode()
        [length] = [line for line in told.splitlines() if line.startswith("content-length: ")]
        content = await reader.readexactly(int(length.partition(": ")[2]))
        return int(told.split(" ", 2)[1]), told, content


if __name__ == "__main__":
    main()

"""What two million answers cost: progress, scale, report, export, and the memory of each.

    python benchmarks/store.py [--answers 2000000] [--layouts many few] [--stores sqlite postgresql]
        [--parts pages commands] [--keep FOLDER]

All answers are simulated, by Thurstone's case V, and marked so in the store; they are written to
the database directly, for two million commits would take hours. "Many" is 2,000 people of 1,000
answers over 60 stimuli; "few" is 40 people of 50,000 over 20, who compare every pair many times.
The server is `nacreous study serve` with its worker; a page that comes first finds nothing worked
out. Memory is the most that a process ever held (VmHWM), what it shares with others included.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
import urllib.request
import uuid
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from http.cookiejar import CookieJar
from itertools import combinations, repeat
from pathlib import Path
from typing import NamedTuple

import numpy as np
import sqlalchemy as sa

from nacreous.study.design import freeze, open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store
from nacreous.study.store.engine import FILE
from nacreous.study.store.schema import sessions, studies

sys.path.insert(0, str(Path(__file__).parent.parent))
from benchmarks.server import address, children, peak_mb, postgresql, processor_s
from tests.support import database

NAME, PASSWORD = "lab", "correct horse battery staple"
#: The server has then done whatever it does at its start.
SETTLING_S = 8.0
#: Beyond, a measurement is given up.
LONGEST_S = 240.0
_ROWS = 50_000
_COLUMNS = (
    *("study", "session", "trial", "kind", "question", "left", "right", "chosen", "response_ms"),
    *("shown_at", "answered_at", "received_at", "flags", "simulated", "digest"),
)


class Layout(NamedTuple):
    """How two million answers are spread; answers: of each person."""

    people: int
    stimuli: int


LAYOUTS = {"many": Layout(2000, 60), "few": Layout(40, 20)}


def main() -> None:
    """Fill, measure, print a line for each."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--answers", type=int, default=2_000_000)
    parser.add_argument("--layouts", nargs="+", choices=LAYOUTS, default=list(LAYOUTS))
    stores = ("sqlite", "postgresql")
    parser.add_argument("--stores", nargs="+", choices=stores, default=stores)
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=list(PARTS))
    parser.add_argument("--keep", type=Path, help="where a filled SQLite store is kept and found")
    args = parser.parse_args()
    print("| store, layout | what | wall | processors | peak memory |\n|---|---|---|---|---|")
    for name in args.layouts:
        for kind in args.stores:
            if kind == "postgresql" and database.binaries() is None:
                print("PostgreSQL is left out (no initdb):   sudo apt install postgresql")
                continue
            with ExitStack() as stack:
                beside = Path(stack.enter_context(tempfile.TemporaryDirectory()))
                folder = args.keep / f"{name}-{args.answers}" if args.keep else beside
                study = folder / "study"
                place = str(study) if kind == "sqlite" else stack.enter_context(postgresql())
                if not study.exists():
                    frozen(folder, LAYOUTS[name])
                if kind == "postgresql" or not (study / FILE).exists():
                    begin = time.monotonic()
                    fill(study, place, LAYOUTS[name], args.answers)
                    filled_s = time.monotonic() - begin
                    print(f"filled in {filled_s:.0f} s", file=sys.stderr, flush=True)
                for part in args.parts:
                    for line in PARTS[part](study, place, beside):
                        print(f"| {kind}, {name} | {line} |", flush=True)


def frozen(folder: Path, layout: Layout) -> None:
    """A study of so many stimuli, whose pictures are small."""
    head = (
        'name = "two million, simulated"\npurpose = "demo"\n'
        'questions = [{ id = "deeper", text = { en = "Deeper?", ja = "どちらが深い?" } }]\n'
        "display = { size_px = 32, samples = 1 }\n"
        '[[groups]]\nname = "sex"\nhow = "recorded"\nvalues = ["f", "m"]\n'
        'question = { en = "Your sex?", ja = "性別" }\n'
    )
    stimuli = "".join(
        f'[[stimuli]]\nlabel = "p{at:02d}"\npearl = "paper"\noverrides = ["depth={at / 100}"]\n'
        for at in range(1, layout.stimuli + 1)
    )
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "two-million.toml").write_text(head + stimuli, encoding="utf-8")
    freeze(folder / "two-million.toml", folder / "study")


def fill(study: Path, place: str, layout: Layout, answers: int) -> None:
    """Write people and their answers, trial by trial, as they come in when all work at once."""
    with Store.open(place) as store:
        running = Running(store, open_frozen(study))
        store.set_registration(running.study, "open", "benchmark")
        store.set_password(NAME, PASSWORD, "benchmark")
        people = [person(running.study, number) for number in range(layout.people)]
        with store.engine.begin() as connection:
            connection.execute(sa.insert(sessions), people)
            connection.execute(sa.update(studies).values(next_number=layout.people))
        ids = [row["id"] for row in people]
        parts = rows(running.study, ids, layout.stimuli, answers // layout.people)
        _write(store, parts)


def person(study: str, number: int) -> dict[str, str | int]:
    """A session as its row."""
    at = "2026-03-01T08:59:00.000000Z"
    return {
        **{"id": str(uuid.UUID(int=number)), "study": study, "number": number, "language": "en"},
        **{"groups": json.dumps({"sex": "fm"[number % 2]}), "consented_at": at, "started_at": at},
    }


def rows(study: str, ids: list[str], stimuli: int, each: int) -> Iterator[list[tuple]]:
    """Answers in parts; each person's one in twenty is a pair asked again, the sides exchanged."""
    random = np.random.default_rng(1996)
    labels = np.array([f"p{at:02d}" for at in range(1, stimuli + 1)])
    values = np.linspace(-1.5, 1.5, stimuli)
    pairs = np.array(list(combinations(range(stimuli), 2)))
    asked = np.empty((len(ids), each, 2), np.int64)
    first = each - each // 20
    for person in range(len(ids)):
        order = np.concatenate(
            [random.permutation(len(pairs)) for _ in range(-(-first // len(pairs)))]
        )
        own = pairs[order[:first]]
        own = np.where(random.random((first, 1)) < 0.5, own, own[:, ::-1])
        asked[person] = np.concatenate([own, own[: each - first, ::-1]])
    ends = [f".{person:06d}Z" for person in range(len(ids))]
    start = np.datetime64("2026-03-01T09:00:00")
    trials_at_once = max(1, _ROWS // len(ids))
    for begin in range(0, each, trials_at_once):
        trials = np.arange(begin, min(begin + trials_at_once, each))
        left, right = asked[:, trials].transpose(2, 1, 0).reshape(2, -1)
        lead = values[left] - values[right] + random.standard_normal(len(left))
        seconds = (start + np.timedelta64(4, "s") * trials).astype(str).tolist()
        at = [f"{second}{end}" for second in seconds for end in ends]
        first_row = begin * len(ids)
        yield list(
            zip(
                *(repeat(study), ids * len(trials), np.repeat(trials, len(ids)).tolist()),
                np.repeat(np.where(trials < first, "pair", "repeat"), len(ids)).tolist(),
                *(repeat("deeper"), labels[left].tolist(), labels[right].tolist()),
                np.where(lead > 0, "left", "right").tolist(),
                np.round(np.exp(random.normal(7.3, 0.4, len(left))), 1).tolist(),
                *(at, at, at, repeat("{}"), repeat(True)),
                (f"{row:064x}" for row in range(first_row, first_row + len(left))),
                strict=False,
            )
        )


def _write(store: Store, parts: Iterator[list[tuple]]) -> None:
    """By the driver itself; what a database notes by itself in time is noted at once."""
    names = ", ".join(f'"{name}"' for name in _COLUMNS)
    connection = store.engine.raw_connection()
    try:
        cursor = connection.cursor()
        if store.engine.dialect.name == "sqlite":
            cursor.execute("PRAGMA cache_size = -500000")  # indices are written all over
            cursor.execute("BEGIN")
            marks = ", ".join("?" * len(_COLUMNS))
            for part in parts:
                cursor.executemany(f"INSERT INTO answers ({names}) VALUES ({marks})", part)
        else:
            for part in parts:
                with cursor.copy(f"COPY answers ({names}) FROM STDIN") as copy:
                    for row in part:
                        copy.write_row(row)
        connection.commit()
        if store.engine.dialect.name == "postgresql":  # as autovacuum does within a minute
            connection.rollback()
            connection.driver_connection.autocommit = True
            cursor.execute("VACUUM ANALYZE answers")
            connection.driver_connection.autocommit = False
    finally:
        connection.close()


@contextmanager
def served(study: Path, place: str) -> Iterator[tuple[str, int, urllib.request.OpenerDirector]]:
    """A server: its address, its process, and who is logged in there."""
    command = [sys.executable, "-m", "nacreous", "study", "serve", str(study), "--port", "0"]
    with subprocess.Popen(
        [*command, "--store", place], stdout=subprocess.PIPE, text=True
    ) as server:
        try:
            url = address(server).rstrip("/")
            time.sleep(SETTLING_S)
            opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(CookieJar()))
            body = json.dumps({"name": NAME, "password": PASSWORD}).encode()
            asked = urllib.request.Request(
                f"{url}/lab/api/login", body, {"Content-Type": "application/json", "Origin": url}
            )
            opener.open(asked).read()
            yield url, server.pid, opener
        finally:
            server.terminate()


def pages(study: Path, place: str, folder: Path) -> Iterator[str]:
    """What an experimenter's page asks, one after the other."""
    with served(study, place) as (url, server, opener):
        for name, path in (
            ("progress", "progress"),
            ("progress again, flags being worked out beside it", "progress"),
            ("scale on the page", "scale?simulated=true"),
            ("progress, once all is worked out", "progress"),
            ("report on the page", "report?simulated=true"),
            ("answers.csv on the page", "answers.csv"),
        ):
            processes = [server, *children(server)]
            begin, used_s = time.monotonic(), sum(map(processor_s, processes))
            try:
                with opener.open(f"{url}/lab/api/{path}", timeout=LONGEST_S) as told:
                    size = sum(len(part) for part in iter(lambda: told.read(2**20), b""))
                said = f"{time.monotonic() - begin:.2f} s ({size / 1e6:.1f} MB)"
            except (TimeoutError, OSError) as problem:
                said = f"nothing in {time.monotonic() - begin:.0f} s ({problem})"
            processes = [server, *children(server)]  # the second starts when it is first asked
            used_s = sum(map(processor_s, processes)) - used_s
            held = " + ".join(f"{peak_mb(process):.0f}" for process in processes)
            yield f"{name} | {said} | {used_s:.1f} s | {held} MB"


def command(name: str, *words: str) -> Iterator[str]:
    """A command in a process of its own."""
    begin = time.monotonic()
    measured = (
        "import pathlib, re, runpy, sys, time\n"
        "sys.argv = ['nacreous', *sys.argv[1:]]\n"
        "try: runpy.run_module('nacreous', run_name='__main__')\n"
        "finally:\n"
        # ru_maxrss would begin with what we ourselves held at the fork.
        "    held = re.search(r'VmHWM:\\s+(\\d+)', pathlib.Path('/proc/self/status').read_text())\n"
        "    print(time.process_time(), held[1], file=sys.stderr)\n"
    )
    try:
        done = subprocess.run(
            [sys.executable, "-c", measured, *words],
            capture_output=True,
            text=True,
            check=True,
            timeout=LONGEST_S,
        )
        used_s, held_kb = map(float, done.stderr.strip().splitlines()[-1].split())
        wall_s = time.monotonic() - begin
        yield f"{name} | {wall_s:.1f} s | {used_s:.1f} s | {held_kb / 1024:.0f} MB"
    except subprocess.TimeoutExpired:
        yield f"{name} | nothing in {LONGEST_S:.0f} s | – | –"
    except subprocess.CalledProcessError as problem:
        yield f"{name} | failed: {problem.stderr[-300:]} | – | –"


def commands(study: Path, place: str, folder: Path) -> Iterator[str]:
    """What the command line does."""
    for name in ("answers.csv", "answers.parquet", "psych-ds"):
        words = ("study", "export", place, "-o", str(folder / name))
        yield from command(f"`nacreous study export -o {name}`", *words)
    where = ("--store", place, "--simulated", "-o", str(folder / "report.html"))
    yield from command("`nacreous study report --simulated`", "study", "report", str(study), *where)


PARTS = {"pages": pages, "commands": commands}

if __name__ == "__main__":
    main()

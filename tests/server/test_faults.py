"""Kill -9, crashes, full disks and clocks, under a server in a process of its own."""

import asyncio
import contextlib
import shutil
import sqlite3
from contextlib import ExitStack
from datetime import UTC, datetime, timedelta
from itertools import cycle
from pathlib import Path
from typing import Any

import httpx
import pytest

from nacreous.server.app import create_app
from nacreous.study.design import freeze, open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store
from tests.server import jumping_server
from tests.server.crowd import Crowd
from tests.server.people import Experimenter, Person
from tests.study.test_faults import small_disk
from tests.support.database import Server
from tests.support.server_process import NAME, PASSWORD, Served, in_thread, served, some_pages

PEOPLE, TRIALS = 50, 100
QUESTIONS = "".join(
    f'\n[[questions]]\nid = "q{k}"\ntext = {{ en = "Which?", ja = "どちら?" }}' for k in range(4)
)
#: Four questions about 21 pairs of which four come twice: a hundred trials.
STUDY = f"""\
purpose = "demo"
display = {{ size_px = 256, samples = 1 }}
pairs = {{ repeats = 4 }}
sitting = {{ training = 0, ties = true }}
stimuli = [{{ pearl = "paper", cut = "seven-crops" }}]
{QUESTIONS}
"""


@pytest.fixture(scope="module")
def frozen(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("study")
    (folder / "long.toml").write_text(STUDY, encoding="utf-8")
    freeze(folder / "long.toml", folder / "study")
    return folder / "study"


def choice(person: int, trial: int) -> dict[str, Any]:
    """What somebody chooses; everybody something else."""
    chosen = ("left", "right", "tie")[(person * 7 + trial) % 3]
    return {"chosen": chosen, "response_ms": 500.0 + person + trial / 128, "flags": {"who": person}}


def check_whole(place: str, crowd: Crowd) -> None:
    """Nothing is lost, doubled or mixed up, and nobody was refused."""
    with Store.open(place) as store:
        study = store.study()
        found = store.progress(study)
        rows = store.answers(study)
        told = [event.what for event in store.events(study)]
    assert (found.entered, found.consented, found.finished) == (crowd.people,) * 3
    keys = {(row["session"], row["trial"]) for row in rows}
    assert len(rows) == len(keys) == crowd.people * crowd.trials == crowd.acknowledged
    mine: dict[str, int] = {}
    for row in rows:
        flags = f'{{"who":{mine.setdefault(row["session"], int(row["flags"][7:-1]))}}}'
        given = crowd.body(mine[row["session"]], row["trial"])
        assert (row["chosen"], row["response_ms"]) == (given["chosen"], given["response_ms"])
        assert row["flags"] == flags
    assert sorted(mine.values()) == list(range(crowd.people))
    assert "refused" not in told
    assert "answer refused" not in told


def test_kill_9_under_fifty_people_loses_and_doubles_nothing(frozen: Path, place: str) -> None:
    with ExitStack() as stack:
        first = stack.enter_context(served(frozen, place=place))
        port = port_of(first)
        crowd = Crowd(port, PEOPLE, TRIALS, choice)

        async def kill(crowd: Crowd) -> None:
            await crowd.reach(PEOPLE * TRIALS // 3)
            first.kill()
            assert crowd.acknowledged < PEOPLE * TRIALS, "killed too late to show anything"
            await asyncio.to_thread(stack.enter_context, again(frozen, port, place))

        crowd.run(kill)
    check_whole(place, crowd)


def port_of(server: Served) -> int:
    return int(server.url.rpartition(":")[2])


def again(frozen: Path, port: int, place: str) -> contextlib.AbstractContextManager[Served]:
    """The server once more, where it was."""
    return served(frozen, "--port", str(port), place=place, prepared=False)


def test_a_crash_of_the_database_is_waited_out(frozen: Path, postgresql: Server) -> None:
    place = postgresql.create("crashed_under_a_server")
    with served(frozen, place=place) as server:
        crowd = Crowd(port_of(server), 20, TRIALS, choice)

        async def crash(crowd: Crowd) -> None:
            await crowd.reach(600)
            await asyncio.to_thread(postgresql.stop, "immediate")
            await asyncio.sleep(0.3)
            await asyncio.to_thread(postgresql.start)

        crowd.run(crash)
    assert sum(person.refused for person in crowd.everyone) > 0
    check_whole(place, crowd)


def fill(person: Person, trial: int) -> tuple[int, dict[str, Any], httpx.Response]:
    """Answer at length until the server refuses: the trial, the answer, the refusal."""
    while True:
        body = {"flags": {"x": "x" * 50_000}, "response_ms": float(trial)}
        told = person.answer(trial, **body)
        if told.status_code != 200:
            return trial, body, told
        trial += 1


def test_a_full_disk_is_told_and_the_study_goes_on_once_there_is_room(
    frozen: Path, tmp_path: Path
) -> None:
    with small_disk(tmp_path / "disk") as disk:
        folder = Path(shutil.copytree(frozen, disk / "study"))
        ballast = disk / "ballast"
        with served(folder) as server, httpx.Client(base_url=server.url, timeout=60) as client:
            person, other = Person.new(client), Person.new(client)
            person.enter(groups={})
            person.post("consent")
            lab = Experimenter.login(client)
            ballast.write_bytes(b"x" * 400_000)
            reached, body, told = fill(person, 0)
            check_told(told)
            assert reached > 0, "the disk was full before"
            for refused in (
                other.enter(language="en", groups={}),
                person.answer(reached, **body),
                lab.post("invitations", {"count": 900, "label": "x" * 200}),
            ):
                check_told(refused)
            assert person.sitting()["answered"] == reached, "reading goes on"
            assert lab.get("progress").json()["answers"] == reached
            ballast.unlink()
            receipt = person.answer(reached, **body).json()
            assert (receipt["trial"], receipt["again"]) == (reached, False)
            assert other.enter(language="en", groups={}).status_code == 201
            assert person.answer(reached, **body).json()["again"]
            assert server.stop() == 0
        check_intact(folder / "answers.sqlite", reached + 1)


def check_told(refusal: httpx.Response) -> None:
    """One clear line, and when to come again."""
    told = refusal.json()
    assert (refusal.status_code, told["kind"]) == (503, "store")
    assert refusal.headers["retry-after"] == "2"
    assert "the disk" in told["problem"]
    assert "\n" not in told["problem"]


def check_intact(file: Path, count: int) -> None:
    with contextlib.closing(sqlite3.connect(file)) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    with Store.open(file) as store:
        assert [row["trial"] for row in store.answers(store.study())] == list(range(count))


def test_a_process_whose_clock_jumps_all_the_time_keeps_every_answer_once(
    frozen: Path, place: str
) -> None:
    with served(frozen, place=place, program=jumping_server.__file__) as server:
        crowd = Crowd(port_of(server), 5, TRIALS, choice)
        asyncio.run(crowd.go_through())
        assert server.stop() == 0
    check_whole(place, crowd)
    with Store.open(place) as store:
        times = [row["received_at"] for row in store.answers(store.study())]
    assert times != sorted(times), "the clock did not jump"


class Clock:
    """A clock that a test sets."""

    def __init__(self) -> None:
        self.now = datetime(2026, 3, 1, tzinfo=UTC)

    def __call__(self) -> datetime:
        return self.now


def test_a_clock_that_jumps_costs_no_answer(frozen: Path, place: str, tmp_path: Path) -> None:
    clock = Clock()
    jumps = cycle([timedelta(hours=-3), timedelta(days=4000), timedelta(days=-8000), timedelta(1)])
    with Store.open(place, clock=clock) as store:
        running = Running(store, open_frozen(frozen))
        store.set_registration(running.study, "open", "test")
        app = create_app(running, built=some_pages(tmp_path / "pages"))
        with in_thread(app) as url, httpx.Client(base_url=url, timeout=60) as client:
            person = Person.new(client)
            person.enter(groups={})
            clock.now += timedelta(days=-1)
            person.post("consent")
            for trial in range(TRIALS):
                clock.now += next(jumps)
                told = person.answer(trial).json()
                assert datetime.fromisoformat(told["received_at"]) == clock.now
                clock.now += next(jumps)
                assert person.answer(trial).json() == {**told, "again": True}
            assert person.post("finish").status_code == 204
            assert person.sitting()["answered"] == TRIALS
            assert [row["trial"] for row in store.answers(running.study)] == list(range(TRIALS))
            check_experimenters(client, store, clock)


def check_experimenters(client: httpx.Client, store: Store, clock: Clock) -> None:
    """Logins end at a jump, not before; what is told of people who were never quick or slow."""
    store.set_password(NAME, PASSWORD, "test")
    lab = Experimenter.login(client)
    clock.now -= timedelta(minutes=5)
    told = lab.get("progress")
    assert (told.status_code, told.json()["answers"], told.json()["finished"]) == (200, TRIALS, 1)
    assert lab.get("answers.csv").text.count("\n") == TRIALS + 1
    clock.now += timedelta(days=1)
    assert lab.get("progress").status_code == 401

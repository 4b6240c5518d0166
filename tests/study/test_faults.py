"""Kill -9, crashes of the database, full disks: no acknowledged answer is lost, none doubled."""

import contextlib
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from nacreous.study.store import Store, StoreError
from tests.support.database import Server
from tests.support.pairs import pair_answer

STUDY = "5e" * 32
PEOPLE, TRIALS = 50, 60
ROOT = Path(__file__).parent.parent.parent
WORKER = Path(__file__).with_name("worker.py")


def prepare(place: str, people: int = PEOPLE) -> list[str]:
    """A store with people who have consented."""
    with Store.open(place) as store:
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        sessions = [store.enter(STUDY, "en", {})[0].id for _ in range(people)]
        for session in sessions:
            store.consent(session)
    return sessions


def work(place: str, acknowledged: Path) -> "subprocess.Popen[bytes]":
    return subprocess.Popen([sys.executable, WORKER, place, acknowledged, STUDY])


def told(acknowledged: Path) -> list[tuple[str, int]]:
    """The keys that were acknowledged; a line cut short by the kill is none."""
    if not acknowledged.exists():
        return []
    lines = acknowledged.read_text().split("\n")[:-1]
    return [(session, int(trial)) for session, trial in map(str.split, lines)]


def wait_for(acknowledged: Path, count: int) -> None:
    end = time.monotonic() + 60
    while not acknowledged.exists() or acknowledged.read_bytes().count(b"\n") < count:
        assert time.monotonic() < end, "the worker does not come forward"
        time.sleep(0.01)


def stored(place: str) -> list[tuple[str, int]]:
    with Store.open(place) as store:
        return [(row["session"], row["trial"]) for row in store.answers(STUDY)]


def check_whole(place: str) -> None:
    keys = stored(place)
    assert len(keys) == len(set(keys)) == PEOPLE * TRIALS


def test_kill_9_loses_and_doubles_nothing(place: str, tmp_path: Path) -> None:
    prepare(place)
    acknowledged = tmp_path / "acknowledged"
    for share in (0.2, 0.3):  # and again while it resumes
        worker = work(place, acknowledged)
        wait_for(acknowledged, len(told(acknowledged)) + int(share * PEOPLE * TRIALS))
        worker.kill()
        assert worker.wait() == -signal.SIGKILL
        keys = stored(place)
        assert set(told(acknowledged)) <= set(keys)
        assert len(keys) == len(set(keys))
        assert len(keys) < PEOPLE * TRIALS, "it was killed too late to show anything"
    assert work(place, acknowledged).wait() == 0
    check_whole(place)


def test_a_crash_of_the_database_server_loses_and_doubles_nothing(
    postgresql: Server, tmp_path: Path
) -> None:
    place = postgresql.create("crash")
    prepare(place)
    acknowledged = tmp_path / "acknowledged"
    worker = work(place, acknowledged)
    wait_for(acknowledged, 1000)
    postgresql.stop("immediate")
    keys = set(told(acknowledged))
    postgresql.start()
    assert keys <= set(stored(place))
    assert worker.wait() == 0
    check_whole(place)


@contextlib.contextmanager
def small_disk(folder: Path) -> Iterator[Path]:
    """A disk of 2 MB; skips where none can be mounted."""
    folder.mkdir()
    done = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=2m", "tmpfs", folder], capture_output=True, check=False
    )
    if done.returncode != 0:
        pytest.skip("no small disk can be mounted here:   run the tests as root")
    try:
        yield folder
    finally:
        subprocess.run(["umount", folder], check=True)


def fill(store: Store, session: str, start: int) -> int:
    """Answer until the machine refuses in one clear line; the first trial that was not stored."""
    for trial in range(start, start + 10_000):
        large = pair_answer(trial, "q", "a", "b", "left", flags={"x": "x" * 20_000})
        try:
            store.answer(session, large)
        except StoreError as problem:
            refusal = str(problem)
            break
    else:
        raise AssertionError("the disk is never full")
    assert "the disk" in refusal
    assert "\n" not in refusal
    return trial


def check_intact(file: Path, session: str, count: int) -> None:
    with contextlib.closing(sqlite3.connect(file)) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    with Store.open(file) as store:
        assert [row["trial"] for row in store.answers(STUDY, session)] == list(range(count))


def test_a_full_disk_is_one_clear_line_and_the_store_stays_whole(tmp_path: Path) -> None:
    with small_disk(tmp_path / "disk") as disk:
        [session] = prepare(str(disk), people=1)
        ballast = disk / "ballast"
        ballast.write_bytes(b"x" * 500_000)
        with Store.open(disk) as store:
            reached = fill(store, session, 0)
            assert len(store.answers(STUDY)) == reached, "reading goes on"
            ballast.unlink()
            further = fill(store, session, reached)
            assert further > reached, "and writing, once there is room"
        check_intact(disk / "answers.sqlite", session, further)


LIMITED = """
import resource, sys
sys.path.insert(0, sys.argv[1])
from tests.study.test_faults import fill
from nacreous.study.store import Store
resource.setrlimit(resource.RLIMIT_FSIZE, (1_000_000, 1_000_000))
with Store.open(sys.argv[2]) as store:
    print(fill(store, sys.argv[3], 0))
"""


def test_a_file_that_may_not_grow_is_a_clear_line_and_the_store_stays_whole(tmp_path: Path) -> None:
    [session] = prepare(str(tmp_path), people=1)
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, str(ROOT), str(tmp_path), session],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    count = int(done.stdout)
    assert count > 10
    check_intact(tmp_path / "answers.sqlite", session, count)


def test_a_database_locked_by_another_is_a_clear_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("nacreous.study.store.engine._BUSY_MS", 50)
    [session] = prepare(str(tmp_path), people=1)
    with Store.open(tmp_path) as store:
        file = tmp_path / "answers.sqlite"
        with contextlib.closing(sqlite3.connect(file, isolation_level=None)) as other:
            other.execute("BEGIN IMMEDIATE")
            with pytest.raises(StoreError, match="another program keeps the database locked"):
                store.answer(session, pair_answer(0, "q", "a", "b", "left"))
            other.execute("ROLLBACK")
        assert not store.answer(session, pair_answer(0, "q", "a", "b", "left")).again


def test_many_who_wait_for_a_locked_database_wait_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("nacreous.study.store.engine._BUSY_MS", 200)
    [session] = prepare(str(tmp_path), people=1)
    with Store.open(tmp_path) as store:
        file = tmp_path / "answers.sqlite"
        with contextlib.closing(sqlite3.connect(file, isolation_level=None)) as other:
            other.execute("BEGIN IMMEDIATE")
            begin = time.monotonic()
            given = [
                store.hand_in(session, pair_answer(n, "q", "a", "b", "left")) for n in range(100)
            ]
            assert all(isinstance(future.exception(), StoreError) for future in given)
            assert time.monotonic() - begin < 5
            other.execute("ROLLBACK")


def test_a_lost_connection_costs_no_answer(postgresql: Server) -> None:
    place = postgresql.create("lost")
    [session] = prepare(place, people=1)
    with Store.open(place) as store:
        store.answer(session, pair_answer(0, "q", "a", "b", "left"))
        postgresql.stop("immediate")
        try:
            with pytest.raises(StoreError, match="cannot be reached, or the connection was lost"):
                store.answer(session, pair_answer(1, "q", "a", "b", "left"))
        finally:
            postgresql.start()
        store.answer(session, pair_answer(1, "q", "a", "b", "left"))
        assert [row["trial"] for row in store.answers(STUDY)] == [0, 1]

"""The process that works out what takes seconds: what comes back, and how it ends."""

import asyncio
import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from nacreous.problem import InputError
from nacreous.server.refusal import Refusal
from nacreous.server.worker import Worker
from nacreous.study import results
from nacreous.study.running import Running
from nacreous.study.store import StoreError
from tests.server.people import Experimenter, Person
from tests.support.server_process import prepare, served, small_study


def process_of(_: Running) -> int:
    return os.getpid()


def lasting(_: Running, seconds: float) -> None:
    time.sleep(seconds)


def refusing(_: Running, kind: str) -> None:
    if kind == "store":
        raise StoreError("the disk is full", "answers.sqlite")
    raise {"input": InputError, "fault": ZeroDivisionError}[kind]("it is 3; allowed: 4")


@pytest.fixture
def worker(tmp_path: Path) -> Iterator[Worker]:
    folder = small_study(tmp_path / "study")
    prepare(folder)
    with Worker(folder, str(folder)) as made:
        yield made


needs_proc = pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="no /proc here")


def is_there(process: int) -> bool:
    try:
        stat = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    except FileNotFoundError:
        return False
    return stat.rpartition(")")[2].split()[0] != "Z"


def gone(process: int) -> bool:
    for _ in range(100):
        if not is_there(process):
            return True
        time.sleep(0.1)
    return False


def test_problems_come_back_as_what_they_are(worker: Worker) -> None:
    async def ask() -> None:
        assert await worker(results.people_flags) == {}
        with pytest.raises(InputError, match=r"^it is 3; allowed: 4$"):
            await worker(refusing, "input")
        with pytest.raises(StoreError, match="the disk is full"):
            await worker(refusing, "store")
        with pytest.raises(RuntimeError, match="ZeroDivisionError"):
            await worker(refusing, "fault")

    asyncio.run(ask())


@needs_proc
def test_a_process_that_is_killed_is_started_anew(worker: Worker) -> None:
    async def ask() -> tuple[int, int]:
        first = await worker(process_of)
        asyncio.get_running_loop().call_later(0.3, os.kill, first, signal.SIGKILL)
        with pytest.raises(Refusal, match="busy"):
            await worker(lasting, 60)
        return first, await worker(process_of)

    first, second = asyncio.run(ask())
    assert gone(first)
    assert is_there(second)


@needs_proc
@pytest.mark.parametrize("how", ["stop", "kill"])
def test_it_ends_with_the_server(tmp_path: Path, how: str) -> None:
    folder = small_study(tmp_path / "study")
    with served(folder) as server:
        with httpx.Client(base_url=server.url, timeout=60) as client:
            Person.consented(client).answer(0)
            lab = Experimenter.login(client)
            while not lab.get("progress").json()["flags_known"]:
                time.sleep(0.1)
        lists = Path(f"/proc/{server.process.pid}/task").glob("*/children")
        processes = [int(child) for one in lists for child in one.read_text().split()]
        assert processes
        getattr(server, how)()
    assert all(gone(process) for process in processes)

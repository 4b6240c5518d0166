"""A process beside the server that works out what takes seconds, so that answers do not wait.

It opens the study and the store for itself and only reads; it gives way to whatever else wants the
processor, and ends with the server, however that ends.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import traceback
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import Any, Concatenate, ParamSpec, TypeVar

from starlette.concurrency import run_in_threadpool

from nacreous.problem import InputError
from nacreous.server.refusal import Refusal
from nacreous.study.design import open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Store, StoreError

T = TypeVar("T")
P = ParamSpec("P")


class Worker:
    """Starts its process when it is entered, as by `with`, and ends it at the end."""

    def __init__(self, folder: Path, place: str) -> None:
        self._opened = (folder, place)
        self._one = Lock()
        self._process: SpawnProcess | None = None
        self._line: Connection | None = None

    async def __call__(
        self, work: Callable[Concatenate[Running, P], T], *args: P.args, **kwargs: P.kwargs
    ) -> T:
        """What `work(running, ...)` gives there. Refused with 503 where the process is killed."""
        return await run_in_threadpool(self._ask, work, args, kwargs)

    def __enter__(self) -> Worker:
        """Start, without waiting until it is ready."""
        with self._one:
            self._connected()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """End the process, in the middle of its work too."""
        if self._process is not None:
            self._process.kill()
            self._process.join()

    def _ask(self, work: Callable[..., T], args: tuple[Any, ...], kwargs: dict[str, Any]) -> T:
        with self._one:
            line = self._connected()
            try:
                line.send((work, args, kwargs))
                kind, told = line.recv()
            except (EOFError, OSError):
                line.close()
                self._line = None
                wait = {"Retry-After": "2"}
                raise Refusal(503, "busy", "the work was ended from outside", wait) from None
        if kind == "input":
            raise InputError(told)
        if kind == "store":
            raise StoreError(*told)
        if kind == "fault":
            raise RuntimeError(told)
        value: T = told
        return value

    def _connected(self) -> Connection:
        if self._line is None:
            # Not forked, for that would copy locks that threads hold.
            context = multiprocessing.get_context("spawn")
            self._line, theirs = context.Pipe()
            self._process = context.Process(target=_work, args=(theirs, *self._opened), daemon=True)
            self._process.start()
            theirs.close()  # so that its end is the end of the line
        return self._line


def _work(line: Connection, folder: Path, place: str) -> None:
    """The process: one thing after the other, until the server is gone."""
    import scipy.stats  # noqa: F401 (takes a second; now, and not when answers come in)

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C on a terminal is for the server
    if sys.platform != "win32":
        os.nice(10)
    with suppress(EOFError, OSError), Store.open(place, make=False) as store:
        running = Running(store, open_frozen(folder))
        while True:
            line.send(_done(running, *line.recv()))


def _done(
    running: Running, work: Callable[..., object], args: tuple[Any, ...], kwargs: dict[str, Any]
) -> tuple[str, Any]:
    """What came of it, in a form that goes from process to process."""
    try:
        return "value", work(running, *args, **kwargs)
    except InputError as problem:
        return "input", str(problem)
    except StoreError as problem:
        return "store", (problem.strerror, problem.filename)
    except Exception:
        return "fault", traceback.format_exc()

"""A process beside the server that works out what takes seconds, so that answers do not wait.

It gives way to whatever else wants the processor, and ends with the server, however that ends.
"""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import Any, Concatenate, ParamSpec, TypeVar

from starlette.concurrency import run_in_threadpool

from nacreous.problem import InputError
from nacreous.server.refusal import Refusal
from nacreous.server.work import work_for
from nacreous.study.running import Running
from nacreous.study.store import StoreError

T = TypeVar("T")
P = ParamSpec("P")


class Worker:
    """Starts its process when it is first asked, and ends it when it is left, as by `with`.

    A study that no experimenter looks at needs none.
    """

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
        """Nothing is started yet."""
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
            self._process = context.Process(
                target=work_for, args=(theirs, *self._opened), daemon=True
            )
            self._process.start()
            theirs.close()  # so that its end is the end of the line
        return self._line

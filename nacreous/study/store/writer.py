"""One thread that writes, many that wait: group commit.

A job is a function of a connection. Jobs that arrive while a transaction is on its way to the disk
go together into the next one; each caller hears of its own job after that commit and never before.

A job that refuses (`InputError`) keeps what it wrote before it refused, such as a line in the audit
log; so jobs check first and write last. Where the database refuses, the whole transaction is rolled
back and each of its jobs is tried again alone, so that one cannot spoil its neighbours; they must
bear to be run twice. What cannot be begun is not tried again, for each try may wait for seconds;
nor is a failed commit, for it may have succeeded: the callers hear `StoreError` and give the same
again, under the same key.
"""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, TypeVar

import sqlalchemy as sa
from sqlalchemy.exc import SQLAlchemyError

from nacreous.problem import InputError
from nacreous.study.store.engine import writing
from nacreous.study.store.fault import StoreError, place_of, said

T = TypeVar("T")

#: Jobs in one transaction, so that no caller waits for a thousand others.
_MOST = 500


@dataclass(frozen=True)
class _Job:
    work: Callable[[sa.Connection], Any]
    future: Future[Any]


class _AllFailedError(Exception):
    """The transaction could not be begun, or the commit failed: no job is to blame."""


class Writer:
    """The writing thread of a store."""

    def __init__(self, engine: sa.Engine) -> None:
        self._engine = writing(engine)
        self._place = place_of(engine)
        self._waiting: deque[_Job] = deque()
        self._changed = threading.Condition()
        self._closing = False
        self._thread = threading.Thread(target=self._run, name="nacreous-store", daemon=True)
        self._thread.start()

    def submit(self, work: Callable[[sa.Connection], T]) -> Future[T]:
        """Hand in a job; the future is done once it is on the disk, or refused."""
        future: Future[T] = Future()
        with self._changed:
            if self._closing:
                raise StoreError("the store is closed", self._place)
            self._waiting.append(_Job(work, future))
            self._changed.notify()
        return future

    def close(self) -> None:
        """Finish the jobs handed in, and stop."""
        with self._changed:
            self._closing = True
            self._changed.notify()
        self._thread.join()

    def _run(self) -> None:
        while (jobs := self._next()) is not None:
            self._write(jobs)

    def _next(self) -> list[_Job] | None:
        """All that wait, up to a limit; None once closed and nothing waits."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._closing)
            if not self._waiting:
                return None
            count = min(len(self._waiting), _MOST)
            taken = [self._waiting.popleft() for _ in range(count)]
        return [job for job in taken if job.future.set_running_or_notify_cancel()]

    def _write(self, jobs: Sequence[_Job]) -> StoreError | None:
        """Run jobs and tell their callers; return what failed them all, if anything did."""
        try:
            results = self._transaction(jobs)
        except _AllFailedError as failure:
            told = StoreError(str(failure), self._place)
            _fail(jobs, told)
            return told
        except Exception as problem:
            if len(jobs) == 1:
                _fail(jobs, self._told(problem))
            else:
                self._write_singly(jobs)
        else:
            for job, result in zip(jobs, results, strict=True):
                if isinstance(result, InputError):
                    job.future.set_exception(result)
                else:
                    job.future.set_result(result)
        return None

    def _write_singly(self, jobs: Sequence[_Job]) -> None:
        for done, job in enumerate(jobs, 1):
            if failure := self._write([job]):
                _fail(jobs[done:], failure)
                return

    def _transaction(self, jobs: Sequence[_Job]) -> list[Any]:
        with contextlib.ExitStack() as stack:
            with _blaming_none():
                connection = stack.enter_context(self._engine.connect())
                transaction = connection.begin()
            try:
                results = [_result(job, connection) for job in jobs]
                with _blaming_none():
                    transaction.commit()
            except BaseException:
                # SQLite has rolled back by itself when the disk is full.
                with contextlib.suppress(SQLAlchemyError):
                    transaction.rollback()
                raise
        return results

    def _told(self, problem: Exception) -> Exception:
        if isinstance(problem, SQLAlchemyError):
            return StoreError(said(problem), self._place)
        return problem


@contextlib.contextmanager
def _blaming_none() -> Iterator[None]:
    try:
        yield
    except SQLAlchemyError as problem:
        raise _AllFailedError(said(problem)) from problem


def _result(job: _Job, connection: sa.Connection) -> Any:
    try:
        return job.work(connection)
    except InputError as refusal:
        return refusal


def _fail(jobs: Sequence[_Job], problem: Exception) -> None:
    for job in jobs:
        job.future.set_exception(problem)

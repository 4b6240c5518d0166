"""One thread that writes, many that wait: group commit.

A job is a function of a connection. Jobs that arrive while a transaction is on its way to the disk
go together into the next one; each caller hears of its own job after that commit and never before.

A job that refuses (`InputError`) keeps what it wrote before it refused, such as a line in the audit
log; so jobs check first and write last. Where the database refuses, the whole transaction is rolled
back and each of its jobs is tried again alone, so that one cannot spoil its neighbours; they must
bear to be run twice. A failed commit is tried no more, for it may have succeeded: the callers hear
`StoreError` and give the same again, under the same key.
"""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from collections.abc import Callable, Sequence
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


class _CommitFailedError(Exception):
    """The commit itself failed; the jobs may or may not be stored."""


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

    def _write(self, jobs: Sequence[_Job]) -> None:
        try:
            results = self._transaction(jobs)
        except _CommitFailedError as failure:
            _fail(jobs, StoreError(str(failure), self._place))
        except Exception as problem:
            if len(jobs) > 1:
                for job in jobs:
                    self._write([job])
            else:
                _fail(jobs, self._told(problem))
        else:
            for job, result in zip(jobs, results, strict=True):
                if isinstance(result, InputError):
                    job.future.set_exception(result)
                else:
                    job.future.set_result(result)

    def _transaction(self, jobs: Sequence[_Job]) -> list[Any]:
        with self._engine.connect() as connection:
            transaction = connection.begin()
            try:
                results = [_result(job, connection) for job in jobs]
            except BaseException:
                # SQLite has rolled back by itself when the disk is full.
                with contextlib.suppress(SQLAlchemyError):
                    transaction.rollback()
                raise
            try:
                transaction.commit()
            except Exception as problem:
                with contextlib.suppress(SQLAlchemyError):
                    transaction.rollback()
                told = said(problem) if isinstance(problem, SQLAlchemyError) else str(problem)
                raise _CommitFailedError(told) from problem
        return results

    def _told(self, problem: Exception) -> Exception:
        if isinstance(problem, SQLAlchemyError):
            return StoreError(said(problem), self._place)
        return problem


def _result(job: _Job, connection: sa.Connection) -> Any:
    try:
        return job.work(connection)
    except InputError as refusal:
        return refusal


def _fail(jobs: Sequence[_Job], problem: Exception) -> None:
    for job in jobs:
        job.future.set_exception(problem)

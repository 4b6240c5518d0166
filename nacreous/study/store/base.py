"""What every part of a store rests on: the database, the writing thread, the clock."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from datetime import UTC, datetime
from os import PathLike
from types import TracebackType
from typing import Self, TypeVar

import sqlalchemy as sa

from nacreous.study.store import check
from nacreous.study.store.engine import engine_of
from nacreous.study.store.fault import place_of, translated
from nacreous.study.store.migrate import upgrade
from nacreous.study.store.writer import Writer

T = TypeVar("T")


def _now() -> datetime:
    return datetime.now(UTC)


class Base:
    """An open database with one thread that writes."""

    def __init__(self, engine: sa.Engine, clock: Callable[[], datetime]) -> None:
        self.engine = engine
        self.place = place_of(engine)
        self._clock = clock
        self._writer = Writer(engine)

    def __repr__(self) -> str:
        """Where it is."""
        return f"{type(self).__name__}({self.place!r})"

    @classmethod
    def open(
        cls,
        place: str | PathLike[str] | None = None,
        *,
        make: bool = True,
        clock: Callable[[], datetime] = _now,
    ) -> Self:
        """Open or make a store: a file, a folder (answers.sqlite in it), or postgresql://....

        None: what NACREOUS_STORE says. Unless it may `make` one, an empty place is refused. `clock`
        tells the server's time; it may jump, for the order of answers hangs on their sequence
        alone.
        """
        engine = engine_of(place)
        try:
            upgrade(engine, make=make)
        except BaseException:
            engine.dispose()
            raise
        return cls(engine, clock)

    def close(self) -> None:
        """Finish what was handed in, and let go of the database."""
        self._writer.close()
        self.engine.dispose()

    def __enter__(self) -> Self:
        """Close at the end of the block."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Close."""
        self.close()

    @contextlib.contextmanager
    def reading(self) -> Iterator[sa.Connection]:
        """A connection that sees one state of the store throughout."""
        with translated(self.place), self.engine.connect() as connection:
            yield connection

    def _at(self) -> str:
        return check.written("clock", self._clock())

    def _do(self, work: Callable[[sa.Connection], T]) -> T:
        return self._writer.submit(work).result()

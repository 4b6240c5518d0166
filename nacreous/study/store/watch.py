"""What shows of each person while answers are read once, in the order in which they came."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, cast

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.check.response import MOST_FAST
from nacreous.study.task.flag import LONGEST_PAUSE_S, Flag
from nacreous.study.task.row import Row

if TYPE_CHECKING:
    import pyarrow as pa

__all__ = ["NOTICED", "Watch"]

#: What our page notices with an answer. Another client may write what it likes.
NOTICED = ("away", "early", "not_kept", "resized", "shrunk")
#: What everyone does now and then is a flag from more than this share of answers on: pressing
#: before a pair may be answered, as with answers that are too fast.
_OFTEN = {"early": MOST_FAST}


class Watch:
    """Sums by person, and the time of each person's last answer; no answer is kept.

    minimum_ms: for how long our page lets nobody answer. missed: whether a catch was answered
    otherwise than by what is known.
    """

    def __init__(self, minimum_ms: float, missed: Callable[[Row], bool]) -> None:
        self._minimum_ms, self._missed = minimum_ms, missed
        self._answers = self._sooner = np.zeros(0, np.int64)
        self._last_us = self._longest_us = np.zeros(0, np.int64)
        self._catches: Counter[int] = Counter()
        self._catches_missed: Counter[int] = Counter()
        self._noticed: Counter[tuple[int, str]] = Counter()

    def add(self, part: pa.Table) -> None:
        """Answers of people who have a `number`, as the store's columns, later than all before."""
        import pyarrow as pa
        import pyarrow.compute as pc

        person = np.asarray(part["number"])
        if not len(person):
            return
        self._grow(int(person.max()) + 1)
        self._count(person, np.asarray(pc.fill_null(part["response_ms"], np.inf)))
        self._pause(person, _microseconds(part["received_at"]))
        for row in part.filter(pc.equal(part["kind"].cast(pa.string()), "catch")).to_pylist():
            self._catches[row["number"]] += 1
            self._catches_missed[row["number"]] += self._missed(cast("Row", row))
        self._notice(person, part["flags"].combine_chunks())

    def _notice(self, person: NDArray[np.int32], flags: pa.DictionaryArray) -> None:
        code = np.asarray(flags.indices)
        for at, text in enumerate(flags.dictionary.to_pylist()):
            names = [name for name, value in json.loads(text).items() if value and name in NOTICED]
            if names:  # of nearly no answers
                numbers = person[code == at].tolist()
                self._noticed.update((number, name) for number in numbers for name in names)

    def flags(self) -> Iterator[tuple[int, list[Flag]]]:
        """By the number of each person who has answered."""
        for number in np.flatnonzero(self._answers).tolist():
            yield number, [*self._of(number)]

    def _grow(self, people: int) -> None:
        more = max(0, people - len(self._answers))
        for name, value in (("_answers", 0), ("_sooner", 0), ("_last_us", _NEVER)):
            grown = np.pad(getattr(self, name), (0, more), constant_values=value)
            setattr(self, name, grown)
        self._longest_us = np.pad(self._longest_us, (0, more))

    def _count(self, person: NDArray[np.int32], times_ms: NDArray[np.float64]) -> None:
        waited_ms = np.where(
            times_ms == 0, np.inf, times_ms
        )  # a time of 0 is none: no page says it
        self._answers += np.bincount(person, minlength=len(self._answers))
        early = person[waited_ms < self._minimum_ms]
        self._sooner += np.bincount(early, minlength=len(self._answers))

    def _pause(self, person: NDArray[np.int32], received_us: NDArray[np.int64]) -> None:
        """The longest time between two answers, by the server's clock."""
        order = np.argsort(person, kind="stable")
        who, at_us = person[order], received_us[order]
        before_us = np.roll(at_us, 1)
        first = np.append(True, who[1:] != who[:-1])
        before_us[first] = self._last_us[who[first]]
        known = before_us != _NEVER
        np.maximum.at(self._longest_us, who[known], (at_us - before_us)[known])
        last = np.append(first[1:], True)
        self._last_us[who[last]] = at_us[last]

    def _of(self, number: int) -> Iterator[Flag]:
        answers, missed = int(self._answers[number]), self._catches_missed[number]
        if missed:
            yield Flag("catches", f"{missed}/{self._catches[number]}")
        longest_s = int(self._longest_us[number]) / 1e6
        if longest_s >= LONGEST_PAUSE_S:
            yield Flag("pause", f"{longest_s:.0f} s")
        for name in sorted(NOTICED):
            count = self._noticed[number, name]
            if count > _OFTEN.get(name, 0.0) * answers:
                yield Flag(f"answer-{name}", f"{count}/{answers}")
        sooner = int(self._sooner[number])
        if sooner > MOST_FAST * answers:
            yield Flag("unwaited", f"{sooner}/{answers}")


_NEVER = np.iinfo(np.int64).min


def _microseconds(texts: pa.ChunkedArray) -> NDArray[np.int64]:
    """Times as the store writes them, since 1970."""
    import pyarrow as pa

    return np.asarray(texts.cast(pa.timestamp("us", "UTC")).cast(pa.int64()))

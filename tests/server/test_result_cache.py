"""What takes seconds is worked out once for many who ask, and not again and again."""

import asyncio
import threading
import time

import pytest

from nacreous.server.result_cache import ResultCache


class Work:
    """Something slow that counts how often it is done, and whether twice at once."""

    def __init__(self, lasting_s: float = 0.05) -> None:
        self.lasting_s = lasting_s
        self.times = 0
        self.one = threading.Lock()

    async def __call__(self) -> int:
        assert self.one.acquire(blocking=False)
        await asyncio.sleep(self.lasting_s)
        self.times += 1
        self.one.release()
        return self.times


def test_many_who_ask_at_once_wait_for_one_piece_of_work() -> None:
    async def many() -> list[int]:
        cache, work = ResultCache(), Work()
        return await asyncio.gather(*(cache.get("scale", 1, work) for _ in range(20)))

    assert asyncio.run(many()) == [1] * 20


def test_two_kinds_of_work_are_not_done_at_once() -> None:
    async def both() -> None:
        cache, work = ResultCache(), Work()
        await asyncio.gather(*(cache.get(key, 1, work) for key in ("scale", "flags", "report")))
        assert work.times == 3

    asyncio.run(both())


def test_while_answers_come_in_it_takes_a_small_part_of_the_time() -> None:
    async def watch() -> int:
        cache, work = ResultCache(), Work()
        begin = time.monotonic()
        answers = 0
        while time.monotonic() - begin < 1:
            answers += 1
            await cache.get("scale", answers, work)
            await asyncio.sleep(0.01)
        return work.times

    assert 2 <= asyncio.run(watch()) <= 4


def test_a_report_is_of_the_answers_that_are_there() -> None:
    async def twice() -> list[int]:
        cache, work = ResultCache(), Work()
        return [await cache.get("report", answers, work, good_for=0) for answers in (1, 1, 2)]

    assert asyncio.run(twice()) == [1, 1, 2]


def test_what_fails_is_tried_again() -> None:
    async def fail() -> int:
        return 1 // 0

    async def twice() -> int:
        cache, work = ResultCache(), Work()
        try:
            await cache.get("scale", 1, fail)
        except ZeroDivisionError:
            return await cache.get("scale", 1, work)
        raise AssertionError("it must be told")

    assert asyncio.run(twice()) == 1


def test_what_was_known_a_moment_ago_does_not_wait_for_a_report() -> None:
    async def look() -> list[str]:
        cache, written = ResultCache(), asyncio.Event()

        async def flags(answers: int) -> str:
            return f"of {answers} answers"

        first = await cache.get("flags", 1, lambda: flags(1))
        report = asyncio.create_task(cache.get("report", 1, written.wait, good_for=0))
        await asyncio.sleep(0.05)
        during = await asyncio.wait_for(cache.get("flags", 2, lambda: flags(2)), 5)
        written.set()
        await report
        return [first, during, await cache.get("flags", 2, lambda: flags(2))]

    assert asyncio.run(look()) == ["of 1 answers", "of 1 answers", "of 2 answers"]


def test_what_is_asked_for_so_far_never_waits_and_tells_of_a_failure_once() -> None:
    async def look() -> list[int | None]:
        cache, work = ResultCache(), Work()

        async def fail() -> int:
            return 1 // 0

        found = [cache.so_far("flags", 1, work)]
        await asyncio.sleep(0.2)
        found.append(cache.so_far("flags", 1, work))
        cache.so_far("others", 1, fail)
        await asyncio.sleep(0.05)
        with pytest.raises(ZeroDivisionError):
            cache.so_far("others", 1, work)
        return [*found, cache.so_far("others", 1, work)]

    assert asyncio.run(look()) == [None, 1, None]

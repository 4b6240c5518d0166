"""What takes seconds is worked out once for many who ask, and not again and again."""

import asyncio
import threading
import time

from nacreous.server.outcomes import Outcomes


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
        outcomes, work = Outcomes(), Work()
        return await asyncio.gather(*(outcomes.get("scale", 1, work) for _ in range(20)))

    assert asyncio.run(many()) == [1] * 20


def test_two_kinds_of_work_are_not_done_at_once() -> None:
    async def both() -> None:
        outcomes, work = Outcomes(), Work()
        await asyncio.gather(*(outcomes.get(key, 1, work) for key in ("scale", "flags", "report")))
        assert work.times == 3

    asyncio.run(both())


def test_while_answers_come_in_it_takes_a_small_part_of_the_time() -> None:
    async def watch() -> int:
        outcomes, work = Outcomes(), Work()
        begin = time.monotonic()
        answers = 0
        while time.monotonic() - begin < 1:
            answers += 1
            await outcomes.get("scale", answers, work)
            await asyncio.sleep(0.01)
        return work.times

    assert 2 <= asyncio.run(watch()) <= 4


def test_a_report_is_of_the_answers_that_are_there() -> None:
    async def twice() -> list[int]:
        outcomes, work = Outcomes(), Work()
        return [await outcomes.get("report", answers, work, good_for=0) for answers in (1, 1, 2)]

    assert asyncio.run(twice()) == [1, 1, 2]


def test_what_fails_is_tried_again() -> None:
    async def fail() -> int:
        return 1 // 0

    async def twice() -> int:
        outcomes, work = Outcomes(), Work()
        try:
            await outcomes.get("scale", 1, fail)
        except ZeroDivisionError:
            return await outcomes.get("scale", 1, work)
        raise AssertionError("it must be told")

    assert asyncio.run(twice()) == 1


def test_what_was_known_a_moment_ago_does_not_wait_for_a_report() -> None:
    async def look() -> list[str]:
        outcomes, written = Outcomes(), asyncio.Event()

        async def flags(answers: int) -> str:
            return f"of {answers} answers"

        first = await outcomes.get("flags", 1, lambda: flags(1))
        report = asyncio.create_task(outcomes.get("report", 1, written.wait, good_for=0))
        await asyncio.sleep(0.05)
        during = await asyncio.wait_for(outcomes.get("flags", 2, lambda: flags(2)), 5)
        written.set()
        await report
        return [first, during, await outcomes.get("flags", 2, lambda: flags(2))]

    assert asyncio.run(look()) == ["of 1 answers", "of 1 answers", "of 2 answers"]

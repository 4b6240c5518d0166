"""What takes long to work out keeps nobody from seeing how far a study is."""

import asyncio
import threading

from nacreous.server.outcomes import Outcomes


def test_what_may_be_stale_does_not_wait_for_a_report() -> None:
    written = threading.Event()

    async def look() -> list[str]:
        outcomes = Outcomes()
        first = await outcomes.get("flags", 1, lambda: "flags of 1 answer", 0.001)
        report = asyncio.create_task(outcomes.get("report", 1, written.wait))
        await asyncio.sleep(0.05)
        during = await asyncio.wait_for(outcomes.get("flags", 2, lambda: "of 2", 0.001), 5)
        written.set()
        await report
        return [first, during, await outcomes.get("flags", 2, lambda: "of 2", 0.001)]

    assert asyncio.run(look()) == ["flags of 1 answer", "flags of 1 answer", "of 2"]

"""Many participants at once who never give up, each over a connection of their own.

Who hears nothing, or that the server cannot store just now, asks the same again: that is all a
browser can do, and all that is needed.
"""

import asyncio
import json
from collections.abc import Callable, Coroutine
from dataclasses import dataclass, field
from typing import Any

from nacreous.study.store.tokens import draw

#: Seconds between two tries, and for all tries of one request.
AGAIN_S = 0.05
PATIENCE_S = 60


@dataclass
class Participant:
    """Somebody with a token and a connection; `again`: answers that had been stored unheard."""

    port: int
    token: str = field(default_factory=draw)
    again: int = 0
    refused: int = 0
    _reader: asyncio.StreamReader | None = None
    _writer: asyncio.StreamWriter | None = None

    async def ask(self, method: str, path: str, body: Any = None) -> Any:
        """The answer to a request that is asked until there is one."""
        content = b"" if body is None else json.dumps(body).encode()
        head = f"{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n"
        head += f"Authorization: Bearer {self.token}\r\nContent-Length: {len(content)}\r\n"
        head += "Content-Type: application/json\r\n\r\n"
        async with asyncio.timeout(PATIENCE_S):
            while True:
                try:
                    status, told = await self._once(head.encode() + content)
                except (OSError, asyncio.IncompleteReadError, EOFError):
                    self.hang_up()
                    status, told = 0, b""
                if status in (0, 503):
                    self.refused += status == 503
                    await asyncio.sleep(AGAIN_S)
                    continue
                assert status in (200, 201, 204), (method, path, status, told)
                return json.loads(told) if told else None

    async def enter(self) -> None:
        """Enter, and consent."""
        await self.ask("POST", "/api/enter", {"language": "en", "groups": {}})
        await self.ask("POST", "/api/consent")

    async def answer(self, trial: int, body: dict[str, Any]) -> None:
        """Answer a trial, and hold the receipt to it."""
        told = await self.ask("PUT", f"/api/answers/{trial}", body)
        assert told["trial"] == trial
        self.again += told["again"]

    def hang_up(self) -> None:
        """Close the connection; the next request opens another."""
        if self._writer is not None:
            self._writer.close()
        self._reader = self._writer = None

    async def _once(self, request: bytes) -> tuple[int, bytes]:
        if self._reader is None or self._writer is None:
            self._reader, self._writer = await asyncio.open_connection("127.0.0.1", self.port)
        self._writer.write(request)
        head = await self._reader.readuntil(b"\r\n\r\n")
        length = 0
        for line in head.split(b"\r\n"):
            name, _, value = line.partition(b":")
            if name.lower() == b"content-length":
                length = int(value)
        return int(head.split(b" ", 2)[1]), await self._reader.readexactly(length)


@dataclass
class Crowd:
    """Participants who go through their trials; `acknowledged`: the receipts so far."""

    port: int
    people: int
    trials: int
    body: Callable[[int, int], dict[str, Any]]
    acknowledged: int = 0
    everyone: list[Participant] = field(default_factory=list)

    async def go_through(self) -> None:
        """All of them at once, to the end."""
        self.everyone = [Participant(self.port) for _ in range(self.people)]
        await asyncio.gather(*(self._one(*one) for one in enumerate(self.everyone)))

    async def _one(self, place: int, person: Participant) -> None:
        await person.enter()
        for trial in range(self.trials):
            await person.answer(trial, self.body(place, trial))
            self.acknowledged += 1
        await person.ask("POST", "/api/finish")
        person.hang_up()

    async def reach(self, count: int) -> None:
        """Wait until there are so many receipts."""
        while self.acknowledged < count:
            await asyncio.sleep(0.002)

    def run(self, meanwhile: Callable[["Crowd"], Coroutine[Any, Any, None]]) -> None:
        """Let them go through while something else happens."""

        async def both() -> None:
            async with asyncio.TaskGroup() as group:
                group.create_task(self.go_through())
                group.create_task(meanwhile(self))

        asyncio.run(both())

"""How a server listens, and how it ends."""

import os
import signal
import threading
from contextlib import suppress
from typing import Any

from fastapi import FastAPI

from nacreous.server.listening import listen, serve, until_stopped


def test_a_signal_that_comes_while_the_server_is_set_up_ends_it() -> None:
    class Slow(FastAPI):
        def openapi(self) -> dict[str, Any]:
            with suppress(BaseException):  # as some compiled code does
                signal.raise_signal(signal.SIGTERM)
            return {}

    again = threading.Timer(20, os.kill, (os.getpid(), signal.SIGTERM))
    again.start()
    before = signal.getsignal(signal.SIGTERM)
    with listen("127.0.0.1", 0) as listening, until_stopped():
        serve(Slow(), listening)
    assert again.is_alive(), "it took a second signal"
    again.cancel()
    assert signal.getsignal(signal.SIGTERM) is before

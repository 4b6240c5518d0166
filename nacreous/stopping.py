"""How a program is stopped from outside: Ctrl-C, or SIGTERM as `kill` and systems send it."""

from __future__ import annotations

import signal
from types import FrameType

__all__ = ["Terminated", "code_of", "how_stopped", "stop_cleanly"]


class Terminated(KeyboardInterrupt):
    """SIGTERM came; whatever cleans up after Ctrl-C cleans up after it too."""


def stop_cleanly() -> None:
    """Raise `Terminated` on SIGTERM, unless whoever started the program wants it ignored."""
    if signal.getsignal(signal.SIGTERM) is signal.SIG_DFL:
        signal.signal(signal.SIGTERM, _terminate)


def _terminate(number: int, frame: FrameType | None) -> None:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)  # a second one would cut the cleaning up short
    raise Terminated


def code_of(stop: BaseException) -> int:
    """The exit code: 128 and the signal's number.

    >>> code_of(KeyboardInterrupt()), code_of(Terminated())
    (130, 143)
    """
    return 143 if _is_terminated(stop) else 130


def how_stopped(stop: BaseException) -> str:
    """In a word."""
    return "terminated" if _is_terminated(stop) else "interrupted"


def _is_terminated(stop: BaseException) -> bool:
    """Pydantic, met by a signal at work in its compiled part, raises an error that quotes it."""
    return isinstance(stop, Terminated) or "Terminated" in str(stop)

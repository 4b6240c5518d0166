"""A program at a terminal of its own, as somebody watches and interrupts it."""

from __future__ import annotations

import os
import pty
import select
import signal
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

#: A machine that others keep busy may take so long over a second's work.
PATIENCE_S = 120.0


@dataclass
class Watched:
    """The program, and what it shows on its terminal."""

    program: subprocess.Popen[bytes]
    reader: int

    def shows(self, words: bytes) -> bytes:
        """What it writes until the words appear."""
        shown = b""
        end = time.monotonic() + PATIENCE_S
        while words not in shown and time.monotonic() < end:
            if select.select([self.reader], [], [], 0.1)[0]:
                shown += os.read(self.reader, 4096)
        assert words in shown, f"{words!r} does not appear: {shown[-200:]!r}"
        return shown

    def interrupted(self) -> tuple[int, float]:
        """Its exit code after Ctrl-C, and how many seconds it took to end."""
        begin = time.monotonic()
        self.program.send_signal(signal.SIGINT)
        return self.program.wait(PATIENCE_S), time.monotonic() - begin


def _heeding() -> None:
    """Heed Ctrl-C, though whoever started the tests may not, as a shell's jobs behind do not."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@contextmanager
def at_terminal(command: Sequence[str], folder: Path) -> Iterator[Watched]:
    """Start a program, and end it whatever happens: one that nobody reads would wait for ever."""
    reader, writer = pty.openpty()
    program = subprocess.Popen(command, cwd=folder, stderr=writer, preexec_fn=_heeding)
    try:
        yield Watched(program, reader)
    finally:
        program.kill()
        program.wait()
        os.close(writer)
        os.close(reader)

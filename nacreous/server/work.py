"""What the worker's process does. It loads nothing of HTTP, for its memory is the machine's too."""

from __future__ import annotations

import os
import signal
import sys
import traceback
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from nacreous.frames import without_pandas
from nacreous.problem import InputError
from nacreous.study.design import open_frozen
from nacreous.study.memory import hold_little
from nacreous.study.running import Running
from nacreous.study.store import Store, StoreError


def work_for(line: Connection, folder: Path, place: str) -> None:
    """One thing after the other, until the server is gone.

    The study and the store are opened anew and only read.
    """
    hold_little()
    without_pandas()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C on a terminal is for the server
    if sys.platform != "win32":
        os.nice(10)
    with suppress(EOFError, OSError), Store.open(place, make=False) as store:
        running = Running(store, open_frozen(folder))
        while True:
            line.send(_done(running, *line.recv()))


def _done(
    running: Running, work: Callable[..., object], args: tuple[Any, ...], kwargs: dict[str, Any]
) -> tuple[str, Any]:
    """What came of it, in a form that goes from process to process."""
    try:
        return "value", work(running, *args, **kwargs)
    except InputError as problem:
        return "input", str(problem)
    except StoreError as problem:
        return "store", (problem.strerror, problem.filename)
    except Exception:
        return "fault", traceback.format_exc()

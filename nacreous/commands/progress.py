"""A bar on the terminal while something long runs."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

_WIDTH = 32
#: Work shorter than this shows no bar.
_PATIENCE_S = 0.5


@contextmanager
def bar(what: str) -> Iterator[Callable[[float], None] | None]:
    """Yield a function to call with the finished share, 0 to 1; None where no person watches.

    >>> with bar("rendering") as show:
    ...     show is None
    True
    """
    if sys.stderr is None or not sys.stderr.isatty():
        yield None
        return
    begin = time.monotonic()

    def show(share: float) -> None:
        elapsed_s = time.monotonic() - begin
        if elapsed_s >= _PATIENCE_S:
            done = round(_WIDTH * share)
            left_s = elapsed_s * (1 - share) / share if share > 0 else 0.0
            cells = "#" * done + "." * (_WIDTH - done)
            print(f"\r{what} [{cells}] {share:4.0%}  {left_s:4.0f} s left", end="", file=sys.stderr)

    try:
        yield show
    finally:
        print("\r\033[K", end="", file=sys.stderr, flush=True)

"""What commands say."""

from __future__ import annotations

import sys
from collections.abc import Collection

from nacreous.printable import printable_lines

__all__ = ["counted", "say"]


def counted(count: int, what: str) -> str:
    """A number of things.

    >>> counted(1, "strand"), counted(2, "strand")
    ('1 strand', '2 strands')
    """
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def say(text: str, outputs: Collection[str] = ()) -> None:
    """Print lines at once, names of files and studies in them without control characters.

    They go beside standard output where that is one of the outputs.
    """
    stream = sys.stderr if "-" in outputs else sys.stdout
    print(printable_lines(text), flush=True, file=stream)

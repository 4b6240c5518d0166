"""What commands say."""

from __future__ import annotations

import sys
from collections.abc import Collection

from nacreous.printable import printable_lines

__all__ = ["say"]


def say(text: str, outputs: Collection[str] = ()) -> None:
    """Print lines at once, names of files and studies in them without control characters.

    They go beside standard output where that is one of the outputs.
    """
    stream = sys.stderr if "-" in outputs else sys.stdout
    print(printable_lines(text), flush=True, file=stream)

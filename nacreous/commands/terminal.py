"""What commands say."""

from __future__ import annotations

from nacreous.printable import printable_lines

__all__ = ["say"]


def say(text: str) -> None:
    """Print lines at once, names of files and studies in them without control characters."""
    print(printable_lines(text), flush=True)

"""Memory that libraries keep for later, though nothing is in it any more."""

from __future__ import annotations

import ctypes
import sys
from contextlib import suppress

__all__ = ["give_back", "hold_little"]


def give_back() -> None:
    """Let Arrow and glibc give back what was freed: of two million answers that is 130 MB."""
    import pyarrow as pa

    pa.default_memory_pool().release_unused()
    if sys.platform == "linux":
        with suppress(OSError, AttributeError):  # another C library
            ctypes.CDLL(None).malloc_trim(0)


def hold_little() -> None:
    """From now on let glibc give back each array of 8 MB that is freed, and not keep up to 32 MB.

    M_MMAP_THRESHOLD at a fixed value, mallopt(3); a lower one takes longer.
    """
    if sys.platform == "linux":
        with suppress(OSError, AttributeError):  # another C library
            ctypes.CDLL(None).mallopt(-3, 1 << 23)

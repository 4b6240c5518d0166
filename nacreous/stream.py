"""Standard input, by the name that stands for it."""

from __future__ import annotations

import sys
from typing import BinaryIO

from nacreous.problem import InputError

#: The path that stands for standard input and output.
STREAM = "-"


def standard_input() -> BinaryIO:
    """What a program before this one writes. Raises `InputError` where it was closed (`<&-`)."""
    if sys.stdin is None:
        raise InputError("standard input is closed; allowed: < file or program | before, or a file")
    return sys.stdin.buffer

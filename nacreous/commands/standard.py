"""`-` in place of a file: standard input to read from, standard output to write to."""

from __future__ import annotations

import re
import shutil
import sys
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from nacreous import file
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.stream import STREAM, standard_input


def check_output(output: str, endings: Collection[str]) -> None:
    """Refuse what cannot be written, before any long work; standard output always can."""
    if output != STREAM:
        file.check_output(output, endings)
    elif sys.stdout is None or sys.stdout.isatty():
        raise InputError("- is given as the output; allowed: with > file or | program behind")


def require_apart(outputs: Sequence[str], inputs: Iterable[str]) -> None:
    """Refuse to write over what is read, `-` included, and to write two outputs to one place."""
    if list(outputs).count(STREAM) > 1:
        raise InputError(f"{STREAM} is given twice as an output; allowed: once")
    read = [0 if path == STREAM else path for path in inputs]
    file.require_apart([output for output in outputs if output != STREAM], read)


@contextmanager
def writing(output: str, ending: str) -> Iterator[Path]:
    """The path to write to; of `-` a file whose bytes go to standard output once it is whole."""
    if output != STREAM:
        yield Path(output)
        return
    with TemporaryDirectory(prefix="nacreous-") as folder:
        path = Path(folder, f"output{ending}")
        yield path
        with path.open("rb") as whole:
            shutil.copyfileobj(whole, sys.stdout.buffer)


@contextmanager
def reading(given: str, ending: str) -> Iterator[str]:
    """The path to read; of `-` a file with all that standard input holds.

    Raises `InputError` for an empty name and for an address of the web.
    """
    if not given.strip():
        raise InputError("the file's name is empty; allowed: a file, or - for standard input")
    if re.match(r"[a-z]{2,}://", given, re.IGNORECASE):
        raise InputError(
            f"{printable(given)}: is an address; allowed: a file on this computer (download it "
            "first)"
        )
    if given != STREAM:
        yield given
        return
    with TemporaryDirectory(prefix="nacreous-") as folder:
        path = Path(folder, f"input{ending}")
        with path.open("wb") as whole:
            shutil.copyfileobj(standard_input(), whole)
        try:
            yield str(path)
        except InputError as problem:
            raise InputError(str(problem).replace(str(path), "standard input")) from None

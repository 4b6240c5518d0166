"""A TOML file, read with care: what cannot be used is refused in one plain line."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from nacreous import toml_text
from nacreous.missing import missing
from nacreous.problem import InputError
from nacreous.spec.complaint import shown
from nacreous.stream import STREAM, standard_input

#: Far above any pearl or scene: 5000 listed layers take 40 kB.
MOST_BYTES = 1_000_000


def label(path: Path) -> str:
    """The file's name as it stands in messages: as given, on one line."""
    if str(path) == STREAM:
        return "standard input"
    return str(path) if str(path).isprintable() else shown(str(path), 200)


def read(path: Path) -> dict[str, Any]:
    """The keys of a TOML file; an InputError with the place of what is wrong."""
    where = label(path)
    values = parse(_text(path, where), where)
    if not values:
        raise InputError(f"{where}: the file is empty; wanted: at least one key, such as name")
    return values


def _text(path: Path, where: str) -> str:
    if str(path) == STREAM:
        return _decoded(standard_input().read(MOST_BYTES + 1), where)
    if path.is_dir():
        raise InputError(f"{where}: is a folder; wanted: a TOML file")
    if path.exists() and not path.is_file():
        raise InputError(f"{where}: is not a regular file; wanted: a TOML file")
    if "\0" in str(path):
        raise InputError(f"{where}: is not the name of a file")
    try:
        with path.open("rb") as file:
            content = file.read(MOST_BYTES + 1)
    except FileNotFoundError:
        raise missing(path, "a TOML file") from None
    except OSError as error:
        raise InputError(f"{where}: cannot be read: {error.strerror}") from None
    return _decoded(content, where)


def _decoded(content: bytes, where: str) -> str:
    if len(content) > MOST_BYTES:
        raise InputError(f"{where}: is longer than {MOST_BYTES} bytes, the most that is read")
    if b"\0" in content:
        raise InputError(f"{where}: is a binary file; wanted: a TOML file")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise InputError(f"{where}: line {line}: is not UTF-8; wanted: a TOML file") from None


def parse(text: str, where: str) -> dict[str, Any]:
    """The keys of a TOML text; `where` names it in messages.

    >>> parse("name = ", "pearl.toml")
    Traceback (most recent call last):
    nacreous.problem.InputError: pearl.toml: line 1, column 8: not TOML: Invalid value
    """
    try:
        return toml_text.loads(text)
    except tomllib.TOMLDecodeError as error:
        reason, line, column = _placed(str(error), text)
        message = f"{where}: line {line}, column {column}: not TOML: {reason}"
    except toml_text.TooDeepError as error:
        before = text[: error.position]
        line, column = before.count("\n") + 1, error.position - before.rfind("\n")
        message = f"{where}: line {line}, column {column}: {error}"
    except ValueError:  # a whole number of thousands of digits
        message = f"{where}: holds a number too long to be read"
    raise InputError(message)


def _placed(message: str, text: str) -> tuple[str, int, int]:
    """The parser's reason with its line and column; the text's end has them too."""
    reason, _, place = message.rpartition(" (at ")
    found = re.fullmatch(r"line (\d+), column (\d+)\)", place)
    if found:
        return reason, int(found[1]), int(found[2])
    lines = text.split("\n")
    return reason or message, len(lines), len(lines[-1]) + 1

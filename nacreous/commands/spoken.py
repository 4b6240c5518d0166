"""Messages of `nacreous.scaling` in the words of the command: its options, not Python's arguments.

The library names its arguments as Python writes them: `prior=1.0`, `left='stimL'`. Here, and only
here, these become what can be pasted behind a command.
"""

from __future__ import annotations

import re
import shlex
from ast import literal_eval
from collections.abc import Iterator
from contextlib import contextmanager

from nacreous.printable import printable
from nacreous.problem import InputError

_COLUMNS = ("left", "right", "chosen", "winner", "loser", "person", "time", "trial", "count")
_TIMES = ("response_s", "response_ms")
#: Arguments whose option has the same name, but for dashes.
_SAME = (
    *("model", "method", "ties", "order", "prior", "unit", "level", "bootstrap", "seed", "group"),
    *("tie", "repeats", "skip_rows", "skip_unanswered", "encoding", "language", "question"),
)
_OPTIONS = {name: f"--{name.replace('_', '-')}" for name in _SAME}
_OPTIONS |= {"left_word": "--left", "right_word": "--right"}
_OPTIONS |= {name: f"--column {name}=" for name in (*_COLUMNS, *_TIMES)}
#: What has another way of being said than an option and its value.
_PHRASES = {
    "order=False": "no --order",
    "sided=False": "--no-sides",
    "read this by Answers.read": "leave out --counts",
    "read this by Comparisons.read_counts": "give --counts",
    "with Comparisons.read_counts": "with --counts",
    "in Python Comparisons.of_proportions": "Python's nc.scaling.Comparisons.of_proportions",
    'kind="expected" or counts, which take answers as independent': "--column person= to take "
    "answers as independent",
    'by="answers", which takes the answers as independent': "--column person= to take answers as "
    "independent",
    "with method 'bias-reduced': False": "with --method bias-reduced: --no-ties",
}

_VALUE = (
    r"'(?:[^'\\]|\\.)*'|\"(?:[^\"\\]|\\.)*\"|[+-]?[0-9.]+(?:e[+-]?[0-9]+)?|True|False|None|[A-Z]+\b"
)
_ARGUMENT = re.compile(rf"(?<![\w.\-])({'|'.join(_OPTIONS)})=({_VALUE})")
_SUBJECT = re.compile(rf"({'|'.join((*_SAME, 'left_word', 'right_word'))})(?= is .*; )")
#: A message is read once from left to right. What stands in quotes is what somebody wrote, and
#: stays as it is, unless it is the value of an argument or part of a phrase. Python parts arguments
#: by commas, and a command by spaces. `is True` is said of a switch that was given.
_PIECE = re.compile(
    rf"(?P<phrase>{'|'.join(map(re.escape, _PHRASES))})"
    rf"|(?P<arguments>{_ARGUMENT.pattern}(?:, {_ARGUMENT.pattern})*)"
    r"""|(?P<own>"[^"]*"|(?<!\w)'(?:[^'\\]|\\.)*'(?!\w))"""
    r"|(?P<given>\bis True(?=;))|(?P<none>\bNone\b)"
)


@contextmanager
def spoken(place: str) -> Iterator[None]:
    """Raise each `InputError` from within in the words of options. place: the file, as it is said.

    >>> with spoken("a.csv"):
    ...     raise InputError("prior is 0; allowed: a spread, or prior='hierarchical'")
    Traceback (most recent call last):
    nacreous.problem.InputError: --prior is 0; allowed: a spread, or --prior hierarchical
    """
    try:
        yield
    except InputError as problem:
        lines = [_line(line, f"{printable(place)}: ") for line in str(problem).split("\n")]
        raise InputError("\n".join(lines)) from problem


def _line(line: str, place: str) -> str:
    """One message; the file's name and what stands in quotes is what somebody else wrote."""
    above, said = (place, line[len(place) :]) if line.startswith(place) else ("", line)
    subject = _SUBJECT.match(said)
    if subject:
        above, said = f"{above}{_OPTIONS[subject[1]]}", said[subject.end() :]
    return above + _PIECE.sub(lambda found: _piece(found, subject is not None), said)


def _piece(found: re.Match[str], of_option: bool) -> str:
    """A part of a message in the command's words. of_option: the message is about an option."""
    if found["phrase"]:
        return _PHRASES[found["phrase"]]
    if found["arguments"]:
        return " ".join(_option(*each) for each in _ARGUMENT.findall(found["arguments"]))
    if found["given"]:
        return "is given"
    return _bare(found[0]) if of_option else found[0]


def _option(name: str, written: str) -> str:
    option = _OPTIONS[name]
    if written in ("True", "False"):
        return option if written == "True" else option.replace("--", "--no-", 1)
    value = _value(written)
    if option.endswith("="):
        return "--column " + shlex.quote(f"{name}={value}")
    return f"{option} {shlex.quote(value)}"


def _value(written: str) -> str:
    """What Python wrote as a literal, as a word of a command."""
    if written == "None":
        return "none"
    if written.isalpha():  # NAME, N: a place to be filled in
        return written
    value = literal_eval(written)
    return value if isinstance(value, str) else f"{value:g}"


def _bare(piece: str) -> str:
    """A word without Python's quotes, and none for None."""
    return "none" if piece == "None" else re.sub(r"'(\w[\w.\-]*)'", r"\1", piece)

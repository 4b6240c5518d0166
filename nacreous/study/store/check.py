"""What may be stored, checked where it comes in: text, JSON, times, numbers."""

from __future__ import annotations

import json
import math
from collections.abc import Collection, Mapping
from datetime import UTC, datetime
from numbers import Integral
from typing import Any

from nacreous.number import number_of
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.nothing import NOTHING
from nacreous.scaling.data.truth import says_true

#: The longest label, question or reason, in characters.
LONGEST_TEXT = 1000
#: The longest parameter of an address, in characters.
LONGEST_PARAMETER = 200
#: The largest flags, groups or screen check, as JSON in bytes; of a plan or a manifest: 64 MiB.
LARGEST_JSON = 65_536
LARGEST_PLAN = 64 * 2**20
LARGEST_MANIFEST = 64 * 2**20


def text(name: str, value: Any, longest: int = LONGEST_TEXT) -> str:
    """Text of 1 to `longest` characters, not all blank, that every database can hold."""
    if not isinstance(value, str) or value.isspace():
        raise InputError(f"{name} is {_shown(value)}; allowed: text")
    if not 1 <= len(value) <= longest:
        raise InputError(f"{name} is {len(value)} characters long; allowed: 1 to {longest}")
    if "\0" in value or any("\ud800" <= letter <= "\udfff" for letter in value):
        raise InputError(f"{name} is {_shown(value)}; allowed: text without NUL and half letters")
    return value


def reason(value: Any) -> str:
    """Why a person is left out: text, no word for no, nor one that programs write for nothing.

    In an export a reason is all that says so.

    >>> reason("n/a")
    Traceback (most recent call last):
    nacreous.problem.InputError: reason is 'n/a', which programs read as an empty cell; wanted: ...
    """
    given = text("reason", value)
    if given.strip().lower() in NOTHING:
        raise InputError(
            f"reason is {_shown(value)}, which programs read as an empty cell; wanted: words"
        )
    if says_true(given) is False:
        raise InputError(f"reason is {_shown(value)}, a word for no; wanted: a reason")
    return given


def one_of(name: str, value: Any, allowed: Collection[str]) -> str:
    """One of some words."""
    if not isinstance(value, str) or value not in allowed:
        raise InputError(f"{name} is {_shown(value)}; allowed: {', '.join(allowed)}")
    return value


def whole(name: str, value: Any, most: int = 2**31 - 1) -> int:
    """A whole number from 0 to `most`, NumPy's too."""
    is_whole = isinstance(value, Integral) and not isinstance(value, bool)
    if not is_whole or not 0 <= value <= most:
        raise InputError(f"{name} is {_shown(value)}; allowed: a whole number, 0 to {most}")
    return int(value)


def duration_ms(name: str, value: Any) -> float | None:
    """Milliseconds, 0 to a day, or None where unknown."""
    if value is None:
        return None
    try:
        duration = number_of(name, value)
    except InputError:
        duration = math.nan
    if not 0 <= duration <= 86_400_000:  # which no NaN is
        raise InputError(f"{name} is {_shown(value)}; allowed: 0 to 86400000")
    return duration


def canonical(name: str, value: Any, largest: int = LARGEST_JSON) -> str:
    """A mapping as JSON in its one form: keys sorted, no spaces, no NaN; NumPy's numbers too.

    >>> canonical("flags", {"fast": True, "age": 3})
    '{"age":3,"fast":true}'
    """
    if not isinstance(value, Mapping):
        raise InputError(f"{name} is {_shown(value)}; allowed: a mapping of names to values")
    return _json(name, dict(value), largest)


def levels(groups: Mapping[str, str]) -> str:
    """A person's groups, as JSON."""
    for name, level in groups.items():
        text("group's name", name, 100)
        text(f"group {name}", level)
    return canonical("groups", groups)


def parameters(given: Mapping[str, str]) -> str:
    """Parameters of an address, as JSON: each one line of 1 to 200 characters.

    >>> parameters({"PROLIFIC_PID": "5f0c"})
    '{"PROLIFIC_PID":"5f0c"}'
    """
    for name, value in given.items():
        text("parameter's name", name, 40)
        # The value, which may identify somebody, stands in no message: messages are logged.
        if isinstance(value, str) and printable(value) != value:
            raise InputError(f"parameter {name} has control characters; allowed: none")
        if isinstance(value, str) and value and not value.strip():
            raise InputError(f"parameter {name} is blank; allowed: text, or no such parameter")
        text(f"parameter {name}", value, LONGEST_PARAMETER)
    return canonical("parameters", given)


def canonical_list(name: str, value: Any, largest: int) -> str:
    """The same of a list."""
    if not isinstance(value, list):
        raise InputError(f"{name} is {_shown(value)}; allowed: a list")
    return _json(name, value, largest)


def _json(name: str, value: Any, largest: int) -> str:
    try:
        made = json.dumps(
            value, sort_keys=True, separators=(",", ":"), allow_nan=False, default=_plain
        )
    except (TypeError, ValueError, RecursionError) as problem:
        raise InputError(f"{name} is no JSON ({problem})") from problem
    if len(made) > largest:
        raise InputError(f"{name} is {len(made)} bytes of JSON; allowed: up to {largest}")
    return made


def _plain(value: Any) -> Any:
    """A number or a truth value of NumPy as Python's own, which alone JSON knows."""
    kind = getattr(getattr(value, "dtype", None), "kind", "")
    if not kind or kind not in "biuf" or value.shape != ():
        raise TypeError(f"{type(value).__name__} is none of its types")
    return value.item()


def written(name: str, value: Any) -> str:
    """An instant as text, UTC.

    >>> written("shown_at", datetime(2026, 3, 1, 9, 30, tzinfo=UTC))
    '2026-03-01T09:30:00.000000Z'
    """
    if not isinstance(value, datetime) or value.utcoffset() is None:
        raise InputError(f"{name} is {_shown(value)}; allowed: a time with its zone")
    try:
        return value.astimezone(UTC).isoformat(timespec="microseconds").replace("+00:00", "Z")
    except OverflowError as problem:  # the first or last hours of the calendar
        raise InputError(f"{name} is {value}; allowed: the years 1 to 9999 in UTC") from problem


def read(value: str | None) -> datetime | None:
    """The instant that `written` wrote; of an erased person, the day's beginning."""
    if value is None:
        return None
    instant = datetime.fromisoformat(value)
    return instant if instant.tzinfo else instant.replace(tzinfo=UTC)


def day(value: str | None) -> str | None:
    """A written instant, to the day."""
    return None if value is None else value[:10]


def _shown(value: Any) -> str:
    made = ascii(value)
    return made if len(made) <= 60 else made[:57] + "..."

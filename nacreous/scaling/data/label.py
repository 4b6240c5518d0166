"""Labels of stimuli: their natural order, and what may be one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any
from unicodedata import normalize

import numpy as np

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.fault import listed, quoted
from nacreous.scaling.data.hidden import hidden_in
from nacreous.scaling.data.likeness import check_alike

#: The largest design that is taken. A matrix of counts of that size fills 800 MB.
MOST_STIMULI = 10_000
LONGEST_LABEL = 200


def natural(labels: Iterable[str]) -> list[str]:
    """The labels in the order in which people number things.

    >>> natural(["crop 10", "crop 2", "Crop 1"])
    ['Crop 1', 'crop 2', 'crop 10']
    """
    return sorted(labels, key=_natural_key)


def labels_of(stimuli: Iterable[object], count: int | None = None) -> tuple[str, ...]:
    """Labels that a caller gave, as text and checked: `count` of them, no two alike, none empty.

    >>> labels_of([1, 2, "akoya"])
    ('1', '2', 'akoya')
    """
    if isinstance(stimuli, str | bytes) or not isinstance(stimuli, Iterable):
        raise InputError(f"stimuli is {said(stimuli)}; allowed: a list of labels")
    labels = tuple(_label(index, label) for index, label in enumerate(stimuli))
    if count is not None and len(labels) != count:
        raise InputError(f"stimuli has {len(labels)} labels; allowed: {count}, one a stimulus")
    seen: set[str] = set()
    for index, label in enumerate(labels):
        if label in seen:
            raise InputError(f"stimuli[{index}] is {quoted(label)} again; allowed: each label once")
        seen.add(label)
    check_number(labels)
    check_alike(labels, "stimuli")
    return labels


def place_of(label: object, stimuli: tuple[str, ...]) -> int:
    """Where a label stands among stimuli, from 0; raises `InputError` for one that does not.

    >>> place_of("b", ("a", "b"))
    1
    """
    found = label_of(label) if isinstance(label, str) else label
    if found not in stimuli:
        raise InputError(f"there is no stimulus {said(label)}; allowed: {listed(stimuli)}")
    return stimuli.index(found)


def numbered(count: int) -> tuple[str, ...]:
    """The labels "1" to "count"."""
    return tuple(str(number) for number in range(1, count + 1))


def check_number(labels: Sequence[str], place: str = "stimuli") -> None:
    """Refuse fewer than two stimuli, and more than can be worked with."""
    if len(labels) < 2:
        only = f", {quoted(labels[0])}" if labels else ""
        raise InputError(f"{place}: {len(labels)} stimuli{only}; allowed: 2 to {MOST_STIMULI}")
    if len(labels) > MOST_STIMULI:
        raise InputError(f"{place}: {len(labels)} stimuli; allowed: 2 to {MOST_STIMULI}")


def label_of(text: str) -> str:
    r"""A label without space around it, in Unicode's form NFC, in which labels are compared.

    >>> label_of("cafe\u0301 ") == "caf\u00e9"
    True
    """
    return normalize("NFC", text.strip())


def check_visible(labels: Iterable[str], place: str) -> None:
    r"""Refuse labels with characters that nobody can see, and that a terminal would obey.

    >>> check_visible(["A\x1b[31m"], "stimuli")
    Traceback (most recent call last):
    nacreous.problem.InputError: stimuli[0] is "A\u001b[31m"; allowed: no \u001b in it
    """
    for index, label in enumerate(labels):
        if not label.isprintable() and (hidden := hidden_in(label)):
            raise InputError(f"{place}[{index}] is {quoted(label)}; allowed: no {hidden} in it")


def group_names(groups: Mapping[Any, Any]) -> tuple[str, ...]:
    r"""Names of groups as a caller gave them, in Unicode's form NFC, no two the same.

    Raises `InputError` for a name that is there twice, or has characters that nobody can see.

    >>> group_names({"cafe\u0301": 1, 2: 2}) == ("caf\u00e9", "2")
    True
    """
    names = tuple(label_of(str(name)) for name in groups)
    check_visible(names, "groups")
    again = next((name for at, name in enumerate(names) if name in names[:at]), None)
    if again is not None:
        raise InputError(f"groups has {quoted(again)} again; allowed: each name once")
    return names


def _label(index: int, label: Any) -> str:
    if isinstance(label, bool | np.bool_) or not isinstance(label, str | int | np.integer):
        raise InputError(f"stimuli[{index}] is {said(label)}; allowed: text or a whole number")
    text = label_of(str(label))
    hidden = hidden_in(text)
    if hidden:
        raise InputError(f"stimuli[{index}] is {quoted(text)}; allowed: no {hidden} in it")
    if not 0 < len(text) <= LONGEST_LABEL:
        length = f"{len(text)} characters long"
        raise InputError(f"stimuli[{index}] is {length}; allowed: 1 to {LONGEST_LABEL} characters")
    return text


def _natural_key(label: str) -> tuple[Any, ...]:
    parts = re.split(r"([0-9]+)", label)
    words = [
        (part.casefold(), 0) if i % 2 == 0 else ("", _number(part)) for i, part in enumerate(parts)
    ]
    return (*words, (label, 0))  # "a" and "A", "1" and "01" still have an order


def _number(digits: str) -> float:
    return float(digits[:300])  # beyond, the order is by the first 300 digits

"""Faults of a table: all of them looked for, the first few said, each with its place."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable
from difflib import get_close_matches

import numpy as np
from numpy.typing import NDArray

from nacreous.printable import by_number, printable
from nacreous.problem import InputError

#: A column of a million bad cells is one mistake, not a million.
MOST_LINES = 20
MOST_OF_A_KIND = 5


class Faults:
    """Collects what is wrong at one place, and raises it all at once.

    >>> faults = Faults("answers.csv")
    >>> faults.say("has no column chosen")
    >>> faults.stop()
    Traceback (most recent call last):
    nacreous.problem.InputError: answers.csv: has no column chosen
    """

    def __init__(self, place: str, numbers: NDArray[np.int64] | None = None) -> None:
        """numbers: what messages call each row; None counts them from 0."""
        self._place = place
        self._numbers = numbers
        self._lines: list[str] = []
        self._count = 0
        #: The rows (positions from 0) of each of which something was noted.
        self.rows: set[int] = set()

    def __bool__(self) -> bool:
        """Whether anything was noted."""
        return bool(self._lines)

    def say(self, verdict: str) -> None:
        """Note one problem of the whole."""
        self._lines.append(f"{self._place}: {verdict}")
        self._count += 1

    def say_of_rows(self, rows: NDArray[np.int64], verdict: Callable[[int], str]) -> None:
        """Note a problem of each of these rows (positions from 0), naming the first few."""
        for row in rows[:MOST_OF_A_KIND].tolist():
            number = row if self._numbers is None else int(self._numbers[row])
            self._lines.append(f"{self._place}: row {number}: {verdict(row)}")
        self._count += len(rows)
        self.rows.update(rows.tolist())

    def say_of_column(
        self, rows: NDArray[np.int64], verdict: Callable[[int], str], such: str = "rows"
    ) -> None:
        """Note a problem of a whole column in one line, with its first row and how many there are.

        What is said of a column helps all its rows at once.
        """
        if len(rows) == 0:
            return
        number = rows[0] if self._numbers is None else self._numbers[rows[0]]
        more = f" ({len(rows)} such {such})" if len(rows) > 1 else ""
        self._lines.append(f"{self._place}: row {number}: {verdict(int(rows[0]))}{more}")
        self._count += 1

    def stop(self) -> None:
        """Raise `InputError` if anything was noted."""
        if not self._lines:
            return
        lines = self._lines[:MOST_LINES]
        if self._count > len(lines):
            lines.append(f"{self._place}: {self._count} problems in all")
        raise InputError("\n".join(lines))


def quoted(label: object) -> str:
    r"""A label in quotes, on one line and never long.

    Blanks are by number that would look like one plain blank, or be lost on a page: several of
    them, tabs, no-break ones. A wide one stays, as Japanese has it.

    >>> print(quoted("a pearl"), quoted("a  pearl"))
    "a pearl" "a\u0020\u0020pearl"
    """
    return _quoted(label, (" ", "\u3000"))


def quoted_exactly(label: object) -> str:
    r"""The same with every blank by number but single plain ones, beside a label that looks alike.

    >>> print(quoted_exactly("crop\u30001"))
    "crop\u30001"
    """
    return _quoted(label, (" ",))


def in_one_line(text: str) -> str:
    """What is no label, such as a question, with single blanks."""
    return " ".join(text.split())


def _quoted(label: object, plain: Collection[str]) -> str:
    text = re.sub(
        r"\s+",
        lambda found: found[0] if found[0] in plain else "".join(map(by_number, found[0])),
        str(label).strip(),
    )
    text = printable(text)
    return f'"{text}"' if len(text) <= 40 else f'"{text[:37]}..."'


def listed(labels: Iterable[object], most: int = 8) -> str:
    """Labels in quotes, the first few of them.

    >>> listed(range(12), most=3)
    '"0", "1", "2" and 9 more'
    """
    names = [quoted(label) for label in labels]
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def nearest(word: str, choices: Iterable[str]) -> str | None:
    """The choice that a mistyped word most probably meant, or None.

    >>> nearest("chossen", ["left", "right", "chosen"])
    'chosen'
    """
    by_lower = {choice.lower(): choice for choice in choices}
    close = get_close_matches(word.lower(), list(by_lower), n=1, cutoff=0.6)
    return by_lower[close[0]] if close else None


def hint_of(word: str, choices: Collection[str]) -> str:
    """What was probably meant by a word that is none of the choices; or all of these.

    >>> hint_of("Deeper", ["deeper", "shinier"]), hint_of("x", ["deeper", "shinier"])
    ('did you mean deeper?', 'allowed: deeper, shinier')
    """
    near = nearest(str(word), choices)
    return f"did you mean {near}?" if near else f"allowed: {', '.join(choices)}"

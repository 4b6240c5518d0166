"""A word of the trade, and the ranges of numbers that it stands for."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Literal

from nacreous.value import value_class

__all__ = ["Factor", "Language", "Range", "Word"]

Language = Literal["en", "ja"]

#: The quantity that begins again after 360 degrees.
_HUE = "hue_deg"


@value_class
class Range:
    """The values of one quantity that a word stands for: from `lower` to below `upper`.

    closed: `upper` itself belongs to it too, where no other word of the factor goes further.
    The quantity's name carries its unit where it has one; `unit` is for people. key: the key of a
    pearl file that has this quantity, or "" where none has it yet; sets: the value that the word
    puts there, or NaN. source: where the bounds come from; **(ours)** where nobody states a number;
    source_ja: the same in Japanese.
    Hues begin again after 360 degrees, so -30 to 50 is 330 to 50.

    >>> Range("hue_deg", "degrees", "", -30, 50, math.nan, "(ours)").holds(340)
    True
    """

    quantity: str
    unit: str
    key: str
    lower: float
    upper: float
    sets: float
    source: str
    closed: bool = False
    source_ja: str = ""

    def said_by(self, language: Language) -> str:
        """Where the bounds come from, without the marks of bold type.

        >>> Range("a", "", "", 0, 1, 0, "**(ours)**", source_ja="**(当方)**").said_by("ja")
        '(当方)'
        """
        text = self.source_ja if language == "ja" and self.source_ja else self.source
        return text.replace("**", "")

    def holds(self, value: float) -> bool:
        """Whether the value is in the range."""
        if self.quantity == _HUE:
            return (value - self.lower) % 360 < self.upper - self.lower
        return self.lower <= value < self.upper or (self.closed and value == self.upper)

    @property
    def is_free(self) -> bool:
        """Whether it holds every value: it is there for what the word sets alone."""
        return self.lower <= 0 and math.isinf(self.upper)

    def __repr__(self) -> str:
        """The bounds alone."""
        return f"Range({self.text})"

    @property
    def text(self) -> str:
        """The bounds and the unit, as people write them: "2 to 5 %"."""
        unit = f" {self.unit}" if self.unit else ""
        if math.isinf(self.upper):
            return f"from {self.lower:g}{unit}"
        return f"{self.lower:g} to {self.upper:g}{unit}"


@value_class
class Word:
    """A word, in English and Japanese, and its ranges, each of another quantity."""

    factor: str
    en: str
    ja: str
    ranges: tuple[Range, ...]

    def text(self, language: Language) -> str:
        """The word in a language."""
        return self.ja if language == "ja" else self.en

    @property
    def bounds(self) -> tuple[Range, ...]:
        """Its ranges that leave values out."""
        return tuple(one for one in self.ranges if not one.is_free)

    def holds(self, values: Mapping[str, float]) -> bool:
        """Whether each of these quantities that the word binds is in its range."""
        return all(
            found.holds(values[found.quantity]) for found in self.ranges if found.quantity in values
        )


@value_class
class Factor:
    """What a grader looks at, such as luster: its words, in the order in which they are tried."""

    name: str
    ja: str
    words: tuple[Word, ...]

    @property
    def quantities(self) -> tuple[str, ...]:
        """The quantities that its words bind, the first of them first."""
        return tuple(dict.fromkeys(one.quantity for word in self.words for one in word.bounds))

    @property
    def is_told_by_each(self) -> bool:
        """Whether one quantity is enough: every word binds all of them."""
        return all(len(word.bounds) == len(self.quantities) for word in self.words)

"""A value factor as a card has it: a word, the numbers that it follows from, and their origin."""

from __future__ import annotations

from typing import Literal

from nacreous.trade import Word
from nacreous.value import value_class

__all__ = ["Factor", "Figure"]

Origin = Literal["file", "picture"]


@value_class
class Figure:
    """A number, and whether it is from the pearl's file or measured in the picture.

    quantity: its name, as in the trade's table where that has it. key: of a number from the file,
    the key that says it. error: the standard error of a measured one, where there is one.
    across: of a length, the width that the trade says before it: 12 x 17.4 mm.
    """

    quantity: str
    value: float
    unit: str
    origin: Origin
    key: str = ""
    error: float | None = None
    across: float | None = None


@value_class
class Factor:
    """One of the seven value factors, of which colour has three parts.

    name: "size", "shape", "bodycolour", "overtone", "orient", "luster", "surface", "nacre" or
    "matching". word: None where the table gives none for what is known. figures: those that the
    word follows from first. note: why something is left out, a key of the card's texts; "" where
    nothing is. reason: why the picture lets it not be measured, as `nacreous.measure` says it.
    """

    name: str
    word: Word | None
    figures: tuple[Figure, ...]
    note: str = ""
    reason: str = ""

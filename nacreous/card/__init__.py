"""Grade cards: a pearl's picture, the trade's seven value factors in words and numbers, its file.

The words are the table's of `nacreous.trade`, applied to numbers: nobody has graded anything.

>>> card = make(["akoya-rg"], size=64, samples=1, culture="akoya")[0]
>>> [(factor.name, factor.word.en) for factor in card.factors if factor.name in ("luster", "nacre")]
[('luster', 'Very good'), ('nacre', 'thick')]
"""

from nacreous.card.card import ENDINGS, MOST_PEARLS, Card, make, save
from nacreous.card.factor import Factor, Figure
from nacreous.card.grading import CULTURES, graded
from nacreous.card.page import html
from nacreous.card.record import record
from nacreous.card.translation import LANGUAGES

__all__ = [
    "CULTURES",
    "ENDINGS",
    "LANGUAGES",
    "MOST_PEARLS",
    "Card",
    "Factor",
    "Figure",
    "graded",
    "html",
    "make",
    "record",
    "save",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

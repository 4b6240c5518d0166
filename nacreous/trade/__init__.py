"""What the trade says of a pearl, bound to numbers: one table, `words.csv`, in two languages.

>>> word_of("luster", 0.03).en, word_of("luster", 0.03).ja
('Very good', '上')
>>> range_of("shape", "near-round")
Range(2 to 5 %)
"""

from nacreous.trade.setting import overrides_of, with_words
from nacreous.trade.stated import (
    Stated,
    dimensions_of,
    stated,
    stated_luster,
    stated_shape,
    stated_size,
    stated_surface,
)
from nacreous.trade.table import factors, range_of, word_of, words
from nacreous.trade.word import Factor, Range, Word

__all__ = [
    "Factor",
    "Range",
    "Stated",
    "Word",
    "dimensions_of",
    "factors",
    "overrides_of",
    "range_of",
    "stated",
    "stated_luster",
    "stated_shape",
    "stated_size",
    "stated_surface",
    "with_words",
    "word_of",
    "words",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

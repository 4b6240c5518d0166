"""Strands: lots of pearls, how well they match, and sorting them into strands.

>>> lot = AKOYA.draw(60, seed=1)
>>> sorting = sort_lot(lot, Form(20))
>>> len(sorting.strands), len(sorting.spare)
(3, 0)
"""

from nacreous.strand.form import Form
from nacreous.strand.lot import Lot
from nacreous.strand.lot_file import read_lot, read_sorted, write_lot, write_sorted
from nacreous.strand.matching import Matching, matching
from nacreous.strand.population import AKOYA, Population
from nacreous.strand.sorting import Sorting, Strand, cut_lot, sort_lot

__all__ = [
    "AKOYA",
    "Form",
    "Lot",
    "Matching",
    "Population",
    "Sorting",
    "Strand",
    "cut_lot",
    "matching",
    "read_lot",
    "read_sorted",
    "sort_lot",
    "write_lot",
    "write_sorted",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__

"""The [film] of a pearl: the outer layers whose interference the transport model sums exactly."""

from __future__ import annotations

from nacreous.spec.key import quantity
from nacreous.spec.section import Section


class Film(Section):
    """The outer nacre as a film of many columns of tablets (the transport model).

    A spot on the pearl shows the mean of columns that grew alike and not the same.
    """

    outer_um: float | None = quantity(
        None,
        "Depth of the outer nacre whose layers interfere; what lies below only scatters.",
        least=1,
        most=500,
        unit="um",
        source="**(ours)**; the trade's reports speak of the outer 10 and 50 um",
        left_out="from the knob depth",
    )
    columns: int = quantity(
        64,
        "Columns of tablets whose reflectances are averaged.",
        least=2,
        most=1024,
        unit="columns",
        source="**(ours)**",
    )
    column_spread_nm: float | None = quantity(
        None,
        "Spread (standard deviation) of each layer's thickness from column to column, added to "
        "what growth gives.",
        least=0,
        most=200,
        unit="nm",
        source="Pearl Science Laboratory, 10 to 20 nm where teri is strong",
        left_out="0 where the layers are grown, 10 nm where they are listed",
    )

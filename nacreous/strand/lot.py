"""A lot: loose pearls, each with what decides whether it matches another."""

from __future__ import annotations

from collections import Counter

import numpy as np
from numpy.typing import NDArray

from nacreous.number import array_of, said
from nacreous.problem import InputError
from nacreous.value import value_class

__all__ = ["MOST_PEARLS", "QUANTITIES", "Lot", "Quantity"]

Array = NDArray[np.float64]

#: The most pearls in a lot: differences of all pairs are kept, 200 MB for so many **(ours)**.
MOST_PEARLS = 5000


@value_class
class Quantity:
    """A column of a lot: its name, with the unit, and the range that is allowed."""

    name: str
    least: float
    most: float

    @property
    def allowed(self) -> str:
        """The range in words."""
        return f"{self.least:g} to {self.most:g}"


#: Diameter as pearl files take it; body colour in CIELAB under D65; luster as the facets' spread.
QUANTITIES = (
    Quantity("size_mm", 1, 30),
    Quantity("L", 0, 100),
    Quantity("a", -128, 128),
    Quantity("b", -128, 128),
    Quantity("facet_spread_rad", 0.005, 0.6),
)


@value_class
class Lot:
    """Pearls by name, with size, body colour and luster.

    names: one for each pearl, all different. values: float64 [pearl, 5], the columns of
    `QUANTITIES`: diameter in mm; L*, a* and b* of the body under D65; spread of the facets' slopes
    in radians. Raises `InputError`.

    >>> lot = Lot(("a", "b"), [[7.2, 94, 0.5, 4, 0.035], [7.3, 93, 0.4, 5, 0.03]])
    >>> len(lot), lot.size_mm.tolist(), lot.take([1]).names
    (2, [7.2, 7.3], ('b',))
    """

    names: tuple[str, ...]
    values: Array

    def __post_init__(self) -> None:
        """Check everything."""
        values = array_of("values", self.values)
        if values.ndim != 2 or values.shape != (len(self.names), len(QUANTITIES)):
            raise InputError(
                f"values has shape {list(values.shape)}; allowed: "
                f"[{len(self.names)}, {len(QUANTITIES)}], for as many names"
            )
        if not 1 <= len(self.names) <= MOST_PEARLS:
            raise InputError(f"the lot has {len(self.names)} pearls; allowed: 1 to {MOST_PEARLS}")
        name, count = Counter(self.names).most_common(1)[0]
        if count > 1:
            raise InputError(f"{count} pearls are called {said(name)}; allowed: a name each")
        for column, quantity in zip(values.T, QUANTITIES, strict=True):
            bad = np.flatnonzero(~((column >= quantity.least) & (column <= quantity.most)))
            if bad.size:
                at = int(bad[0])
                raise InputError(
                    f"pearl {self.names[at]}: {quantity.name} is {column[at]:g}; "
                    f"allowed: {quantity.allowed}"
                )
        object.__setattr__(self, "values", values)

    def __len__(self) -> int:
        """How many pearls there are."""
        return len(self.names)

    @property
    def size_mm(self) -> Array:
        """Float64 [pearl], the diameters."""
        return self.values[:, 0]

    @property
    def lab(self) -> Array:
        """Float64 [pearl, 3], the body colours in CIELAB under D65."""
        return self.values[:, 1:4]

    @property
    def facet_spread_rad(self) -> Array:
        """Float64 [pearl], the spreads of the facets' slopes."""
        return self.values[:, 4]

    def take(self, pearls: NDArray[np.int64] | list[int]) -> Lot:
        """These pearls, in this order."""
        chosen = np.asarray(pearls, np.int64)
        return Lot(tuple(self.names[at] for at in chosen), self.values[chosen])

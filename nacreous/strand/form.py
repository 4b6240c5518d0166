"""The form of a strand: even, or graduated from small ends to a large centre."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.number import whole_of, within
from nacreous.value import value_class

__all__ = ["LONGEST", "MOST_GRADUATED_MM", "Form"]

#: As many pearls as a scene may hold.
LONGEST = 400
#: From the smallest pearl of a lot to the largest.
MOST_GRADUATED_MM = 29


@value_class
class Form:
    """How many pearls a strand has, and by how much its centre is larger than its ends, in mm.

    Between ends and centre sizes grow by equal steps. 0 is an even strand. Raises `InputError`.

    >>> Form(5, 1.0).above_ends_mm.tolist(), Form(4, 1.0).above_ends_mm.tolist()
    ([0.0, 0.5, 1.0, 0.5, 0.0], [0.0, 1.0, 1.0, 0.0])
    """

    length: int
    graduation_mm: float = 0.0

    def __post_init__(self) -> None:
        """Check both."""
        object.__setattr__(self, "length", whole_of("length", self.length, 2, LONGEST))
        graduation_mm = within("graduation_mm", self.graduation_mm, 0, MOST_GRADUATED_MM)
        object.__setattr__(self, "graduation_mm", graduation_mm)

    @property
    def above_ends_mm(self) -> NDArray[np.float64]:
        """Float64 [place], how much larger the pearl at a place is than those at the ends."""
        from_end = np.minimum(np.arange(self.length), np.arange(self.length)[::-1])
        share: NDArray[np.float64] = from_end / max(from_end.max(), 1)
        return self.graduation_mm * share

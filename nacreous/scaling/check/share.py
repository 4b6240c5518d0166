"""A share of something counted, with its interval."""

from __future__ import annotations

import numpy as np

from nacreous.scaling.fit.uncertainty import level_of
from nacreous.value import value_class


@value_class
class Share:
    """`count` of `total`, as a `share` with an interval of `level` from `low` to `high`.

    Wilson's interval (1927), which stays inside 0..1 and is honest for few answers too. It takes
    answers as independent; where the same people answer often, doubt is larger.

    >>> print(Share.of(9, 10))
    9 of 10, 0.90 (0.60 to 0.98)
    """

    count: float
    total: float
    share: float
    low: float
    high: float
    level: float

    @classmethod
    def of(cls, count: float, total: float, level: float = 0.95) -> Share:
        """The share of `count` in `total`, which is above 0."""
        from scipy.special import ndtri

        z = float(ndtri((1 + level_of(level)) / 2))
        share = count / total
        middle = (share + z**2 / (2 * total)) / (1 + z**2 / total)
        half = z / (1 + z**2 / total) * np.sqrt(share * (1 - share) / total + z**2 / (4 * total**2))
        low, high = max(0.0, middle - half), min(1.0, middle + half)
        low, high = (0.0 if count == 0 else low), (1.0 if count == total else high)
        return cls(float(count), float(total), float(share), float(low), float(high), level)

    def __str__(self) -> str:
        """Count, share and interval in one line."""
        interval = f"({self.low:.2f} to {self.high:.2f})"
        return f"{self.count:g} of {self.total:g}, {self.share:.2f} {interval}"

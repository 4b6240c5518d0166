"""What a plan foretells: results of simulated studies, each of which says that it is simulated."""

from __future__ import annotations

from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from nacreous.value import value_class

__all__ = ["Needed", "Power", "Precision"]

Array = NDArray[np.float64]


@value_class
class Power:
    """Share of simulated studies that find what is there.

    power     the share, with its Monte-Carlo standard error `se`
    studies   how many were simulated; people: how many simulated observers each had (a group)
    unplaced  share of studies whose answers give no scale; they count as not having found it
    """

    power: float
    se: float
    studies: int
    people: int
    unplaced: float
    simulated: bool = field(default=True, init=False)

    def __str__(self) -> str:
        """In one line, with what it rests on."""
        return (
            f"power {self.power:.3f} +- {self.se:.3f} "
            f"({self.people} people; simulated, {self.studies} studies)"
        )


@value_class
class Precision:
    """How far fitted values are off, from simulated studies; float64 [stimulus] each.

    error       root mean square of fitted value less the value that endless answers would give
    error_se    its Monte-Carlo standard error
    half_width  mean half width of the interval of each value
    coverage    share of intervals that hold the value
    """

    stimuli: tuple[str, ...]
    error: Array
    error_se: Array
    half_width: Array
    coverage: Array
    level: float
    studies: int
    people: int
    unplaced: float
    simulated: bool = field(default=True, init=False)


@value_class
class Needed:
    """How many people a study needs: `people`, and low..high by Monte-Carlo error (95 %).

    power: of a study with so many people, from fresh simulated studies.
    """

    people: int
    low: int
    high: int
    target: float
    power: Power
    simulated: bool = field(default=True, init=False)

"""What the drawings ask of a fitted scale, and of the place they are written to."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from nacreous import file
from nacreous.number import number_of, said
from nacreous.problem import InputError

__all__ = ["SUFFIXES", "WIDTHS_PT", "Fitted", "by_name", "output", "span"]

SUFFIXES = (".svg", ".png", ".pdf")
WIDTHS_PT = (200.0, 2000.0)
#: Values nearer together are one place, as three decimals show them.
_LEVEL = 0.0005


class Fitted(Protocol):
    """A scale: names, values and the unit they are in."""

    @property
    def stimuli(self) -> tuple[str, ...]:
        """Names."""

    @property
    def scale(self) -> NDArray[np.float64]:
        """Values, [stimulus]."""

    @property
    def unit(self) -> str:
        """What a difference of 1 is."""


F = TypeVar("F", bound=Fitted)


def by_name(fits: F | Mapping[str, F]) -> dict[str, F]:
    """One or more scales of the same stimuli and unit, by name; one alone has the name ""."""
    named = dict(fits) if isinstance(fits, Mapping) else {"": fits}
    if not named:
        raise InputError("there are 0 scales to draw; allowed: 1 or more")
    for fit in named.values():
        if not all(hasattr(fit, part) for part in ("stimuli", "scale", "unit")):
            raise InputError(f"fits holds {said(fit)}; wanted: scales, such as thurstone(answers)")
    first = next(iter(named.values()))
    for name, fit in named.items():
        if fit.stimuli != first.stimuli:
            raise InputError(f"scale {name!r} is of other stimuli; allowed: the same for all")
        if fit.unit != first.unit:
            raise InputError(
                f"scale {name!r} is in {fit.unit}; allowed: {first.unit}, as the first"
            )
    return named


def output(path: str | PathLike[str], width_pt: float) -> tuple[Path, float]:
    """The file to write and the width, or one clear message."""
    width = number_of("width_pt", width_pt)
    least, most = WIDTHS_PT
    if not least <= width <= most:
        raise InputError(f"width_pt is {width:g}; allowed: {least:g} to {most:g}")
    return file.check_output(path, SUFFIXES), width


def span(*values: NDArray[np.float64]) -> tuple[float, float]:
    """From the least to the greatest; about one place 1 wide, so that rounding looks like none."""
    low, high = min(float(v.min()) for v in values), max(float(v.max()) for v in values)
    return (low, high) if high - low >= _LEVEL else (low - 0.5, high + 0.5)

"""The dispersion of one quantity, n or k, as refractiveindex.info writes it.

Its nine formulas are in the database's "Dispersion formulas.pdf"; wavelengths are in um, and C1,
C2, ... the coefficients in the file's order. Whole terms at the end may be left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from nacreous.value import value_class

Array = NDArray[np.float64]

#: What n and k may be; stacks take them up to 100, which metals exceed in the far infrared.
ALLOWED = {"n": "above 0", "k": "0 or more"}


@value_class
class Dispersion:
    """n or k by wavelength: straight lines between rows, or a formula.

    formula: 0 for rows, else 1 to 9. nm: wavelengths of the rows, rising, or the formula's first
    and last. numbers: values of the rows, or the formula's coefficients.
    """

    formula: int
    nm: Array
    numbers: Array

    def at(self, nm: Array) -> Array:
        """Values at wavelengths within `nm`."""
        if self.formula:
            return FORMULAS[self.formula](nm * 1e-3, self.numbers)
        return np.interp(nm, self.nm, self.numbers)

    def with_range(self) -> tuple[float, float]:
        """First and last wavelength in nm."""
        return float(self.nm[0]), float(self.nm[-1])


def fits(name: str, values: Array) -> NDArray[np.bool_]:
    """Which values of "n" or "k" a medium can have."""
    return values > 0 if name == "n" else values >= 0


def dispersion_of_rows(nm: Array, values: Array) -> Dispersion:
    """Rows in any order; of several at one wavelength, where two measurements meet, the mean."""
    once, place = np.unique(nm, return_inverse=True)
    return Dispersion(0, once, np.bincount(place, values) / np.bincount(place))


def _pairs(c: Array) -> zip[tuple[float, float]]:
    """(C2, C3), (C4, C5), ..."""
    return zip(c[1::2].tolist(), c[2::2].tolist(), strict=False)


def _sellmeier(um: Array, c: Array) -> Array:
    return _root(1 + c[0] + _sum(um, (a * um**2 / (um**2 - b**2) for a, b in _pairs(c))))


def _sellmeier_of_squares(um: Array, c: Array) -> Array:
    return _root(1 + c[0] + _sum(um, (a * um**2 / (um**2 - b) for a, b in _pairs(c))))


def _polynomial(um: Array, c: Array) -> Array:
    return _root(c[0] + _powers(um, c))


def _resonances_and_powers(um: Array, c: Array) -> Array:
    """C1 + C2 l^C3 / (l^2 - C4^C5) + C6 l^C7 / (l^2 - C8^C9) + C10 l^C11 + ..."""
    square = c[0] + np.zeros_like(um)
    for first in range(1, min(9, len(c)), 4):
        factor, power, line, of_line = _filled(c[first : first + 4], 4)
        if factor:
            square += factor * um**power / (um**2 - line**of_line)
    return _root(square + _powers(um, np.concatenate([[0.0], c[9:]])))


def _cauchy(um: Array, c: Array) -> Array:
    return _powers(um, c) + float(c[0])


def _gas(um: Array, c: Array) -> Array:
    return _sum(um, (a / (b - um**-2) for a, b in _pairs(c))) + (1 + float(c[0]))


def _herzberger(um: Array, c: Array) -> Array:
    line = 1 / (um**2 - 0.028)
    c1, c2, c3, c4, c5, c6 = _filled(c, 6)
    return c1 + c2 * line + c3 * line**2 + c4 * um**2 + c5 * um**4 + c6 * um**6


def _retro(um: Array, c: Array) -> Array:
    """(n^2 - 1) / (n^2 + 2), Lorentz and Lorenz's quotient."""
    c1, c2, c3, c4 = _filled(c, 4)
    quotient = c1 + c2 * um**2 / (um**2 - c3) + c4 * um**2
    return _root((1 + 2 * quotient) / (1 - quotient))


def _exotic(um: Array, c: Array) -> Array:
    c1, c2, c3, c4, c5, c6 = _filled(c, 6)
    return _root(c1 + c2 / (um**2 - c3) + c4 * (um - c5) / ((um - c5) ** 2 + c6))


def _powers(um: Array, c: Array) -> Array:
    return _sum(um, (a * um**b for a, b in _pairs(c)))


def _sum(um: Array, terms: Iterable[Array]) -> Array:
    return sum(terms, np.zeros_like(um))


def _filled(c: Array, length: int) -> list[float]:
    given: list[float] = c[:length].tolist()
    return given + [0.0] * (length - len(given))


def _root(square: Array) -> Array:
    """Where a formula has no real index, NaN, which whoever asks refuses by name."""
    return np.sqrt(np.where(square > 0, square, np.nan))


#: By formula, how many coefficients a whole number of its terms has.
COEFFICIENTS: dict[int, tuple[int, ...]] = {
    **dict.fromkeys((1, 2, 3), tuple(range(1, 18, 2))),
    4: (1, 5, 9, 11, 13, 15, 17),
    **dict.fromkeys((5, 6), tuple(range(1, 12, 2))),
    7: tuple(range(1, 7)),
    8: (1, 3, 4),
    9: (1, 3, 6),
}

#: The formulas by their number in a file's "type: formula N".
FORMULAS: dict[int, Callable[[Array, Array], Array]] = {
    1: _sellmeier,
    2: _sellmeier_of_squares,
    3: _polynomial,
    4: _resonances_and_powers,
    5: _cauchy,
    6: _gas,
    7: _herzberger,
    8: _retro,
    9: _exotic,
}

"""One scale brought to the unit of another, with errors on both sides.

Both scales are estimates x and y of u and s u + c, with joint covariance C. For a slope s the
differences y - s x have covariance C(s) = Cyy - s (Cxy + Cyx) + s^2 Cxx, and

    Q(s) = (y - s x)' H' (H C(s) H')^-1 H (y - s x)        H: contrasts, which take c away

is chi-squared with one degree of freedom fewer than contrasts at its least, and rises by a
chi-squared of one from there to the true slope (maximum likelihood of a line with errors in both
variables, Deming 1943; intervals as by Fieller 1954).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.distribution import chi2, t
from nacreous.scaling.fit.uncertainty import holm
from nacreous.value import value_class

__all__ = ["Alignment", "Shifts", "align", "shifts"]

Array = NDArray[np.float64]

#: Slopes looked at, by their angle: from minus to plus infinity in steps of half a degree.
_ANGLES = np.linspace(-np.pi / 2, np.pi / 2, 361)[1:-1]


@value_class
class Alignment:
    """A slope with its interval, and how well a line describes both scales.

    `low` and `high` are None where the data set no bound. misfit: chi-squared with df degrees of
    freedom if one scale is a line of the other; p_value: how often it is as large by chance.
    """

    value: float
    low: float | None
    high: float | None
    misfit: float
    df: int
    p_value: float


@value_class
class Shifts:
    """By how much stimuli stand off the line of the others, float64 [stimulus] each."""

    value: Array
    se: Array
    reach: float
    p_value: Array
    p_adjusted: Array
    moved: NDArray[np.bool_]


def align(x: Array, y: Array, joint: Array, level: float) -> Alignment:
    """The slope of y over x, three stimuli or more."""
    line = _Line(x, y, joint, np.arange(len(x)))
    heights = np.array([line.misfit(angle) for angle in _ANGLES])
    best = int(np.argmin(heights))
    angle = line.angle_near(_ANGLES[best], _ANGLES[1] - _ANGLES[0])
    least = line.misfit(angle)
    height = least + float(chi2.ppf(level, 1))
    df = len(x) - 2
    return Alignment(
        value=float(np.tan(angle)),
        low=_crossing(line, heights, best, height, -1),
        high=_crossing(line, heights, best, height, 1),
        misfit=least,
        df=df,
        p_value=float(chi2.sf(least, df)),
    )


def shifts(x: Array, y: Array, joint: Array, slope: float, level: float, freedom: float) -> Shifts:
    """Which stimuli stand off the line, found one after the other.

    Each stimulus is held against the line through the others that have not moved. While Holm's p
    of the farthest is below 1 - level it counts as moved and the line is laid anew through the
    rest, three at the least, so that one mover does not make the others look moved. Where none
    moved, no more than 1 - level of studies name one; the standard errors contain both scales' and
    the line's. slope: that of all stimuli, near which the others' lines are looked for.
    """
    moved = np.zeros(len(x), bool)
    while True:
        value, se = _offsets(x, y, joint, moved, slope)
        p_value = 2 * t.sf(np.abs(value) / se, freedom)
        p_adjusted = holm(p_value)
        next_one = int(np.argmin(np.where(moved, 2.0, p_value)))
        if p_adjusted[next_one] >= 1 - level or (~moved).sum() < 4:
            break
        moved[next_one] = True
    reach = float(t.ppf((1 + level) / 2, freedom))
    return Shifts(value, se, reach, p_value, p_adjusted, moved)


def _offsets(
    x: Array, y: Array, joint: Array, moved: NDArray[np.bool_], slope: float
) -> tuple[Array, Array]:
    """Each stimulus's offset from the line through the other unmoved ones, with its error."""
    kept = np.flatnonzero(~moved)
    line = _Line(x, y, joint, kept)
    own = float(np.tan(line.angle_near(float(np.arctan(slope)), np.pi / 6)))
    off = y - own * x
    value, se = np.empty(len(x)), np.empty(len(x))
    value[kept], se[kept] = line.left_out(off, own)
    for k in np.flatnonzero(moved):
        apart = line.apart(int(k), own)
        direction = line.direction(apart, own)
        value[k] = apart @ off
        se[k] = np.sqrt(direction @ line.spread(own) @ direction)
    return value, se


class _Line:
    """The line through some stimuli, and how well each slope fits."""

    def __init__(self, x: Array, y: Array, joint: Array, kept: NDArray[np.int64]) -> None:
        from scipy.linalg import helmert

        n = len(x)
        self._x, self._kept = x, kept
        self._blocks = (joint[n:, n:], joint[:n, n:] + joint[n:, :n], joint[:n, :n])
        self._contrasts = np.zeros((len(kept) - 1, n))
        self._contrasts[:, kept] = helmert(len(kept))
        self._ends = (self._contrasts @ y, self._contrasts @ x)
        self._inner = [self._contrasts @ block @ self._contrasts.T for block in self._blocks]

    def spread(self, slope: float) -> Array:
        """Covariance of y - slope x, all stimuli."""
        yy, xy, xx = self._blocks
        return np.asarray(yy - slope * xy + slope**2 * xx)

    def misfit(self, angle: float) -> float:
        """Q of the slope tan(angle)."""
        c, s = np.cos(angle), np.sin(angle)  # both sides times cos: nothing grows near 90 degrees
        off = c * self._ends[0] - s * self._ends[1]
        yy, xy, xx = self._inner
        return float(off @ np.linalg.solve(c * c * yy - c * s * xy + s * s * xx, off))

    def angle_near(self, angle: float, reach: float) -> float:
        """The angle of the least misfit within reach of another."""
        from scipy.optimize import minimize_scalar

        bounds = (max(angle - reach, -np.pi / 2 + 1e-9), min(angle + reach, np.pi / 2 - 1e-9))
        found = minimize_scalar(
            self.misfit, bounds=bounds, method="bounded", options={"xatol": 1e-8}
        )
        return float(found.x)

    def left_out(self, off: Array, slope: float) -> tuple[Array, Array]:
        """Offset of each of the line's stimuli from the line without it, and its error.

        All at once: least squares with a term for one stimulus gives (P off)_k / P_kk with variance
        1 / P_kk, P what the line leaves of the inverse covariance (Cook and Weisberg 1982, 2.2).
        The line's x are freed of the noise that they share with the offsets.
        """
        spread = self.spread(slope)
        inner = spread[np.ix_(self._kept, self._kept)] + np.trace(spread) / len(spread)
        inverse = np.linalg.inv(inner)
        with_x = (self._blocks[1] / 2 - slope * self._blocks[2])[np.ix_(self._kept, self._kept)]
        residual = off[self._kept] - off[self._kept] @ inverse.sum(axis=1) / inverse.sum()
        freed = self._x[self._kept] - with_x @ inverse @ residual
        line = np.column_stack([np.ones(len(inner)), freed])
        weighed = inverse @ line
        left = inverse - weighed @ np.linalg.pinv(line.T @ weighed, hermitian=True) @ weighed.T
        own = np.maximum(np.diag(left), 1e-12 / np.diag(inner))
        return (left @ residual) / own, 1 / np.sqrt(own)

    def apart(self, k: int, slope: float) -> Array:
        """Weights that take from stimulus k the best guess of the line's constant."""
        spread = self.spread(slope)
        inner = spread[np.ix_(self._kept, self._kept)] + np.trace(spread) / len(spread)
        sums = np.linalg.solve(inner, np.ones(len(inner)))
        weights = np.zeros(len(spread))
        weights[self._kept] = -sums / sums.sum()
        weights[k] += 1.0
        return weights

    def direction(self, apart: Array, slope: float) -> Array:
        """Weights of the errors of y - slope x in that offset, also by way of the slope."""
        along = self._ends[1]
        across = np.linalg.solve(self._contrasts @ self.spread(slope) @ self._contrasts.T, along)
        gain = across / max(float(along @ across), 1e-12)
        return np.asarray(apart - (apart @ self._x) * (gain @ self._contrasts))


def _crossing(line: _Line, heights: Array, best: int, height: float, way: int) -> float | None:
    """The slope, down (-1) or up (1) from the best, at which the misfit reaches a height."""
    from scipy.optimize import brentq

    steps = range(best + way, len(_ANGLES) if way > 0 else -1, way)
    beyond = next((k for k in steps if heights[k] > height), None)
    if beyond is None:
        return None
    inner = _ANGLES[beyond - way]
    if line.misfit(inner) > height:
        return float(np.tan(inner))
    return float(np.tan(brentq(lambda angle: line.misfit(angle) - height, inner, _ANGLES[beyond])))

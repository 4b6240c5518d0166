"""Columns of tablets side by side: means over stacks that grew alike."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.nacre import LayerStack, grow
from nacreous.number import number_of, row_of, said, whole_of
from nacreous.optics.transfer import energies
from nacreous.problem import InputError
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.spec import Growth

#: The most columns of an ensemble.
MAX_COLUMNS = 10_000

#: Columns grown before they are computed: enough to be worth a call, few megabytes.
AT_ONCE = 64


@value_class
class Ensemble:
    """What an eye sees of many columns of tablets side by side, each float64 [angle, wavelength].

    R, T: means over the columns. R_spread, T_spread: standard deviations from column to column.
    columns: how many. A mean is known to R_error or T_error, the standard deviation of itself.
    """

    R: NDArray[np.float64]
    T: NDArray[np.float64]
    R_spread: NDArray[np.float64]
    T_spread: NDArray[np.float64]
    columns: int

    @property
    def R_error(self) -> NDArray[np.float64]:  # noqa: N802, as R
        """Standard error of R: four times the columns halve it."""
        return self.R_spread / math.sqrt(self.columns)

    @property
    def T_error(self) -> NDArray[np.float64]:  # noqa: N802, as T
        """Standard error of T."""
        return self.T_spread / math.sqrt(self.columns)


def ensemble(
    growth: str | Growth,
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    columns: int = 64,
    seed: int = 1,
    polarisation: str = "unpolarised",
    precision: str = "double",
    coherence_nm: float | None = None,
    error: float | None = None,
) -> Ensemble:
    """Mean and spread of R and T over stacks that grew alike, each on its own: disordered nacre.

    growth: a nacre preset's name or a `Growth`, as for `nc.grow`. columns: how many stacks, 2 to
    10000; they have the seeds seed, seed + 1, ... and nothing else in common, so light from
    different columns is added by energy **(ours)**. The rest as `energies`.
    error: None, or how well every mean must be known: columns are added until no R_error and no
    T_error is above it. A mean of few columns that chance made alike may stop too early; begin
    with enough of them.

    Same seed, same answer. Raises `InputError` for what is out of range, and for an error that
    10000 columns do not reach.

    >>> nacre = ensemble("akoya-rg", [0.0, 0.5], [450.0, 550.0, 650.0], columns=8, seed=7)
    >>> nacre.R.shape
    (2, 3)
    """
    first, seed = whole_of("columns", columns, 2, MAX_COLUMNS), whole_of("seed", seed, 0, 2**62)
    if error is not None and not 1e-9 <= number_of("error", error) <= 1:
        raise InputError(f"error is {said(error)}; allowed: 1e-9 to 1, or None")
    light = _Light(
        row_of("angle_rad", angle_rad),
        row_of("wavelength_nm", wavelength_nm),
        polarisation,
        precision,
        coherence_nm,
    )
    tables = np.zeros((4, light.angle_rad.size, light.wavelength_nm.size))
    done, goal = 0, first
    while True:
        while done < goal:
            seeds = range(seed + done, seed + min(done + AT_ONCE, goal))
            stacks = [grow(growth, seed=each) for each in seeds]
            tables = light.added(tables, done, stacks)
            done += len(stacks)
        spread = np.sqrt(tables[2:] / (done - 1))
        reached = spread.max(initial=0.0) / math.sqrt(done)
        if error is None or reached <= error:
            return Ensemble(tables[0], tables[1], spread[0], spread[1], done)
        goal = _goal(done, reached, error)


def _goal(done: int, reached: float, error: float) -> int:
    """Columns for an error, where `done` of them reach another: it falls with their root."""
    goal = max(done + 1, math.ceil(done * (reached / error) ** 2))
    if goal > MAX_COLUMNS:
        raise InputError(
            f"error is {said(error)}; allowed for this nacre: what {MAX_COLUMNS} columns "
            f"reach, about {reached * math.sqrt(done / MAX_COLUMNS):.2g}"
        )
    return goal


@dataclass(frozen=True)
class _Light:
    """What the columns are asked."""

    angle_rad: NDArray[np.float64]
    wavelength_nm: NDArray[np.float64]
    polarisation: str
    precision: str
    coherence_nm: float | None

    def added(
        self, tables: NDArray[np.float64], done: int, stacks: list[LayerStack]
    ) -> NDArray[np.float64]:
        """Means of R and T and sums of squared differences from them, with more columns."""
        angle, nm = self.angle_rad, self.wavelength_nm
        if self.coherence_nm is None:
            sampled = [stack.at(nm) for stack in stacks]
            return _core.ensemble(
                sampled, angle, nm, self.polarisation, self.precision, done, tables
            )
        means, squares = tables[:2].copy(), tables[2:].copy()
        for column, stack in enumerate(stacks, start=done + 1):
            found = energies(stack, angle, nm, self.polarisation, self.precision, self.coherence_nm)
            # Welford 1962: no difference of large sums.
            step = np.stack([found.R, found.T]) - means
            means += step / column
            squares += step * (np.stack([found.R, found.T]) - means)
        return np.concatenate([means, squares])

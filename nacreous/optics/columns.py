"""Columns of tablets side by side: means over stacks that grew alike."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous import _core
from nacreous.nacre import LayerStack, grow
from nacreous.number import number_of, row_of, said, whole_of, within
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
    growth: str | Growth | Sequence[LayerStack] | tuple[float, float, int, float],
    angle_rad: ArrayLike,
    wavelength_nm: ArrayLike,
    columns: int = 64,
    seed: int = 1,
    polarisation: str = "unpolarised",
    precision: str = "double",
    coherence_nm: float | None = None,
    error: float | None = None,
    like: LayerStack | None = None,
) -> Ensemble:
    """Mean and spread of R and T over stacks that grew alike, each on its own: disordered nacre.

    growth: a nacre preset's name or a `Growth`, as for `nc.grow`; or a list of stacks, such as
    sections measured in a microscope; or four numbers, (mean, spread, layers, correlation): normal
    layers, mean and standard deviation in nm, each correlated with the next within its column, -1 <
    correlation < 1 (an autoregressive row; below 1 nm a layer counts as 1 nm). Their protein and
    media are those of `like`, the paper's if it is left out.
    columns: how many stacks, 2 to 10000; they have the seeds seed, seed + 1, ... and nothing else
    in common, so light from different columns is added by energy **(ours)**. A list has as many as
    it has, 2 or more. The rest as `energies`.
    error: None, or how well every mean must be known: columns are added until no R_error and no
    T_error is above it. A mean of few columns that chance made alike may stop too early; begin
    with enough of them.

    Same seed, same answer. Raises `InputError` for what is out of range, and for an error that
    10000 columns do not reach.

    >>> nacre = ensemble("akoya-rg", [0.0, 0.5], [450.0, 550.0, 650.0], columns=8, seed=7)
    >>> nacre.R.shape
    (2, 3)
    >>> sections = [LayerStack([380.0, 402.0, 391.0]), LayerStack([376.0, 395.0, 404.0, 388.0])]
    >>> ensemble(sections, 0.0, 550.0).columns
    2
    >>> ensemble((390.0, 12.0, 50, 0.4), 0.0, 550.0, columns=8).R.shape
    (1, 1)
    """
    if isinstance(growth, (list, tuple)) and any(isinstance(one, LayerStack) for one in growth):
        sections = _sections(growth, error)
        growth, columns = "", len(sections)
    else:
        sections = []
    grown = _grown(growth, like)
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
            following = range(done, min(done + AT_ONCE, goal))
            stacks = [sections[i] if sections else grown(seed + i) for i in following]
            tables = light.added(tables, done, stacks)
            done += len(stacks)
        spread = np.sqrt(tables[2:] / (done - 1))
        reached = spread.max(initial=0.0) / math.sqrt(done)
        if error is None or reached <= error:
            return Ensemble(tables[0], tables[1], spread[0], spread[1], done)
        goal = _goal(done, reached, error)


def _sections(stacks: Sequence[object], error: float | None) -> list[LayerStack]:
    """Stacks as they were measured, each of them one."""
    for place, stack in enumerate(stacks):
        if not isinstance(stack, LayerStack):
            raise InputError(f"growth[{place}] is {said(stack)}; allowed: a LayerStack")
    if error is not None:
        raise InputError(f"error is {said(error)}; allowed for a list of stacks: None")
    if not 2 <= len(stacks) <= MAX_COLUMNS:
        raise InputError(f"growth has {len(stacks)} stacks; allowed: 2 to {MAX_COLUMNS}")
    return [stack for stack in stacks if isinstance(stack, LayerStack)]


def _grown(growth: object, like: LayerStack | None) -> Callable[[int], LayerStack]:
    """What makes a column of a seed."""
    if like is not None and not isinstance(like, LayerStack):
        raise InputError(f"like is {said(like)}; allowed: a LayerStack, or None")
    if not isinstance(growth, (list, tuple)):
        if like is not None:
            raise InputError(
                "like is given; allowed with (mean, spread, layers, correlation) alone"
            )
        return lambda seed: grow(growth, seed=seed)  # type: ignore[arg-type]
    if len(growth) != 4:
        raise InputError(
            f"growth is {said(growth)}; allowed: a preset, a Growth, stacks, "
            "or (mean, spread, layers, correlation)"
        )
    mean_nm = within("growth: mean", growth[0], 1, 1e6)
    spread_nm = within("growth: spread", growth[1], 0, mean_nm / 3)
    layers = whole_of("growth: layers", growth[2], 1, 5000)
    correlation = within("growth: correlation", growth[3], -0.999, 0.999)
    pattern = LayerStack([mean_nm]) if like is None else like

    def column(seed: int) -> LayerStack:
        deviation = np.random.default_rng(seed).standard_normal(layers)
        new = math.sqrt(1 - correlation**2)
        for layer in range(1, layers):
            deviation[layer] = correlation * deviation[layer - 1] + new * deviation[layer]
        return replace(pattern, thickness_nm=np.maximum(1.0, mean_nm + spread_nm * deviation))

    return column


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
        if self.coherence_nm is None and all(stack.is_plain for stack in stacks):
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

"""Whether the likelihood of a scale that is made of columns of a design has one finite maximum.

A direction in the coefficients along which no answer becomes less likely has no end; whether there
is one is a linear programme (K. Konis, Linear programming algorithms for detecting separated data,
2007).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons


def require_design(
    comparisons: Comparisons,
    design: NDArray[np.float64],
    ties: bool,
    order: bool,
    prior: float | None,
) -> None:
    """Raise `InputError` if columns cannot be told apart, or if answers are all of one kind."""
    equal, rising = _directions(comparisons, design, ties, order)
    size = equal.shape[1]
    if prior is not None:  # which holds the coefficients; side and ties are not
        equal, rising = equal[:, design.shape[1] :], rising[:, design.shape[1] :]
        size = equal.shape[1]
        if size == 0:
            return
    both = np.vstack((equal, rising))
    scale = np.maximum(np.abs(both).max(axis=0, initial=0.0), 1e-300)
    if np.linalg.matrix_rank(np.linalg.qr(both / scale, mode="r")) < size:
        raise InputError(
            "design: its columns cannot be told apart by these answers; allowed: columns that "
            "differ between compared stimuli and are no sums of each other"
        )
    if recession(equal / scale, rising / scale) is not None:
        raise InputError(
            "design: some combination of its columns explains every answer, so the coefficients "
            "have no upper end; allowed: fewer columns, more answers, or a prior, as prior=1.0"
        )


def _directions(
    comparisons: Comparisons, design: NDArray[np.float64], ties: bool, order: bool
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rows that must be 0, and rows that must be 0 or more, times a direction without loss."""
    lead = design[comparisons.left] - design[comparisons.right]
    one = np.ones((len(lead), 1))
    if order:
        lead = np.hstack((lead, one))
    left, right, tied = comparisons.left_wins > 0, comparisons.right_wins > 0, comparisons.ties > 0
    if not ties:
        both = (left & right) | tied
        rising = np.vstack((lead[left & ~both], -lead[right & ~both]))
        return lead[both], rising
    wide, narrow = np.hstack((lead, one)), np.hstack((lead, -one))
    rows = (narrow[left], -wide[right], wide[tied], -narrow[tied])
    return np.zeros((0, wide.shape[1])), np.vstack(rows)


def recession(
    equal: NDArray[np.float64], rising: NDArray[np.float64]
) -> NDArray[np.float64] | None:
    """A direction without loss and with gain, its largest part 1 at most; None where there is none.

    equal, rising: float64 [row, parameter], what must be 0, and what must be 0 or more.
    """
    from scipy.optimize import linprog

    if len(rising) == 0:
        return None
    nothing: Any = None
    found = linprog(
        -rising.sum(axis=0),
        A_ub=-rising,
        b_ub=np.zeros(len(rising)),
        A_eq=equal if len(equal) else nothing,
        b_eq=np.zeros(len(equal)) if len(equal) else nothing,
        bounds=(-1, 1),
        method="highs",
    )
    return np.asarray(found.x) if found.status == 0 and -found.fun > 1e-7 else None

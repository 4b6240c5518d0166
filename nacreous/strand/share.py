"""Fair shares: every strand gets as many pearls as it has places, at the least cost in all."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.strand.form import Form

__all__ = ["shares"]

Array = NDArray[np.float64]
Pearls = NDArray[np.int64]


def shares(costs: Array, form: Form) -> list[Pearls]:
    """The pearls of each strand, int64, at the least sum of costs; exact.

    costs: [pearl, strand, step], of a pearl in a strand at a step of its form's sizes.

    Even strands: a transport problem, whose linear program has whole numbers at its corners, by
    SciPy's HiGHS. Graduated ones, with some 28 steps each: an assignment of pearls to places, by
    SciPy's shortest augmenting paths (Crouse 2016), which is quicker there.
    """
    if costs.shape[2] == 1:
        return _transported(costs[:, :, 0], form.length)
    steps = np.unique(form.above_ends_mm, return_inverse=True)[1]
    return _assigned(costs[:, :, steps])


def _transported(costs: Array, length: int) -> list[Pearls]:
    from scipy import sparse
    from scipy.optimize import linprog

    pearls, strands = costs.shape
    found = linprog(
        costs.ravel(),
        A_ub=sparse.kron(sparse.eye_array(pearls), np.ones((1, strands)), "csr"),
        b_ub=np.ones(pearls),
        A_eq=sparse.kron(np.ones((1, pearls)), sparse.eye_array(strands), "csr"),
        b_eq=np.full(strands, float(length)),
        bounds=(0, 1),  # as the rows say too, but four times as quick with it
        method="highs-ds",
    )
    if found.x is None:
        raise RuntimeError(f"no shares: {found.message}")
    chosen = found.x.reshape(pearls, strands) > 0.5
    return [np.flatnonzero(column) for column in chosen.T]


def _assigned(costs: Array) -> list[Pearls]:
    from scipy.optimize import linear_sum_assignment

    pearls, strands, places = costs.shape
    pearl, place = linear_sum_assignment(costs.reshape(pearls, strands * places))
    strand = place // places
    return [pearl[strand == number].astype(np.int64) for number in range(strands)]

"""Sort and cut: strands as they are made without a solver."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nacreous.strand.form import Form
from nacreous.strand.lot import Lot

__all__ = ["sort_and_cut"]

Pearls = NDArray[np.int64]


def sort_and_cut(lot: Lot, form: Form, strands: int) -> list[Pearls]:
    """The pearls of each strand, int64 [pearl], smallest first; those left over are the largest.

    The lot is sorted by size and cut into trays; each tray is sorted by the colour that varies
    most in it (the first principal component of L*, a*, b*) and cut again. For even strands there
    are as many trays as strands in a tray; for graduated ones a tray a step of size, of which each
    strand gets its part.
    """
    by_size = np.argsort(lot.size_mm, kind="stable")[: strands * form.length]
    if form.graduation_mm == 0:
        trays = np.array_split(np.arange(strands), math.isqrt(strands))
        cuts = [form.length * (int(tray[-1]) + 1) for tray in trays]
        return [
            strand
            for tray, numbers in zip(np.split(by_size, cuts[:-1]), trays, strict=True)
            for strand in np.split(_by_colour(lot, tray), len(numbers))
        ]
    sizes = np.unique(form.above_ends_mm, return_counts=True)[1]
    trays = np.split(by_size, np.cumsum(strands * sizes)[:-1])
    parts = [np.split(_by_colour(lot, tray), strands) for tray in trays]
    return [np.concatenate(strand) for strand in zip(*parts, strict=True)]


def _by_colour(lot: Lot, pearls: Pearls) -> Pearls:
    lab = lot.lab[pearls] - lot.lab[pearls].mean(axis=0)
    axis = np.linalg.svd(lab, full_matrices=False)[2][0]
    axis = axis * np.sign(axis[np.argmax(np.abs(axis))])  # of either sign otherwise
    return pearls[np.argsort(lab @ axis, kind="stable")]

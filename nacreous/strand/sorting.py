"""A lot sorted into strands of least differences, by a solver of fair shares."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from nacreous.number import whole_of
from nacreous.problem import InputError
from nacreous.strand.form import Form
from nacreous.strand.greedy import sort_and_cut
from nacreous.strand.lot import Lot
from nacreous.strand.matching import SIZE_WEIGHT_PER_MM, Matching, looks_apart, matching
from nacreous.strand.order import ordered
from nacreous.strand.share import shares
from nacreous.value import value_class

__all__ = ["Sorting", "Strand", "cut_lot", "require_sizes", "sort_lot"]

Array = NDArray[np.float64]
Pearls = NDArray[np.int64]

#: Shares are dealt out anew at most so often, and no more once a round gains less than this part of
#: the mean difference **(ours)**.
_ROUNDS, _LEAST_GAIN = 12, 0.003
#: Sizes are written to so many mm, and a graduation may be off by as much.
_ROUNDED_MM = 1e-5


@value_class
class Strand:
    """Pearls of a lot in the order in which they hang.

    pearls: int64 [place], which of the lot. target_mm: float64 [place], the sizes that the
    strand's form wants.
    """

    pearls: Pearls
    target_mm: Array
    matching: Matching


@value_class
class Sorting:
    """A lot's strands, best matching first, and the pearls that are left over."""

    strands: tuple[Strand, ...]
    spare: Pearls

    @property
    def score(self) -> float:
        """Mean score of the strands."""
        return float(np.mean([strand.matching.score for strand in self.strands]))


def sort_lot(
    lot: Lot,
    form: Form,
    strands: int | None = None,
    show: Callable[[float], None] | None = None,
) -> Sorting:
    """Sort a lot into as many strands as it has pearls for, or so many; the rest is left over.

    Each round asks how much every pearl differs in mean from each strand's pearls as they are, and
    deals all pearls out anew so that the sum of these is least: a linear program, solved exactly
    (`nacreous.strand.share`). The rounds begin with `sort_and_cut` and end at an arrangement that
    is best for itself; that no other is better is not known. show: is told the finished share.
    Raises `InputError`.

    >>> from nacreous.strand.population import AKOYA
    >>> lot = AKOYA.draw(60, seed=1)
    >>> sort_lot(lot, Form(20)).score < cut_lot(lot, Form(20)).score
    True
    """
    strands = _count(lot, form, strands)
    show = show or _silent
    looks = looks_apart(lot)
    show(0.1)
    best = groups = sort_and_cut(lot, form, strands)
    least = _mean(groups, lot, form, looks)
    for number in range(_ROUNDS if strands > 1 or len(lot) > form.length else 0):
        groups = shares(_costs(groups, lot, form, looks), form)
        found = _mean(groups, lot, form, looks)
        show(0.1 + 0.8 * (number + 1) / _ROUNDS)
        gain = 1 - found / least if least > 0 else 0.0
        if gain > 0:
            best, least = groups, found
        if gain < _LEAST_GAIN:
            break
    sorting = _hung(best, lot, form, lambda group: looks[np.ix_(group, group)])
    show(1.0)
    return sorting


def cut_lot(lot: Lot, form: Form, strands: int | None = None) -> Sorting:
    """A lot sorted and cut (`sort_and_cut`), to compare: each strand is ordered as well as ours."""
    strands = _count(lot, form, strands)
    groups = sort_and_cut(lot, form, strands)
    return _hung(groups, lot, form, lambda group: looks_apart(lot.take(group)))


def _silent(share: float) -> None:
    """Nobody watches."""


def require_sizes(lot: Lot, graduation_mm: float, name: str = "graduation_mm") -> None:
    """Refuse a strand whose ends and centre are further apart than any two pearls of the lot."""
    range_mm = float(np.ptp(lot.size_mm))
    if graduation_mm > range_mm + _ROUNDED_MM:
        shown_mm = math.floor(100 * range_mm + 1e-6) / 100
        raise InputError(
            f"{name} is {graduation_mm:g}; allowed: 0 to {shown_mm:g}, by which the lot's largest "
            "pearl exceeds its smallest"
        )


def _count(lot: Lot, form: Form, strands: int | None) -> int:
    require_sizes(lot, form.graduation_mm)
    most = len(lot) // form.length
    if most == 0:
        raise InputError(f"length is {form.length}; allowed: up to {len(lot)}, the lot's pearls")
    return most if strands is None else whole_of("strands", strands, 1, most)


def _off_mm(group: Pearls, lot: Lot, form: Form) -> Array:
    """Sizes of a strand's pearls, less what the form adds at their places; in the group's order."""
    off_mm = lot.size_mm[group].copy()
    off_mm[np.argsort(off_mm, kind="stable")] -= np.sort(form.above_ends_mm)
    return off_mm


def _mean(groups: list[Pearls], lot: Lot, form: Form, looks: Array) -> float:
    """Mean difference of all pairs that share a strand."""
    total = 0.0
    for group in groups:
        off_mm = SIZE_WEIGHT_PER_MM * _off_mm(group, lot, form)
        apart = looks[np.ix_(group, group)] + np.abs(off_mm[:, None] - off_mm)
        total += float(apart.sum()) / (len(group) * (len(group) - 1))
    return total / len(groups)


def _costs(groups: list[Pearls], lot: Lot, form: Form, looks: Array) -> Array:
    """Float64 [pearl, strand, step], mean difference of each pearl from each strand as it is.

    step: the form's sizes, from the ends to the centre; one of an even strand. Sizes are compared
    with the strand's own: pearl by pearl in an even one, with their median in a graduated one,
    which is near to that and quicker.
    """
    above_mm = np.unique(form.above_ends_mm)
    costs = np.empty((len(lot), len(groups), len(above_mm)))
    for number, group in enumerate(groups):
        off_mm, own_mm = lot.size_mm[:, None] - above_mm, _off_mm(group, lot, form)
        if len(above_mm) > 1:
            own_mm = np.median(own_mm, keepdims=True)
        sizes = np.abs(off_mm[:, :, None] - own_mm).mean(axis=2)
        costs[:, number] = looks[:, group].mean(axis=1)[:, None] + SIZE_WEIGHT_PER_MM * sizes
    return costs


def _hung(groups: list[Pearls], lot: Lot, form: Form, looks: Callable[[Pearls], Array]) -> Sorting:
    """The strands in order, and their matching. looks: differences of a strand's pearls' looks."""
    strands = sorted(
        (_strand(group, lot, form, looks(group)) for group in groups),
        key=lambda strand: strand.matching.score,
    )
    hung = np.concatenate([strand.pearls for strand in strands])
    return Sorting(tuple(strands), np.setdiff1d(np.arange(len(lot)), hung))


def _strand(group: Pearls, lot: Lot, form: Form, looks: Array) -> Strand:
    size_mm, apart = lot.size_mm[group], looks
    if form.graduation_mm == 0:
        apart = apart + SIZE_WEIGHT_PER_MM * np.abs(size_mm[:, None] - size_mm)
    pearls = group[ordered(apart, size_mm, form)]
    above_mm = form.above_ends_mm
    # Of few large pearls among many small ones the median alone would want ends of below 0 mm.
    smallest_mm, largest_mm = lot.size_mm.min(), lot.size_mm.max()
    ends_mm = min(np.median(lot.size_mm[pearls] - above_mm), largest_mm - form.graduation_mm)
    target_mm = above_mm + max(ends_mm, smallest_mm)
    return Strand(pearls, target_mm, matching(lot.take(pearls), target_mm))

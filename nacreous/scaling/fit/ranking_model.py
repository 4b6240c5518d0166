"""The likelihood of rankings, its slopes and its information, tray by tray.

Of a ranking (R. D. Luce, Individual Choice Behavior, 1959; R. L. Plackett, Applied Statistics 24
(1975), 193): the best is chosen from all with probability exp(u_i) / sum exp(u_j), the second so
from what is left, and so on as far as the tray was put in order. Of the best and the worst (A. A.
J. Marley, J. J. Louviere, J. Math. Psychology 49 (2005), 464, the maxdiff model): of all ordered
pairs, (b, w) with probability proportional to exp(u_b - u_w). Both are log-concave in u.

The information that is expected of a ranking before it is made is a sum over what may be left at
each choice, which is exact and takes 2^n steps for n stimuli on a tray.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.rankings import Rankings

__all__ = ["MOST_EXPECTED", "RankingModel"]

Array = NDArray[np.float64]
Index = NDArray[np.int64]

#: The largest tray whose expected information is worked out: 4096 sets of stimuli.
MOST_EXPECTED = 12
#: Numbers that are held at a time.
_NUMBERS = 1 << 22


@dataclass(frozen=True, eq=False)
class _Batch:
    """Trays of one size: their numbers, items [tray, place], and how many choices were made."""

    tray: Index
    items: Index
    choices: Index


class RankingModel:
    """Rankings as the likelihood needs them: trays of one size side by side."""

    def __init__(self, rankings: Rankings) -> None:
        self.count = len(rankings.stimuli)
        self.trays = len(rankings)
        self._of_order = rankings.task == "ranking"
        self._batches = list(_batches(rankings))

    def log_likelihood(self, values: Array, weights: Array | None = None) -> float:
        """Natural logarithm; weights: how often each tray counts, float64 [tray]."""
        weight = np.ones(self.trays) if weights is None else weights
        return float(
            sum(weight[each.tray] @ self._local(each, values)[0] for each in self._batches)
        )

    def slopes(self, values: Array, weights: Array | None = None) -> tuple[float, Array, Array]:
        """Log-likelihood, its gradient [stimulus] and the observed information, n by n."""
        weight = np.ones(self.trays) if weights is None else weights
        total, gradient = 0.0, np.zeros(self.count)
        information = np.zeros(self.count**2)
        for each in self._batches:
            found, score, told = self._local(each, values)
            own = weight[each.tray]
            total += float(own @ found)
            gradient += np.bincount(each.items.ravel(), (score * own[:, None]).ravel(), self.count)
            cell = _cells(each.items, self.count)
            information += np.bincount(
                cell.ravel(), (told * own[:, None, None]).ravel(), self.count**2
            )
        return total, gradient, information.reshape(self.count, self.count)

    def scores(self, values: Array, owner: Index, owners: int) -> Array:
        """Gradients by whoever owns a tray, owner [tray], float64 [owner, stimulus]."""
        found = np.zeros(owners * self.count)
        for each in self._batches:
            cell = owner[each.tray][:, None] * self.count + each.items
            score = self._local(each, values)[1]
            found += np.bincount(cell.ravel(), score.ravel(), len(found))
        return found.reshape(owners, self.count)

    def information(self, values: Array, owner: Index, owners: int) -> Array:
        """Observed information likewise, float64 [owner, stimulus, stimulus]."""
        found = np.zeros(owners * self.count**2)
        for each in self._batches:
            cell = owner[each.tray][:, None, None] * self.count**2 + _cells(each.items, self.count)
            told = self._local(each, values)[2]
            np.add.at(found, cell.ravel(), told.ravel())
        return found.reshape(owners, self.count, self.count)

    def expected(self, values: Array) -> Array:
        """The information expected of these trays before they are ranked, n by n."""
        if not self._of_order:  # of one choice alone it hangs on no answer
            return self.slopes(values)[2]
        found = np.zeros((self.count, self.count))
        for each in self._batches:
            if each.items.shape[1] > MOST_EXPECTED:
                raise InputError(
                    f'kind is "expected", and a tray holds {each.items.shape[1]} stimuli; allowed: '
                    f'up to {MOST_EXPECTED}, or kind="observed"'
                )
            kept = np.column_stack((np.sort(each.items, axis=1), each.choices))
            for row, times in zip(*np.unique(kept, axis=0, return_counts=True), strict=True):
                items = row[:-1]
                found[np.ix_(items, items)] += times * _expected(values[items], int(row[-1]))
        return found

    def _local(self, batch: _Batch, values: Array) -> tuple[Array, Array, Array]:
        """Of each tray the log-likelihood, gradient and information in its own places."""
        own = values[batch.items]
        return _of_orders(own, batch.choices) if self._of_order else _of_extremes(own)


def _batches(rankings: Rankings) -> Iterator[_Batch]:
    sizes, starts = rankings.sizes, rankings.starts
    for size in np.unique(sizes).tolist():
        trays = np.flatnonzero(sizes == size)
        at_once = max(1, _NUMBERS // size**2)
        for start in range(0, len(trays), at_once):
            tray = trays[start : start + at_once]
            items = rankings.items[starts[tray][:, None] + np.arange(size)]
            yield _Batch(tray, items, np.minimum(rankings.ordered[tray], size - 1))


def _cells(items: Index, count: int) -> Index:
    return np.asarray(items[:, :, None] * count + items[:, None, :])


def _of_orders(values: Array, choices: Index) -> tuple[Array, Array, Array]:
    """Plackett and Luce; values [tray, place], the best first."""
    size = values.shape[1]
    place = np.arange(size)
    rest = np.logaddexp.accumulate(values[:, ::-1], axis=1)[:, ::-1]  # ln of what is left there
    made = place < choices[:, None]
    there = made[:, :, None] & (place[None, :] >= place[:, None])
    lead = np.where(there, values[:, None, :] - rest[:, :, None], -np.inf)
    share = np.exp(lead)  # [tray, choice, place]
    taken = share.sum(axis=1)
    told = -np.swapaxes(share, 1, 2) @ share
    told[:, place, place] += taken
    return np.where(made, values - rest, 0.0).sum(axis=1), made - taken, told


def _of_extremes(values: Array) -> tuple[Array, Array, Array]:
    """Maxdiff; values [tray, place], the best first and the worst last."""
    place = np.arange(values.shape[1])
    lead = values[:, :, None] - values[:, None, :]
    lead[:, place, place] = -np.inf
    top = lead.max(axis=(1, 2))
    weight = np.exp(lead - top[:, None, None])
    total = weight.sum(axis=(1, 2))
    share = weight / total[:, None, None]  # [tray, best, worst]
    best, worst = share.sum(axis=2), share.sum(axis=1)
    expected = best - worst
    score = -expected
    score[:, 0] += 1.0
    score[:, -1] -= 1.0
    told = -share - np.swapaxes(share, 1, 2) - expected[:, :, None] * expected[:, None, :]
    told[:, place, place] += best + worst
    return values[:, 0] - values[:, -1] - top - np.log(total), score, told


def _expected(values: Array, choices: int) -> Array:
    """Of one tray: over all sets that may be left, how likely each is times what it then tells."""
    size = len(values)
    odds = np.exp(values - values.max())
    bit = 1 << np.arange(size)
    chance = np.zeros(1 << size)
    chance[-1] = 1.0
    found = np.zeros((size, size))
    for left in range(size, size - choices, -1):
        members = np.array(list(combinations(range(size), left)), np.int64)
        sets = bit[members].sum(axis=1)
        likely = chance[sets]
        held = np.zeros((len(sets), size))
        held[np.arange(len(sets))[:, None], members] = 1.0
        weight = held * odds
        share = weight / np.maximum(weight.sum(axis=1, keepdims=True), 1e-300)
        found += np.diag(likely @ share) - (share * likely[:, None]).T @ share
        without = sets[:, None] - bit[members]
        own = likely[:, None] * np.take_along_axis(share, members, axis=1)
        chance += np.bincount(without.ravel(), own.ravel(), len(chance))
    return found

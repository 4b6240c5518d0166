"""The most likely values of rankings, and the wins by which it is seen whether there are any."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.rankings import Rankings
from nacreous.scaling.fit.ranking_model import RankingModel

__all__ = ["maximum", "wins"]

Array = NDArray[np.float64]

#: Newton's steps, of which a likelihood that has a maximum needs some ten, and the last of them.
_MOST_STEPS, _SMALLEST_STEP = 200, 1e-11


def maximum(
    model: RankingModel,
    start: Array,
    weights: Array | None = None,
    leash: tuple[Array, float] | None = None,
) -> Array:
    """Where the likelihood is greatest, mean 0: Newton's steps, each halved until it helps.

    weights: how often each tray counts. leash: centre and precision of a normal prior.
    """
    values = start.copy()
    centre, precision = (start, 0.0) if leash is None else leash

    def penalised(at: Array) -> tuple[float, Array, Array]:
        total, gradient, information = model.slopes(at, weights)
        away = at - centre
        information[np.diag_indices(len(at))] += precision
        return total - precision * float(away @ away) / 2, gradient - precision * away, information

    best, gradient, information = penalised(values)
    for _ in range(_MOST_STEPS):
        if leash is None:  # the common shift, of which nothing is known
            information = information + np.trace(information) / len(values) ** 2
        step = np.linalg.solve(information, gradient)
        if np.abs(step).max() < _SMALLEST_STEP:
            break
        share = 1.0
        found = penalised(values + step)
        while found[0] < best - 1e-12 * abs(best) and share > 1e-9:
            share /= 2
            found = penalised(values + share * step)
        values, (best, gradient, information) = values + share * step, found
    return np.asarray(values - values.mean())


def wins(rankings: Rankings) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Who was put before whom: winner, loser and tray, int64 [win] each.

    Of a ranking each that was chosen is before all that were left; of best and worst the best is
    before all others, and all others are before the worst.
    """
    winners, losers, trays = [], [], []
    sizes, starts = rankings.sizes, rankings.starts
    for size in np.unique(sizes).tolist():
        tray = np.flatnonzero(sizes == size)
        items = rankings.items[starts[tray][:, None] + np.arange(size)]
        first, second = np.triu_indices(size, 1)
        if rankings.task == "ranking":
            told = first[None, :] < rankings.ordered[tray][:, None]
        else:
            told = np.broadcast_to((first == 0) | (second == size - 1), (len(tray), len(first)))
        winners.append(items[:, first][told])
        losers.append(items[:, second][told])
        trays.append(np.repeat(tray, told.sum(axis=1)))
    return np.concatenate(winners), np.concatenate(losers), np.concatenate(trays)

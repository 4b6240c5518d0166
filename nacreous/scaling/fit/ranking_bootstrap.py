"""Rankings drawn again, by people or by trays, and the scales of these samples.

As `nacreous.scaling.fit.bootstrap` says; a sample without a maximum is held by a normal prior about
the fit, 3 z wider than the whole scale.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of
from nacreous.scaling.data.rankings import Rankings
from nacreous.scaling.fit.bootstrap import (
    MOST_STUDENTISED,
    Bootstrap,
    Progress,
    drawn_by,
    samples_of,
)
from nacreous.scaling.fit.judges import require_many
from nacreous.scaling.fit.ranking_errors import errors_of, judges_of, owners_of
from nacreous.scaling.fit.ranking_maximum import maximum, wins
from nacreous.scaling.fit.ranking_model import RankingModel
from nacreous.scaling.fit.uncertainty import centred, inverse, root_of_diagonal
from nacreous.scaling.fit.unit import factor

if TYPE_CHECKING:
    from nacreous.scaling.fit.ranked_scale import RankedScale

__all__ = ["resampled"]

Array = NDArray[np.float64]
Index = NDArray[np.int64]

#: How far from the fit a sample without a maximum may lie, in z.
_LEASH = 3.0


def resampled(
    fit: RankedScale, samples: int, by: str | None, seed: int, progress: Progress | None
) -> Bootstrap:
    """The samples of a fit; see `RankedScale.bootstrap`."""
    chosen = drawn_by(by, fit.rankings.person is not None)
    samples, seed = samples_of(samples, len(fit.stimuli)), seed_of(seed)
    owner, owners = np.arange(len(fit.rankings)), len(fit.rankings)
    if chosen == "people":
        owner, owners = owners_of(fit.rankings)
        require_many(fit.stimuli, judges_of(fit.rankings), owners)
    errors = errors_of(fit, "people" if chosen == "people" else "observed")
    drawing = _Drawing(fit, owner, owners, chosen == "people")
    random = np.random.default_rng(seed)
    values, ses, unplaced = np.empty((samples, len(fit.stimuli))), [], 0
    for at in range(samples):
        times = np.bincount(random.integers(0, owners, owners), minlength=owners).astype(float)
        values[at], placed = drawing.values(times)
        unplaced += not placed
        if len(fit.stimuli) <= MOST_STUDENTISED:
            ses.append(drawing.se(values[at], times))
        if progress is not None:
            progress((at + 1) / samples)
    return Bootstrap(
        stimuli=fit.stimuli,
        unit=fit.unit,
        by=chosen,
        scale=fit.scale,
        samples=values,
        without_maximum=unplaced,
        scale_se=root_of_diagonal(errors.covariance),
        sample_se=np.array(ses) if ses else None,
    )


class _Drawing:
    """Fits to owners of trays, each counted so often."""

    def __init__(self, fit: RankedScale, owner: Index, owners: int, over_people: bool) -> None:
        self._model = RankingModel(fit.rankings)
        self._owner, self._owners, self._over_people = owner, owners, over_people
        self._centre = fit.scale
        spread = _LEASH * factor("z", "logit") + float(np.ptp(fit.scale))
        self._leash = (fit.scale, 1 / spread**2)
        self._wins = _wins_of(fit.rankings, owner)

    def values(self, times: Array) -> tuple[Array, bool]:
        """The values of a sample, and whether it has a maximum of its own."""
        placed = self._is_placed(times)
        weights = times[self._owner]
        leash = None if placed else self._leash
        return maximum(self._model, self._centre, weights, leash), placed

    def se(self, values: Array, times: Array) -> Array:
        """Standard errors of a sample: over people, or by information; the leash helps out."""
        information = self._model.slopes(values, times[self._owner])[2]
        count = len(values)
        if not self._is_placed(times):
            information[np.diag_indices(count)] += self._leash[1]
            covariance = np.asarray(np.linalg.inv(information), np.float64)
        else:
            covariance = inverse(information, count)
        if self._over_people:
            scores = self._model.scores(values, self._owner, self._owners)
            influence = scores @ covariance * np.sqrt(times)[:, None]
            covariance = influence.T @ influence * (self._owners / (self._owners - 1))
        return root_of_diagonal(centred(covariance))

    def _is_placed(self, times: Array) -> bool:
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

        winner, loser, owner = self._wins
        there = times[owner] > 0
        count = self._model.count
        graph = coo_array(
            (np.ones(int(there.sum())), (winner[there], loser[there])), shape=(count, count)
        )
        parts = connected_components(graph, directed=True, connection="strong")[0]
        return bool(parts == 1)


def _wins_of(rankings: Rankings, owner: Index) -> tuple[Index, Index, Index]:
    """Winner, loser and owner of the tray, each such triple once."""
    winner, loser, tray = wins(rankings)
    found = np.unique(np.column_stack((winner, loser, owner[tray])), axis=0)
    return found[:, 0], found[:, 1], found[:, 2]

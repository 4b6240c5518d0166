"""The errors of a scale of rankings: by information, and over people."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.rankings import Rankings
from nacreous.scaling.fit import clustering
from nacreous.scaling.fit.blocks import numbered
from nacreous.scaling.fit.clustering import Clusters
from nacreous.scaling.fit.errors import Errors, require_difference
from nacreous.scaling.fit.judges import judges_among, require_judges
from nacreous.scaling.fit.ranking_model import RankingModel
from nacreous.scaling.fit.uncertainty import centred, inverse

if TYPE_CHECKING:
    from nacreous.scaling.fit.ranked_scale import RankedScale

__all__ = ["INSTEAD", "errors_of", "judges_of", "owners_of"]

Array = NDArray[np.float64]
Index = NDArray[np.int64]

INSTEAD = 'kind="observed", which takes trays as independent'


def errors_of(fit: RankedScale, kind: str) -> Errors:
    """Errors of a kind: expected, observed or people."""
    model, count = RankingModel(fit.rankings), len(fit.stimuli)
    values = np.eye(count) - 1 / count
    if kind == "expected":
        return Errors(centred(inverse(model.expected(fit.scale), count)), None, values)
    observed = inverse(model.slopes(fit.scale)[2], count)
    if kind == "observed":
        return Errors(centred(observed), None, values)
    found = _clusters(fit, model, observed)
    covariance = centred(found.covariance)
    require_difference(fit.stimuli, covariance, centred(observed), INSTEAD)
    return Errors(covariance, found, values)


def owners_of(rankings: Rankings) -> tuple[Index, int]:
    """Who ranked each tray, int64 [tray], numbered from 0, and how many people there are."""
    if rankings.person is None:
        raise InputError("it is not known who ranked the trays; allowed: rankings with people")
    here, owner = numbered(rankings.person, len(rankings.people))
    return owner, len(here)


def judges_of(rankings: Rankings) -> Index:
    """How many people judged each stimulus, int64 [stimulus]."""
    owner, _ = owners_of(rankings)
    shown = (np.repeat(owner, rankings.sizes), [rankings.items])
    return judges_among(len(rankings.stimuli), *shown)


def _clusters(fit: RankedScale, model: RankingModel, observed: Array) -> Clusters:
    """People behind a fit; what each is expected to tell is what was observed **(ours)**.

    It adds up to the whole, as CR2 wants it; what is expected of each would need a sum over all
    orders of every tray.
    """
    owner, people = owners_of(fit.rankings)
    require_judges(fit.stimuli, judges_of(fit.rankings), people, INSTEAD)
    scores = model.scores(fit.scale, owner, people)
    if _is_equal(fit.rankings, owner, people) or clustering.too_many(people, model.count):
        return clustering.of_scores(scores, (observed, observed), people - 1.0, None, INSTEAD)
    seen = model.information(fit.scale, owner, people)
    return clustering.of_scores(scores, (observed, observed), None, seen, INSTEAD)


def _is_equal(rankings: Rankings, owner: Index, people: int) -> bool:
    """Whether all people had the same trays, each as often, and put as many in order."""
    asked: list[list[tuple[int, ...]]] = [[] for _ in range(people)]
    items, ordered = rankings.items.tolist(), rankings.ordered.tolist()
    starts, sizes = rankings.starts.tolist(), rankings.sizes.tolist()
    for tray, who in enumerate(owner.tolist()):
        own = items[starts[tray] : starts[tray] + sizes[tray]]
        asked[who].append((ordered[tray], *sorted(own)))
    first = sorted(asked[0])
    return all(sorted(each) == first for each in asked)

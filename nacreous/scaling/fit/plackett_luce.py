"""The scale of rankings: Plackett and Luce's, and of best and worst the maxdiff model's."""

from __future__ import annotations

import numpy as np

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.rankings import Rankings
from nacreous.scaling.fit.existence import pair_model, require_maximum
from nacreous.scaling.fit.ranked_scale import RankedScale
from nacreous.scaling.fit.ranking_maximum import maximum, wins
from nacreous.scaling.fit.ranking_model import RankingModel

__all__ = ["MOST_STIMULI", "plackett_luce"]

#: Beyond, matrices of stimuli by stimuli take longer than anyone waits.
MOST_STIMULI = 1000


def plackett_luce(rankings: Rankings) -> RankedScale:
    """The most likely scale of rankings in logit, mean 0.

    Of a ranking each next one is chosen from what is left with probability exp(u_i) / sum exp(u_j)
    (Luce 1959, Plackett 1975); of two stimuli that is Bradley and Terry's model. Of best and worst
    the pair (b, w) is chosen with probability proportional to exp(u_b - u_w) (maxdiff, Marley and
    Louviere 2005), which takes both choices as one and treats best and worst alike; of two stimuli
    a is then best with probability 1 / (1 + exp(-2 (u_a - u_b))).

    There is a maximum if, and only if, in every split of the stimuli in two some one of each part
    was put before some one of the other (Hunter 2004). Raises `InputError` elsewhere, naming what
    cannot be placed, and beyond 1000 stimuli.

    >>> from nacreous.scaling import Rankings
    >>> fit = plackett_luce(Rankings.of_lists([["a", "b", "c"], ["a", "c", "b"], ["b", "a", "c"]]
    ...                                       + [["c", "a", "b"]]))
    >>> fit.ranking, fit.scale.round(3).tolist()  # a over b by ln(1 + root of 5)
    (('a', 'b', 'c'), [0.783, -0.391, -0.391])
    """
    if not isinstance(rankings, Rankings):
        raise InputError(
            f"the rankings are {said(rankings)}; allowed: Rankings, as Rankings.of_lists makes them"
        )
    if len(rankings.stimuli) > MOST_STIMULI:
        raise InputError(f"{len(rankings.stimuli)} stimuli; allowed: at most {MOST_STIMULI}")
    comparisons = _comparisons(rankings)
    require_maximum(comparisons, pair_model(comparisons, "logit"), remedy="")
    model = RankingModel(rankings)
    values = maximum(model, np.zeros(model.count))
    return RankedScale(rankings.stimuli, values, rankings, model.log_likelihood(values))


def _comparisons(rankings: Rankings) -> Comparisons:
    """Every win as an answer about a pair: enough to see which stimuli can be placed."""
    winner, loser, _ = wins(rankings)
    outcome = np.ones(len(winner), np.int8)
    return Comparisons.of_outcomes(rankings.stimuli, winner, loser, outcome, sided=False)

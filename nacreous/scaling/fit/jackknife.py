"""People left out one by one: how far each of them moves a scale of least squares.

The values are an explicit function of the counts, so that leaving a person out is quick and exact
(J. W. Tukey, Annals of Mathematical Statistics 29, 1958). Degrees of freedom are Satterthwaite's,
with people's shares of the variance as independent answers would have them, less the one that goes
with their mean: people less one where all answered the same pairs.
"""

from __future__ import annotations

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.fit.blocks import Array, Blocks, Index, blocks_of
from nacreous.scaling.fit.existence import islands
from nacreous.scaling.fit.judges import INSTEAD, require_people
from nacreous.scaling.fit.row_means import projection, z_of_pairs, z_variance
from nacreous.value import value_class

__all__ = ["LeftOut", "left_out"]

#: Numbers of contrasts and pairs that are held at a time.
_NUMBERS = 1 << 22


@value_class
class LeftOut:
    """What leaving each person out does to the values of a scale, in z.

    influence  float64 [person, stimulus]; its squares sum to the covariance
    operator   float64 [stimulus, pair]: from z of pairs to values
    pair, person, share  [block], where a person answered a pair: indices, and the person's share of
               the variance of the pair's z, as independent answers have it
    """

    influence: Array
    operator: Array
    pair: Index
    person: Index
    share: Array

    @property
    def covariance(self) -> Array:
        """float64 [stimulus, stimulus]."""
        return np.asarray(self.influence.T @ self.influence)

    def freedom(self, contrasts: Array) -> Array:
        """Degrees of freedom of the variance of contrasts [k, stimulus], float64 [k]; 1 or more."""
        from scipy.sparse import csr_array  # which takes a while to import

        size = (self.operator.shape[1], len(self.influence))
        shares = csr_array((self.share, (self.pair, self.person)), size)
        at_once = max(1, _NUMBERS // self.operator.shape[1])
        found = [np.zeros(0)]
        for at in range(0, len(contrasts), at_once):
            each = ((contrasts[at : at + at_once] @ self.operator) ** 2) @ shares
            squares = (each**2).sum(axis=1)
            safe = np.where(squares > 0, squares, 1.0)
            degrees = np.where(squares > 0, each.sum(axis=1) ** 2 / safe, len(self.influence)) - 1
            found.append(np.maximum(degrees, 1.0))
        return np.concatenate(found)


def left_out(answers: Answers | None) -> LeftOut:
    """Each person left out, of three or more for each stimulus; raises `InputError` for fewer."""
    blocks = blocks_of(require_people(answers))
    count = len(blocks.first)
    total: Array = np.asarray(np.bincount(blocks.pair, blocks.answers, count), np.float64)
    chosen: Array = np.asarray(np.bincount(blocks.pair, blocks.chosen, count), np.float64)
    pairs = _counted(blocks, chosen, total)
    operator, z = projection(pairs), z_of_pairs(pairs)
    people, stimuli = len(blocks.people), len(blocks.stimuli)
    ends = np.searchsorted(blocks.person, np.arange(people + 1))
    influence = np.empty((people, stimuli))
    for at in range(people):
        own = slice(ends[at], ends[at + 1])
        pair = blocks.pair[own]
        less, without = total.copy(), chosen.copy()
        less[pair] -= blocks.answers[own]
        without[pair] -= blocks.chosen[own]
        if less[pair].all():
            some = _counted(blocks, without[pair], less[pair], pair)
            influence[at] = operator[:, pair] @ (z_of_pairs(some) - z[pair])
        else:
            influence[at] = _values(blocks, without, less) - operator @ z
    share = blocks.answers * (z_variance(pairs, z) / total)[blocks.pair]
    influence *= np.sqrt((people - 1) / people)
    return LeftOut(influence, operator, blocks.pair, blocks.person, share)


def _values(blocks: Blocks, chosen: Array, total: Array) -> Array:
    """Values of the pairs that are still answered, which must join all stimuli."""
    kept = np.flatnonzero(total)
    pairs = _counted(blocks, chosen[kept], total[kept], kept)
    if islands(pairs).max() > 0:
        raise InputError(
            "the answers of 1 person alone join some stimuli to the others, so that it is not "
            f"known how people differ there; allowed: more people for them, or {INSTEAD}"
        )
    return np.asarray(projection(pairs) @ z_of_pairs(pairs))


def _counted(
    blocks: Blocks, chosen: Array, total: Array, pair: Index | slice = slice(None)
) -> Comparisons:
    """Counts of some pairs, a tie counting half for each."""
    first, second = blocks.first[pair], blocks.second[pair]
    none = np.zeros(len(total))
    return Comparisons(blocks.stimuli, first, second, chosen, total - chosen, none, sided=False)

"""The two ways round in which a pair may stand, and what its answers say of the side."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.answers import Answers
from nacreous.scaling.distribution import chi2
from nacreous.scaling.fit.blocks import numbered
from nacreous.value import value_class


@value_class
class WaysRound:
    """Answers with a choice, by pair and by which of it stood on the left.

    - `shown`, `chosen`: int64 [pair, 2], answers with the first or the second of a pair on the
      left, and how many of them chose the first
    - `both`: bool [answer], whether its pair stood both ways round
    - `expected`: float64 [answer], how often the left one would be chosen if the side did nothing:
      the share of the pair, both ways round with equal weight
    """

    shown: NDArray[np.int64]
    chosen: NDArray[np.int64]
    both: NDArray[np.bool_]
    expected: NDArray[np.float64]

    def exchanged(self, deviations: float) -> bool:
        """Whether pairs stood either way as often as by tossed coins, within some deviations.

        False where no pair stood both ways, about which nothing can be known.
        """
        from scipy.special import gammaln

        if not self.both.any():
            return False
        count = self.shown.sum(axis=1)
        half = count // 2
        # Mean distance from 0 of a walk of so many steps.
        choices = gammaln(2 * half + 1) - 2 * gammaln(half + 1) - 2 * half * np.log(2)
        mean = count * np.exp(choices)
        variance = np.maximum(count - mean**2, 0.0)
        ahead = np.abs(self.shown[:, 0] - self.shown[:, 1])
        return bool(ahead.sum() <= mean.sum() + deviations * np.sqrt(variance.sum()))

    @property
    def p_value(self) -> float | None:
        """Mantel and Haenszel's test, corrected for continuity; None where no pair tells."""
        count, first = self.shown.sum(axis=1), self.chosen.sum(axis=1)
        expected = self.shown[:, 0] * first / count
        spread = self.shown[:, 0] * self.shown[:, 1] * first * (count - first)
        variance = float(np.sum(spread / (count**2 * np.maximum(count - 1.0, 1.0))))
        if variance == 0:
            return None
        gap = max(0.0, abs(float(np.sum(self.chosen[:, 0] - expected))) - 0.5)
        return float(chi2.sf(gap**2 / variance, 1))


def ways_round(answers: Answers) -> WaysRound:
    """The ways round of answers that all have a choice."""
    low = np.minimum(answers.left, answers.right)
    high = np.maximum(answers.left, answers.right)
    count = len(answers.stimuli)
    pairs, pair = numbered(low * count + high, count**2)
    way = (answers.left > answers.right).astype(np.int64)
    chose_first = (answers.outcome == 1) == (way == 0)
    cell, cells = 2 * pair + way, 2 * len(pairs)
    shown = np.bincount(cell, minlength=cells).reshape(-1, 2)
    chosen = np.bincount(cell[chose_first], minlength=cells).reshape(-1, 2)
    share = (chosen / np.maximum(shown, 1)).mean(axis=1)
    return WaysRound(
        shown=shown,
        chosen=chosen,
        both=np.all(shown > 0, axis=1)[pair],
        expected=np.where(way == 0, share[pair], 1 - share[pair]),
    )

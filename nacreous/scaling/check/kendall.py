"""How far people agree: Kendall's u.

M. G. Kendall and B. Babington Smith, On the method of paired comparisons, Biometrika 31 (1940).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.given import counted
from nacreous.scaling.distribution import chi2
from nacreous.scaling.fit.blocks import Array, Blocks, blocks_of
from nacreous.value import value_class

#: Up to so many people every way to turn some of them round is tried, beyond it so many by lot.
_MOST_TRIED, _TURNS, _LEAST_TURNS = 10, 999, 99
#: Numbers turned at a time, and in all.
_AT_ONCE, _MOST_TURNED = 1 << 22, 200_000_000


@value_class
class Agreement:
    """Kendall's coefficient of agreement and its test.

    - `u`: 1 where all gave the same answers, about 0 where they answered at random; `least` is
      below all that so many answers can have. Where people are known, only answers of different
      people are held together: that someone agrees with themselves is no agreement
    - `p_value`: without people, against tossing coins. With people, against people with nothing in
      common, each of whom might as well have answered everything the other way round, however much
      their own answers hang together
    - `statistic`, `df`: without people, chi-squared, corrected for continuity where every pair has
      the same number of answers (Kendall's); otherwise (`equal` is False) the sum over pairs of
      (wins - losses)² / answers, with as many degrees of freedom as pairs. With people None
    - `pairs`, `answers`, `people`: how many were used; people 0 where they are not known
    - `ties`: the share of all answers that are ties, which say neither and are left out
    """

    u: float
    least: float
    statistic: float | None
    df: float | None
    p_value: float
    equal: bool
    pairs: int
    answers: float
    people: int
    ties: float

    @property
    def least_p_value(self) -> float:
        """The smallest there can be: with few people even full agreement may be chance."""
        return 0.5 ** (self.people - 1) if self.people else 0.0


def agreement(data: Any) -> Agreement:
    """Kendall's u of whatever `comparisons_of` takes; between people where `Answers` know them.

    Pairs with one answer, or of one person, say nothing about agreement and do not count. Raises
    `InputError` where no pair has two.

    >>> round(agreement([("a", "b"), ("a", "b"), ("b", "a")]).u, 3)
    -0.333
    """
    answers, comparisons = counted(data)
    counts = comparisons.unsided()
    ties = float(counts.ties.sum() / max(counts.total, 1e-300))
    if answers is not None and answers.person is not None:
        return _between_people(answers, ties)
    return _between_answers(counts, ties)


def _between_answers(counts: Comparisons, ties: float) -> Agreement:
    total = counts.left_wins + counts.right_wins
    used = total >= 2
    if not used.any():
        raise InputError("no pair has two answers without a tie; allowed: 2 or more, to agree on")
    total, wins = total[used], counts.left_wins[used]
    losses = total - wins
    agreeing = float(np.sum(wins * (wins - 1) + losses * (losses - 1)) / 2)
    possible = float(np.sum(total * (total - 1)) / 2)
    half = np.floor(total / 2)
    fewest = float(np.sum(half * (half - 1) + (total - half) * (total - half - 1)) / 2)
    pairs, each = len(total), float(total[0])
    equal = bool(np.all(total == each)) and each > 2
    if equal:
        df = pairs * each * (each - 1) / (each - 2) ** 2
        excess = agreeing - 1 - possible / 2 * (each - 3) / (each - 2)
        statistic = max(0.0, 4 / (each - 2) * excess)
    else:
        df = float(pairs)
        statistic = float(np.sum((wins - losses) ** 2 / total))
    return Agreement(
        u=2 * agreeing / possible - 1,
        least=2 * fewest / possible - 1,
        statistic=statistic,
        df=df,
        p_value=float(chi2.sf(statistic, df)),
        equal=equal,
        pairs=pairs,
        answers=float(total.sum()),
        people=0,
        ties=ties,
    )


def _between_people(answers: Answers, ties: float) -> Agreement:
    """Products of the answers of different people to the same pair, over those there can be."""
    decided = answers.decided()
    blocks = blocks_of(decided) if len(decided) else None
    possible = 0.0
    if blocks is not None:
        total = np.bincount(blocks.pair, blocks.answers)
        own = np.bincount(blocks.pair, blocks.answers**2)
        possible = float(np.sum(total**2 - own))
    if blocks is None or possible == 0:
        raise InputError(
            "no pair has answers by two people without a tie; allowed: 2 people or more, to agree"
        )
    used = total**2 > own
    net = 2 * blocks.chosen - blocks.answers
    between = float((np.bincount(blocks.pair, net) ** 2).sum() - (net**2).sum())
    return Agreement(
        u=between / possible,
        least=float(np.sum(total[used] % 2 - own[used])) / possible,
        statistic=None,
        df=None,
        p_value=_turned(blocks, net),
        equal=bool(np.ptp(total[used]) == 0),
        pairs=int(used.sum()),
        answers=float(total[used].sum()),
        people=len(blocks.people),
        ties=ties,
    )


def _turned(blocks: Blocks, net: Array) -> float:
    """How often people turned round at random agree as well as they do."""
    from scipy.sparse import csr_array

    people, pairs = len(blocks.people), len(blocks.first)
    table = csr_array((net, (blocks.pair, blocks.person)), shape=(pairs, people))
    true = float((table.sum(axis=1) ** 2).sum())
    signs = _signs(people, len(net))
    at_once, as_well = max(1, _AT_ONCE // pairs), 0
    for start in range(0, len(signs), at_once):
        turned = table @ signs[start : start + at_once].T
        as_well += int(((turned**2).sum(axis=0) >= true * (1 - 1e-9)).sum())
    if people <= _MOST_TRIED:
        return as_well / len(signs)
    return (1 + as_well) / (1 + len(signs))


def _signs(people: int, answers: int) -> Array:
    """float64 [turn, person], 1 or -1; all that differ, the first person held, or some by lot."""
    if people <= _MOST_TRIED:
        ways = np.arange(2 ** (people - 1))
        return np.asarray(1.0 - 2.0 * ((ways[:, None] >> np.arange(people)) & 1), np.float64)
    turns = max(_LEAST_TURNS, min(_TURNS, _MOST_TURNED // answers))
    return np.random.default_rng(1).choice([-1.0, 1.0], (turns, people))

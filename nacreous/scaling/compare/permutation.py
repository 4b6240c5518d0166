"""People dealt anew to groups: how far groups differ that differ by chance alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.compare.estimate import names_of
from nacreous.scaling.compare.restricted import Restricted
from nacreous.scaling.data.answers import Answers

__all__ = ["permutation_test"]

Array = NDArray[np.float64]

#: Random numbers at a time: 2 MB of them.
_AT_ONCE = 1 << 18


def permutation_test(
    groups: Mapping[str, Answers],
    alike: Restricted,
    permutations: int,
    same_people: bool,
    seed: int,
) -> tuple[float, float]:
    """Rao's score statistic of the hypothesis that groups are alike, and its p value.

    Where groups share what `alike` says, the slopes of the log-likelihood by it sum to zero over
    all people; over the people of one group they do so up to chance. The statistic is the sum over
    groups of S' J^-1 S (people / people of the group), S the group's slopes, J the information of
    all answers; with equal shares of answers that is Rao's (1948), to first order the likelihood
    ratio. Nothing is fitted anew for another deal, so thousands cost milliseconds. Slopes are
    efficient ones: what a group has of its own, a width of ties or a pull of the side, is out.

    Exact for people who are exchangeable between groups (Fisher 1935), where groups have nothing of
    their own, and nearly so elsewhere (docs/people.md): those of one group only are dealt among
    themselves; whoever is in several groups has these exchanged within.
    """
    asked, group, stratum = _blocks(groups, alike, same_people)
    shares = np.bincount(group) / len(group)
    statistic = _statistics(asked, group[np.newaxis], shares)[0]
    as_far = 0
    for dealt in _deals(group, stratum, permutations, np.random.default_rng(seed)):
        # A deal that repeats the true one must count, whatever rounding says.
        as_far += int((_statistics(asked, dealt, shares) >= statistic * (1 - 1e-9)).sum())
    return float(statistic), (1 + as_far) / (1 + permutations)


def _blocks(
    groups: Mapping[str, Answers], alike: Restricted, same_people: bool
) -> tuple[Array, NDArray[np.int64], NDArray[np.int64]]:
    """Slopes in units of their errors, group and stratum of each block of answers.

    A block is what one person answered in one group. Blocks exchange groups within their stratum.
    """
    parts: list[Array] = []
    codes: list[int] = []
    names: list[str] = []
    for code, (name, answers) in enumerate(groups.items()):
        parts.append(alike.slopes(name, answers))
        codes += [code] * len(parts[-1])
        names += names_of(answers)
    values, vectors = np.linalg.eigh(alike.covariance)
    asked = np.vstack(parts) @ (vectors * np.sqrt(np.maximum(values, 0.0)))
    return asked, np.array(codes), _strata(names, same_people)


def _strata(names: list[str], same_people: bool) -> NDArray[np.int64]:
    """0 for people of one group only; a number of their own for people of several."""
    if not same_people:
        return np.zeros(len(names), np.int64)
    _, number, count = np.unique(names, return_inverse=True, return_counts=True)
    return np.where(count[number] > 1, number + 1, 0).astype(np.int64)


def _deals(
    group: NDArray[np.int64],
    stratum: NDArray[np.int64],
    permutations: int,
    random: np.random.Generator,
) -> Iterator[NDArray[np.int64]]:
    """Groups dealt anew within strata, int64 [deal, block], as many at a time as memory bears."""
    by_stratum = np.argsort(stratum, kind="stable")
    lots = stratum[by_stratum].astype(np.float64)
    at_once = max(1, _AT_ONCE // len(group))
    for start in range(0, permutations, at_once):
        count = min(at_once, permutations - start)
        order = np.argsort(lots + random.random((count, len(group))), axis=1)
        dealt = np.empty((count, len(group)), np.int64)
        dealt[:, by_stratum] = group[by_stratum][order]
        yield dealt


def _statistics(asked: Array, dealt: NDArray[np.int64], shares: Array) -> Array:
    statistics = np.zeros(len(dealt))
    for code, share in enumerate(shares):
        sums = (dealt == code).astype(np.float64) @ asked
        statistics += (sums * sums).sum(axis=1) / share
    return statistics

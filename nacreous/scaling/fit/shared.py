"""Do all people share one scale? Their answers dealt anew to each other, pair by pair."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from nacreous._core import spread_of_people
from nacreous.number import seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.given import answers_of
from nacreous.scaling.fit.blocks import Array, Blocks, blocks_of
from nacreous.scaling.fit.case_v import thurstone
from nacreous.scaling.fit.own_side import with_own_sides
from nacreous.scaling.fit.own_ties import choosing, with_own_ties
from nacreous.value import value_class

__all__ = ["MOST_STIMULI", "SharedScale", "shared_scale"]

#: Beyond, matrices of stimuli by stimuli take longer than anyone waits.
MOST_STIMULI = 500
#: A difference below this share of the whole is rounding.
_NOTHING = 1e-9
#: Beyond this spread of own values, in z, people have hardly anything in common **(ours)**:
#: of two stimuli that stand alike for all, each tells them apart like 84 of 100 answers.
_GROSS = 1.0
#: Such a share of studies finds what is called detectable.
_MOSTLY = 0.8
#: Spreads of own values that are looked at, in z, and how often the range is halved: to 2 in 100.
_OWN_VALUES, _HALVINGS = (0.05, 5.0), 8
#: So many people with values of their own are drawn; fewer where each answered so many pairs that
#: theirs are more in all, of which each then tells as much more.
_DRAWN, _LEAST_DRAWN, _MOST_BLOCKS = 1000, 100, 200_000
#: Standard deviations below 0 beyond which 1 of 100 tossing coins would be called reversed.
_REVERSED = -2.326

Progress = Callable[[float], None]


@value_class
class SharedScale:
    """Whether people share one scale, as `shared_scale` tested it.

    - `people`, `permutations`: how many chose something, and how often answers were dealt anew
    - `p_value`: how often people who share one scale differ as much; least 1 / (permutations + 1)
    - `z`: by how many standard deviations of the dealt ones the true people differ more
    - `sharper_p_value`: the same for the part of the differences that lies along the scale of all:
      some people tell the stimuli apart more sharply than others, or **the other way round**
    - `order_p_value`: the same for the part across it: people have other orders or distances
    - `reversed`: people who chose against the scale of all more than 99 of 100 coin-tossers would
    - `detectable`: the standard deviation, in z, of values of people's own that about 80 of 100
      such studies would find at p < .05; the fewer answers a person, the larger
    """

    people: int
    permutations: int
    p_value: float
    z: float
    sharper_p_value: float
    order_p_value: float
    reversed: tuple[str, ...]
    detectable: float

    @property
    def tells(self) -> bool:
        """Whether people with hardly anything in common would mostly be found: 1 z or less."""
        return self.detectable <= _GROSS

    def differ(self, level: float = 0.95) -> bool:
        """Whether people differ by more than chance, at a level."""
        return self.p_value < 1 - level

    def verdict(self, level: float = 0.95) -> str:
        """What was found, in a line.

        >>> import nacreous as nc
        >>> own = nc.scaling.simulate([0.8, 0.0, -0.8], people=60, person_spread=1.0, seed=1)
        >>> nc.scaling.shared_scale(own).verdict()
        'people do not share one scale, p 0.007 (other orders)'
        """
        if not self.differ(level) and not self.tells:
            return (
                "these answers cannot tell whether people share one scale: even own values with a "
                "standard deviation of 1 z would often go unnoticed"
            )
        if not self.differ(level):
            return f"nothing says that people do not share one scale, p {self.p_value:.2g}"
        ways = ["other orders"] if self.order_p_value < 1 - level else []
        ways += ["sharper, or the other way round"] if self.sharper_p_value < 1 - level else []
        way = f" ({'; '.join(ways)})" if ways else ""
        return f"people do not share one scale, p {self.p_value:.3g}{way}"


def shared_scale(
    answers: Any, permutations: int = 999, seed: int = 1, progress: Progress | None = None
) -> SharedScale:
    """Test whether all people judge by one scale, by dealing answers anew within each pair.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.
    The statistic is the sum over people of g' V^-1 g, with g the slopes of a person's answers
    against the shares of all people, and V their covariance where answers are dealt at random.
    Products of a person's answers to the same pair are left out, and such answers are dealt
    together: that people remember what they said is no scale of their own. The test is exact for
    any number of people, with ties, repeats, missing pairs and pairs of one's own, under no model
    of choice; only where it is split does a scale of all people tell along from across. Whoever
    said tie alone is left out. Where people differ in how often they tie by more than chance, each
    is held against what all give at the person's own width of ties, and where pairs stood both ways
    round, at the person's own pull of the side; the test is then nearly exact. Where pairs always
    stood one way round such a pull looks like another order.

    permutations: 99 to 1 000 000; seed: 0 to 2^63 - 1, the same seed deals alike. progress: called
    with the finished share, 0 to 1, now and then. Raises `InputError` where people are unknown,
    where nobody chose anything, where no two answered the same pair, where all agree on every pair,
    where nobody answered two pairs that can be dealt, and beyond 500 stimuli.

    >>> import nacreous as nc
    >>> alike = nc.scaling.simulate([1.0, 0.0, -1.0], people=40, seed=3)
    >>> nc.scaling.shared_scale(alike).differ()
    False
    """
    whole_of("permutations", permutations, 99, 1_000_000)
    seed = seed_of(seed)
    answers = answers_of(answers)
    choosers = choosing(answers)
    if len(choosers) == 0:
        raise InputError(
            "all answers are ties; allowed: people of whom two or more chose something"
        )
    blocks = with_own_sides(with_own_ties(blocks_of(choosers), drawn_in=True))
    if len(blocks.stimuli) > MOST_STIMULI:
        raise InputError(f"{len(blocks.stimuli)} stimuli; allowed: at most {MOST_STIMULI}")
    leads = blocks.leads(thurstone(choosers, prior=1.0).scale)
    metric = _along_first(blocks, leads)
    true, dealt, size = _dealt(blocks, metric, permutations, seed, progress)
    spread = float(dealt[:, 0].std())
    if spread <= _NOTHING * size:
        raise InputError(
            "nobody answered two pairs that others answered in other ways, so that no one's own "
            "answers can be held together; allowed: people who answered several pairs, some of "
            "them the same"
        )
    # Whole, along, across; a deal that repeats the true one must count, whatever rounding says.
    p_values = (1 + (dealt >= true - _NOTHING * size).sum(axis=0)) / (1 + permutations)
    return SharedScale(
        people=len(blocks.people),
        permutations=permutations,
        p_value=float(p_values[0]),
        z=float((true[0] - dealt[:, 0].mean()) / spread),
        sharper_p_value=float(p_values[1]),
        order_p_value=float(p_values[2]),
        reversed=_reversed(blocks, leads),
        detectable=_detectable(blocks, metric, leads, float(np.quantile(dealt[:, 0], 0.95))),
    )


def _dealt(
    blocks: Blocks, metric: Array, permutations: int, seed: int, progress: Progress | None
) -> tuple[Array, Array, float]:
    """The statistic as people are, [3], and of each deal, [deal, 3]: whole, along and across.

    The third is how much there is to deal. Squares of single residuals, which are no product of
    two answers, are taken off at once: dealing within a pair does not change their sum.
    """
    order = np.lexsort((blocks.person, blocks.answers, blocks.pair))
    pair, count = blocks.pair[order], blocks.answers[order]
    value = blocks.residual[order]
    ends = np.append(np.flatnonzero((np.diff(pair) != 0) | (np.diff(count) != 0)) + 1, len(order))
    starts = np.append(0, ends[:-1])
    apart = np.maximum.reduceat(value, starts) - np.minimum.reduceat(value, starts)
    if (apart <= _NOTHING).all():
        raise InputError(
            "no two people answered the same pair in different ways; "
            "allowed: pairs that two or more people answered, and not all alike"
        )
    stimuli = np.column_stack((blocks.first, blocks.second))[pair[starts]]
    show = None if progress is None else lambda done: progress(done / permutations)
    sums = spread_of_people(
        len(blocks.people),
        stimuli,
        ends,
        blocks.person[order],
        value,
        np.ascontiguousarray(metric),
        permutations,
        seed,
        show,
    )
    squares = (
        np.bincount(blocks.pair, blocks.residual**2, len(blocks.first))
        @ (metric[blocks.first] - metric[blocks.second]) ** 2
    )
    found = sums - (squares.sum(), squares[0])
    found = np.column_stack((found, found[:, 0] - found[:, 1]))
    return found[0], found[1:], float(squares.sum())


def _detectable(blocks: Blocks, metric: Array, leads: Array, critical: float) -> float:
    """The spread of people's own values, in z, from which 80 of 100 studies exceed critical.

    People with values of their own are drawn and answer; what they add to the statistic, each
    alike, makes its mean and spread in a study, and so the share of studies beyond (ours).
    """
    people = len(blocks.people)
    most = min(_DRAWN, max(_LEAST_DRAWN, _MOST_BLOCKS * people // len(blocks.person)))
    drawn = np.linspace(0, people - 1, min(people, most)).astype(np.int64)
    rows = np.flatnonzero(np.isin(blocks.person, drawn))
    times = max(1, most // people)
    person = np.searchsorted(drawn, np.tile(blocks.person[rows], times))
    person += len(drawn) * np.repeat(np.arange(times), len(rows))
    each = replace(
        blocks,
        people=("",) * (times * len(drawn)),
        person=person,
        pair=np.tile(blocks.pair[rows], times),
        answers=np.tile(blocks.answers[rows], times),
        width=None if blocks.width is None else np.tile(blocks.width[drawn], times),
        expected=None,
    )
    drawn_of = (people, len(drawn), critical)
    low, high = _OWN_VALUES
    if _found(each, metric, leads, high, *drawn_of) < _MOSTLY:
        return np.inf
    for _ in range(_HALVINGS):
        middle = float(np.sqrt(low * high))
        if _found(each, metric, leads, middle, *drawn_of) < _MOSTLY:
            low = middle
        else:
            high = middle
    return high


def _found(
    blocks: Blocks,
    metric: Array,
    leads: Array,
    spread: float,
    people: int,
    drawn: int,
    critical: float,
) -> float:
    """The share of studies of so many people, whose own values spread so, beyond critical.

    drawn: how many of the people are in the blocks, once or again and again.
    """
    from scipy.special import ndtr

    random = np.random.default_rng(1)
    count, stimuli = len(blocks.people), len(blocks.stimuli)
    first, second = blocks.first[blocks.pair], blocks.second[blocks.pair]
    own = random.standard_normal((count, stimuli)) * spread
    # Wider by as much as own values blur it, so that people together choose as these do.
    lead = leads[blocks.pair] * np.sqrt(1 + 2 * spread**2)
    lead = lead + own[blocks.person, first] - own[blocks.person, second]
    width = 0.0 if blocks.width is None else blocks.width[blocks.person]
    asked = blocks.answers.astype(np.int64)
    won = random.binomial(asked, ndtr(lead - width))
    tied = ndtr(width - lead) - ndtr(-width - lead)
    # Of what was not won, a tie or lost.
    tied = random.binomial(
        asked - won, np.clip(tied / np.maximum(ndtr(width - lead), 1e-300), 0.0, 1.0)
    )
    moved = replace(blocks, chosen=won + tied / 2).residual
    slopes = np.bincount(blocks.person * stimuli + first, moved, own.size)
    slopes -= np.bincount(blocks.person * stimuli + second, moved, own.size)
    lengths = ((metric[blocks.first] - metric[blocks.second]) ** 2).sum(axis=1)
    added = ((slopes.reshape(own.shape) @ metric) ** 2).sum(axis=1)
    added -= np.bincount(blocks.person, moved**2 * lengths[blocks.pair], count)
    # Studies like this one have the same people's designs: only within a design is chance.
    each = added.reshape(-1, drawn)
    varied = each.var(axis=0, ddof=1).mean() if len(each) > 1 else added.var()
    error = float(np.sqrt(varied * people))
    return float(ndtr((added.mean() * people - critical) / max(error, 1e-300)))


def _along_first(blocks: Blocks, leads: Array) -> Array:
    """The metric turned so that its first axis is the way in which sharper people differ.

    Of people whose values are s times those of all, the share of a pair changes with ln s by lead
    times phi(lead).
    """
    metric = blocks.metric()
    asked = np.bincount(blocks.pair, blocks.answers, len(leads))
    change = asked * leads * np.exp(-(leads**2) / 2)
    slopes = np.zeros(len(blocks.stimuli))
    np.add.at(slopes, blocks.first, change)
    np.add.at(slopes, blocks.second, -change)
    along = metric.T @ slopes
    size = np.linalg.norm(along)
    if size == 0:
        return metric
    turn, _ = np.linalg.qr(np.column_stack([along / size, np.eye(len(along))]))
    return np.asarray(metric @ turn)


def _reversed(blocks: Blocks, leads: Array) -> tuple[str, ...]:
    """People who choose against the scale of all: against tosses of a coin, 1 of 100 would."""
    lead, count = leads[blocks.pair], len(blocks.people)
    gain = np.bincount(blocks.person, (blocks.chosen - blocks.answers / 2) * lead, count)
    error = np.sqrt(np.bincount(blocks.person, blocks.answers * lead**2 / 4, count))
    against = gain < _REVERSED * np.maximum(error, 1e-12)
    return tuple(blocks.people[index] for index in np.flatnonzero(against))

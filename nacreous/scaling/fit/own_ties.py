"""How readily each person says tie, which is no part of a scale.

A tie counts half for each, so that who says it often has shares nearer to a half than others of
the same scale, and would pass for less sharp. People are therefore held against what all together
give at the person's own width of ties, by W. A. Glenn and H. A. David's model (1960).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.person import known_people
from nacreous.scaling.fit.blocks import Array, Blocks

__all__ = ["choosing", "own_shares", "with_own_ties"]

#: Leads and widths in z beyond which nothing changes any more.
_FARTHEST, _WIDEST = 20.0, 12.0
#: Widths follow from leads and leads from widths so often; halvings of what each may be.
_ROUNDS, _HALVINGS = 5, 24


def choosing(answers: Answers) -> Answers:
    """The answers of people who chose something; ties alone tell nothing of an order."""
    person = known_people(answers)
    chose = np.bincount(person, answers.outcome != 0, len(answers.people)) > 0
    return answers if chose[person].all() else answers.take(chose[person])


def with_own_ties(blocks: Blocks, *, drawn_in: bool = False) -> Blocks:
    """The blocks with a width of ties for each person: 0 without a tie, infinite with ties alone.

    drawn_in: numbers of ties are drawn in to what the width of all gives, as far as they differ by
    chance alone; one's own width otherwise takes away of one's own sharpness. Without any tie the
    blocks stay as they are.
    """
    if not blocks.tied.any():
        return blocks
    people = len(blocks.people)
    ties = np.asarray(np.bincount(blocks.person, blocks.tied, people), np.float64)
    total = np.bincount(blocks.person, blocks.answers, people)
    held = replace(blocks, width=np.zeros(people))
    for _ in range(_ROUNDS):
        leads = _leads(held)
        wanted = _drawn_in(held, leads, ties) if drawn_in else ties
        if wanted is None:
            return blocks
        width = np.where(wanted > 0, _widths(held, leads, wanted), 0.0)
        held = replace(held, width=np.where(wanted >= total, np.inf, width))
    return held


def _drawn_in(blocks: Blocks, leads: Array, ties: Array) -> Array | None:
    """float64 [person], ties as a person's own width is expected to give them; None if all alike.

    The variance of a person's number of ties is v by chance and, where ln odds of a tie vary by s
    between people, nearly s² v² more; s² by moments **(ours)**.
    """
    one = replace(blocks, people=("",), person=np.zeros_like(blocks.person))
    width = _widths(one, leads, ties.sum(keepdims=True))
    share = _tied(leads[blocks.pair], width)
    people = len(blocks.people)
    expected = np.bincount(blocks.person, blocks.answers * share, people)
    chance = np.bincount(blocks.person, blocks.answers * share * (1 - share), people)
    beyond = float(((ties - expected) ** 2 - chance).sum() / max((chance**2).sum(), 1e-300))
    if beyond <= 0:
        return None
    own = beyond * chance
    return np.asarray(expected + (ties - expected) * own / (1 + own))


def own_shares(blocks: Blocks, width: Array) -> Array:
    """float64 [block], the share of the first at a person's width, a tie counting half.

    The lead of a pair is what makes the shares of all together those that were given.
    """
    return _half(_leads(replace(blocks, width=width))[blocks.pair], width[blocks.person])


def _leads(blocks: Blocks) -> Array:
    """float64 [pair], in z."""
    width = np.zeros(len(blocks.people)) if blocks.width is None else blocks.width
    own, count = width[blocks.person], len(blocks.first)
    given = np.asarray(np.bincount(blocks.pair, blocks.chosen, count), np.float64)

    def made(lead: Array) -> Array:
        share = blocks.answers * _half(lead[blocks.pair], own)
        return np.asarray(np.bincount(blocks.pair, share, count), np.float64)

    return _solved(made, given, -_FARTHEST, _FARTHEST)


def _widths(blocks: Blocks, leads: Array, ties: Array) -> Array:
    """float64 [person], at which as many ties are expected as each gave."""
    lead, people = leads[blocks.pair], len(blocks.people)

    def made(width: Array) -> Array:
        tied = blocks.answers * _tied(lead, width[blocks.person])
        return np.asarray(np.bincount(blocks.person, tied, people), np.float64)

    return _solved(made, ties, 0.0, _WIDEST)


def _solved(made: Callable[[Array], Array], wanted: Array, low: float, high: float) -> Array:
    """Where functions that rise reach what is wanted, by halving."""
    least, most = np.full(len(wanted), low), np.full(len(wanted), high)
    for _ in range(_HALVINGS):
        middle = (least + most) / 2
        short = made(middle) < wanted
        least, most = np.where(short, middle, least), np.where(short, most, middle)
    return np.asarray((least + most) / 2)


def _half(lead: Array, width: Array) -> Array:
    """Chance of the first, and half of that of a tie."""
    from scipy.special import ndtr

    return np.asarray((ndtr(lead - width) + ndtr(lead + width)) / 2)


def _tied(lead: Array, width: Array) -> Array:
    """Chance of a tie."""
    from scipy.special import ndtr

    return np.asarray(ndtr(width - lead) - ndtr(-width - lead))

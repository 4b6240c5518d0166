"""Groups allocated by lot, equally many participants in each."""

from __future__ import annotations

from itertools import product

from nacreous.study.design.design import Design
from nacreous.study.random_streams import ALLOCATION, numbered, stream

__all__ = ["drawn_groups"]


def drawn_groups(design: Design, number: int) -> dict[str, str]:
    """The value of each randomised factor in slot `number`, by the factor's name.

    Permuted blocks: with n combinations of values, each 2n slots in a row have every
    combination twice, once among the even numbers and once among the odd ones, whose sides are
    mirrored. So groups never differ by more than two, and sides are balanced in each.

    >>> design = Design.load("paper")
    >>> sorted(drawn_groups(design, number)["real-pearl"] for number in range(4))
    ['not-shown', 'not-shown', 'shown', 'shown']
    """
    number = numbered(number)
    factors = [group for group in design.groups if group.how == "randomised"]
    cells = list(product(*(factor.values for factor in factors)))
    block, place = divmod(number, 2 * len(cells))
    random = stream(design.seed, ALLOCATION, block)
    lots = [random.permutation(len(cells)), random.permutation(len(cells))]
    cell = cells[int(lots[place % 2][place // 2])]
    return {factor.name: value for factor, value in zip(factors, cell, strict=True)}

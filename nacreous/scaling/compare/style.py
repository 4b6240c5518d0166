"""How groups answer, whatever stands there: how readily they tie, and which side draws them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.compare.estimate import Estimate
from nacreous.scaling.compare.group_test import GroupTest, group_tests
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.uncertainty import holm
from nacreous.value import value_class

__all__ = ["GroupStyle", "styles_of"]

Array = NDArray[np.float64]


@value_class
class GroupStyle:
    """Whether groups differ in one way of answering, whatever places they see.

    - `name`: "ties", how readily two things are called equal, or "side", how the left one draws
    - `shares`: group -> of two equal things, the share of ties, or that of choices of the left one,
      a tie counting half; 0 to 1
    - `statistic`, `df`, `p_value`: of the default test, "permutation" or "likelihood-ratio", with
      places (and the other way of answering) free in each group
    - `p_adjusted`: Holm's over the ways of answering that were tested
    """

    name: Literal["ties", "side"]
    shares: Mapping[str, float]
    statistic: float
    df: int
    p_value: float
    p_adjusted: float

    def differs(self, level: float = 0.95) -> bool:
        """Whether groups answer in different ways, at a level, among the ways tested."""
        return self.p_adjusted < 1 - level

    @property
    def most(self) -> str:
        """The group that ties most readily, or whom the left one draws most."""
        return max(self.shares, key=self.shares.__getitem__)

    @property
    def least(self) -> str:
        """The group that ties least readily, or whom the left one draws least."""
        return min(self.shares, key=self.shares.__getitem__)


def styles_of(
    named: Mapping[str, Any],
    found: Mapping[str, Estimate],
    pooled: Scale,
    permutations: int,
    same_people: bool,
    seed: int,
) -> tuple[GroupStyle, ...]:
    """Test the width of ties and the pull of the side, where they were fitted."""
    names: list[Literal["ties", "side"]] = []
    names += ["ties"] if pooled.tie_threshold else []
    names += ["side"] if pooled.order_effect is not None else []
    if not names:
        return ()
    tests = [
        group_tests(named, found, pooled, name, permutations, same_people, seed)[0]
        for name in names
    ]
    adjusted = holm(np.array([test.p_value for test in tests]))
    return tuple(
        _style(name, found, test, float(both))
        for name, test, both in zip(names, tests, adjusted, strict=True)
    )


def _style(
    name: Literal["ties", "side"], found: Mapping[str, Estimate], test: GroupTest, adjusted: float
) -> GroupStyle:
    share = _tied if name == "ties" else _left
    shares = {group: share(one.fit) for group, one in found.items()}
    return GroupStyle(name, shares, test.statistic, test.df, test.p_value, adjusted)


def _tied(fit: Scale) -> float:
    """Of two equal things with no side, the share of ties."""
    return float(_between_equals(fit, 0.0)[2])


def _left(fit: Scale) -> float:
    """Of two equal things, the share of the left one."""
    left, _, tie = _between_equals(fit, fit.order_effect or 0.0)
    return float(left + tie / 2)


def _between_equals(fit: Scale, lead: float) -> Array:
    """Chances of left, right and tie; the fit in its model's own unit."""
    width = float(fit.parameters[-1]) if fit.tie_threshold else 0.0
    return np.asarray(fit.room.probabilities(np.array([lead]), width)[0])

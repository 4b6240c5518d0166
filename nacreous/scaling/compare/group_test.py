"""Tests that groups are alike in one thing, whatever else each has of its own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nacreous.scaling.compare.estimate import Estimate
from nacreous.scaling.compare.permutation import permutation_test
from nacreous.scaling.compare.restricted import Restriction, restricted
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.distribution import chi2
from nacreous.scaling.fit.scale import Scale
from nacreous.value import value_class

__all__ = ["GroupTest", "group_tests"]


@value_class
class GroupTest:
    """One test that groups are alike: its name, statistic, degrees of freedom, p."""

    name: str
    statistic: float
    df: int
    p_value: float


def group_tests(
    named: Mapping[str, Any],
    found: Mapping[str, Estimate],
    pooled: Scale,
    restriction: Restriction,
    permutations: int,
    same_people: bool,
    seed: int,
) -> list[GroupTest]:
    """The permutation test, where every group names its people, and the likelihood ratio."""
    alike = restricted(named, pooled, restriction)
    apart = sum(one.fit.log_likelihood for one in found.values())
    statistic = max(0.0, 2 * (apart - alike.log_likelihood))
    df = (len(found) - 1) * alike.free
    tests = [
        GroupTest("likelihood-ratio", float(statistic), df, float(chi2.sf(statistic, df))),
    ]
    if all(one.people for one in found.values()):
        parts = {name: data for name, data in named.items() if isinstance(data, Answers)}
        score, p_value = permutation_test(parts, alike, permutations, same_people, seed)
        tests.insert(0, GroupTest("permutation", score, df, p_value))
    return tests

"""Do groups of people share one scale? Tests that hold their size, and what differs.

Three tests of one hypothesis, that the places of the stimuli are the same in every group. Where
answers tell the width of ties and the pull of the side, each group has its own, and whether these
differ is tested apart (`GroupStyle`): who calls more things equal may well have the same scale.

likelihood-ratio  2 (sum of the groups' log-likelihoods - that with places shared), chi-squared.
                  Holds its size if answers are independent; all that can be had from counts.
permutation       Rao's score statistic, with people dealt anew to the groups thousands of times.
                  Exact however people differ, for groups formed by chance, but for what each group
                  has of its own. **The default wherever every group names its people.**
robust-wald       differences of the scales against their covariance with people as clusters, as
                  Hotelling's T squared. Needs more people than parameters.

With people who differ, the likelihood-ratio test finds differences where there are none: at a
spread of 0.5 z between people, 7 stimuli and 50 people a group, in a fifth of all studies
instead of 5 % (tests/scaling/test_recovery.py).
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said, seed_of, whole_of, within
from nacreous.problem import InputError
from nacreous.scaling.compare.estimate import (
    Estimate,
    estimates,
    fit_of,
    hotelling,
    shared_people,
    spread_over,
)
from nacreous.scaling.compare.group_test import GroupTest, group_tests
from nacreous.scaling.compare.pool import pooled
from nacreous.scaling.compare.style import GroupStyle, styles_of
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.given import answers_or_counts
from nacreous.scaling.data.label import group_names
from nacreous.scaling.distribution import t
from nacreous.scaling.fit.scale import Scale
from nacreous.scaling.fit.side import fits_side
from nacreous.scaling.fit.uncertainty import holm
from nacreous.scaling.fit.unit import check_model
from nacreous.value import value_class

__all__ = ["GroupComparison", "GroupDifference", "GroupTest", "compare_groups", "compared"]

Array = NDArray[np.float64]

#: How often people are dealt anew to the groups.
PERMUTATIONS = 1999


@value_class
class GroupDifference:
    """By how much one stimulus stands higher in the first group than in the second.

    In the model's own unit (z or logit), both scales with mean 0. `low` and `high` are the ends of
    its own interval; `p_adjusted` is Holm's over all stimuli and pairs of groups.
    """

    stimulus: str
    first: str
    second: str
    difference: float
    se: float
    low: float
    high: float
    p_value: float
    p_adjusted: float


@value_class
class GroupComparison:
    """What `compare_groups` found.

    fits         one fitted scale a group
    shared       the scale fitted to all answers together
    tests        all tests of the places that could be made, the default one first
    differences  stimulus by stimulus, for each pair of groups
    styles       whether groups differ in how readily they tie, and in how the side draws them,
                 where that is fitted
    side_untold  whether left and right are places whose pull these answers do not tell, so that
                 groups which differ may differ in that alone
    clustered    whether people were known, and errors take them as clusters
    """

    model: str
    fits: Mapping[str, Scale]
    shared: Scale
    tests: tuple[GroupTest, ...]
    differences: tuple[GroupDifference, ...]
    clustered: bool
    styles: tuple[GroupStyle, ...] = ()
    side_untold: bool = False

    @property
    def statistic(self) -> float:
        """Statistic of the default test."""
        return self.tests[0].statistic

    @property
    def df(self) -> int:
        """Degrees of freedom of the default test."""
        return self.tests[0].df

    @property
    def p_value(self) -> float:
        """How often groups that share one scale differ as much in it, by the default test."""
        return self.tests[0].p_value

    def test(self, name: str) -> GroupTest:
        """The test of that name: "likelihood-ratio", "permutation" or "robust-wald"."""
        for test in self.tests:
            if test.name == name:
                return test
        made = ", ".join(test.name for test in self.tests)
        raise InputError(f"test {said(name)} was not made; allowed here: {made}")


def compare_groups(
    groups: Mapping[str, Any],
    model: str = "probit",
    *,
    ties: bool | None = None,
    order: bool | None = None,
    same_people: bool | None = None,
    permutations: int = PERMUTATIONS,
    level: float = 0.95,
    seed: int = 1,
) -> GroupComparison:
    """Test whether two or more groups share one scale, and say which stimuli differ.

    groups        name -> Answers, counts, or whatever `thurstone` takes; the same stimuli in each
                  (`answers.split("group")` gives such).
    model         "probit" (Thurstone's case V) or "logit" (Bradley and Terry).
    ties, order   whether each group has a width of ties and a pull of the side of its own, compared
                  apart from the places (`styles`). A group without a tie has width 0. None, the
                  default: ties as for `thurstone`, and the side wherever each group tells its pull:
                  left and right are places, and a quarter of the answers or more have a partner
                  with the sides exchanged.
    same_people   whether a person's label in two groups is one person (who then is dealt anew
                  between these groups only) or two. Needed only where labels are in both.
    permutations  how often people are dealt anew; the smallest p is 1 / (permutations + 1).
    level         of each difference's own interval.

    Raises `InputError` where a group cannot be fitted, and names it.

    >>> import numpy as np
    >>> before = np.array([[0, 30, 38], [20, 0, 31], [12, 19, 0]])
    >>> after = np.array([[0, 22, 35], [28, 0, 36], [15, 14, 0]])
    >>> found = compare_groups({"before": before, "after": after})
    >>> found.tests[0].name, found.df, round(found.statistic, 2), round(found.p_value, 2)
    ('likelihood-ratio', 2, 4.17, 0.12)
    """
    named = _named(groups)
    check_model(model)
    whole_of("permutations", permutations, 99, 1_000_000)
    within("level", level, 0.5, 0.9999)
    seed = seed_of(seed)
    found = estimates(named, model, ties=ties, order=order)
    return compared(named, found, same_people, permutations, level, seed)


def compared(
    named: dict[str, Any],
    found: dict[str, Estimate],
    same_people: bool | None,
    permutations: int,
    level: float,
    seed: int,
) -> GroupComparison:
    """As `compare_groups`, of groups whose scales are fitted, all of one model and alike."""
    same = shared_people(found, same_people)
    fit = next(iter(found.values())).fit
    counted = [one.fit.comparisons for one in found.values()]
    model, order = fit.model, fit.order_effect is not None
    clustered = all(one.people for one in found.values())
    fitted_ties = fit.tie_threshold is not None
    shared = fit_of(pooled(named, same), model, ties=fitted_ties, order=order)
    joint = spread_over(found, same)
    freedom = _freedom(found, same) if clustered else np.inf
    tests = group_tests(named, found, shared, "places", permutations, same, seed)
    if clustered:
        tests += _robust_wald(found, joint, freedom)
    differences = _differences(found, joint, freedom, level)
    fits = {name: one.fit for name, one in found.items()}
    styles = styles_of(named, found, shared, permutations, same, seed)
    untold = all(each.sided for each in counted) and not (
        order or fits_side(None, counted, model, fitted_ties)
    )
    return GroupComparison(
        model, fits, shared, tuple(tests), differences, clustered, styles, untold
    )


def _named(groups: Mapping[str, Any]) -> dict[str, Any]:
    if not isinstance(groups, Mapping):
        raise InputError(
            f"groups is {said(groups)}; allowed: a dict of name -> data, "
            "such as Answers.split(column) makes"
        )
    if len(groups) < 2:
        raise InputError(f"groups holds {listed(groups) or 'nothing'}; allowed: 2 groups or more")
    return {
        name: answers_or_counts(data)
        for name, data in zip(group_names(groups), groups.values(), strict=True)
    }


def _freedom(found: dict[str, Estimate], same: bool) -> float:
    """Degrees of freedom of the errors: people, less one for each group they were taken from."""
    if same:
        return len({label for one in found.values() for label in one.people}) - 1.0
    return float(sum(one.freedom for one in found.values()))


def _robust_wald(found: dict[str, Estimate], joint: Array, freedom: float) -> list[GroupTest]:
    """Differences from the first group against their covariance, as Hotelling's T squared."""
    count, size = len(found), len(next(iter(found.values())).fit.scale)
    against_first = np.hstack([-np.ones((count - 1, 1)), np.eye(count - 1)])
    # One stimulus of each fewer: with means of 0 it says nothing more.
    contrast = np.kron(against_first, np.eye(size)[:-1])
    apart = contrast @ np.concatenate([one.fit.scale for one in found.values()])
    tested = hotelling(apart, contrast @ joint @ contrast.T, freedom)
    return [] if tested is None else [GroupTest("robust-wald", tested[0], len(apart), tested[1])]


def _differences(
    found: dict[str, Estimate], joint: Array, freedom: float, level: float
) -> tuple[GroupDifference, ...]:
    names = list(found)
    stimuli = found[names[0]].fit.stimuli
    size = len(stimuli)
    scales = np.array([one.fit.scale for one in found.values()])
    places, apart, errors = [], [], []
    for a, b in combinations(range(len(names)), 2):
        one, two = (np.arange(k * size, (k + 1) * size) for k in (a, b))
        places += [(label, names[a], names[b]) for label in stimuli]
        apart.append(scales[a] - scales[b])
        errors.append(np.sqrt(joint[one, one] + joint[two, two] - 2 * joint[one, two]))
    difference, se = np.concatenate(apart), np.concatenate(errors)
    p_values = 2 * t.sf(np.abs(difference) / se, freedom)
    reach = t.ppf((1 + level) / 2, freedom) * se
    columns = zip(
        places, difference, se, difference - reach, difference + reach, p_values, holm(p_values),
        strict=True,
    )  # fmt: skip
    return tuple(
        GroupDifference(*place, *(float(x) for x in numbers)) for place, *numbers in columns
    )

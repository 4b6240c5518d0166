"""All that answers say about themselves, before any scale: in one place."""

from __future__ import annotations

from typing import Any

from nacreous.problem import InputError
from nacreous.scaling.check.always_tied import AlwaysTied, always_tied
from nacreous.scaling.check.kendall import Agreement, agreement
from nacreous.scaling.check.person import PersonalTriads, triads_by_person
from nacreous.scaling.check.repetition import Retest, retest
from nacreous.scaling.check.response import ResponseTime, response_time
from nacreous.scaling.check.side import SideBias, side_bias
from nacreous.scaling.check.transitive import Transitivity, transitivity
from nacreous.scaling.check.triads import Triads, circular_triads
from nacreous.scaling.data.given import counted
from nacreous.value import value_class


@value_class
class Consistency:
    """What the answers allow to say; None (or () for people) where they do not.

    - `triads`, `transitivity`: of the group, from 3 stimuli on
    - `agreement`: Kendall's u, where a pair was answered twice; by two people where they are known
    - `people`: each person's own circular triads
    - `retest`, `side`, `response`: where pairs were repeated, sides known, times taken
    - `always_tied`: people who never chose
    """

    triads: Triads | None
    transitivity: Transitivity | None
    agreement: Agreement | None
    people: tuple[PersonalTriads, ...]
    retest: Retest | None
    side: SideBias | None
    response: ResponseTime | None
    always_tied: tuple[AlwaysTied, ...] = ()


def consistency(data: Any, scale: Any = None) -> Consistency:
    """Everything about the consistency of whatever `comparisons_of` takes.

    What concerns people, sides and times needs `Answers`. `scale` [n], if given, is what response
    times are related to.

    >>> import nacreous as nc
    >>> found = consistency(nc.scaling.paper())
    >>> round(found.triads.zeta, 4), round(found.agreement.u, 4), found.transitivity.strong
    (0.9286, 0.3717, 13)
    """
    answers, comparisons = counted(data)
    three = len(comparisons.stimuli) >= 3
    return Consistency(
        triads=circular_triads(comparisons) if three else None,
        transitivity=transitivity(comparisons) if three else None,
        agreement=_or_none(agreement, comparisons if answers is None else answers),
        people=triads_by_person(answers) if answers and answers.people else (),
        retest=retest(answers) if answers and answers.people else None,
        side=_or_none(side_bias, answers) if answers and answers.sided else None,
        response=response_time(answers, scale) if answers else None,
        always_tied=always_tied(answers) if answers and answers.people else (),
    )


def _or_none(measure: Any, data: Any) -> Any:
    """What a measure finds, or None where it says that these data have no answer for it."""
    try:
        return measure(data)
    except InputError:
        return None

"""Why a row with an answer does not count: the words for each reason."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

#: By reason what is said of such rows behind their number. `people`: of people, where simulated
#: observers are wanted. `question`: the row answers another one than was chosen.
REASONS: Mapping[str, str] = {
    "question": "of other questions",
    "practice": "of practice",
    "catch": "of catch trials",
    "simulated": "of simulated observers",
    "people": "of people",
    "excluded": "of excluded people",
    "marked": "marked as excluded",
}


def counted_by_reason(reasons: Iterable[str | None]) -> dict[str, int]:
    """How many rows do not count for which reason, in the order of `REASONS`; None counts.

    >>> counted_by_reason(["catch", None, "practice", "catch"])
    {'practice': 1, 'catch': 2}
    """
    found = list(reasons)
    return {reason: found.count(reason) for reason in REASONS if reason in found}

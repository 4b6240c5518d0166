"""The [pairs] of a study: which are shown, and which twice."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section


class Pairs(Section):
    """Which pairs each participant sees.

    >>> Pairs(kind="all", repeat_share=0.2).repeated(21)
    4
    """

    kind: Literal["all", "incomplete", "adaptive"] = key(
        "all",
        "All pairs, some that join all stimuli, drawn anew for every two participants, or those "
        "that tell most, chosen while the study runs.",
        allowed='"all", "incomplete" or "adaptive"',
        source="paper 2.2, all pairs",
    )
    choice: Literal["greedy", "drawn"] | None = key(
        None,
        "Of adaptive pairs: those that tell most, or pairs drawn with chances in proportion to "
        "what they tell.",
        allowed='"greedy" or "drawn"',
        left_out="greedy, where pairs are adaptive",
        source="**(ours)**",
    )
    number: int | None = quantity(
        None,
        "How many pairs each participant sees.",
        least=1,
        most=10_000,
        left_out="all of them",
        source="**(ours)**",
    )
    repeats: int | None = quantity(
        None,
        "How many pairs are shown once more, the sides exchanged.",
        least=0,
        most=10_000,
        left_out="repeat_share says it; without that none",
        source="**(ours)**",
    )
    repeat_share: float | None = quantity(
        None,
        "The same as a share of the pairs, rounded.",
        least=0,
        most=1,
        left_out="repeats says it",
        source="**(ours)**",
    )

    @property
    def chosen_by(self) -> Literal["greedy", "drawn"] | None:
        """How pairs are chosen by the answers so far; None where they are not.

        >>> Pairs(kind="adaptive", number=20).chosen_by, Pairs(kind="all").chosen_by
        ('greedy', None)
        """
        return (self.choice or "greedy") if self.kind == "adaptive" else None

    def repeated(self, pairs: int) -> int:
        """How many of so many pairs are shown once more."""
        if self.repeats is not None:
            return min(self.repeats, pairs)
        return round((self.repeat_share or 0.0) * pairs)

    def contradictions(self) -> Iterator[Contradiction]:
        """A number that is missing or would be ignored, and two ways to say how many repeats."""
        if self.kind == "all" and self.number is not None:
            verdict = f'is {shown(self.number)} while {{other}} is "all"; allowed: nothing'
            yield Contradiction("number", verdict, "kind")
        if self.kind != "adaptive" and self.choice is not None:
            verdict = f'is {shown(self.choice)} while {{other}} is "{self.kind}"; allowed: nothing'
            yield Contradiction("choice", verdict, "kind")
        if self.kind != "all" and self.number is None:
            verdict = f'is missing while {{other}} is "{self.kind}"; allowed: 1 to 10000'
            yield Contradiction("number", verdict, "kind")
        if self.repeats is not None and self.repeat_share is not None:
            yield Contradiction("repeat_share", "cannot stand beside {other}: give one", "repeats")

    def impossible(self, count: int) -> Iterator[Contradiction]:
        """Numbers that cannot be with so many stimuli; paths are those of the whole file."""
        every = count * (count - 1) // 2
        if self.number is not None and not count - 1 <= self.number <= every:
            verdict = (
                f"is {self.number}; allowed: {count - 1} to {every}, so that {{other}} are "
                "joined and no pair comes twice"
            )
            yield Contradiction("pairs.number", verdict, "stimuli")
        shown_pairs = self.number or every
        if self.repeats is not None and self.repeats > shown_pairs:
            verdict = f"is {self.repeats}; allowed: 0 to {shown_pairs}, the pairs there are"
            yield Contradiction("pairs.repeats", verdict)

"""The [[questions]] of a study, and the [[catches]] whose answers are known."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key
from nacreous.spec.section import Section
from nacreous.spec.texts import NAME, Name
from nacreous.study.design.multilingual import WORDS, Words

Word = Annotated[str, Field(pattern="^[a-z0-9][a-z0-9_-]{0,39}$")]
WORD = "1 to 40 of a to z, 0 to 9, - and _, the first a letter or digit"


class Question(Section):
    """What people are asked about every pair.

    >>> Question(id="pearl", text={"en": "Which looks more like a pearl?"}).id
    'pearl'
    """

    id: Word = key(..., "What answers call the question.", allowed=WORD, source="free")
    text: Words = key(..., "The question as people read it.", allowed=WORDS, source="free")


class Catch(Section):
    """A pair whose answer is known: whoever misses it was not looking."""

    expected: Name = key(
        ..., "The label of the stimulus to be chosen.", allowed=NAME, source="free"
    )
    against: Name = key(..., "The label of the other one.", allowed=NAME, source="free")
    question: Word | None = key(
        None,
        "The question that is asked, by its id.",
        allowed=WORD,
        left_out="the first of questions",
        source="free",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A stimulus against itself."""
        if self.expected == self.against:
            yield Contradiction(
                "against", f"is {shown(self.against)}, as {{other}}; allowed: another", "expected"
            )

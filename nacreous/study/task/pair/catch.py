"""The [[catches]] of a study: pairs whose answer is known."""

from __future__ import annotations

from collections.abc import Iterator

from nacreous.spec.complaint import Contradiction, nearest, shown
from nacreous.spec.key import key
from nacreous.spec.section import Section
from nacreous.spec.texts import NAME, WORD, Name, Word


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

    def unknown(
        self, path: str, labels: list[str], questions: list[str]
    ) -> Iterator[Contradiction]:
        """The stimuli and the question that the study does not have; path: of this table."""
        named = [("expected", self.expected, labels), ("against", self.against, labels)]
        if self.question is not None:
            named.append(("question", self.question, questions))
        for name, given, known in named:
            if given not in known:
                near = nearest(given, known)
                hint = f'did you mean "{near}"?' if near else f"allowed: {shown(known)}"
                of = "questions" if known is questions else "stimuli"
                verdict = f"is {shown(given)}, which is none of {{other}}; {hint}"
                yield Contradiction(f"{path}.{name}", verdict, of)

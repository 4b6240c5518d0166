"""The [[groups]] of a study: factors drawn by lot, or asked of the participant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

from pydantic import Field

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key
from nacreous.spec.section import Section
from nacreous.spec.texts import WORD, Word
from nacreous.study.design.multilingual import WORDS, Words


class Group(Section):
    """A factor and its values.

    >>> Group(name="real-pearl", values=["shown", "not-shown"], how="randomised").values
    ('shown', 'not-shown')
    """

    name: Word = key(..., "What answers call the factor.", allowed=WORD, source="free")
    values: Annotated[tuple[Word, ...], Field(min_length=2, max_length=24)] = key(
        ...,
        "The values it can have.",
        allowed=f"2 to 24 different texts, each {WORD}",
        source="paper 2.2, a real pearl shown before or not",
        strict=False,
    )
    how: Literal["randomised", "recorded"] = key(
        "randomised",
        "Drawn by lot, equally many of each value, or asked of the participant.",
        allowed='"randomised" or "recorded"',
        source="**(ours)**",
    )
    question: Words | None = key(
        None,
        "What the participant is asked.",
        allowed=WORDS,
        left_out="nothing is asked; only where the value is drawn by lot",
        source="free",
    )
    choices: tuple[Words, ...] | None = key(
        None,
        "The values as the participant reads them, in the same order.",
        allowed=f"as many tables as values, each {WORDS}",
        left_out="the values as they are",
        source="free",
        strict=False,
    )
    notes: tuple[Words, ...] | None = key(
        None,
        "What a participant is told once the value is known, one for each value; {} for nothing.",
        allowed=f"as many tables as values, each {WORDS}, or {{}}",
        left_out="nothing is told",
        source="paper 2.2, a real pearl is handed over or not",
        strict=False,
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A value twice, and a question that is missing or would never be asked."""
        if len(set(self.values)) < len(self.values):
            yield Contradiction("values", f"are {shown(self.values)}; allowed: each once")
        if self.how == "recorded" and self.question is None:
            verdict = f'is missing while {{other}} is "recorded"; allowed: {WORDS}'
            yield Contradiction("question", verdict, "how")
        for name in ("question", "choices"):
            if self.how == "randomised" and getattr(self, name) is not None:
                verdict = 'is given while {other} is "randomised"; nobody would be asked'
                yield Contradiction(name, verdict, "how")
        for name in ("choices", "notes"):
            given = getattr(self, name)
            if given is not None and len(given) != len(self.values):
                verdict = f"are {len(given)}; allowed: {len(self.values)}, one for each value"
                yield Contradiction(name, verdict)

    def note(self, value: str) -> Words | None:
        """What somebody with this value is told, if anything.

        >>> notes = [{"en": "Please hold the pearl.", "ja": "真珠をお持ちください。"}, {}]
        >>> group = Group(name="real-pearl", values=["shown", "not-shown"], notes=notes)
        >>> group.note("shown").en, group.note("not-shown")
        ('Please hold the pearl.', None)
        """
        note = self.notes[self.values.index(value)] if self.notes is not None else None
        return note if note is not None and (note.en or note.ja) else None

    def missing(self, path: str, languages: tuple[str, ...]) -> Iterator[Contradiction]:
        """What a participant would have to read and cannot."""
        if self.question is not None:
            yield from self.question.missing(f"{path}.question", languages)
        for place, choice in enumerate(self.choices or ()):
            yield from choice.missing(f"{path}.choices.{place}", languages)
        for place, value in enumerate(self.values):
            note = self.note(value)
            if note is not None:
                yield from note.missing(f"{path}.notes.{place}", languages)

"""What people read, in each language of the study."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal, get_args

from pydantic import AfterValidator, Field

from nacreous.printable import printable_lines
from nacreous.spec.complaint import Contradiction
from nacreous.spec.key import key
from nacreous.spec.section import Section

#: The languages that pages can be in.
Language = Literal["en", "ja"]
LANGUAGES: tuple[str, ...] = get_args(Language)


def _readable(text: str) -> str:
    if not text.strip() or printable_lines(text) != text:
        raise ValueError("blank, or not printable")
    return text


Prose = Annotated[str, Field(min_length=1, max_length=20_000), AfterValidator(_readable)]
PROSE = "text of 1 to 20000 characters, not blank"
WORDS = "a table with en and ja"


class Words(Section):
    """The same words in English and in Japanese.

    >>> Words(en="Which looks more like a pearl?").in_language("en")
    'Which looks more like a pearl?'
    """

    en: Prose | None = key(
        None,
        "In English.",
        allowed=PROSE,
        left_out="only where languages leave out English",
        source="free",
    )
    ja: Prose | None = key(
        None,
        "In Japanese.",
        allowed=PROSE,
        left_out="only where languages leave out Japanese",
        source="free",
    )

    def in_language(self, language: str) -> str:
        """The words in a language of the study."""
        text = self.ja if language == "ja" else self.en
        return text or ""

    def missing(self, path: str, languages: tuple[str, ...]) -> Iterator[Contradiction]:
        """The languages of the study in which there are no words; path: of this table."""
        for language in languages:
            if not self.in_language(language):
                verdict = f'is missing while {{other}} has "{language}"; allowed: {PROSE}'
                yield Contradiction(f"{path}.{language}", verdict, "languages")

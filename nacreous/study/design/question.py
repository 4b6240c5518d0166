"""The [[questions]] of a study."""

from __future__ import annotations

from nacreous.spec.key import key
from nacreous.spec.section import Section
from nacreous.spec.texts import WORD, Word
from nacreous.study.design.multilingual import WORDS, Words


class Question(Section):
    """What people are asked about every pair.

    >>> Question(id="pearl", text={"en": "Which looks more like a pearl?"}).id
    'pearl'
    """

    id: Word = key(..., "What answers call the question.", allowed=WORD, source="free")
    text: Words = key(..., "The question as people read it.", allowed=WORDS, source="free")

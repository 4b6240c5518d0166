"""Names of columns and texts of questions that have two stimuli in them: `A vs B`."""

from __future__ import annotations

import re

from nacreous.scaling.data.label import label_of

_VERSUS = re.compile(r"(.*?\S)[\s_.\-]+(?:vs|versus)\.?[\s_.\-]+(\S.*)", re.IGNORECASE)
#: What parts a question from the pair below or behind it.
_PARTS = re.compile(r"[?:\n\r]|？|：|<[^>]*>")
#: A question of LimeSurvey with one of its parts: `Which? [A vs B]`.
_BRACKETS = re.compile(r".*\[([^\[\]]+)\]\s*", re.DOTALL)


def pair_of_name(name: str) -> tuple[str, str] | None:
    """The left and right one of which a column's name consists, or that it has in brackets.

    >>> pair_of_name("A_vs_B"), pair_of_name("Which? [A vs B]"), pair_of_name("chosen")
    (('A', 'B'), ('A', 'B'), None)
    """
    inside = _BRACKETS.fullmatch(name)
    return _pair((inside[1] if inside else name).strip())


def pair_of_question(text: str) -> tuple[str, str] | None:
    """The left and right one in the text of a question, if there is one pair in it.

    >>> pair_of_question("Which shines more? A vs B")
    ('A', 'B')
    """
    pairs = [pair for part in _PARTS.split(text) if (pair := pair_of_name(part))]
    return pairs[0] if len(pairs) == 1 else None


def _pair(text: str) -> tuple[str, str] | None:
    found = _VERSUS.fullmatch(text)
    return (label_of(found[1]), label_of(found[2])) if found else None

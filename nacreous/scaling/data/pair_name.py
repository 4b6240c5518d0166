"""Names of columns and texts of questions that have two stimuli in them: `A vs B`."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from html import unescape

from nacreous.scaling.data.label import label_of

_MARK = r"[\s_.\-]+(?:vs|versus)\.?[\s_.\-]+"
_VERSUS = re.compile(rf"(.*?\S){_MARK}(\S.*)", re.IGNORECASE)
_AGAIN = re.compile(rf"\S{_MARK}\S", re.IGNORECASE)
#: Tags that set letters and part nothing.
_LETTERING = re.compile(
    r"</?(?:a|b|i|u|em|strong|span|font|small|big|mark|sub|sup)(?:\s[^<>]*)?>", re.IGNORECASE
)
#: What parts lines, each of which stands alone.
_LINES = re.compile(r"[\n\r]|<[^>]*>")
#: What parts a question from the pair behind or before it. A colon within 10:30 does not.
_SENTENCES = re.compile(r"[？：]+|\?+(?=[\s_\[(\-–—？：]|$)|:(?=\s|$)")
#: A pair in brackets behind its question: `Which? [A vs B]` of LimeSurvey and Google Forms.
_BRACKETS = re.compile(r"(.*)(?:\[([^\[\]]+)\]|(?<=[\s?？])\(([^()]+)\))\s*[.?]?\s*", re.DOTALL)
#: A dash or bullet that opens a line, as between the question and the row of a matrix.
_BULLET = re.compile(r"^(?:[\-–—•·*]+\s+)+")
_NUMBER = re.compile(
    r"((?:q|question|問|設問|質問)[\s_.]*[0-9]+[\s_.):\-]+|\(?[0-9]+[.)]\s*(?![0-9]))(.*)",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class PairName:
    """A pair as a text names it, with what stands before and behind it, such as a question.

    within: text stands on both sides of it in one line.
    """

    left: str
    right: str
    before: str = ""
    behind: str = ""
    within: bool = False

    @property
    def number(self) -> str:
        """A number such as `Q1_` or `1. ` that may be that of the question; else nothing."""
        found = _NUMBER.fullmatch(self.left)
        return found[1] if found and found[2] else ""

    def numbered(self) -> PairName:
        """The same pair, its number taken for that of the question."""
        left = label_of(self.left[len(self.number) :])
        return replace(self, left=left, before=self.before or _bare(self.number))


def is_numbered(label: str) -> bool:
    """Whether a label begins as a question with a number does.

    >>> is_numbered("Q1_A"), is_numbered("1. A"), is_numbered("A")
    (True, True, False)
    """
    return bool(_NUMBER.fullmatch(label))


def pairs_in(text: str) -> list[PairName]:
    """Each pair that a name or a question has in it.

    >>> pairs_in("Which is better? A vs B")
    [PairName(left='A', right='B', before='Which is better', behind='', within=False)]
    >>> [(pair.left, pair.right) for pair in pairs_in("Which? [A_vs_B]")]
    [('A', 'B')]
    """
    plain = _LETTERING.sub("", unescape(text))
    inside = _BRACKETS.fullmatch(plain)
    if inside:
        found = _pairs(inside[2] or inside[3], inside[1])
        if found:
            return [*pairs_in(inside[1]), *found]
    lines = _LINES.split(plain)
    found = []
    for at, line in enumerate(lines):
        above, below = "\n".join(lines[:at]), "\n".join(lines[at + 1 :])
        marks = [match.span() for match in _SENTENCES.finditer(line)]
        starts = [0, *(end for _, end in marks)]
        stops = [*(begin for begin, _ in marks), len(line)]
        for start, stop in zip(starts, stops, strict=True):
            within = bool(_bare(line[:start]) and _bare(line[stop:]))
            before, behind = f"{above}\n{line[:start]}", f"{line[stop:]}\n{below}"
            found += _pairs(line[start:stop], before, behind, within)
    return found


def _pairs(part: str, before: str, behind: str = "", within: bool = False) -> list[PairName]:
    """The pair of which a part of a text consists; where three stand in a row, two pairs."""
    found = _VERSUS.fullmatch(_BULLET.sub("", part.strip()))
    if not found:
        return []
    sides = (label_of(found[1]), label_of(found[2]))
    pair = PairName(*sides, _bare(before), _bare(behind), within)
    return [pair] * (2 if _AGAIN.search(found[2]) else 1)


def _bare(text: str) -> str:
    """The last sentence, without the marks around it."""
    text = text.strip(" \t\n\r?？:：-–—_.[]()*•·")
    return re.split(r"(?<=\w{2}[.!?])\s+|(?<=[。？！])|[\n\r]+", text)[-1].strip()

"""SurveyMonkey's two lines of names: a question, and below it the row of it that was answered.

The question stands above the first of its rows alone. Below a question without rows is `Response`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import zip_longest

from nacreous.scaling.data.pair_name import pairs_in

#: Columns by which its files are known, in small letters without what parts words.
_RESPONDENT, _COLLECTOR = "respondentid", "collectorid"


def has_second_line(names: Sequence[str], below: Sequence[str]) -> bool:
    """Whether these are names of SurveyMonkey, and below them stands no respondent's number.

    >>> has_second_line(["Respondent ID", "Collector ID", "A vs B"], ["", "", "Response"])
    True
    """
    bare = [re.sub(r"[\s_]+", "", name).casefold() for name in names]
    if not {_RESPONDENT, _COLLECTOR} <= {*bare}:
        return False
    at = bare.index(_RESPONDENT)
    return at < len(below) and not below[at].isdecimal()


def joined_names(names: Sequence[str], below: Sequence[str]) -> list[str]:
    """One name a column: the question, with its row in brackets where that tells columns apart.

    >>> joined_names(["Which?", "", "Age"], ["A vs B", "B vs C", "Response"])
    ['Which? [A vs B]', 'Which? [B vs C]', 'Age']
    """
    found = []
    question = ""
    for name, row in zip_longest(names, below, fillvalue=""):
        question = name or question
        tells = not name or (pairs_in(row) and not pairs_in(name))
        found.append(f"{question} [{row}]" if row and tells else name)
    return found

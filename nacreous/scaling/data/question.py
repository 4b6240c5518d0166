"""Tables that answer several questions: one of them is chosen, or the table refused."""

from __future__ import annotations

import re
from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.column import codes_of, text_column
from nacreous.scaling.data.fault import hint_of, listed
from nacreous.scaling.data.label import label_of
from nacreous.scaling.data.table import Table

#: Names of a column that says which question a row answers, in small letters.
_NAMES = frozenset({"question", "questionid", "質問", "設問"})


class SeveralQuestionsError(InputError):
    """None of several questions is chosen; who knows which one is wanted can say it."""


def of_question(table: Table, question: str | None, roles: Collection[str]) -> NDArray[np.bool_]:
    """Bool [row], the rows that answer the question; all of them where none is to be chosen.

    roles: columns with a role, the two stimuli first. A column whose values stand for one pair each
    numbers the pairs, and asks one question. Raises `SeveralQuestionsError` where it has to be
    chosen, and `InputError` for one that is not there.
    """
    name = _column(table, roles)
    if name is None:
        if question is not None:
            raise InputError(
                f"{table.place}: question is {said(question)}, and the table has no column "
                "question; allowed: a table with one, or no question"
            )
        return np.ones(table.rows, bool)
    asked, code = codes_of(text_column(table, name))
    if question is not None:
        wanted = label_of(str(question))
        if wanted not in asked:
            raise InputError(f"{table.place}: question is {said(question)}; {_hint(wanted, asked)}")
        return np.asarray(code == asked.index(wanted))
    if len(asked) > 1 and not _numbers_pairs(table, code, [*roles][:2]):
        raise SeveralQuestionsError(
            f"{table.place}: answers several questions, in the column {name}, and none is chosen; "
            f"wanted: question={asked[0]!r} or another of {listed(asked)}; or another name for the "
            "column, if it asks none"
        )
    return np.ones(table.rows, bool)


def _hint(wanted: str, asked: Collection[str]) -> str:
    few = hint_of(wanted, asked)
    return few if few.startswith("did") else f"allowed: {listed(asked)}"


def _column(table: Table, roles: Collection[str]) -> str | None:
    """The column that says which question a row answers."""
    names = [name for name in table.columns if name not in roles]
    return next((name for name in names if re.sub(r"[\s_]", "", name).casefold() in _NAMES), None)


def _numbers_pairs(table: Table, code: NDArray[np.int64], sides: list[str]) -> bool:
    """Whether each value stands for one pair alone, and the values for more than one."""
    import pyarrow as pa

    texts = [text_column(table, name) for name in sides]
    _, both = codes_of(pa.concat_arrays(texts))
    pairs = np.sort(both.reshape(2, -1).T, axis=1)
    told = code >= 0
    each = np.unique(np.column_stack([code[told], pairs[told]]), axis=0)
    alone = len(each) == len(np.unique(each[:, 0]))
    return bool(alone and len(np.unique(each[:, 1:], axis=0)) > 1)

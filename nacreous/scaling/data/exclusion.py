"""Rows that whoever made a table marked as excluded, or as not valid, in a column of that name."""

from __future__ import annotations

import re
from collections.abc import Collection
from unicodedata import normalize

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.column import codes_of, text_column
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.table import Table
from nacreous.scaling.data.truth import plain_word, says_true

#: What a name may have before and behind: `is_excluded`, `exclude_trial`, `valid_response`.
_AROUND = (
    r"(?:is|to|was|be|trial|row|participant|subject|person)*{}"
    r"(?:trials?|rows?|participants?|subjects?|persons?|people|data|responses?|answers?|"
    r"flag|from(?:the)?analys[ie]s|yn)?[0-9?]*"
)
_OUT = re.compile(
    _AROUND.format(
        r"(?:exclu(?:ded?|sion|dereason|dedreason|sionreason|sioncriteri(?:on|a))|reason"
        r"(?:for)?exclu(?:ded|sion)|discard(?:ed)?|invalid|ausgeschlossen|exclu[es]?|excluido|"
        r"除外|除外理由|無効)"
    )
)
_IN = re.compile(
    _AROUND.format(
        r"(?:valid|includ(?:ed?|ein|edin)|inclusion|keep|kept|gültig|eingeschlossen|有効|採用)"
    )
)
#: A column that says why, and has an empty cell, or none, where nothing is the matter.
_REASON = re.compile(r"reason|理由", re.IGNORECASE)
#: Other column names that often say which rows are no good, and may say something else.
_PERHAPS = re.compile(
    r"(?:.*(?:attention|catch|check|quality|comprehension).*)?(?:pass(?:ed)?|fail(?:ed)?)(?:.*check.*)?|"
    r"(?:is)?(?:outliers?|usable|rejected|dropped|omit(?:ted)?|removed?|bad(?:trial|data)?)"
)
#: Words of either kind of column beside yes and no.
_KEPT = frozenset({"valid", "included", "include", "keep", "kept", "gültig", "有効", "採用"})
_LEFT_OUT = frozenset(
    {"invalid", "excluded", "exclude", "discard", "discarded", "ungültig", "無効", "除外"}
)


def excluded(table: Table, roles: Collection[str]) -> NDArray[np.bool_]:
    """Bool [row], what a column marks as excluded, or as not valid; roles: columns that have one.

    In a column of exclusions an empty cell counts, and a reason excludes where the other cells are
    empty. Raises `InputError` where it is not clear which rows are meant.
    """
    out = np.zeros(table.rows, bool)
    for name in table.columns:
        if name in roles:
            continue
        bare = _bare(name)
        if _OUT.fullmatch(bare):
            out |= _marked(table, name)
        elif _IN.fullmatch(bare):
            out |= _not_kept(table, name)
    return out


def may_exclude(column: str, cells: Collection[str]) -> bool:
    """Whether a group's column may say which rows count; one has to ask.

    >>> may_exclude("outlier", ("no", "yes")), may_exclude("valid", ("a", "b"))
    (True, True)
    >>> may_exclude("valid", ("yes",)), may_exclude("sex", ("f", "m"))
    (False, False)
    """
    if len(cells) < 2:
        return False
    bare = _bare(column)
    if _PERHAPS.fullmatch(bare):
        return all(_says(cell) is not None for cell in cells)
    return _IN.fullmatch(bare) is not None


def _marked(table: Table, name: str) -> NDArray[np.bool_]:
    """By a column of exclusions."""
    cells, code = _cells(table, name)
    told = [_says(cell) for cell in cells]
    if None in told:
        empty = bool((code < 0).any())
        if set(told) != {None} or not (empty or _REASON.search(name)):
            raise _unclear(table, name, cells, "yes, no or an empty cell in each row")
        told = [True] * len(cells)
    return np.array([*told, False], bool)[code]


def _not_kept(table: Table, name: str) -> NDArray[np.bool_]:
    """By a column of what counts; one that says something else altogether is a group."""
    cells, code = _cells(table, name)
    told = [_says(cell, of_kept=True) for cell in cells]
    if not told or set(told) == {None} or (None in told and False not in told):
        return np.zeros(table.rows, bool)
    if None in told or (code < 0).any():
        held = cells if None in told else (*cells, "")
        raise _unclear(table, name, held, "yes or no in each row")
    return ~np.array(told, bool)[code]


def _cells(table: Table, name: str) -> tuple[tuple[str, ...], NDArray[np.int64]]:
    """The values of a column, and for each row the index of its own; -1 where it holds nothing."""
    text = text_column(table, name)
    cells, code = codes_of(text)
    code = np.where(is_nothing(text), -1, code)
    used = np.unique(code[code >= 0])
    place = np.full(len(cells) + 1, -1)
    place[used] = np.arange(len(used))
    return tuple(cells[at] for at in used), place[code]


def _says(cell: str, *, of_kept: bool = False) -> bool | None:
    """What a cell says of what the column is about; None where that is not clear."""
    word = plain_word(cell)
    if word in _KEPT | _LEFT_OUT:
        return (word in _KEPT) == of_kept
    return says_true(cell)


def _unclear(table: Table, name: str, cells: Collection[str], allowed: str) -> InputError:
    return InputError(
        f"{table.place}: column {name} may say which rows are excluded, and holds {listed(cells)}; "
        f"allowed: {allowed}, or another name for the column if it says "
        "something else"
    )


def _bare(name: str) -> str:
    return re.sub(r"[\s_.\-/()]+", "", normalize("NFKC", name)).casefold()

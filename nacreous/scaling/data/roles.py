"""Which column of a table is what: by the names given, the usual ones, or a program's own."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from itertools import combinations
from typing import Any, TypedDict

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling.data.column import codes_of, text_column
from nacreous.scaling.data.count import count_column, counts_of_sides
from nacreous.scaling.data.fault import Faults, listed, nearest, quoted
from nacreous.scaling.data.header import name_of
from nacreous.scaling.data.number_column import number_column
from nacreous.scaling.data.other_pair import renamed_pair
from nacreous.scaling.data.program import names_people, program_of
from nacreous.scaling.data.table import Table


class Names(TypedDict, total=False):
    """What the columns are called, where not as usual, and what `chosen` holds for no label."""

    person: str
    left: str
    right: str
    chosen: str
    winner: str
    loser: str
    time: str
    trial: str
    response_s: str
    response_ms: str
    count: str
    tie: str
    left_word: str
    right_word: str


LONG = ("left", "right", "chosen")
WINNERS = ("winner", "loser")
OPTIONAL = ("person", "time", "trial", "response_s", "response_ms", "count")
WORDS = ("left_word", "right_word", "tie")


def check_names(names: Names) -> Names:
    """The names as they are compared, or one message about a role that is none."""
    roles = (*LONG, *WINNERS, *OPTIONAL, *WORDS)
    unknown = sorted(set(names) - set(roles))
    if unknown:
        near = nearest(unknown[0], roles)
        hint = f"did you mean {near}?" if near else f"allowed: {', '.join(roles)}"
        raise InputError(f"{quoted(unknown[0])} is no role of a column; {hint}")
    given: Any = {role: name_of(name) for role, name in names.items() if name is not None}
    if set(given) & set(WINNERS) and set(given) & {*LONG, *WORDS}:
        raise InputError("winner and loser are given with left, right or chosen; allowed: either")
    _check_words(given)
    found: Names = given
    return found


def _check_words(given: dict[str, str]) -> None:
    """Refuse an empty word or name, except of a column that may be missing, and a word twice."""
    for role, name in given.items():
        if not name and role not in OPTIONAL:
            raise InputError(f"{role} is empty; allowed: {'a word' if role in WORDS else 'a name'}")
    words = {role: word for role, word in ({"tie": "tie"} | given).items() if role in WORDS}
    for role, other in combinations(sorted(words, key=WORDS.index), 2):
        if words[role] == words[other]:
            raise InputError(
                f"{role}={words[role]!r} is given with {other}={words[other]!r}; allowed: "
                "different words"
            )


def wanted_of(names: Names) -> list[set[str]]:
    """Names of columns, one of these sets being in the line of names."""
    given: Any = names
    pairs = (LONG[:2], WINNERS)
    return [{str(given.get(role) or role) for role in pair} for pair in pairs]


def column_of(table: Table, role: str, names: Names) -> str | None:
    """The column that has a role, or None: as given, as usual, or as the program calls it.

    An empty name is given for none.
    """
    given: Any = names.get(role)
    if given is not None:
        return given if given in table.columns else None
    if role in table.columns:
        return role
    alike = [name for name in table.columns if name.casefold() == role]
    if len(alike) == 1:
        return alike[0]
    if role == "trial" and _holds_numbers(table, "order"):
        return "order"
    program = program_of(table.columns)
    own = program.columns.get(role) if program else None
    return own if own in table.columns else None


def has_winners(table: Table, names: Names) -> bool:
    """Whether the answers are winner and loser, and not left, right and chosen."""
    if set(names) & set(WINNERS):
        return True
    return not has_long(table, names) and all(column_of(table, role, names) for role in WINNERS)


def has_long(table: Table, names: Names) -> bool:
    """Whether there are columns for left, right and chosen."""
    return all(column_of(table, role, names) for role in LONG)


def columns_of(table: Table, names: Names, faults: Faults) -> dict[str, str]:
    """For each role the name of the column that has it; optional ones only where they are."""
    needed = WINNERS if has_winners(table, names) else LONG
    found: dict[str, str] = {}
    lacking: dict[str, str] = {}
    for role in (*needed, *OPTIONAL):
        column = column_of(table, role, names)
        if role == "person" and column is None and "person" not in names:
            column = _people(table, {*found.values()})
        if role == "count" and "count" not in names and not lacking:
            column = count_column(table, {*found.values()})
        name = str(names.get(role) or role)
        if column is not None:
            found[role] = column
        elif role in needed or names.get(role):
            lacking[role] = name
    if lacking:
        faults.say(_lacking(table, lacking, set(found.values())))
    for role in found:
        alike = [name for name in table.columns if name.casefold() == role]
        if role not in names and len(alike) > 1:
            faults.say(
                f"has the columns {' and '.join(alike)}; allowed: one of them, or {role}="
                f"{alike[0]!r} to name it"
            )
    if "response_s" in found and "response_ms" in found:
        faults.say("has both response_s and response_ms; allowed: one of them")
    for name in dict.fromkeys(found.values()):
        roles = [role for role in found if found[role] == name]
        if len(roles) > 1:
            faults.say(f"column {name} is used as {' and as '.join(roles)}; allowed: one of them")
    return found


def _people(table: Table, taken: Iterable[str]) -> str | None:
    """The column of people by another program's name for it, where one is not empty."""
    likely = [name for name in table.columns if names_people(name) and name not in taken]
    likely = [name for name in likely if text_column(table, name).null_count < table.rows]
    if len(likely) > 1 and not _tell_the_same(table, likely):
        raise InputError(
            f"{table.place}: people may be in the columns {listed(likely)}; allowed: one, named by "
            f"person={likely[0]!r}"
        )
    return likely[0] if likely else None


def _tell_the_same(table: Table, names: list[str]) -> bool:
    """Whether columns sort the rows into the same people, under whatever labels."""
    codes = np.column_stack([codes_of(text_column(table, name))[1] for name in names])
    together = len(np.unique(codes, axis=0))
    return all(len(np.unique(column)) == together for column in codes.T)


def _holds_numbers(table: Table, name: str) -> bool:
    """Whether a column is there and numbers the trials; AB and BA in it would be a group."""
    scratch = Faults(table.place)
    if name in table.columns:
        number_column(table, name, "trial", scratch, -np.inf)
    return name in table.columns and not scratch


def _lacking(table: Table, lacking: dict[str, str], taken: Collection[str]) -> str:
    """In one line the columns that are not there, and the arguments that name them."""
    free = [name for name in table.columns if name not in taken]
    sides = counts_of_sides(table, taken) if "chosen" in lacking else []
    if len(sides) > 1:
        return (
            f"columns {' and '.join(sides[:2])} may count the answers for either side, and no "
            "column is called chosen; allowed: the columns left, right, chosen and count, with a "
            "row for each side, such as A,B,A,5 and A,B,B,3"
        )
    near = {
        role: _likely(role, free) if name == role else nearest(name, free)
        for role, name in lacking.items()
    }
    twice = {name for name in near.values() if [*near.values()].count(name) > 1}
    near = {role: None if name in twice else name for role, name in near.items()}
    options = ", ".join(f"{role}={near[role]!r}" if near[role] else f"{role}=NAME" for role in near)
    renamed = renamed_pair(table, free) if len(lacking) > 1 else None
    if renamed:
        name, versus = map(quoted, renamed)
        return (
            f"has columns such as {name}; allowed with a column a pair: names such as {versus}, "
            "or the columns left, right and chosen"
        )
    names = list(lacking.values())
    meant = next(iter(near.values()))
    if len(names) == 1 and meant:
        return f"has no column {names[0]}; did you mean {meant}? ({options})"
    several = f"s {', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else f" {names[0]}"
    them = "them" if len(names) > 1 else "it"
    hint = f"columns here: {listed(table.columns)}; name {them} by {options}"
    if table.place != "table" and len(table.columns) < 3:
        hint += ", or skip rows above the names by skip_rows=N"
    return f"has no column{several}; {hint}"


#: Parts of names that columns of a role have in other programs and languages.
_PARTS = {
    "left": (
        "left",
        "links",
        "gauche",
        "stim_l",
        "stim l",
        "stiml",
        "first",
        "imagel",
        "option1",
        "左",
    ),
    "right": (
        "right",
        "rechts",
        "droite",
        "stim_r",
        "stim r",
        "stimr",
        "second",
        "imager",
        "option2",
        "右",
    ),
    "chosen": (
        *("chosen", "choice", "chose", "keys", "clicked_name", "response", "answer", "select"),
        *("picked", "better", "gewählt", "wahl", "choix", "回答", "選択"),
    ),
}


def _likely(role: str, columns: Collection[str]) -> str | None:
    """The column that was probably meant: by its spelling, or by what other programs call it."""
    near = nearest(role, columns)
    for part in () if near else _PARTS.get(role, ()):
        hits = [column for column in columns if part in column.casefold()]
        hits = [column for column in hits if not column.casefold().endswith(("rt", "time"))]
        if len(hits) == 1:
            return hits[0]
    return near

"""Wide tables in which one person may have filled in several rows."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from nacreous.problem import InputError
from nacreous.scaling.data.column import codes_of, text_column
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.nothing import is_nothing
from nacreous.scaling.data.program import names_one_each, names_people
from nacreous.scaling.data.table import Table


def refuse_twice(table: Table, person: str | None, pairs: Collection[str]) -> None:
    """Refuse rows that would count as several people's, and that another column says are one's.

    Answers of one person hang together, and intervals that take them for several people's are too
    narrow; but a class may share an address, so that only who asked can tell. person: the column of
    people, None where each row counts as another one. Raises `InputError`.
    """
    own = np.arange(table.rows) if person is None else codes_of(text_column(table, person))[1]
    for name in table.columns:
        if name in {person, *pairs} or not (names_one_each(name) or names_people(name)):
            continue
        text = text_column(table, name)
        cells, code = codes_of(text)
        code = np.where(is_nothing(text), -1, code)
        for at in range(len(cells)):
            rows = np.flatnonzero(code == at)
            if len(set(own[rows])) > 1:
                other = "''" if person is None else repr(person)
                raise InputError(
                    f"{table.place}: {name} is {quoted(cells[at])} in rows "
                    f"{table.numbers[rows[0]]} and {table.numbers[rows[-1]]}, which would count as "
                    f"several people; allowed: person={name!r} where it says who answered, or "
                    f"person={other} where each is another's"
                )

"""Judgements of differences: of two pairs of stimuli, which pair differs more."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from os import PathLike
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said
from nacreous.problem import InputError
from nacreous.scaling.data.fault import listed
from nacreous.scaling.data.label import check_visible
from nacreous.scaling.data.quadruple_table import (
    FOUR,
    THREE,
    QuadrupleNames,
    judged,
    names_of,
)
from nacreous.scaling.data.table import Table, is_table, read_table, table_of
from nacreous.unchanging import released
from nacreous.value import value_class

Index = NDArray[np.int64]


@value_class
class Quadruples:
    """One row a judgement. Made by `read`, `of_table`, `of_tuples` or `of_triads`, which check all.

    - `stimuli`: labels in the order in which the scale is to run: natural ("2" before "10"), or
      as given. A pair's difference is its later stimulus less its earlier one, however the pair is
      written
    - `shown`: int64 [judgement, 4], indices into `stimuli`: the first pair, then the second one
    - `outcome`: int8 [judgement]: 1 where the first pair was judged the larger difference, -1 the
      second one
    - `people`, `person`: labels of people and int64 [judgement], an index into them; () and None
      where unknown

    >>> Quadruples.of_tuples([("1", "2", "3", "4", "first"), ("1", "3", "4", "5", "second")])
    Quadruples(2 judgements, 5 stimuli, people unknown)
    """

    stimuli: tuple[str, ...]
    shown: NDArray[np.int64]
    outcome: NDArray[np.int8]
    people: tuple[str, ...] = ()
    person: NDArray[np.int64] | None = None

    def __post_init__(self) -> None:
        """Refuse labels of stimuli and people with characters that a terminal would obey."""
        check_visible(self.stimuli, "stimuli")
        check_visible(self.people, "people")

    @classmethod
    def read(
        cls,
        path: str | PathLike[str],
        *,
        stimuli: Iterable[object] | None = None,
        **names: Unpack[QuadrupleNames],
    ) -> Quadruples:
        """Read judgements from a table as text (.csv, .tsv, .txt) or a .parquet file.

        Columns, which `names` may call otherwise (`larger="resp"`): `first_a` and `first_b`, the
        first pair; `second_a` and `second_b`, the second one; `larger`, the word first or second
        (`first_word="0"`, `second_word="1"` for other words); `person` is used where it is. Other
        columns are not read. `stimuli` gives the labels in an order of your own, and allows no
        others. Ties are refused: the model has none.
        Raises `InputError` with the row and column of each fault.
        """
        words = names_of(names, FOUR)
        table = read_table(path, [{words[role] for role in (*FOUR, "larger")}], rows="judgements")
        return cls._of(table, words, FOUR, stimuli)

    @classmethod
    def of_table(
        cls,
        table: object,
        *,
        stimuli: Iterable[object] | None = None,
        **names: Unpack[QuadrupleNames],
    ) -> Quadruples:
        """The judgements in a frame, a dict of columns or a list of dicts; see `read`.

        >>> table = {"first_a": [1], "first_b": [2], "second_a": [3], "second_b": [4]}
        >>> Quadruples.of_table(table | {"larger": ["second"], "person": ["mika"]})
        Quadruples(1 judgement, 4 stimuli, 1 person)
        """
        return cls._of(table_of(table), names_of(names, FOUR), FOUR, stimuli)

    @classmethod
    def of_tuples(
        cls, rows: Iterable[Sequence[object]], *, stimuli: Iterable[object] | None = None
    ) -> Quadruples:
        """Judgements as (first pair's two, second pair's two, "first" or "second"), or with person.

        >>> Quadruples.of_tuples([("a", "b", "c", "d", "first", "mika")]).people
        ('mika',)
        """
        columns = ("first_a", "first_b", "second_a", "second_b", "larger", "person")
        return cls._of(_table_of_tuples(rows, columns), names_of({}, FOUR), FOUR, stimuli)

    @classmethod
    def of_triads(
        cls,
        triads: object,
        *,
        stimuli: Iterable[object] | None = None,
        **names: Unpack[QuadrupleNames],
    ) -> Quadruples:
        """Triads: which of two stimuli differs more from a third that both are compared with.

        A path, a table or tuples, with columns `first`, `middle`, `second`, `larger` (the word
        first or second: the one that differs more from `middle`) and perhaps `person`.

        >>> Quadruples.of_triads([("1", "2", "5", "second"), ("2", "4", "5", "first")])
        Quadruples(2 judgements, 4 stimuli, people unknown)
        """
        words = names_of(names, THREE)
        if isinstance(triads, str | PathLike):
            wanted = [{words[role] for role in (*THREE, "larger")}]
            table = read_table(triads, wanted, rows="judgements")
        elif is_table(triads):
            table = table_of(triads)
        else:
            table = _table_of_tuples(triads, (*THREE, "larger", "person"))
        return cls._of(table, words, THREE, stimuli)

    @classmethod
    def _of(
        cls,
        table: Table,
        words: dict[str, str],
        roles: tuple[str, ...],
        stimuli: Iterable[object] | None,
    ) -> Quadruples:
        return cls(*judged(table, words, roles, stimuli))

    def __repr__(self) -> str:
        """In one line how much was judged, and by how many."""
        count = len(self.people)
        people = f"{count} {'person' if count == 1 else 'people'}" if count else "people unknown"
        judgements = f"{len(self)} {'judgement' if len(self) == 1 else 'judgements'}"
        return f"Quadruples({judgements}, {len(self.stimuli)} stimuli, {people})"

    def __len__(self) -> int:
        """How many judgements there are."""
        return len(self.outcome)

    @property
    def ordered(self) -> Index:
        """int64 [judgement, 4], as `shown`, the earlier stimulus of each pair before the later."""
        return np.sort(self.shown.reshape(-1, 2, 2), axis=2).reshape(-1, 4)

    def take(self, rows: Any) -> Quadruples:
        """The judgements of some rows (a mask, or positions), with the same stimuli and people."""
        person = None if self.person is None else released(self.person[rows])
        return Quadruples(
            self.stimuli,
            released(self.shown[rows]),
            released(self.outcome[rows]),
            self.people,
            person,
        )

    def of_person(self, person: str) -> Quadruples:
        """The judgements of one person; raises `InputError` for one that is not there.

        >>> rows = [("a", "b", "c", "d", "first", "mika"), ("a", "b", "c", "d", "second", "aoi")]
        >>> Quadruples.of_tuples(rows).of_person("aoi").outcome
        array([-1], dtype=int8)
        """
        if self.person is None or person not in self.people:
            allowed = listed(self.people) or "none, for people are unknown"
            raise InputError(f"there is no person {said(person)}; allowed: {allowed}")
        return self.take(self.person == self.people.index(person))


def _table_of_tuples(rows: object, columns: tuple[str, ...]) -> Table:
    """Tuples as a table; the last column, person, may be left out of all."""
    if isinstance(rows, str | bytes) or not isinstance(rows, Iterable):
        raise InputError(f"judgements is {said(rows)}; allowed: a list of tuples, or a table")
    kept = list(rows)
    lengths = (len(columns) - 1, len(columns))
    for number, row in enumerate(kept):
        if isinstance(row, str | bytes) or not isinstance(row, Sequence):
            raise InputError(f"judgements[{number}] is {said(row)}; allowed: a tuple")
        if len(row) not in lengths or len(row) != len(kept[0]):
            allowed = ", ".join(columns[:-1])
            raise InputError(
                f"judgements[{number}] has {len(row)} parts; allowed: {lengths[0]} ({allowed}), "
                f"or {lengths[1]} with person, in all alike"
            )
    if not kept:
        raise InputError("judgements is empty; allowed: one or more")
    named = columns[: len(kept[0])]
    return table_of({name: [row[at] for row in kept] for at, name in enumerate(named)})

"""All answers of a study as an Arrow table with the columns of an export, part by part."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sqlalchemy as sa

from nacreous.study.store import answers as answering
from nacreous.study.store import people, studies
from nacreous.study.store import progress as counting
from nacreous.study.store.codebook import CHOSEN_BY, COLUMNS, group_column
from nacreous.study.store.person_columns import PersonColumns
from nacreous.study.store.progress import Progress
from nacreous.study.task.tasks import columns_of_tasks

if TYPE_CHECKING:
    import pyarrow as pa

    from nacreous.study.task.column import Column

__all__ = ["AnswerTable", "levels_of"]

_TEXTS = (
    *("kind", "question", "shown_at", "answered_at", "received_at"),
    *("language", "excluded", "flags", *(column.name for column in columns_of_tasks())),
)
_OTHERS = ("seq", "trial", "response_ms", "simulated", "erased_as", "number", "person", "groups")


class AnswerTable:
    """The columns, described, and the rows of one study as the connection sees it.

    chosen_by: how the study chooses items by the answers so far; None where it does not.
    identifying: with what may identify a person.
    """

    def __init__(
        self, connection: sa.Connection, study: str, chosen_by: str | None, *, identifying: bool
    ) -> None:
        self.study = study
        self._connection, self._chosen_by = connection, chosen_by
        self._people = PersonColumns(connection, study, identifying=identifying)
        given = [json.loads(one) for one in people.groups_of_answers(connection, study)]
        names = sorted({name for one in given for name in one})
        self._groups = {name: group_column(name) for name in names}
        chosen = [] if chosen_by is None else [CHOSEN_BY]
        self.columns: list[Column] = [
            *COLUMNS,
            *chosen,
            *self._people.columns,
            *self._groups.values(),
        ]

    def progress(self) -> Progress:
        """The counts of these rows and people."""
        state = studies.states(self._connection)[self.study]
        return counting.progress(self._connection, self.study, state)

    def empty(self) -> pa.Table:
        """The columns without a row."""
        names = (*_TEXTS, *_OTHERS)
        return self._table(dict.fromkeys(names, ()))

    def parts(self) -> Iterator[pa.Table]:
        """The rows in the order of arrival, `answers.ROWS` at a time."""
        for part in answering.parts(self._connection, self.study, (*_TEXTS, *_OTHERS)):
            yield self._table(part)

    def _table(self, part: Mapping[str, Sequence[Any]]) -> pa.Table:
        import pyarrow as pa

        values = {**_values(part), **self._people.of(part["number"])}
        if self._chosen_by is not None:
            values[CHOSEN_BY.name] = pa.array([self._chosen_by] * len(part["seq"]), pa.string())
        levels = levels_of(pa.array(part["groups"], pa.string()).dictionary_encode(), self._groups)
        values.update({self._groups[name].name: level for name, level in levels.items()})
        return pa.table({column.name: values[column.name] for column in self.columns})


def _values(part: Mapping[str, Sequence[Any]]) -> dict[str, Any]:
    """What is known of the answers themselves."""
    import pyarrow as pa

    return {
        **{name: pa.array(part[name], pa.string()) for name in _TEXTS},
        "sequence": pa.array(part["seq"], pa.int64()),
        "person": pa.array(part["person"], pa.string()),
        "trial": pa.array(part["trial"], pa.int32()),
        "response_ms": pa.array(part["response_ms"], pa.float64()),
        "simulated": pa.array(part["simulated"], pa.bool_()),
        "erased": pa.array([erased is not None for erased in part["erased_as"]], pa.bool_()),
    }


def levels_of(groups: pa.DictionaryArray, names: Collection[str] | None = None) -> dict[str, Any]:
    """Each group's level by row, as Arrow dictionaries, from everyone's groups as JSON.

    names: of the groups; all that are there by default.

    >>> import pyarrow as pa
    >>> levels_of(pa.array(['{"sex":"f"}', None]).dictionary_encode())["sex"].to_pylist()
    ['f', None]
    """
    import pyarrow as pa

    given = [json.loads(one) for one in groups.dictionary.to_pylist()]
    wanted = sorted({name for one in given for name in one}) if names is None else names
    return {
        name: pa.DictionaryArray.from_arrays(
            groups.indices, pa.array([one.get(name) for one in given], pa.string())
        )
        for name in wanted
    }

"""The tables of an export: answers, a row each; people, a row each; the log, a row a line."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nacreous.problem import InputError
from nacreous.study.design.design import Design
from nacreous.study.store import check
from nacreous.study.store.codebook import (
    BEFOREHAND,
    CHOSEN_BY,
    COLUMNS,
    LOG,
    LOG_IDENTIFYING,
    PEOPLE,
    PLAN,
    group_column,
)
from nacreous.study.store.disclosure import plain_flags
from nacreous.study.store.flags import flags_of_people
from nacreous.study.store.person_columns import Known, PersonColumns
from nacreous.study.task.column import Column
from nacreous.study.task.tasks import TASKS, columns_of_tasks

if TYPE_CHECKING:
    import pyarrow as pa

    from nacreous.study.store.store import Store

__all__ = ["TABLES", "Table", "levels_of"]


@dataclass(frozen=True)
class Table:
    """Columns, described, and Arrow tables of them in that order.

    empty: the columns without a row. parts: the rows, some thousands at a time.
    """

    columns: tuple[Column, ...]
    empty: pa.Table
    parts: Callable[[], Iterator[pa.Table]]


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


def _levels(groups: Sequence[Mapping[str, str]]) -> dict[Column, list[str | None]]:
    names = sorted({name for given in groups for name in given})
    return {group_column(name): [given.get(name) for given in groups] for name in names}


def _design_of(store: Store, study: str) -> Design | None:
    """The study's design; None where it is of another version, which costs no answer."""
    stored = store.manifest(study).get("design")
    if not isinstance(stored, dict):
        return None
    try:
        return Design.check(copy.deepcopy(stored), f"study {study[:12]}", Path())
    except InputError:
        return None


def _answers(store: Store, study: str, identifying: bool) -> Table:
    design = _design_of(store, study)
    chosen_by = None if design is None else TASKS[design.task].chosen_by(design.asked)
    people = PersonColumns(_known(store, study, design), identifying=identifying)
    given = [json.loads(one) for one in store.groups_of_answers(study)]
    groups = {name: group_column(name) for name in sorted({name for one in given for name in one})}
    columns = (*COLUMNS, CHOSEN_BY, *people.columns, *groups.values())

    def made(part: Mapping[str, Sequence[Any]]) -> pa.Table:
        import pyarrow as pa

        values = {**_given(part, identifying), **people.of(part["number"])}
        values[CHOSEN_BY.name] = pa.array([chosen_by or BEFOREHAND] * len(part["seq"]), pa.string())
        levels = levels_of(pa.array(part["groups"], pa.string()).dictionary_encode(), groups)
        values.update({groups[name].name: level for name, level in levels.items()})
        return pa.table({column.name: values[column.name] for column in columns})

    names = (*_TEXTS, *_OTHERS)
    empty = made(dict.fromkeys(names, ()))
    return Table(columns, empty, lambda: map(made, store.parts(study, names)))


_TEXTS = (
    *("kind", "question", "shown_at", "answered_at", "received_at"),
    *("language", "excluded", "flags", *(column.name for column in columns_of_tasks())),
)
_OTHERS = (
    *("seq", "trial", "response_ms", "simulated"),
    *("erased_as", "number", "person", "groups"),
)


def _given(part: Mapping[str, Sequence[Any]], identifying: bool) -> dict[str, Any]:
    """What is known of the answers themselves."""
    import pyarrow as pa

    flags = part["flags"] if identifying else [plain_flags(one) for one in part["flags"]]
    return {
        **{name: pa.array(part[name], pa.string()) for name in (*_TEXTS, "person")},
        "flags": pa.array(flags, pa.string()),
        "sequence": pa.array(part["seq"], pa.int64()),
        "trial": pa.array(part["trial"], pa.int32()),
        "response_ms": pa.array(part["response_ms"], pa.float64()),
        "simulated": pa.array(part["simulated"], pa.bool_()),
        "erased": pa.array([erased is not None for erased in part["erased_as"]], pa.bool_()),
    }


def _known(store: Store, study: str, design: Design | None) -> Known:
    """What is known of everyone; without a design, and so without flags, the rest of it."""
    people = store.sessions(study)
    return Known(
        people=people,
        checks=store.screen_checks(study),
        labels={
            one.number: one.label for one in store.invitations(study) if one.number is not None
        },
        flags={} if design is None else flags_of_people(design, store.watched(study), people),
    )


def _people(store: Store, study: str, identifying: bool) -> Table:
    import pyarrow as pa

    found = store.progress(study).people
    everyone = [one.session for one in found]
    numbers = [None if one.erased_at is not None else one.number for one in everyone]
    plans = [
        None if number is None else store.plan(one.id)
        for one, number in zip(everyone, numbers, strict=True)
    ]
    values: dict[str, Any] = {
        "person": pa.array([str(one.number) for one in everyone], pa.string()),
        "language": pa.array([one.language for one in everyone], pa.string()),
        "excluded": pa.array([one.excluded_reason for one in everyone], pa.string()),
        "simulated": pa.array([one.simulated > 0 for one in found], pa.bool_()),
        "erased": pa.array([number is None for number in numbers], pa.bool_()),
        "slot": pa.array([one.slot for one in everyone], pa.int32()),
        "answers": pa.array([one.answers for one in found], pa.int32()),
        "trials": pa.array([None if plan is None else len(plan) for plan in plans], pa.int32()),
        "plan": pa.array([None if plan is None else _json(plan) for plan in plans], pa.string()),
    }
    groups = _levels([one.groups for one in everyone])
    for column, levels in groups.items():
        values[column.name] = pa.array(levels, pa.string())
    known = _known(store, study, _design_of(store, study))
    people = PersonColumns(known, identifying=identifying)
    values.update(people.of(numbers))
    return _table((*PEOPLE, *people.columns, PLAN, *groups), values)


def _log(store: Store, study: str, identifying: bool) -> Table:
    import pyarrow as pa

    numbers = {one.id: str(one.number) for one in store.sessions(study)}
    lines = store.events(study)
    values = {
        "at": pa.array([check.written("at", one.at) for one in lines], pa.string()),
        "what": pa.array([one.what for one in lines], pa.string()),
        "person": pa.array([numbers.get(one.session or "") for one in lines], pa.string()),
        "who": pa.array([one.who for one in lines], pa.string()),
        "detail": pa.array([_json(one.detail) for one in lines], pa.string()),
    }
    return _table((*LOG, *(LOG_IDENTIFYING if identifying else ())), values)


def _table(columns: Sequence[Column], values: Mapping[str, Any]) -> Table:
    import pyarrow as pa

    data = pa.table({column.name: values[column.name] for column in columns})
    return Table(tuple(columns), data.slice(0, 0), lambda: iter([data]))


def _json(value: Any) -> str:
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False)


#: By name, each made from a store, a study, and whether with what may identify a person.
TABLES: Mapping[str, Callable[[Store, str, bool], Table]] = {
    "answers": _answers,
    "people": _people,
    "log": _log,
}

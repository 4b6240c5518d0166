"""The tables of an export: answers, a row each; people, a row each; the log, a row a line."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nacreous.problem import InputError
from nacreous.study.design.design import Design
from nacreous.study.store import check
from nacreous.study.store.codebook import (
    CHOSEN_BY,
    COLUMNS,
    LOG,
    LOG_IDENTIFYING,
    PEOPLE,
    PLAN,
    group_column,
)
from nacreous.study.store.flags import flags_of_people
from nacreous.study.store.person_columns import Known, person_columns
from nacreous.study.task.column import Column
from nacreous.study.task.row import Row, person_of
from nacreous.study.task.tasks import TASKS, columns_of_tasks

if TYPE_CHECKING:
    from nacreous.study.store.store import Store

__all__ = ["TABLES", "Table", "groups_of"]


@dataclass(frozen=True)
class Table:
    """Columns, described, and an Arrow table of them in that order."""

    columns: tuple[Column, ...]
    data: Any


def groups_of(rows: Sequence[Row]) -> dict[Column, list[str | None]]:
    """Each group's level by row."""
    return _levels([json.loads(row["groups"] or "{}") for row in rows])


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
    import pyarrow as pa

    rows = store.answers(study)
    texts = (
        *("kind", "question", "shown_at", "answered_at", "received_at"),
        *("language", "excluded", "flags", *(column.name for column in columns_of_tasks())),
    )
    told: Sequence[Mapping[str, Any]] = rows
    values: dict[str, Any] = {
        name: pa.array([row[name] for row in told], pa.string()) for name in texts
    }
    values["sequence"] = pa.array([row["seq"] for row in rows], pa.int64())
    values["person"] = pa.array([person_of(row) for row in rows], pa.string())
    values["trial"] = pa.array([row["trial"] for row in rows], pa.int32())
    values["response_ms"] = pa.array([row["response_ms"] for row in rows], pa.float64())
    values["simulated"] = pa.array([row["simulated"] for row in rows], pa.bool_())
    values["erased"] = pa.array([row["erased_as"] is not None for row in rows], pa.bool_())
    design = _design_of(store, study)
    chosen_by = None if design is None else TASKS[design.task].chosen_by(design.asked)
    if chosen_by is not None:
        values[CHOSEN_BY.name] = pa.array([chosen_by] * len(rows), pa.string())
    groups = groups_of(rows)
    for column, levels in groups.items():
        values[column.name] = pa.array(levels, pa.string())
    known = _known(store, study, design, rows)
    numbers = [row["number"] for row in rows]
    people = person_columns(known, numbers, identifying=identifying)
    values.update({column.name: given for column, given in people.items()})
    columns = (*COLUMNS, *([] if chosen_by is None else [CHOSEN_BY]), *people, *groups)
    return _table(columns, values)


def _known(store: Store, study: str, design: Design | None, rows: Sequence[Row]) -> Known:
    """What is known of everyone; without a design, and so without flags, the rest of it."""
    people = store.sessions(study)
    return Known(
        people=people,
        checks=store.screen_checks(study),
        labels={
            one.number: one.label for one in store.invitations(study) if one.number is not None
        },
        flags={} if design is None else flags_of_people(design, rows, people),
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
    known = _known(store, study, _design_of(store, study), store.answers(study))
    people = person_columns(known, numbers, identifying=identifying)
    values.update({column.name: given for column, given in people.items()})
    return _table((*PEOPLE, *people, PLAN, *groups), values)


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
    return Table(tuple(columns), data)


def _json(value: Any) -> str:
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False)


#: By name, each made from a store, a study, and whether with what may identify a person.
TABLES: Mapping[str, Callable[[Store, str, bool], Table]] = {
    "answers": _answers,
    "people": _people,
    "log": _log,
}

"""Answers out of the store: CSV, Parquet, Psych-DS, and to `nacreous.scaling`.

Excluded, simulated and erased rows are marked in files, never left out.
"""

from __future__ import annotations

import codecs
import copy
import json
import re
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nacreous import file, folder
from nacreous.problem import InputError
from nacreous.study.design.design import Design
from nacreous.study.store.codebook import CHOSEN_BY, COLUMNS, description, group_column
from nacreous.study.store.person_columns import person_columns
from nacreous.study.store.spreadsheet import defused, plain
from nacreous.study.store.store import Store
from nacreous.study.task import counting
from nacreous.study.task.column import Column
from nacreous.study.task.row import Row, person_of
from nacreous.study.task.tasks import TASKS, columns_of_tasks, task_of

if TYPE_CHECKING:
    from nacreous.scaling import Answers, Comparisons

_RECORD = "dataset_description.json"
#: Rows written at a time.
_ROWS = 65_536
_MAKER = "nacreous study export"


def export(
    store: Store,
    study: str,
    output: str | PathLike[str],
    *,
    bom: bool = False,
    identifying: bool = False,
) -> int:
    """Write all answers of a study to .csv, .parquet or a Psych-DS folder; return how many.

    A name without an ending is a folder, which must not be there yet: `dataset_description.json`
    describes every column, and `data/` holds the answers. A file or folder is whole or absent.
    bom: begin a .csv with a byte order mark, by which Excel knows UTF-8. In CSV texts that a
    spreadsheet would take for a formula are defused (`nacreous.study.store.spreadsheet`).
    identifying: with what may identify a person (`nacreous.study.store.person_columns`), readable
    by the owner alone. Raises `InputError` where it cannot be written.
    """
    suffix = Path(output).suffix.lower()
    if bom and suffix != ".csv":
        raise InputError(f"{output}: bom is for .csv files; allowed without it: any other output")
    if suffix:
        file.check_output(output, [".csv", ".parquet"])
        file.require_apart([output], [store.place])
    columns, table = _table(store, study, identifying)
    if suffix:
        with file.atomic(output, private=identifying) as temporary:
            _write(table, temporary, suffix, bom)
    else:
        _write_psych_ds(store, study, columns, table, Path(output), private=identifying)
    return int(table.num_rows)


def answers_of(store: Store, study: str, question: str, *, simulated: bool = False) -> Answers:
    """The answers to one question that count (`nacreous.study.task.counting`), ready for a scale.

    People are named by number, erased ones by their random names; trials give the order, and each
    group is a group. `simulated` takes those that a program gave, instead of people's. Raises
    `InputError` where none are left.

    >>> from tempfile import TemporaryDirectory
    >>> from nacreous.study.store import Answer
    >>> from nacreous.study.task.response import Response
    >>> pair = {"left": "a", "right": "b"}
    >>> with TemporaryDirectory() as folder, Store.open(folder) as store:
    ...     study = store.add_study({"design_hash": "ab" * 32})
    ...     store.set_registration(study, "open", "lab")
    ...     session, _ = store.enter(study, "en", {"sex": "f"})
    ...     store.consent(session.id)
    ...     _ = store.answer(session.id, Answer(0, "deeper", pair, Response("left")))
    ...     answers_of(store, study, "deeper")
    Answers(1 answers, 2 stimuli, 1 person)
    """
    rows = [
        row
        for row in store.answers(study)
        if row["question"] == question and counting.counts(row, simulated=simulated)
    ]
    if not rows:
        raise InputError(f"no answers to {question!a} count yet; wanted: at least one")
    groups = {column.name: levels for column, levels in _groups(rows).items()}
    return task_of(rows[0]).answers(rows, groups)


def counts(store: Store, study: str, question: str, *, simulated: bool = False) -> Comparisons:
    """The same, counted by pair."""
    return answers_of(store, study, question, simulated=simulated).comparisons()


def _groups(rows: Sequence[Row]) -> dict[Column, list[str | None]]:
    """Each group's level by row."""
    groups = [json.loads(row["groups"] or "{}") for row in rows]
    names = sorted({name for given in groups for name in given})
    return {group_column(name): [given.get(name) for given in groups] for name in names}


def _table(store: Store, study: str, identifying: bool) -> tuple[list[Column], Any]:
    """The columns described, and a pyarrow table of them."""
    import pyarrow as pa

    store_rows = store.answers(study)
    rows: Sequence[Mapping[str, Any]] = store_rows
    texts = (
        *("kind", "question", "shown_at", "answered_at", "received_at"),
        *("language", "excluded", "flags", *(column.name for column in columns_of_tasks())),
    )
    values: dict[str, Any] = {
        name: pa.array([row[name] for row in rows], pa.string()) for name in texts
    }
    values["sequence"] = pa.array([row["seq"] for row in rows], pa.int64())
    values["person"] = pa.array([person_of(row) for row in rows], pa.string())
    values["trial"] = pa.array([row["trial"] for row in rows], pa.int32())
    values["response_ms"] = pa.array([row["response_ms"] for row in rows], pa.float64())
    values["simulated"] = pa.array([row["simulated"] for row in rows], pa.bool_())
    values["erased"] = pa.array([row["erased_as"] is not None for row in rows], pa.bool_())
    chosen_by = _chosen_by(store, study)
    if chosen_by is not None:
        values[CHOSEN_BY.name] = pa.array([chosen_by] * len(rows), pa.string())
    groups = _groups(store_rows)
    for column, levels in groups.items():
        values[column.name] = pa.array(levels, pa.string())
    numbers = [row["number"] for row in store_rows]
    people = person_columns(store, study, numbers, identifying=identifying)
    values.update({column.name: told for column, told in people.items()})
    columns = [*COLUMNS, *([] if chosen_by is None else [CHOSEN_BY]), *people, *groups]
    return columns, pa.table({column.name: values[column.name] for column in columns})


def _chosen_by(store: Store, study: str) -> str | None:
    """How the study chooses items by the answers so far; None where it does not."""
    stored = store.manifest(study).get("design")
    if not isinstance(stored, dict):
        return None
    try:
        design = Design.check(copy.deepcopy(stored), f"study {study[:12]}", Path())
    except InputError:  # of another version, say; what was collected is exported all the same
        return None
    return TASKS[design.task].chosen_by(design.asked)


def _write(table: Any, path: Path, suffix: str, bom: bool = False) -> None:
    from pyarrow import csv, parquet

    schema = plain(table.slice(0, 0)).schema
    with path.open("wb") as stream:
        stream.write(codecs.BOM_UTF8 if bom else b"")
        make = csv.CSVWriter if suffix == ".csv" else parquet.ParquetWriter
        with make(stream, schema) as writer:
            # In parts, for what is known of a person is long, and stands in each row.
            for start in range(0, table.num_rows, _ROWS):
                part = plain(table.slice(start, _ROWS))
                writer.write_table(defused(part) if suffix == ".csv" else part)


def _write_psych_ds(
    store: Store, study: str, columns: Sequence[Column], table: Any, output: Path, *, private: bool
) -> None:
    if output.exists():
        raise InputError(f"{output}: is there already; wanted: a folder that is not")
    design = store.manifest(study).get("design")
    name = str(design.get("name", "")) if isinstance(design, Mapping) else ""
    word = re.sub("[^a-z0-9]", "", name.lower()) or study[:12]
    told = description(name or f"study {study[:12]}", study, columns, store.progress(study))
    with folder.whole(output, [_RECORD, "data"], _RECORD, _MAKER) as temporary:
        (temporary / "data").mkdir()
        data = temporary / "data" / f"study-{word}_data.csv"
        data.touch(0o600 if private else 0o666)
        _write(table, data, ".csv")
        text = json.dumps(told, indent=2, ensure_ascii=False) + "\n"
        (temporary / _RECORD).write_text(text, encoding="utf-8", newline="\n")

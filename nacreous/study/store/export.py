"""Answers out of the store: CSV, Parquet, Psych-DS, and to `nacreous.scaling`.

Excluded, simulated and erased rows are marked in files, never left out.
"""

from __future__ import annotations

import codecs
import json
import re
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nacreous import file, folder
from nacreous.problem import InputError
from nacreous.study.store import check
from nacreous.study.store.codebook import description
from nacreous.study.store.spreadsheet import defused, plain
from nacreous.study.store.store import Store
from nacreous.study.store.tables import TABLES, Table, groups_of
from nacreous.study.task import counting
from nacreous.study.task.tasks import task_of

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
    table: str = "answers",
    bom: bool = False,
    identifying: bool = False,
) -> int:
    """Write a table of a study to .csv or .parquet, or all to a Psych-DS folder; return its rows.

    table: "answers", "people" (everyone who has entered) or "log". A name without an ending is a
    folder, which must not be there yet: `dataset_description.json` describes every column, and
    `data/` holds all three. A file or folder is whole or absent.
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
    made = TABLES[check.one_of("table", table, TABLES)](store, study, identifying)
    if suffix:
        with file.atomic(output, private=identifying) as temporary:
            _write(made.data, temporary, suffix, bom)
    else:
        tables = {
            name: made if name == table else make(store, study, identifying)
            for name, make in TABLES.items()
        }
        _write_psych_ds(store, study, tables, Path(output), private=identifying)
    return int(made.data.num_rows)


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
    groups = {column.name: levels for column, levels in groups_of(rows).items()}
    return task_of(rows[0]).answers(rows, groups)


def counts(store: Store, study: str, question: str, *, simulated: bool = False) -> Comparisons:
    """The same, counted by pair."""
    return answers_of(store, study, question, simulated=simulated).comparisons()


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
    store: Store, study: str, tables: Mapping[str, Table], output: Path, *, private: bool
) -> None:
    if output.exists():
        raise InputError(f"{output}: is there already; wanted: a folder that is not")
    design = store.manifest(study).get("design")
    name = str(design.get("name", "")) if isinstance(design, Mapping) else ""
    word = re.sub("[^a-z0-9]", "", name.lower()) or study[:12]
    first = {column.name: column for table in tables.values() for column in table.columns}
    first.update({column.name: column for column in tables["answers"].columns})
    told = description(
        name or f"study {study[:12]}", study, list(first.values()), store.progress(study)
    )
    with folder.whole(output, [_RECORD, "data"], _RECORD, _MAKER) as temporary:
        (temporary / "data").mkdir()
        for called, table in tables.items():
            kind = "" if called == "answers" else f"_description-{called}"
            data = temporary / "data" / f"study-{word}{kind}_data.csv"
            data.touch(0o600 if private else 0o666)
            _write(table.data, data, ".csv")
        text = json.dumps(told, indent=2, ensure_ascii=False) + "\n"
        (temporary / _RECORD).write_text(text, encoding="utf-8", newline="\n")

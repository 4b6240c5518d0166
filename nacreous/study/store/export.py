"""Answers out of the store: CSV, Parquet, Psych-DS, and to `nacreous.scaling`.

Excluded, simulated and erased rows are marked in files, never left out.
"""

from __future__ import annotations

import codecs
import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import islice
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from nacreous import file, folder
from nacreous.number import truth_of
from nacreous.problem import InputError
from nacreous.scaling.data.column import Grouping
from nacreous.scaling.data.column import group_column as grouping_of
from nacreous.scaling.data.spreadsheet import defused, plain
from nacreous.scaling.data.table import table_of
from nacreous.study.memory import give_back
from nacreous.study.store import answers as answering
from nacreous.study.store import check, people
from nacreous.study.store.answers import COUNTED, ROWS
from nacreous.study.store.codebook import description, group_column
from nacreous.study.store.coded import Coded
from nacreous.study.store.store import Store
from nacreous.study.store.tables import TABLES, Table, levels_of
from nacreous.study.task.tasks import task_of
from nacreous.unchanging import released

if TYPE_CHECKING:
    import pyarrow as pa

    from nacreous.scaling import Answers, Comparisons

_RECORD = "dataset_description.json"
#: Parts of a table that are one row group of Parquet: 65,536 rows.
_ROW_GROUP = 65_536 // ROWS
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
    spreadsheet would take for a formula are defused (`nacreous.scaling.data.spreadsheet`).
    identifying: with what may identify a person (`nacreous.study.store.person_columns`), readable
    by the owner alone. Raises `InputError` where it cannot be written.
    """
    bom, identifying = truth_of("bom", bom), truth_of("identifying", identifying)
    suffix = Path(output).suffix.lower()
    if bom and suffix != ".csv":
        raise InputError(f"{output}: bom is for .csv files; allowed without it: any other output")
    if suffix:
        file.check_output(output, [".csv", ".parquet"])
        file.require_apart([output], [store.place])
    made = TABLES[check.one_of("table", table, TABLES)](store, study, identifying)
    if suffix:
        with file.atomic(output, private=identifying) as temporary:
            return _write(made, temporary, suffix, bom)
    tables = {
        name: made if name == table else make(store, study, identifying)
        for name, make in TABLES.items()
    }
    return _write_psych_ds(store, study, tables, Path(output), private=identifying)[table]


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
    simulated = truth_of("simulated", simulated)
    columns = Coded(COUNTED)
    with store.reading() as connection:
        for part in answering.counting_parts(connection, study, question, simulated=simulated):
            columns.add(dict(zip(part.column_names, part.columns, strict=True)))
        known = people.by_session(connection, study)
        table = columns.table()
        if not table.num_rows:
            other = answering.counting_parts(connection, study, question, simulated=not simulated)
            hint = _hint_of(simulated) if any(part.num_rows for part in other) else ""
            raise InputError(f"no answers to {question!a} count yet; wanted: at least one{hint}")
    held = {name: table[name] for name in table.column_names if name != "who"}
    person, given = _of_people(table["who"].combine_chunks(), known)
    del table  # each column is as large as all that a part of the answers takes
    groups = {group_column(name).name: _grouping(level) for name, level in levels_of(given).items()}
    found = task_of({}).answers({**held, "person": person}, groups)
    del held, person, given, groups
    give_back()
    return found


def _hint_of(simulated: bool) -> str:
    """Where answers of the other kind would count."""
    way, whose = ("without", "people") if simulated else ("with", "simulated observers")
    return f"; those of {whose} do {way} --simulated"


def _of_people(
    who: pa.DictionaryArray, known: Mapping[str, tuple[str, str]]
) -> tuple[pa.DictionaryArray, pa.DictionaryArray]:
    """By row who answered, by number, and the groups as JSON; erased people have a name alone."""
    import pyarrow as pa

    found = [known.get(one, (one, "{}")) for one in who.dictionary.to_pylist()]
    named = pa.array([person for person, _ in found], pa.string())
    given = pa.array([groups for _, groups in found], pa.string())
    rows = who.indices
    return (
        pa.DictionaryArray.from_arrays(rows, named),
        pa.DictionaryArray.from_arrays(rows, given),
    )


def _grouping(levels: pa.DictionaryArray) -> Grouping:
    """Levels by row as a group, each looked at once. A level such as NA was declared."""
    codes = np.asarray(levels.indices.fill_null(-1))
    if not len(levels.dictionary):
        return Grouping((), codes.astype(np.int64))
    table = table_of({"level": levels.dictionary.to_pylist()})
    known = grouping_of(table, "level", declared=True)
    return replace(known, code=released(np.append(known.code, -1)[codes]))


def counts(store: Store, study: str, question: str, *, simulated: bool = False) -> Comparisons:
    """The same, counted by pair."""
    return answers_of(store, study, question, simulated=simulated).comparisons()


def _write(table: Table, path: Path, suffix: str, bom: bool = False) -> int:
    """Part by part, for what is known of a person is long, and stands in each row."""
    from pyarrow import csv, parquet

    csv_wanted = suffix == ".csv"
    make = csv.CSVWriter if csv_wanted else parquet.ParquetWriter
    rows = 0
    with path.open("wb") as stream:
        stream.write(codecs.BOM_UTF8 if bom else b"")
        with make(stream, plain(table.empty).schema) as writer:
            parts = (plain(part) for part in table.parts())
            for part in map(defused, parts) if csv_wanted else _larger(parts):
                writer.write_table(part)
                rows += part.num_rows
    return rows


def _larger(parts: Iterator[pa.Table]) -> Iterator[pa.Table]:
    """Parts joined, so that each is a row group of Parquet worth reading."""
    import pyarrow as pa

    while some := list(islice(parts, _ROW_GROUP)):
        yield pa.concat_tables(some).combine_chunks()


def _write_psych_ds(
    store: Store, study: str, tables: Mapping[str, Table], output: Path, *, private: bool
) -> dict[str, int]:
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
        rows = {}
        for called, table in tables.items():
            kind = "" if called == "answers" else f"_description-{called}"
            data = temporary / "data" / f"study-{word}{kind}_data.csv"
            data.touch(0o600 if private else 0o666)
            rows[called] = _write(table, data, ".csv")
        text = json.dumps(told, indent=2, ensure_ascii=False) + "\n"
        (temporary / _RECORD).write_text(text, encoding="utf-8", newline="\n")
    return rows

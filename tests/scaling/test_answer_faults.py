"""Faults of answers, every one named by row and column."""

from __future__ import annotations

import gzip
import zipfile
from typing import Any

import numpy as np
import pytest

from nacreous.scaling import Answers
from nacreous.scaling.data import table as table_module
from tests.scaling.answer_tables import CSV, TABLE, refusal, written


def without(name: str) -> dict[str, Any]:
    return {key: column for key, column in TABLE.items() if key != name}


@pytest.mark.parametrize(
    ("table", "message"),
    [
        (without("left"), 'table: has no column left; columns here: "person", "right"'),
        (without("chosen") | {"chossen": TABLE["chosen"]}, "table: has no column chosen; did you"),
        (TABLE | {"chosen": ["2", "left", "2", "3"]}, 'table: row 3: chosen is "3"; allowed: "9"'),
        (TABLE | {"chosen": ["9", "left", "2", "2"]}, 'table: row 0: chosen is "9"; allowed: "2"'),
        (
            TABLE | {"chosen": ["2", "Lefft", "2", "2"]},
            'table: row 1: chosen is "Lefft"; allowed: ',
        ),
        (TABLE | {"left": ["2", "9", "2", "9"]}, 'table: row 1: "9" is paired with itself'),
        (TABLE | {"left": ["2", "", "2", "9"]}, "table: row 1: left is empty; allowed: a label"),
        (TABLE | {"left": ["2", None, "2", "9"]}, "table: row 1: left is empty; allowed: a label"),
        (TABLE | {"left": ["2", "  ", "2", "9"]}, "table: row 1: left is empty; allowed: a label"),
        (TABLE | {"left": ["2", "x" * 201, "2", "9"]}, "table: row 1: left is 201 characters long"),
        (TABLE | {"chosen": ["2", None, "2", "9"]}, "table: row 1: chosen is empty; allowed: "),
        (
            TABLE | {"person": ["a", "", "b", "c"]},
            "table: row 1: person is empty; allowed: a label",
        ),
        (TABLE | {"left": ["2"] * 3}, "table: columns differ in length (person has 4, left has 3"),
        (TABLE | {"left": ["\ud800", "9", "2", "9"]}, "table: column left holds half a character"),
        (
            TABLE | {"left": [b"2"] * 3 + [b"\xff"]},
            "table: column left holds bytes that are no text",
        ),
        (TABLE | {"left": "abcd"}, "table: column left is 'abcd'; allowed: a list of values"),
        (TABLE | {"left": np.ones((4, 2))}, "table: column left is array("),
        (TABLE | {"left": [["a"]] * 4}, "table: column left holds lists"),
        (TABLE | {"left": [1, 2.5, "x", 3]}, "table: row 1: left is 2.5; allowed: text or a whole"),
        (
            TABLE | {"response_s": [1, -2, 2, 3]},
            'table: row 1: response_s is "-2"; allowed: a numb',
        ),
        (
            TABLE | {"response_s": [1, "slow", 2, 3]},
            'table: row 1: response_s is "slow"; allowed: ',
        ),
        (TABLE | {"response_s": [1, 1e999, 2, 3]}, 'table: row 1: response_s is "inf"; allowed: '),
        (TABLE | {"response_ms": [1] * 4}, "table: has both response_s and response_ms; allowed: "),
        (
            TABLE | {"time": ["2026-13-45"] * 4},
            'table: row 0: time is "2026-13-45"; allowed: a time',
        ),
        (TABLE | {"time": ["noon"] * 4}, 'table: row 0: time is "noon"; allowed: a number'),
        (TABLE | {" left ": ["2"] * 4}, 'table: has more than one column "left"; allowed: one of'),
        ({name: [] for name in TABLE}, "table: has no rows; allowed: 1 to 100000000 answers"),
        ([dict.fromkeys(TABLE, "a"), ["a"]], "table: row 1 is ['a']; allowed: a dict, as row 0 is"),
        ([TABLE | {None: ["x"]}], "table: row 0 has more cells than columns; allowed: as many"),
        ({}, "table: has no rows; allowed: 1 to 100000000 answers"),
        (
            [1, 2],
            "the table is [1, 2]; allowed: a pandas, Polars or pyarrow table, a dict of co",
        ),
        (
            None,
            "the table is None; allowed: a pandas, Polars or pyarrow table, a dict of columns, or",
        ),
    ],
    ids=lambda case: str(case)[-50:],
)
def test_each_fault_is_named(table, message):
    assert refusal(lambda: Answers.of_table(table))[0].startswith(message)


def test_one_stimulus_cannot_be():
    """Two labels at least are in every row, for nothing is paired with itself."""
    table = {"left": ["a", "a"], "right": ["a", "a"], "chosen": ["a", "a"]}
    lines = refusal(lambda: Answers.of_table(table))
    assert lines[0] == 'table: row 0: "a" is paired with itself; allowed: two stimuli'


def test_names_of_columns_are_checked():
    def lines(**names: Any) -> list[str]:
        return refusal(lambda: Answers.of_table(TABLE, **names))

    assert lines(person="who")[0].startswith("table: has no column who; columns here: ")
    assert lines(left="lefft")[0] == (
        "table: has no column lefft; did you mean left? (left='left')"
    )
    assert lines(lefft="left")[0] == '"lefft" is no role of a column; did you mean left?'
    assert lines(left="right")[0] == "table: column right is used as left and as right; allowed: " \
        "one of them"  # fmt: skip


def test_faults_are_told_together_and_counted(tmp_path):
    rows = ["a,b,c"] * 30 + ["a,a,a"]
    path = written(tmp_path, "\n".join(["left,right,chosen", *rows]))
    lines = refusal(lambda: Answers.read(path))
    assert lines == [f'{path}: row 32: "a" is paired with itself; allowed: two stimuli']
    path = written(tmp_path, "\n".join(["left,right,chosen", *rows[:-1], ",b,b"]))
    assert refusal(lambda: Answers.read(path)) == [
        f"{path}: row 32: left is empty; allowed: a label"
    ]
    path = written(tmp_path, "\n".join(["left,right,chosen", *rows[:-1], "a,c,a"]))
    lines = refusal(lambda: Answers.read(path))
    assert lines[0] == f'{path}: row 2: chosen is "c"; allowed: "a" or "b", left, right or tie'
    assert lines[5:] == [f"{path}: 30 problems in all"]


def test_the_same_answer_twice_is_refused_and_named():
    again = {name: [*column, column[1]] for name, column in TABLE.items()}
    lines = refusal(lambda: Answers.of_table(again))
    assert lines[0].startswith("table: row 4: repeats row 1: the same person on the same pair, and")
    assert len(Answers.of_table(again, repeats=True)) == 5


def test_a_repeat_is_no_duplicate_where_something_tells_them_apart():
    twice = {"person": ["x", "x"], "left": ["a", "a"], "right": ["b", "b"], "chosen": ["a", "a"]}
    assert len(refusal(lambda: Answers.of_table(twice))) == 1
    different = [
        twice | {"trial": [1, 2]},
        twice | {"time": [1, 2]},
        twice | {"time": ["2026-03-01T09:30:00", "2026-03-01T09:30:01"]},
        twice | {"left": ["a", "b"], "right": ["b", "a"]},
        twice | {"person": ["x", "y"]},
        {name: column for name, column in twice.items() if name != "person"},
    ]
    assert all(len(Answers.of_table(table)) == 2 for table in different)
    same_trial = twice | {"trial": [1, 1], "chosen": ["a", "b"]}
    assert "repeats row 0" in refusal(lambda: Answers.of_table(same_trial))[0]


def test_without_people_only_whole_rows_with_their_time_are_duplicates():
    rows = {"left": ["a", "a"], "right": ["b", "b"], "chosen": ["a", "a"]}
    assert len(Answers.of_table(rows | {"trial": [1, 1]})) == 2
    assert (
        "the same in every column" in refusal(lambda: Answers.of_table(rows | {"time": [5, 5]}))[0]
    )
    assert len(Answers.of_table(rows | {"time": [5, 5], "seat": ["1", "2"]})) == 2


def test_files_that_are_no_answers_are_refused(tmp_path, monkeypatch):
    def line(name: str, content: str | bytes) -> str:
        path = written(tmp_path, content, name)
        (only,) = refusal(lambda: Answers.read(path))
        return only.removeprefix(f"{path}: ")

    latin = "left,right,chosen\na,b,a\né,b,b\n".encode("latin-1")
    assert line("a.csv", latin).startswith("line 3 is not UTF-8 text; allowed: UTF-8 (save it as ")
    assert line("a.csv", b"\x89PNG\r\n\0\0").startswith("is no text; allowed: a table as CSV")
    assert line("a.csv", gzip.compress(latin)).endswith("a table as text (unpack it first)")
    assert line("a.csv.gz", b"").endswith(".parquet (unpack it first)")
    assert line("a.xlsx", b"").endswith(".parquet (save it as CSV UTF-8)")
    for inside, advice in (("a.csv", "unpack it first"), ("xl/a.xml", "save it as CSV UTF-8")):
        with zipfile.ZipFile(tmp_path / "of.zip", "w") as made:
            made.writestr(inside, latin)
        assert line("a.csv", (tmp_path / "of.zip").read_bytes()).endswith(f"text ({advice})")
    assert line("a.csv", "").startswith("is empty; allowed: a line of column names, then answers")
    assert line("a.csv", " \n").startswith("is empty")
    assert line("a.csv", "left,right,chosen\n").startswith("has no rows; allowed: 1 to 100000000")
    assert line("a.csv", "left,,chosen\na,b,a\n").startswith("column 2 has no name, and row 2 ")
    assert line("a.csv", "left,left,chosen\na,b,a\n").startswith('has more than one column "left"')
    assert line("a.csv", CSV + "ren,9\n") == "row 6: has 2 cells; allowed: 7"
    assert line("a.parquet", CSV) == "is no whole Parquet file"
    assert line("answers", CSV) == "the ending is missing; allowed: .csv, .tsv, .txt, .parquet"
    monkeypatch.setattr(table_module, "MOST_BYTES", 2**20)
    assert line("a.csv", CSV * 20_000) == "is 2 MiB large; allowed: up to 1 MiB"


def test_what_is_no_file_is_refused(tmp_path):
    folder = tmp_path / "answers.csv"
    folder.mkdir()
    assert refusal(lambda: Answers.read(folder)) == [f"{folder}: is a folder; a file is needed"]
    missing = tmp_path / "no.csv"
    assert refusal(lambda: Answers.read(missing)) == [f"{missing}: does not exist"]
    assert refusal(lambda: Answers.read("a\0.csv"))[0].endswith("the path of a file")

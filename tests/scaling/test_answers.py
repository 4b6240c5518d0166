"""Answers from outside: the same from everywhere, and every fault named by row and column."""

from __future__ import annotations

import gzip
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyarrow import parquet

import nacreous as nc
from nacreous.scaling import Answers, Comparisons
from nacreous.scaling.data import table as table_module
from nacreous.scaling.data.spreadsheet import as_written

TABLE: dict[str, list[Any]] = {
    "person": ["mika", "mika", "ren", "ren"],
    "left": ["2", "10", "2", "9"],
    "right": ["10", "9", "10", "2"],
    "chosen": ["2", "right", "tie", "left"],
    "trial": [1, 2, 1, 2],
    "response_s": [0.5, 1.25, None, 2.0],
    "sex": ["f", "f", "m", None],
}
CSV = """\
person,left,right,chosen,trial,response_s,sex
mika,2,10,2,1,0.5,f
mika,10,9,right,2,1.25,f
ren,2,10,tie,1,,m
ren,9,2,left,2,2.0,
"""


def refusal(act: Any) -> list[str]:
    with pytest.raises(nc.InputError) as caught:
        act()
    lines = str(caught.value).splitlines()
    assert all(0 < len(line) < 400 for line in lines)
    return lines


def same(one: Answers, other: Answers) -> bool:
    def equal(a: Any, b: Any) -> bool:
        return (a is b is None) or np.array_equal(a, b, equal_nan=True)

    arrays = ("left", "right", "outcome", "person", "response_s", "time")
    return (
        (one.stimuli, one.people, one.sided) == (other.stimuli, other.people, other.sided)
        and all(equal(getattr(one, name), getattr(other, name)) for name in arrays)
        and one.groups.keys() == other.groups.keys()
        and all(
            one.groups[name].levels == other.groups[name].levels
            and equal(one.groups[name].code, other.groups[name].code)
            for name in one.groups
        )
    )


def written(folder: Path, content: str | bytes, name: str = "answers.csv") -> Path:
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return path


# --- the same from everywhere


def test_a_table_says_what_was_answered():
    answers = Answers.of_table(TABLE)
    assert answers.stimuli == ("2", "9", "10")
    assert answers.left.tolist() == [0, 2, 0, 1]
    assert answers.right.tolist() == [2, 1, 2, 0]
    assert answers.outcome.tolist() == [1, -1, 0, 1]
    assert answers.people == ("mika", "ren")
    assert answers.person.tolist() == [0, 0, 1, 1]
    assert answers.time.tolist() == [1, 2, 1, 2]
    assert np.array_equal(answers.response_s, [0.5, 1.25, np.nan, 2.0], equal_nan=True)
    assert answers.groups["sex"].levels == ("f", "m")
    assert answers.groups["sex"].code.tolist() == [0, 0, 1, -1]
    assert answers.sided


def test_every_source_gives_the_same_answers(tmp_path):
    expected = Answers.of_table(TABLE)
    arrow = pa.table(TABLE)
    parquet.write_table(arrow, tmp_path / "answers.parquet")
    semicolons = CSV.replace(",", ";")
    sources = {
        "pandas": Answers.of_table(pd.DataFrame(TABLE)),
        "pandas categories": Answers.of_table(pd.DataFrame(TABLE).astype({"left": "category"})),
        "pandas with an index": Answers.of_table(pd.DataFrame(TABLE).set_index(np.arange(4) + 7)),
        "polars": Answers.of_table(pl.DataFrame(TABLE)),
        "arrow": Answers.of_table(arrow),
        "arrow batch": Answers.of_table(arrow.to_batches()[0]),
        "arrow in chunks": Answers.of_table(pa.concat_tables([arrow[:1], arrow[1:]])),
        "NumPy": Answers.of_table(TABLE | {"left": np.array(TABLE["left"])}),
        "csv": Answers.read(written(tmp_path, CSV)),
        "csv with a mark": Answers.read(written(tmp_path, b"\xef\xbb\xbf" + CSV.encode())),
        "csv of Windows": Answers.read(written(tmp_path, CSV.replace("\n", "\r\n"))),
        "csv with semicolons": Answers.read(written(tmp_path, semicolons)),
        "csv with tabs": Answers.read(written(tmp_path, CSV.replace(",", "\t"))),
        "csv with spaces": Answers.read(written(tmp_path, CSV.replace(",", " , "))),
        "csv with blank lines": Answers.read(written(tmp_path, CSV.replace("\n", "\n\n"))),
        "csv in quotes": Answers.read(written(tmp_path, CSV.replace("mika", '"mika"'))),
        "CSV": Answers.read(written(tmp_path, CSV, "ANSWERS.CSV")),
        "parquet": Answers.read(tmp_path / "answers.parquet"),
        "a path as text": Answers.read(str(tmp_path / "answers.parquet")),
    }
    assert [name for name, answers in sources.items() if not same(answers, expected)] == []


def test_whole_numbers_are_labels_whatever_holds_them():
    """pandas makes 1 to 1.0 beside an empty cell, and objects of 1 beside "tie"."""
    expected = Answers.of_table({"left": ["1", "2"], "right": ["2", "3"], "chosen": ["1", "tie"]})
    sources = [
        pd.DataFrame({"left": [1, 2], "right": [2, 3], "chosen": [1, "tie"]}),
        pd.DataFrame({"left": [1.0, 2.0], "right": [2, 3], "chosen": [1.0, "tie"]}),
        {"left": [1, 2], "right": [2, 3], "chosen": [1, "tie"]},
        {"left": np.array([1, 2], np.uint8), "right": [2, 3], "chosen": ["left", "tie"]},
    ]
    assert all(same(Answers.of_table(source), expected) for source in sources)


def test_zeros_in_front_are_part_of_a_label(tmp_path):
    path = written(tmp_path, "left,right,chosen\n01,1,01\n")
    assert Answers.read(path).stimuli == ("01", "1")


#: Letters that no other looks like, and what CSV has a meaning for.
LABELS = st.text("abzAB\"',;|=+@#$%\u3042\u5149\u6ca2\u00e9", min_size=1, max_size=6)


@given(st.data())
def test_answers_survive_a_file(tmp_path_factory, data):
    labels = data.draw(st.lists(LABELS, min_size=2, max_size=5, unique=True))
    pair = st.permutations(labels).map(lambda order: order[:2])
    rows = data.draw(st.lists(st.tuples(LABELS, pair, st.integers(0, 1)), min_size=1, max_size=20))
    table = {
        "person": [who for who, _, _ in rows],
        "left": [left for _, (left, _), _ in rows],
        "right": [right for _, (_, right), _ in rows],
        "chosen": [both[which] for _, both, which in rows],
    }
    path = tmp_path_factory.mktemp("file") / "answers.csv"
    held = {name: [as_written(text) for text in texts] for name, texts in table.items()}
    pd.DataFrame(held).to_csv(path, index=False)
    expected = Answers.of_table(table, repeats=True)
    assert same(Answers.read(path, repeats=True), expected)
    assert [expected.stimuli[i] for i in expected.left] == table["left"]


def test_columns_may_have_names_of_their_own(tmp_path):
    names = {"left": "first", "right": "second", "chosen": "choice", "person": "id", "tie": "="}
    renamed = {names.get(name, name): column for name, column in TABLE.items()}
    renamed["choice"] = ["2", "9", "=", "9"]
    assert same(Answers.of_table(renamed, **names), Answers.of_table(TABLE))


def test_milliseconds_and_order_are_understood():
    table = {name: TABLE[name] for name in ("left", "right", "chosen")}
    answers = Answers.of_table(table | {"response_ms": [500] * 4, "order": [4, 3, 2, 1]})
    assert answers.response_s.tolist() == [0.5] * 4
    assert answers.time.tolist() == [4, 3, 2, 1]
    group = Answers.of_table(table | {"order": ["AB", "BA", "AB", "BA"]})
    assert group.time is None
    assert group.groups["order"].levels == ("AB", "BA")


def test_times_are_numbers_or_dates():
    table = {name: TABLE[name] for name in ("left", "right", "chosen")}
    text = ["2026-03-01T09:30:00Z", "2026-03-01 09:30:01", "2026-03-01 09:30:02.5", None]
    stamps = pd.to_datetime(pd.Series(text), format="ISO8601", utc=True)
    for column in (text, stamps, stamps.dt.tz_localize(None)):
        time = Answers.of_table(table | {"time": column}).time
        assert np.diff(time)[:2].tolist() == [1.0, 1.5]
        assert np.isnan(time[3])
    assert Answers.of_table(table | {"time": [3, 1, 2, 4.5]}).time.tolist() == [3, 1, 2, 4.5]


def test_words_for_sides_give_way_to_stimuli_of_that_name():
    table = {"left": ["right", "x"], "right": ["x", "right"], "chosen": ["right", "right"]}
    assert Answers.of_table(table).outcome.tolist() == [1, -1]
    unclear = {"left": ["tie", "a"], "right": ["a", "b"], "chosen": ["a", "tie"]}
    assert 'chosen is "tie"; allowed: "a" or "b"' in refusal(lambda: Answers.of_table(unclear))[0]


def test_stimuli_may_be_stated_also_those_nobody_saw():
    answers = Answers.of_table(TABLE, stimuli=[10, 9, 2, 4])
    assert answers.stimuli == ("10", "9", "2", "4")
    assert answers.left.tolist() == [2, 0, 2, 1]
    lines = refusal(lambda: Answers.of_table(TABLE, stimuli=["2", "9"]))
    assert lines[0] == 'table: row 1: left is "10"; allowed: "2", "9"'


# --- pairs


def test_pairs_of_labels_and_of_numbers():
    answers = Answers.of_pairs([("b", "a"), ("a", "c")])
    assert answers.stimuli == ("a", "b", "c")
    assert (answers.left.tolist(), answers.right.tolist()) == ([1, 0], [0, 2])
    assert answers.outcome.tolist() == [1, 1]
    assert not answers.sided
    expected = Answers.of_pairs([("10", "2"), ("2", "9")])
    for pairs in ([(10, 2), (2, 9)], [[10, 2], [2, 9]], np.array([[10, 2], [2, 9]])):
        assert same(Answers.of_pairs(pairs), expected)
    assert same(Answers.of_pairs(((10, "2"), ("2", np.int64(9)))), expected)
    assert Answers.of_pairs([(10**12, 5)]).stimuli == ("5", "1000000000000")


PAIR = "allowed: (winner, loser), each text or a whole number"


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        ([], "pairs: has no rows; allowed: 1 or more of (winner, loser)"),
        (np.zeros((0, 2), int), "pairs: has no rows; allowed: 1 or more of (winner, loser)"),
        ([(1, 2, 3)], f"pairs: row 0: is (1, 2, 3); {PAIR}"),
        ([(1, 2), (1,)], f"pairs: row 1: is (1,); {PAIR}"),
        ([(1, 2), (1, 2, 3), (1,)], f"pairs: row 1: is (1, 2, 3); {PAIR}"),
        ([(1, 2), 5], f"pairs: row 1: is 5; {PAIR}"),
        (["ab", "cd"], f"pairs: row 0: is 'ab'; {PAIR}"),
        ([(1, 2.5)], f"pairs: row 0: is (1, 2.5); {PAIR}"),
        ([(1, None)], f"pairs: row 0: is (1, None); {PAIR}"),
        ([(True, False)], f"pairs: row 0: is (True, False); {PAIR}"),
        ([(1, 10**40)], "pairs: holds numbers beyond 2^63"),
        ([("a", "a")], 'pairs: row 0: "a" beats itself; allowed: two stimuli'),
        ([("a", " ")], "pairs: holds a label of 0 characters; allowed: 1 to 200"),
        ([("a", "b" * 201)], "pairs: holds a label of 201 characters; allowed: 1 to 200"),
        ([("a", "\ud800")], 'pairs: "\\ud800" holds half a character; allowed: text'),
        ([("a", "a ")], 'pairs: row 0: "a" beats itself; allowed: two stimuli'),
        (np.array([[1, 2, 3]]), "pairs has the shape (1, 3); allowed: (answers, 2)"),
        (np.array([[1.5, 2.0]]), f"pairs: row 0: is [1.5, 2.0]; {PAIR}"),
        ("ab", "pairs is 'ab'; allowed: a list of (winner, loser)"),
        (7, "pairs is 7; allowed: a list of (winner, loser)"),
    ],
)
def test_what_is_no_list_of_pairs_is_refused(pairs, message):
    assert refusal(lambda: Answers.of_pairs(pairs))[0].startswith(message)


def test_pairs_of_unknown_labels_are_refused_when_the_stimuli_are_stated():
    lines = refusal(lambda: Answers.of_pairs([("a", "x")], stimuli=["a", "b"]))
    assert lines == ['pairs: row 0: ("a", "x") has an unknown label; allowed: "a", "b"']


# --- faults


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


# --- twice the same


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


# --- files


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


# --- parts


def test_groups_keep_the_stimuli_and_their_own_people():
    parts = Answers.of_table(TABLE).split("sex")
    assert {name: len(part) for name, part in parts.items()} == {"f": 2, "m": 1}
    assert all(part.stimuli == ("2", "9", "10") for part in parts.values())
    assert parts["m"].people == ("ren",)
    assert parts["m"].person.tolist() == [0]
    people = Answers.of_table(TABLE).split("person")
    assert {name: len(part) for name, part in people.items()} == {"mika": 2, "ren": 2}


def test_a_group_that_is_not_there_is_refused():
    answers = Answers.of_table(TABLE)
    assert refusal(lambda: answers.split("sexx")) == [
        '"sexx" is no group of these answers; did you mean sex?'
    ]
    pairs = Answers.of_pairs([("a", "b")])
    assert (
        "allowed: none, for the answers have no other columns"
        in refusal(lambda: pairs.split("sex"))[0]
    )


def slow_counts(answers: Answers) -> np.ndarray:
    wins = np.zeros((len(answers.stimuli),) * 2)
    for left, right, outcome in zip(answers.left, answers.right, answers.outcome, strict=True):
        wins[(left, right) if outcome == 1 else (right, left)] += outcome != 0
    return wins


@pytest.mark.parametrize("count", [3, 40])
@pytest.mark.parametrize("sided", [True, False])
def test_counts_are_those_of_a_slow_reference(count, sided):
    random = np.random.default_rng(count)
    pairs = np.array([random.permutation(count)[:2] for _ in range(300)])
    chosen = random.choice(["left", "right", "tie"], 300)
    left, right = pairs.T.astype(str)
    table = {"left": left, "right": right, "chosen": chosen}
    answers = Answers.of_table(table, sided=sided)
    counted = answers.comparisons()
    assert np.array_equal(counted.matrix, slow_counts(answers))
    assert counted.tie_matrix.sum() == 2 * np.sum(chosen == "tie")
    assert counted.total == 300
    codes = counted.left * count + counted.right
    assert np.all(np.diff(codes) > 0)
    assert sided or np.all(counted.left < counted.right)
    assert np.array_equal(counted.unsided().matrix, counted.matrix)
    assert isinstance(counted, Comparisons)

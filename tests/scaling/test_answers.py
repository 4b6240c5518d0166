"""Answers from outside: the same from everywhere."""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyarrow import parquet

from nacreous.scaling import Answers, Comparisons
from nacreous.scaling.data.spreadsheet import as_written
from tests.scaling.answer_tables import CSV, TABLE, refusal, written


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

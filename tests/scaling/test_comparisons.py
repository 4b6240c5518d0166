"""Counts by pair: what a matrix must be, and that every holder of counts gives the same."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import nacreous as nc
from nacreous.scaling import Answers, Comparisons, comparisons_of, paper, paper_proportions

GOLDEN = Path(__file__).parent.parent / "golden/thurstone"
COUNTS = [[0, 5, 2], [1, 0, 3], [4, 0, 0]]


def refusal(act: Any) -> list[str]:
    with pytest.raises(nc.InputError) as caught:
        act()
    return str(caught.value).splitlines()


def same(one: Comparisons, other: Comparisons) -> bool:
    arrays = ("left", "right", "left_wins", "right_wins", "ties")
    return (one.stimuli, one.sided) == (other.stimuli, other.sided) and all(
        np.array_equal(getattr(one, name), getattr(other, name)) for name in arrays
    )


# --- the paper's data


def test_the_papers_counts_are_those_of_the_golden_file():
    golden = np.loadtxt(GOLDEN / "counts_n104.csv", delimiter=",")
    assert np.array_equal(paper().matrix, golden)
    assert (golden + golden.T + 104 * np.eye(7) == 104).all()
    assert np.array_equal(comparisons_of(golden).matrix, golden)


def test_the_papers_proportions_are_those_of_the_golden_file():
    golden = np.loadtxt(GOLDEN / "p_2dec.csv", delimiter=",")
    assert np.array_equal(paper_proportions(), golden)
    wins = Comparisons.of_proportions(golden, answers=104).matrix
    assert np.abs(wins - paper().matrix).max() <= 0.5 + 1e-9


def test_the_data_in_the_package_say_what_they_are():
    paths = list((Path(nc.scaling.__file__).parent / "data" / "examples").glob("*.csv"))
    assert paths
    for path in paths:
        head = " ".join(line for line in path.read_text().splitlines() if line[0] == "#")
        assert "econstructed from the" in head
        assert "not raw data" in head


# --- matrices


def test_a_matrix_gives_its_rows_by_pair():
    found = Comparisons.of_counts(COUNTS)
    assert found.stimuli == ("1", "2", "3")
    assert (found.left.tolist(), found.right.tolist()) == ([0, 0, 1], [1, 2, 2])
    assert (found.left_wins.tolist(), found.right_wins.tolist()) == ([5, 2, 3], [1, 4, 0])
    assert not found.sided
    assert found.total == 15


@given(
    arrays(np.int64, (4, 4), elements=st.integers(0, 50)),
    arrays(np.int64, (4, 4), elements=st.integers(0, 9)),
)
def test_a_matrix_survives(counts, ties):
    off = ~np.eye(4, dtype=bool)
    counts, ties = counts * off, (ties + ties.T) * off
    if (counts + ties).any():
        found = Comparisons.of_counts(counts, ties)
        assert np.array_equal(found.matrix, counts)
        assert np.array_equal(found.tie_matrix, ties)
        assert found.total == counts.sum() + ties.sum() / 2


def test_every_holder_of_counts_gives_the_same(tmp_path):
    expected = Comparisons.of_counts(COUNTS, stimuli=["a", "b", "c"])
    labels = ["a", "b", "c"]
    by_row = {label: [row[i] for row in COUNTS] for i, label in enumerate(labels)}
    plain = "\n".join(",".join(map(str, row)) for row in COUNTS)
    cornered = [
        "x,a,b,c",
        *(f"{n}," + ",".join(map(str, r)) for n, r in zip(labels, COUNTS, strict=True)),
    ]
    for name, text in (("top", "a,b,c\n" + plain), ("both", "\n".join(cornered)), ("none", plain)):
        (tmp_path / f"{name}.csv").write_text(text)
    sources = [
        comparisons_of(pd.DataFrame(by_row, index=labels)),
        comparisons_of(pd.DataFrame(by_row)),
        comparisons_of(pl.DataFrame(by_row)),
        Comparisons.of_counts(np.array(COUNTS, float), stimuli=labels),
        Comparisons.of_counts([[np.nan, 5, 2], [1, np.nan, 3], [4, 0, np.nan]], stimuli=labels),
        Comparisons.read_counts(tmp_path / "top.csv"),
        Comparisons.read_counts(tmp_path / "both.csv"),
    ]
    assert [same(source, expected) for source in sources] == [True] * len(sources)
    numbered = Comparisons.of_counts(COUNTS)
    unlabelled = [COUNTS, np.array(COUNTS), pd.DataFrame(COUNTS), Comparisons.of_counts(COUNTS)]
    assert all(same(comparisons_of(source), numbered) for source in unlabelled)
    assert same(Comparisons.read_counts(tmp_path / "none.csv"), numbered)


def test_answers_in_every_form_are_counted(tmp_path):
    table = {"left": ["a", "b"], "right": ["b", "c"], "chosen": ["a", "b"]}
    path = tmp_path / "answers.csv"
    pd.DataFrame(table).to_csv(path, index=False)
    expected = Answers.of_table(table).comparisons()
    sources = [table, pd.DataFrame(table), pl.DataFrame(table), path, str(path)]
    assert all(same(comparisons_of(source), expected) for source in sources)
    pairs = Answers.of_pairs([("a", "b"), ("b", "c"), ("a", "c")]).comparisons()
    for source in (
        [("a", "b"), ("b", "c"), ("a", "c")],
        (("a", "b"), ("b", "c"), ("a", "c")),
        [["a", "b"], ["b", "c"], ["a", "c"]],
    ):
        assert same(comparisons_of(source), pairs)
    numbers = comparisons_of(np.array([[0, 1], [1, 2], [0, 2]]))
    assert numbers.stimuli == ("0", "1", "2")


def test_two_rows_of_two_are_a_matrix_in_lists_and_pairs_in_tuples():
    assert comparisons_of([[0, 5], [3, 0]]).total == 8
    assert comparisons_of(np.array([[0, 5], [3, 0]])).total == 8
    assert comparisons_of([(0, 5), (3, 0)]).total == 2


def test_an_empty_list_and_other_things_are_refused():
    assert refusal(lambda: comparisons_of([]))[0].startswith("pairs: has no rows")
    for thing in (None, 7, {1, 2}, iter([]), pd.Series([1, 2]), pl.Series([1, 2])):
        assert refusal(lambda thing=thing: comparisons_of(thing))[0].startswith("the data are ")


WHOLE = "allowed: a whole number, 0 or more"


@pytest.mark.parametrize(
    ("counts", "message"),
    [
        ([[0, -1], [1, 0]], f"counts[0, 1] is -1; {WHOLE}"),
        ([[0, 1.5], [1, 0]], f"counts[0, 1] is 1.5; {WHOLE}"),
        ([[0, np.nan], [1, 0]], f"counts[0, 1] is nan; {WHOLE}"),
        ([[0, np.inf], [1, 0]], f"counts[0, 1] is inf; {WHOLE}"),
        ([[0, 1e300], [1, 0]], f"counts[0, 1] is 1e+300; {WHOLE}"),
        ([[2, 1], [1, 0]], "counts[0, 0] is 2; allowed: 0, for nothing is compared with itself"),
        ([[0, 1, 2], [1, 0, 2]], "counts is 2 x 3; allowed: a square, one row and one column a st"),
        ([[0]], "counts has 1 stimuli; allowed: 2 to 10000"),
        ([1, 2, 3], "counts is 3; allowed: a square"),
        ([[0, 1], [1]], "counts is [[0, 1], [1]]; allowed: numbers"),
        ([["0", "1"], ["1", "0"]], "counts is [['0', '1'], ['1', '0']]; allowed: numbers"),
        ([[0, 0], [0, 0]], "counts holds no answers; allowed: 1 or more"),
        (7, "counts is a single number; allowed: a square"),
        (None, "counts is None; allowed: numbers"),
        (pd.DataFrame([[0, 1], [1, 0]], columns=["a", "b"], index=["b", "a"]), "counts: rows and"),
        (pd.DataFrame([["x", 1], [1, 0]]), "counts is array("),
    ],
    ids=lambda case: str(case)[:40],
)
def test_what_are_no_counts_is_refused(counts, message):
    assert refusal(lambda: Comparisons.of_counts(counts))[0].startswith(message)


def test_many_bad_cells_are_counted_not_listed():
    lines = refusal(lambda: Comparisons.of_counts(-np.ones((30, 30))))
    assert len(lines) == 6
    assert lines[-1] == "counts: 900 such cells in all"


def test_labels_and_ties_must_fit_the_matrix():
    def line(**given: Any) -> str:
        return refusal(lambda: Comparisons.of_counts(COUNTS, **given))[0]

    assert line(stimuli=["a", "b"]) == "stimuli has 2 labels; allowed: 3, one a stimulus"
    assert line(stimuli=["a", "b", "a"]) == 'stimuli[2] is "a" again; allowed: each label once'
    assert line(stimuli=["a", "b", 1.5]).startswith("stimuli[2] is 1.5; allowed: text or a whole")
    assert line(ties=[[0, 1], [1, 0]]) == "ties has 2 rows; allowed: 3, as counts"
    unequal = [[0, 1, 0], [2, 0, 0], [0, 0, 0]]
    assert line(ties=unequal).startswith("ties[0, 1] is 1; allowed: the same as its mirror")


@pytest.mark.parametrize(
    ("share", "answers", "message"),
    [
        ([[0.5, 1.2], [-0.2, 0.5]], 10, "proportions[0, 1] is 1.2; allowed: 0 to 1"),
        ([[0.5, np.nan], [0.2, 0.5]], 10, "proportions[0, 1] is nan; allowed: 0 to 1"),
        ([[0.5, 0.7], [0.2, 0.5]], 10, "proportions[0, 1] is 0.7; allowed: 1 less its mirror"),
        ([[0.5, 0.7], [0.3, 0.5]], 0, "answers is 0; allowed: 1 or more a pair"),
        ([[0.5, 0.7], [0.3, 0.5]], np.nan, "answers is nan; allowed: 1 or more a pair"),
        ([[0.5, 0.7], [0.3, 0.5]], "10", "answers is '10'; allowed: a number"),
    ],
)
def test_what_are_no_proportions_is_refused(share, answers, message):
    assert refusal(lambda: Comparisons.of_proportions(share, answers))[0] == message


def test_rounded_proportions_are_brought_to_1():
    wins = Comparisons.of_proportions([[0, 0.67], [0.34, 0]], answers=100).matrix
    assert wins.sum() == pytest.approx(100)


def test_labels_may_be_numbers_and_the_diagonal_empty(tmp_path):
    path = tmp_path / "counts.csv"
    for text, stimuli in (
        (",7,8\n7,0,1\n8,2,0\n", ("7", "8")),
        ("7,8\n0,1\n2,0\n", ("7", "8")),
        (",1\n2,\n", ("1", "2")),
        ("0,1\n2,0\n", ("1", "2")),
        ("\ufeff0;1\r\n2;0\r\n", ("1", "2")),
    ):
        path.write_text(text)
        found = Comparisons.read_counts(path)
        assert found.stimuli == stimuli
        assert found.matrix.tolist() == [[0, 1], [2, 0]]


@pytest.mark.parametrize(
    "text",
    [
        ",A,B,C,Total\nA,,5,3,8\nB,2,,6,8\nC,4,1,,5\n",
        ",A,B,C,Sum\nA,0,5,3,8\nB,2,0,6,8\nC,4,1,0,5\nSum,6,6,9,21\n",
        ",A,B,C\nA,,5,3\nB,2,,6\nC,4,1,\nTotal,6,6,9\n",
        ",A,B,C\nC,4,1,-\nA,-,5,3\nB,2,-,6\n",
        ",A,B,C\nC,4,1,\nA,,5,3\nB,2,,6\n",
    ],
)
def test_sums_dashes_and_the_order_of_rows_change_no_counts(tmp_path, text):
    (tmp_path / "c.csv").write_text(text)
    found = Comparisons.read_counts(tmp_path / "c.csv")
    assert found.stimuli == ("A", "B", "C")
    assert found.matrix.tolist() == [[0, 5, 3], [2, 0, 6], [4, 1, 0]]


def test_shares_and_false_sums_are_no_counts(tmp_path):
    path = tmp_path / "c.csv"
    path.write_text(",A,B\nA,0.5,0.7\nB,0.3,0.5\n")
    assert "as shares are" in refusal(lambda: Comparisons.read_counts(path))[0]
    path.write_text(",A,B,Total\nA,,5,9\nB,2,,2\n")
    assert refusal(lambda: Comparisons.read_counts(path))
    path.write_text(",A,B\nA,,1.5\nB,2,\n")
    (line,) = refusal(lambda: Comparisons.read_counts(path))
    assert line == f'{path}: row "A", column "B" is 1.5; allowed: a whole number, 0 or more'


def test_files_that_are_no_counts_are_refused(tmp_path):
    path = tmp_path / "counts.csv"

    def line(text: str) -> str:
        path.write_text(text)
        return refusal(lambda: Comparisons.read_counts(path))[0].removeprefix(f"{path}")

    assert (
        line("0,1,2\n1,0,2\n") == " is 2 x 3; allowed: a square, one row and one column a stimulus"
    )
    assert line("0,x\n1,0\n") == ': row 1: column 2 is "x"; allowed: a whole number, 0 or more'
    assert line("0,1\n1,x\n") == ': row 2: column 2 is "x"; allowed: a whole number, 0 or more'
    assert line("a,b\n0,1\nx,0\n") == ': row 3: column 1 is "x"; allowed: a whole number, 0 or more'
    assert line("0,1\n,0\n") == ': row 2: column 1 is ""; allowed: a whole number, 0 or more'
    assert line("0,1\n-2,0\n") == f': row "2", column "1" is -2; {WHOLE}'
    assert line("0,1\n2\n") == ': row 2: has 1 cell, "2"; allowed: 2 (remove what is no answer)'
    assert (
        line("x,a,b\nb,0,1\nc,1,0\n")
        == ": rows and columns differ in their labels; allowed: the same"
    )
    assert line("").startswith(": is empty")


# --- sides


def test_either_way_round_is_one_pair_once_sides_are_forgotten():
    table = {"left": ["a", "b", "b"], "right": ["b", "a", "a"], "chosen": ["a", "a", "tie"]}
    sided = Answers.of_table(table).comparisons()
    assert (len(sided), sided.sided) == (2, True)
    one = sided.unsided()
    assert (len(one), one.sided) == (1, False)
    assert (one.left_wins.tolist(), one.right_wins.tolist(), one.ties.tolist()) == ([2], [0], [1])
    assert same(one.unsided(), one)
    assert np.array_equal(one.matrix, sided.matrix)

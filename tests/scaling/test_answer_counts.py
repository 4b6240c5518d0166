"""Rows that stand for several answers: each counts as often as it says, or is refused by name."""

from __future__ import annotations

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import Answers

PAIRS = [("A", "B", 5), ("B", "A", 3), ("B", "C", 2), ("C", "B", 6), ("A", "C", 4), ("C", "A", 0)]
WINNER, LOSER, COUNT = (list(column) for column in zip(*PAIRS, strict=True))
TABLE = {"winner": WINNER, "loser": LOSER}
REPEATED = [(winner, loser) for winner, loser, count in PAIRS for _ in range(count)]


@pytest.mark.parametrize("name", ["count", "Counts", "freq", "frequency"])
def test_a_row_with_a_count_is_as_many_answers(name):
    counted = Answers.of_table(TABLE | {name: COUNT})
    assert np.array_equal(
        counted.comparisons().matrix, Answers.of_pairs(REPEATED).comparisons().matrix
    )


def test_people_times_and_groups_are_repeated_with_their_row():
    answers = Answers.of_table(
        {
            "person": ["p", "q"],
            "left": ["A", "A"],
            "right": ["B", "B"],
            "chosen": ["B", "A"],
            "response_s": [0.5, 0.7],
            "sex": ["f", "m"],
            "count": [2, 3],
        }
    )
    assert answers.person.tolist() == [0, 0, 1, 1, 1]
    assert answers.outcome.tolist() == [-1, -1, 1, 1, 1]
    assert answers.response_s.tolist() == [0.5, 0.5, 0.7, 0.7, 0.7]
    assert {name: len(part) for name, part in answers.split("sex").items()} == {"f": 2, "m": 3}


@pytest.mark.parametrize("name", ["n", "weight", "times", "votes"])
def test_a_name_that_may_count_is_refused_until_it_is_said_what_it_is(name):
    table = TABLE | {name: COUNT}
    with pytest.raises(nc.InputError, match=f"column {name} may say .* count='{name}' .* count=''"):
        Answers.of_table(table)
    assert len(Answers.of_table(table, count=name)) == len(REPEATED)
    assert len(Answers.of_table(table, count="")) == len(PAIRS)


def test_words_decimals_and_ones_below_such_a_name_are_no_counts():
    for cells in (["one", "two"] * 3, [1.5, 2.5] * 3, [1] * 6):
        assert len(Answers.of_table(TABLE | {"n": cells})) == len(PAIRS)
    with pytest.raises(nc.InputError, match="column count may say"):  # a running number
        Answers.of_table(TABLE | {"count": range(1, 7)})


@pytest.mark.parametrize("cell", ["-1", "2.5", "", "many", "1e12"])
def test_a_count_is_a_whole_number(cell):
    with pytest.raises(nc.InputError, match=r"\Atable: row 1: count is"):
        Answers.of_table(TABLE | {"count": ["1", cell, "1", "1", "1", "1"]})


@pytest.mark.parametrize(
    "names",
    [("n_left", "n_right"), ("win1", "win2"), ("winsA", "winsB"), ("left votes", "right votes")],
)
def test_counts_for_either_side_are_refused_by_form(names):
    table = {"left": ["A", "B"], "right": ["B", "C"]} | {name: [5, 3] for name in names}
    with pytest.raises(nc.InputError, match=f"columns {names[0]} and {names[1]} may count"):
        Answers.of_table(table)


WIDE = {"A vs B": ["A", "A", "B"], "B vs C": ["B", "C", "C"], "A vs C": ["A", "", "C"]}


@pytest.mark.parametrize("name", ["count", "freq", "n"])
def test_a_row_of_a_wide_table_is_as_many_people_as_it_counts(name):
    counts = [14, 1, 25]
    given = {"count": "n"} if name == "n" else {}
    counted = Answers.of_table(WIDE | {"sex": ["f", "m", "f"], name: counts}, **given)
    each = {key: np.repeat(cells, counts).tolist() for key, cells in WIDE.items()}
    people = Answers.of_table(each)
    assert len(counted.people) == len(people.people) == 40
    assert counted.person.tolist() == people.person.tolist()
    assert np.array_equal(counted.comparisons().matrix, people.comparisons().matrix)
    assert {sex: found for sex, (found, _) in counted.sizes("sex").items()} == {"f": 39, "m": 1}
    assert [*counted.groups] == ["sex"]


def test_nobody_gave_answers_that_count_0():
    counted = Answers.of_table(WIDE | {"count": [3, 0, 1]})
    assert len(counted.people) == 4
    with pytest.raises(nc.InputError, match=r"column n may say how many .* count='n' .* count=''"):
        Answers.of_table(WIDE | {"n": [3, 0, 1]})
    assert len(Answers.of_table(WIDE | {"n": [3, 0, 1]}, count="").people) == 3


def test_a_person_with_a_name_is_no_crowd():
    table = WIDE | {"person": ["p", "q", "r"]}
    said = r"row 2: count is 2, and person names one person; allowed: .* count='' to leave the col"
    with pytest.raises(nc.InputError, match=said):
        Answers.of_table(table | {"count": [1, 0, 2]})
    assert Answers.of_table(table | {"count": [1, 0, 1]}).people == ("p", "r")
    with pytest.raises(nc.InputError, match="counts 2000001 people; allowed: 1 to 1000000"):
        Answers.of_table(WIDE | {"count": [1, 2_000_000, 0]})

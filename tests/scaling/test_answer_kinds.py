"""Columns of kinds besides text and numbers are text, or are refused in plain words."""

from __future__ import annotations

from typing import Any
from uuid import UUID

import pyarrow as pa
import pytest
from pyarrow import parquet

import nacreous as nc
from nacreous.printable import printable
from nacreous.scaling import Answers

BARE: dict[str, Any] = {
    "left": ["A", "B", "C"],
    "right": ["B", "C", "A"],
    "chosen": ["A", "C", "C"],
}
NUMBERS = [UUID(int=at) for at in (1, 2, 2)]


@pytest.mark.parametrize(
    "person",
    [
        NUMBERS,
        pa.array([number.bytes for number in NUMBERS], pa.uuid()),
        [str(number) for number in NUMBERS],
    ],
)
def test_a_uuid_is_its_text(person):
    answers = Answers.of_table(BARE | {"person": person})
    assert answers.people == (str(NUMBERS[0]), str(NUMBERS[1]))


def test_a_missing_uuid_is_an_empty_cell():
    with pytest.raises(nc.InputError, match=r"^table: row 1: person is empty; allowed: a label$"):
        Answers.of_table(BARE | {"person": [NUMBERS[0], None, NUMBERS[2]]})


@pytest.mark.parametrize(
    ("column", "kind"),
    [
        (pa.array([["A"]] * 3, pa.large_list(pa.string())), "lists"),
        (pa.array([{"a": 1}] * 3), "records of several values"),
        (pa.array([(1, 2, 3)] * 3, pa.month_day_nano_interval()), "lengths of time"),
        (pa.array([number.bytes for number in NUMBERS], pa.binary(16)), "bytes that are no text"),
        (pa.array([b"\xff"] * 3), "bytes that are no text"),
    ],
)
@pytest.mark.parametrize("name", ["chosen", "person", "response_s", "meta"])
def test_what_is_no_text_is_called_by_a_plain_name(column, kind, name):
    with pytest.raises(nc.InputError, match=f"^table: column {name} holds {kind}; allowed: text"):
        Answers.of_table(BARE | {name: column})


def test_runs_periods_and_intervals_are_read():
    pandas = pytest.importorskip("pandas")
    runs = pa.RunEndEncodedArray.from_arrays([2, 3], ["p", "q"])
    assert Answers.of_table(BARE | {"person": runs}).people == ("p", "q")
    months = pandas.Series(pandas.period_range("2024-01", periods=3, freq="M"))
    found = Answers.of_table(pandas.DataFrame(BARE | {"month": months, "time": months}))
    assert found.groups["month"].levels[1].startswith("2024-02-01")
    assert found.time is not None
    assert found.time[1] - found.time[0] == 31 * 86400
    ages = pandas.cut(pandas.Series([1, 15, 2]), [0, 10, 20])
    found = Answers.of_table(pandas.DataFrame(BARE | {"age": ages}))
    assert found.groups["age"].levels == ("(0, 10]", "(10, 20]")


def test_a_parquet_file_with_two_columns_of_one_name_is_whole(tmp_path):
    path = tmp_path / "a.parquet"
    names = ["left", "right", "chosen", "left"]
    parquet.write_table(pa.table([pa.array(["A"])] * 4, names=names), path)
    with pytest.raises(nc.InputError, match=r'a.parquet: has more than one column "left"; allowed'):
        Answers.read(path)


def test_a_count_beyond_the_limit_is_told_the_limit():
    with pytest.raises(nc.InputError, match=r'"150000000"; allowed: a whole number from 0 to 1000'):
        Answers.of_table(BARE | {"count": ["150000000", "1", "1"]})
    with pytest.raises(nc.InputError, match=r"counts 100000002 answers; allowed: 1 to 100000000"):
        Answers.of_table(BARE | {"count": ["100000000", "1", "1"]})


def test_a_folder_is_called_a_folder_whatever_its_ending(tmp_path):
    for name in ("answers", "answers.csv", "answers.d"):
        (tmp_path / name).mkdir()
        with pytest.raises(nc.InputError, match=f"{name}: is a folder; a file is needed"):
            Answers.read(tmp_path / name)


def test_a_character_beyond_four_digits_is_written_with_eight():
    with pytest.raises(nc.InputError) as told:
        Answers.of_table(BARE | {"left": ["A\U000e0041", "B", "C"]})
    assert '"A\\U000e0041"; allowed: no \\U000e0041 in it' in str(told.value)
    assert printable("a\U000e0041\x07") == "a\\U000e0041\\u0007"

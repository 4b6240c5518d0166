"""Numbers with marks in them: decimals where they can be nothing else, and otherwise refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import Answers, Comparisons

SEPARATORS = {";": "a.csv", "\t": "a.tsv", "|": "a.txt", ",": "a.csv"}


def read(folder: Path, separator: str, columns: dict[str, list[str]]) -> Answers:
    rows = len(next(iter(columns.values())))
    table = {
        "left": ["a"] * rows,
        "right": ["b"] * rows,
        "chosen": [*"abababababababababab"][:rows],
        **columns,
    }
    lines = [[*table], *zip(*table.values(), strict=True)]
    text = "".join(separator.join(f'"{cell}"' for cell in line) + "\n" for line in lines)
    path = folder / SEPARATORS[separator]
    path.write_text(text)
    return Answers.read(path)


@pytest.mark.parametrize("separator", [";", "\t", "|"])
@pytest.mark.parametrize(
    ("cells", "ms"),
    [
        (["1.250", "2.100"], None),
        (["1.250", "812"], None),
        (["1.250", "812,5"], None),
        (["1.250", "812.5"], [1.25, 812.5]),
        (["1.250", "0.812"], [1.25, 0.812]),
        (["1.25", "812"], [1.25, 812]),
        (["12500", "812"], [12500, 812]),
    ],
)
def test_a_point_may_part_thousands_whatever_separates_cells(tmp_path, separator, cells, ms):
    if ms is None:
        decimal = r"1\.25" if separator != ";" and "," not in cells[1] else "1[.,]25"
        with pytest.raises(
            nc.InputError, match=rf'"1\.250"; .* as 1250 or {decimal}, or response_'
        ):
            read(tmp_path, separator, {"response_ms": cells})
    else:
        found = read(tmp_path, separator, {"response_ms": cells}).response_s
        assert found == pytest.approx(np.array(ms) / 1000)


@pytest.mark.parametrize("separator", [*SEPARATORS])
def test_the_decimal_mark_of_one_column_is_that_of_the_table(tmp_path, separator):
    thousands = {"response_ms": ["1.250", "900"]}
    with pytest.raises(nc.InputError, match=r'"1\.250"; .* may part thousands'):
        read(tmp_path, separator, thousands | {"alter": ["23,5", "31"]})
    found = read(tmp_path, separator, thousands | {"age": ["23.5", "31"]})
    assert found.response_s == pytest.approx([0.00125, 0.9])
    with pytest.raises(nc.InputError, match=r'"1,250"; .* with a decimal point'):
        read(tmp_path, separator, {"response_ms": ["1,250", "900"], "age": ["23.5", "31"]})


def test_commas_between_cells_stand_for_decimal_points_and_semicolons_for_commas(tmp_path):
    points = read(tmp_path, ",", {"response_ms": ["1.250", "900"]})
    commas = read(tmp_path, ";", {"response_ms": ["1,250", "900"]})
    assert points.response_s.tolist() == commas.response_s.tolist() == [0.00125, 0.9]


def test_numbers_that_are_no_text_have_no_mark():
    table = {"left": ["a", "a"], "right": ["b", "b"], "chosen": ["a", "b"], "age": ["23,5", "4"]}
    found = Answers.of_table(table | {"response_ms": np.array([1.125, 900.0])})
    assert found.response_s == pytest.approx([0.001125, 0.9])


@pytest.mark.parametrize("separator", [";", "\t", "|"])
@pytest.mark.parametrize("role", ["time", "trial"])
def test_times_and_trials_keep_to_the_same_rule(tmp_path, separator, role):
    with pytest.raises(nc.InputError, match=rf'{role} is "1\.250"; .* may part thousands'):
        read(tmp_path, separator, {role: ["1.250", "2"]})


@pytest.mark.parametrize(("separator", "told"), [("\t", None), (";", None), (",", [1.25, 900])])
def test_numbers_of_people_keep_to_the_same_rule(tmp_path, separator, told):
    income = read(tmp_path, separator, {"income": ["1.250", "900"]}).groups["income"]
    numbers = income.numbers(range(2))
    assert numbers is None if told is None else numbers.tolist() == told


@pytest.mark.parametrize("cell", ["1,250", "1.250", "1'250", "1 250", "12.000", "1.250.000"])
def test_a_mark_within_a_count_of_answers_is_refused(tmp_path, cell):
    plain = "".join(filter(str.isdecimal, cell))
    for separator in SEPARATORS:
        for name in ("count", "frequency"):
            with pytest.raises(nc.InputError, match=f'{name} is "{cell}"; .* such as {plain}$'):
                read(tmp_path, separator, {name: [cell, "2"]})
        with pytest.raises(nc.InputError, match="column n may say how many answers"):
            read(tmp_path, separator, {"n": [cell, "2"]})
        lines = [["", "a", "b"], ["a", "0", cell], ["b", "3", "0"]]
        path = tmp_path / "counts.csv"
        path.write_text("".join(separator.join(map('"{}"'.format, row)) + "\n" for row in lines))
        with pytest.raises(nc.InputError, match=rf"^\S*counts.csv: row 2: .* such as {plain}$"):
            Comparisons.read_counts(path)


def test_counts_with_a_decimal_point_are_whole_numbers(tmp_path):
    assert len(read(tmp_path, ",", {"count": ["12.0", "2.000"]})) == 14
    path = tmp_path / "counts.csv"
    path.write_text("a,b\n0.000,12.000\n3.000,0.000\n")
    assert Comparisons.read_counts(path).total == 15

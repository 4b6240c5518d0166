"""Squares of counts as they come from elsewhere: read right, or refused in one line."""

from __future__ import annotations

from pathlib import Path

import pytest

import nacreous as nc
from nacreous.scaling import Comparisons

COUNTS = [[0, 12, 15], [8, 0, 13], [5, 7, 0]]


def refused(folder: Path, text: str) -> str:
    path = folder / "c.csv"
    path.write_text(text)
    with pytest.raises(nc.InputError) as told:
        Comparisons.read_counts(path)
    (line,) = str(told.value).splitlines()
    return line.removeprefix(f"{path}: ")


@pytest.mark.parametrize(
    "text",
    [
        "Study 4,,,\n,A,B,C\nA,0,12,15\nB,8,0,13\nC,5,7,0\n",
        "Study 4\nPearls,,,\n\n,A,B,C\nA,0,12,15\nB,8,0,13\nC,5,7,0\n",
        '"A" "B" "C"\n"A" 0 12 15\n"B" 8 0 13\n"C" 5 7 0\n',
        "A\tB\tC\nA\t0\t12\t15\nC\t5\t7\t0\nB\t8\t0\t13\n",
        ",A,B,C\nA,NA,12,15\nB,8,NA,13\nC,5,7,NA\n",
        "Pearls,,,,\n,A,B,C,Total\nA,0,12,15,27\nB,8,0,13,21\nC,5,7,0,12\n",
    ],
)
def test_titles_and_the_labels_of_r_change_no_counts(tmp_path, text):
    (tmp_path / "c.csv").write_text(text)
    found = Comparisons.read_counts(tmp_path / "c.csv")
    assert (found.stimuli, found.matrix.tolist()) == (("A", "B", "C"), COUNTS)


def test_numbers_as_labels_of_r_are_labels(tmp_path):
    (tmp_path / "c.csv").write_text('"1" "2"\n"1" 0 12\n"2" 8 0\n')
    found = Comparisons.read_counts(tmp_path / "c.csv")
    assert (found.stimuli, found.matrix.tolist()) == (("1", "2"), [[0, 12], [8, 0]])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            ",A,B,Total\nA,0,12,28\nB,8,0,8\n",
            'row 2: Total is "28"; allowed: 12, the sum, or no such column',
        ),
        (
            "Pearls,,\n,A,B\nA,0,12\nB,8,0\nSum,8,13\n",
            'Sum below "B" is "13"; allowed: 12, the sum, or no such row',
        ),
        (
            ",A,B,Total\nA,0,12,12\nB,8,0,8\nTotal,8,12,21\n",
            'row 4: Total is "21"; allowed: 20, the sum, or no such column',
        ),
        (",A,B,C\nA,0,12,15\nB,8,0,13\n", "has 2 rows and 3 columns with labels; allowed: as many"),
        (
            ",A,B\nA,0,60%\nB,40%,0\n",
            'row 2: column 2 is "60%"; allowed: a whole number, 0 or more (2 such cells)',
        ),
    ],
)
def test_one_fault_of_a_square_is_one_line(tmp_path, text, said):
    assert refused(tmp_path, text).startswith(said)

"""What we write as CSV holds no cell that a spreadsheet takes for a formula, and is read back."""

from __future__ import annotations

import csv
import io

import pytest

from nacreous.scaling import Answers, Comparisons, analyse, thurstone
from nacreous.scaling.report import record
from nacreous.server.rehearsal import scale_of

LABELS = ("=1+1", "+a", "@SUM(A1)", "-b", "'=x", "''-y", "＝1", "plain", "'s pearl", "-1", "a-b")
BEGINS = "=+-@\t\r\n＝＋－＠"


def answers() -> Answers:
    """Everyone compares neighbours on a ring of labels, and most prefer the earlier."""
    rows: dict[str, list[str]] = {"person": [], "left": [], "right": [], "chosen": [], "=group": []}
    for person in range(6):
        for at, label in enumerate(LABELS):
            other = LABELS[(at + 1 + person % 3) % len(LABELS)]
            rows["person"].append(f"@p{person}")
            rows["left"].append(label)
            rows["right"].append(other)
            rows["chosen"].append(label if (at + person) % 3 else other)
            rows["=group"].append("=cmd|'/C calc'!A0" if person % 2 else "-2")
    return Answers.of_table(rows)


def cells(text: str) -> list[str]:
    return [cell for row in csv.reader(io.StringIO(text)) for cell in row]


def is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def test_no_cell_of_a_scale_or_of_data_begins_a_formula():
    found = analyse(answers(), bootstrap=0)
    counts = analyse(Comparisons.of_counts([[0, 3], [2, 0]], stimuli=["=1+1", "@x"]), bootstrap=0)
    for text in (record.csv(found), record.data_csv(found), record.data_csv(counts)):
        for cell in cells(text):
            assert not cell or cell[0] not in BEGINS or is_number(cell)
    assert "'=1+1" in cells(record.csv(found))


def test_answers_that_a_report_holds_are_read_again_as_they_were(tmp_path):
    given = answers()
    path = tmp_path / "answers.csv"
    path.write_text(record.data_csv(analyse(given, bootstrap=0)), encoding="utf-8")
    again = Answers.read(path)
    assert set(again.stimuli) == set(LABELS) == set(given.stimuli)
    assert set(again.people) == set(given.people)
    assert set(again.groups["=group"].levels) == set(given.groups["=group"].levels)
    assert thurstone(again).scale == pytest.approx(thurstone(given).scale)


def test_counts_and_scales_are_read_again_as_they_were(tmp_path):
    counts = Comparisons.of_counts([[0, 3], [2, 0]], stimuli=["=1+1", "'@x"])
    found = analyse(counts, bootstrap=0)
    path = tmp_path / "counts.csv"
    path.write_text(record.data_csv(found), encoding="utf-8")
    assert Comparisons.read_counts(path).stimuli == ("=1+1", "'@x")
    found.save(tmp_path / "scale.csv")
    assert set(scale_of(str(tmp_path / "scale.csv"))) == {"=1+1", "'@x"}


def test_a_row_with_an_empty_cell_at_its_end_is_read_as_the_others(tmp_path):
    path = tmp_path / "answers.csv"
    path.write_text("left,right,chosen\n'=a,b,'=a\n'=a,b,b,\nb,'=a,b\n", encoding="utf-8")
    assert set(Answers.read(path, repeats=True).stimuli) == {"=a", "b"}

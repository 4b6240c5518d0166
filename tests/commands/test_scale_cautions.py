"""What `nacreous scale` cautions of, and what it says of an export that is not whole."""

from pathlib import Path

import pytest

from nacreous import cli

HEADS = (
    "sequence,person,trial,kind,question,left,right,chosen,response_ms,shown_at,answered_at,"
    "received_at,language,excluded,simulated,erased,flags,pairs_chosen_by"
)


@pytest.mark.parametrize(
    ("rows", "caution"),
    [
        ("3-Jan,5-32,left,0.9|5-32,3-Jan,left,0.9", 'labels such as "3-Jan" are dates and others'),
        ("a,b,left,900|b,a,left,800", "half of the response times are 850 s or longer"),
        ("2026-01-03,2026-01-04,left,0.9|2026-01-04,2026-01-03,left,0.9", None),
    ],
)
def test_what_is_likely_not_as_it_was_meant_is_cautioned_of(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], rows: str, caution: str | None
) -> None:
    path = tmp_path / "a.csv"
    path.write_text("left,right,chosen,response_s\n" + rows.replace("|", "\n") + "\n")
    out = str(tmp_path / "a.json")
    assert cli.main(["scale", str(path), "--bootstrap", "0", "-o", out]) == 0
    said = capsys.readouterr().out
    assert caution in said if caution else "caution" not in said


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("person,", "", "without the column person; wanted"),
        ("person,", "Person,", 'without the column person (called "Person"); wanted'),
        ("person,", "participant,", 'without the column person (called "participant"); wanted'),
        (",kind", ",KIND", 'without the column kind (called "KIND"); wanted'),
    ],
)
def test_an_export_is_told_which_of_its_columns_is_not_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, told: str
) -> None:
    heads = HEADS.replace(old, new)
    path = tmp_path / "a.csv"
    path.write_text(f"{heads}\n{','.join('1' for _ in heads.split(','))}\n")
    assert cli.main(["scale", str(path)]) == 2
    assert f"a.csv: is an export of a study {told}" in capsys.readouterr().err


def test_columns_that_may_exclude_are_cautioned_of(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out = tmp_path / "a.csv", tmp_path / "a.json"
    path.write_text(
        "excluded,outlier,left,right,chosen\n,0,a,b,a\n,1,b,a,a\n,0,a,b,b\nyes,0,a,b,b\n"
    )
    assert cli.main(["scale", str(path), "--bootstrap", "0", "-o", str(out)]) == 0
    said = capsys.readouterr().out
    assert "rows left out: 1 marked as excluded" in said
    assert 'column "outlier" may say which rows are no good, and holds "0", "1"' in said
    assert '"marked": 1' in out.read_text()


def test_the_table_of_people_is_called_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "people.csv"
    path.write_text(
        "person,language,excluded,simulated,answers,trials,entered_at\n0,en,,false,1,1,\n"
    )
    assert cli.main(["scale", str(path)]) == 2
    assert "people.csv: is the table of people of a study's export" in capsys.readouterr().err


def test_a_study_is_not_read_from_standard_input(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["study", "new", "-", "-o", str(tmp_path / "made")]) == 2
    assert "study is -, and standard input has no folder" in capsys.readouterr().err
    assert not (tmp_path / "made").exists()

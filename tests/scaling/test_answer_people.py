"""Who answered, as other programs name the column: known, asked for, or said to be unknown."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous import cli
from nacreous.scaling import Answers

ROWS = "left,right,chosen\nA,B,A\nA,B,B\nB,A,B\n"


def read(folder: Path, columns: str, *cells: str) -> Answers:
    path = folder / "a.csv"
    lines = zip((columns, *cells), ROWS.splitlines(), strict=True)
    path.write_text("\n".join(",".join(line) for line in lines), encoding="utf-8")
    return Answers.read(path)


@pytest.mark.parametrize(
    "name",
    """person_id|Participant ID|participantId|Subject ID|subject_nr|Response ID|ResponseId|subj
    worker_id|WorkerId|prolific_id|PROLIFIC_PID|run_id|respondent|RespondentID|Person Nr.|Vpn
    Participant Private ID|Participant Public ID|Versuchsperson|参加者|被験者ID
    回答者番号|ｐｅｒｓｏｎ＿ＩＤ|observer|Participant-No|exp_subject_id""".replace(
        "\n    ", "|"
    ).split("|"),
)
def test_people_are_known_by_the_names_of_other_programs(tmp_path, name):
    assert read(tmp_path, name, "x1", "x2", "x1").people == ("x1", "x2")


@pytest.mark.parametrize("name", ["id", "ID", "Name", "session", "sub", "CASE"])
def test_a_name_that_may_mean_something_else_is_no_person(tmp_path, name):
    assert read(tmp_path, name, "x1", "x2", "x1").person is None


def test_columns_that_sort_rows_into_the_same_people_are_one(tmp_path):
    both = read(tmp_path, "participant,PROLIFIC_PID", "1,a", "2,b", "1,a")
    assert both.people == ("1", "2")
    with pytest.raises(nc.InputError, match="people may be in the columns"):
        read(tmp_path, "participant,PROLIFIC_PID", "1,a", "1,b", "1,a")


def test_gorilla_sosci_and_limesurvey_are_known_by_their_columns(tmp_path):
    gorilla = "Event Index,Participant Public ID,Participant Private ID,Reaction Time,Response"
    (tmp_path / "g.csv").write_text(
        f"{gorilla},left,right\n1,x,71,812.5,a,a,b\n2,x,71,700,b,a,b\n1,x,72,9,b,a,b\n"
        "END OF FILE,,,,,,\n"
    )
    answers = Answers.read(tmp_path / "g.csv")
    assert answers.people == ("71", "72")
    assert answers.outcome.tolist() == [1, -1, -1]
    assert answers.response_s.tolist() == [0.8125, 0.7, 0.009]
    assert answers.time.tolist() == [1, 2, 1]
    assert answers.left_out == 1
    assert read(tmp_path, "CASE,QUESTNNR", "12,q", "13,q", "12,q").people == ("12", "13")
    assert read(tmp_path, "id,submitdate,lastpage", "1,,3", "2,,3", "1,,3").people == ("1", "2")


NOTHING = [
    *("NA", "n/a", "null", "NaN", "None", "undefined", "#NV", "\\N", ".", ".a", ".z", "._", "#N/D"),
    *("#Н/Д", "#SAKNAS!", "(null)", "[NULL]", "-nan"),
]
ERRORS = [
    *("#REF!", "#VALUE!", "#DIV/0!", "#NAME?", "#NUM!", "#SPILL!", "#GETTING_DATA", "#########"),
    *("#BEZUG!", "#WERT!", "#ZAHL!", "#ÜBERLAUF!", "#VALEUR!", "#NOM?", "#¡REF!", "#¿NOMBRE?"),
    *("#NOMBRE?", "#RIF!", "#WAARDE!", "#DEEL/0!", "#NAAM?", "#ADR!", "#ССЫЛКА!", "#ИМЯ?", "#AD?"),
    *("#VÄRDEFEL!", "#JAKO/0!", "#DĚLENÍ_NULOU!", "Err:502"),
]


@pytest.mark.parametrize("cell", NOTHING)
def test_a_word_for_an_empty_cell_is_nobody_and_no_stimulus(tmp_path, cell):
    said = f'row 3: person is "{cell}", as programs write an empty cell; allowed: a label'
    with pytest.raises(nc.InputError, match=re.escape(said) + r" \(2 such rows\)$"):
        read(tmp_path, "person", "x1", cell, cell)
    table = {"left": ["A", cell], "right": ["B", "B"], "chosen": ["A", "B"]}
    with pytest.raises(nc.InputError, match=re.escape(f'row 1: left is "{cell}", as programs wr')):
        Answers.of_table(table)
    assert Answers.of_table(table, stimuli=["A", "B", cell]).stimuli == ("A", "B", cell)
    assert Answers.of_table(table | {"left": ["A", "none"]}).stimuli == ("A", "B", "none")


@pytest.mark.parametrize("cell", NOTHING)
def test_a_word_for_an_empty_cell_is_no_answer_and_no_value(cell):
    table = {"left": ["A", "A"], "right": ["B", "B"], "chosen": ["A", cell]}
    with pytest.raises(nc.InputError, match="row 1: chosen is empty; allowed: a label, or skip_un"):
        Answers.of_table(table)
    assert Answers.of_table(table, skip_unanswered=True).unanswered == 1
    told = {"chosen": ["A", "B"], "age": ["31", cell], "time": [1, cell], "response_s": ["1", cell]}
    answers = Answers.of_table(table | told)
    assert answers.groups["age"].levels == ("31",)
    assert answers.groups["age"].nothing == (cell,)
    assert (np.isnan(answers.time[1]), np.isnan(answers.response_s[1])) == (True, True)
    wide = Answers.of_table({"A vs B": ["A", cell], "B vs C": ["C", "C"]})
    assert len(wide) == 3


@pytest.mark.parametrize("cell", ERRORS)
@pytest.mark.parametrize("column", ["person", "left", "right", "chosen", "age", "winner"])
def test_an_error_of_a_spreadsheet_is_refused_in_one_line_by_its_name(cell, column):
    table = {"person": [*"pqr"], "left": [*"ABC"], "right": [*"BCA"], "chosen": [*"ACA"]}
    if column == "winner":
        table = {"winner": [*"ABC"], "loser": [*"BCA"]}
    table = table | {"age": ["31", "32", "33"]}
    table[column][1:] = [cell, cell]
    with pytest.raises(nc.InputError) as told:
        Answers.of_table(table)
    (line,) = str(told.value).splitlines()
    said = f'table: row 1: {column} is "{cell}", an error of a spreadsheet; allowed: '
    assert line.startswith(said)
    assert line.endswith(" (2 such rows)")


@pytest.mark.parametrize("label", ["#1", "#A", "##", "#wow!", "A?", "Err: 5"])
def test_labels_that_are_no_errors_of_spreadsheets_stay_labels(label):
    answers = Answers.of_table({"left": [label], "right": ["B"], "chosen": [label]})
    assert set(answers.stimuli) == {label, "B"}


def test_a_label_that_is_given_may_look_like_an_error():
    table = {"left": ["#REF!"], "right": ["B"], "chosen": ["#REF!"]}
    assert Answers.of_table(table, stimuli=["#REF!", "B"]).stimuli == ("#REF!", "B")


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        ("note,ID", 'columns here: "note", "ID"; name one by --column person=ID\n'),
        ("pearl eye,cohort", "; name one by --column person=NAME\n"),
        ("response_s,trial", "nobody is known as person, so each answer counts as another per"),
    ],
)
def test_the_command_says_that_nobody_is_known(tmp_path, monkeypatch, capsys, columns, said):
    monkeypatch.chdir(tmp_path)
    read(tmp_path, columns, "1,1", "2,2", "1,3")
    command = ["scale", "a.csv", "-o", "r.csv", "--bootstrap", "0"]
    assert cli.main(command) == 0
    assert said in capsys.readouterr().out
    read(tmp_path, "person,x", "1,1", "2,2", "1,3")
    assert cli.main(command) == 0
    assert "nobody" not in capsys.readouterr().out

"""Answers as programs write them, with their numbers and times."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import Answers
from tests.scaling.answer_texts import HEAD, PLAIN, TOLD, read, said

KEYS = "participant,trials.thisN,stimLeft,stimRight,key_resp.keys,key_resp.rt,\n"
PSYCHOPY: dict[str, Any] = {
    "left": "stimLeft",
    "right": "stimRight",
    "chosen": "key_resp.keys",
    "response_s": "key_resp.rt",
}
JSPSYCH = "rt,response,trial_type,trial_index,time_elapsed,left,right,person\n"
QUALTRICS = """\
StartDate,ResponseId,Q1,Q2,Q3
Start Date,Response ID,Which? A vs B,Which? B vs C,C vs. A: which?
"{""ImportId"":""startDate""}","{""ImportId"":""_recordId""}","{""ImportId"":""QID1""}",\
"{""ImportId"":""QID2""}","{""ImportId"":""QID3""}"
"""
UNKNOWN = ["A>B", "C>B", "A>C"]


def test_psychopy_is_read_by_the_names_of_its_columns(tmp_path):
    rows = (
        "001,,,,,,\n"  # instructions
        "001,0,A.png,B.png,left,0.83,\n"
        "001,1,B.png,C.png,['right'],[0.7],\n"
        "001,2,C.png,A.png,left,,\n"
    )
    answers = read(tmp_path, KEYS + rows, **PSYCHOPY)
    assert said(answers) == ["001:A.png>B.png", "001:C.png>B.png", "001:C.png>A.png"]
    assert np.array_equal(answers.response_s, [0.83, 0.7, np.nan], equal_nan=True)
    assert (answers.left_out, answers.unanswered) == (1, 0)
    late = KEYS + rows.replace("left,,", "None,,")
    with pytest.raises(nc.InputError, match=r"row 5: key_resp.keys is empty; .* skip_unan"):
        read(tmp_path, late, **PSYCHOPY)
    answers = read(tmp_path, late, skip_unanswered=True, **PSYCHOPY)
    assert said(answers) == ["001:A.png>B.png", "001:C.png>B.png"]
    assert (answers.left_out, answers.unanswered) == (2, 1)


def test_jspsych_counts_its_buttons_from_the_left_and_from_0(tmp_path):
    rows = (
        "null,null,instructions,0,900,,,p1\n"
        '"812","0",html-button-response,1,1900,A,B,p1\n'
        "700,1,html-button-response,2,2900,B,C,p1\n"
        "-1,1,html-button-response,3,3900,C,A,p2\n"
        '500,"",html-button-response,4,4900,null,null,p2\n'
    )
    answers = read(tmp_path, JSPSYCH + rows)
    assert said(answers) == TOLD
    assert np.array_equal(answers.response_s, [0.812, 0.7, np.nan], equal_nan=True)
    assert answers.time.tolist() == [1, 2, 3]
    assert answers.left_out == 2


def test_lab_js_is_known_by_its_columns(tmp_path):
    head = "sender,sender_type,sender_id,response,duration,left,right,person\n"
    rows = (
        "Welcome,html.Screen,0,,5000,,,p1\n"
        "Pair,html.Screen,1_0,left,750.5,A,B,p1\n"
        "Pair,html.Screen,1_1,right,600,B,C,p1\n"
    )
    answers = read(tmp_path, head + rows)
    assert said(answers) == TOLD[:2]
    assert answers.response_s.tolist() == [0.7505, 0.6]


def test_qualtrics_names_its_pairs_in_its_questions(tmp_path):
    rows = "2024-01-01 10:00,R_1,A,C,A\n2024-01-01 11:00,R_2,,B,C\n"
    answers = read(tmp_path, QUALTRICS + rows)
    assert said(answers) == ["R_1:A>B", "R_1:C>B", "R_1:A>C", "R_2:B>C", "R_2:C>A"]
    assert answers.groups["StartDate"].levels == ("2024-01-01 10:00", "2024-01-01 11:00")
    for cell in ("D", "1"):
        with pytest.raises(nc.InputError, match=f'row 4: Q1 is "{cell}"; allowed: "A" or "B", of'):
            read(tmp_path, QUALTRICS + f"2024-01-01 10:00,R_1,{cell},C,A\n")


@pytest.mark.parametrize("versus", [" vs ", "_vs_", ".vs.", " vs. ", " versus ", "-VS-"])
def test_a_wide_table_has_a_column_a_pair(tmp_path, versus):
    pairs = [("A", "B"), ("B", "C"), ("C", "A")]
    head = "subject," + ",".join(f"{left}{versus}{right}" for left, right in pairs)
    assert said(read(tmp_path, f"{head}\np1,A,C,\np2,,,A\n")) == TOLD
    assert said(read(tmp_path, f"{head}\np1,left,2,NA\np2,,1,right\n")) == [
        *TOLD[:2],
        "p2:B>C",
        TOLD[2],
    ]
    nobody = head.removeprefix("subject,")
    assert said(read(tmp_path, f"{nobody}\nA,C,\n"))[0] == "row 2:A>B"


def test_winner_and_loser_are_answers_without_sides(tmp_path):
    answers = read(tmp_path, "winner,loser\nA,B\nC,B\nA,C\n")
    assert said(answers) == UNKNOWN
    assert not answers.sided
    renamed = read(tmp_path, "won;lost\nA;B\nC;B\nA;C\n", winner="won", loser="lost")
    assert said(renamed) == UNKNOWN


def test_codes_that_may_mean_either_side_are_asked_for(tmp_path):
    binary = HEAD + "p1,A,B,1\np1,B,C,0\np2,C,A,0\n"
    with pytest.raises(nc.InputError, match=r"chosen holds 0 and 1, and either .* left_word='1', "):
        read(tmp_path, binary)
    assert said(read(tmp_path, binary, left_word="1", right_word="0")) == TOLD
    ones = HEAD + "p1,A,B,1\n"
    with pytest.raises(nc.InputError, match="chosen holds 1, and either side may be meant"):
        read(tmp_path, ones)
    keys = HEAD + "p1,A,B,f\np1,B,C,j\np2,C,A,j\n"
    assert said(read(tmp_path, keys, left_word="f", right_word="j")) == TOLD


@pytest.mark.parametrize(
    ("cells", "separator", "seconds"),
    [
        (["1,25", "0,5", ""], ";", [1.25, 0.5, np.nan]),
        (["1,250", "2,500", "3,100"], ";", [1.25, 2.5, 3.1]),
        (["0,834", "1,204", "null"], "\t", [0.834, 1.204, np.nan]),
        (["1.25", "NaN", "-1"], ",", [1.25, np.nan, np.nan]),
        (["[0.5]", "['2']", "[]"], ",", [0.5, 2, np.nan]),
    ],
)
def test_response_times_are_read_as_they_were_meant(tmp_path, cells, separator, seconds):
    lines = [line.replace(",", separator) for line in PLAIN.splitlines()]
    table = [
        f"{line}{separator}{cell}" for line, cell in zip(lines, ["response_s", *cells], strict=True)
    ]
    answers = read(tmp_path, "\n".join(table))
    assert np.array_equal(answers.response_s, seconds, equal_nan=True)


@pytest.mark.parametrize("cells", [["1,250", "2,500", "3,100"], ["1.5", "2,5", "1"]])
def test_a_comma_that_may_part_thousands_is_refused(tmp_path, cells):
    table = zip(PLAIN.replace(",", "\t").splitlines(), ["response_s", *cells], strict=True)
    with pytest.raises(nc.InputError, match=r"response_s is .* with a decimal point"):
        read(tmp_path, "\n".join("\t".join(row) for row in table))


def test_times_with_an_offset_are_instants():
    table: dict[str, Any] = {"left": ["a", "b"], "right": ["b", "a"], "chosen": ["a", "a"]}
    cells = ["2026-03-01T09:30:00+09:00", "2026-03-01 00:30:01.5Z"]
    assert np.diff(Answers.of_table(table | {"time": cells}).time).tolist() == [1.5]
    cells = ["2026-03-01T09:30+0900", "2026-02-28T19:30:00-05:00"]
    assert np.diff(Answers.of_table(table | {"time": cells}).time).tolist() == [0.0]
    with pytest.raises(nc.InputError, match="time has times with an offset and without"):
        Answers.of_table(table | {"time": ["2026-03-01T09:30+09:00", "2026-03-01 09:30"]})

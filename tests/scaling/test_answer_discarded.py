"""Rows that a program marks as no answer are refused, or left out where that is said."""

import pytest

import nacreous as nc
from tests.scaling.answer_texts import read, said

CASES = [
    ("WorkerId,AssignmentStatus", "AssignmentStatus", "Approved", "Rejected"),
    ("WorkerId,AssignmentStatus", "AssignmentStatus", "Submitted", "Rejected"),
    ("WorkerId,AssignmentStatus,Reject", "Reject", "", "Too fast"),
    ("WorkerId,AssignmentStatus,Reject", "Reject", "NA", "x"),
    *(
        ("Submission id,Participant id,Status", "Status", "APPROVED", word)
        for word in ("REJECTED", "RETURNED", "TIMED-OUT")
    ),
    ("session_id,participant_id,status", "status", "AWAITING REVIEW", "RETURNED"),
    ("PROLIFIC_PID,status", "status", "APPROVED", "TIMED-OUT"),
    *(
        (
            "Event Index,Participant Private ID,Participant Status",
            "Participant Status",
            "live",
            word,
        )
        for word in ("rejected", "RejectedManual", "RejectedTime Limit")
    ),
    *(("CASE,QUESTNNR,MODE", "MODE", "interview", word) for word in ("pretest", "admin")),
]


@pytest.mark.parametrize(("columns", "column", "counts", "discarded"), CASES)
def test_what_a_program_does_not_count_is_no_answer(tmp_path, columns, column, counts, discarded):
    cells = [f"{at}," * columns.count(",") for at in (1, 2)]
    text = f"{columns},left,right,chosen\n{cells[0]}{counts},A,B,A\n{cells[1]}{discarded},B,A,B\n"
    meaning = "no person's answer" if column == "MODE" else "no answer that counts"
    with pytest.raises(nc.InputError) as refusal:
        read(tmp_path, text)
    (line,) = str(refusal.value).splitlines()
    assert f'row 3: {column} is "{discarded}", which is {meaning}; allowed: rows' in line
    answers = read(tmp_path, text, skip_unanswered=True)
    assert said(answers) == ["1:A>B"]
    assert (answers.left_out, answers.unanswered) == (1, 1)


@pytest.mark.parametrize(
    "columns",
    ["person,Status", "person,MODE", "person,status", "person,Participant Status", "person,Reject"],
)
def test_the_same_words_in_a_table_of_no_such_program_are_groups(tmp_path, columns):
    text = f"{columns},left,right,chosen\n1,returned,A,B,A\n2,admin,B,A,B\n3,rejected,A,B,B\n"
    assert said(read(tmp_path, text)) == ["1:A>B", "2:B>A", "3:B>A"]


def test_who_only_did_not_finish_is_a_person(tmp_path):
    text = "id,submitdate,lastpage,A vs B,B vs C\n1,2026-03-01 09:30:00,2,A,B\n2,,1,B,\n"
    assert said(read(tmp_path, text)) == ["1:A>B", "1:B>C", "2:B>A"]

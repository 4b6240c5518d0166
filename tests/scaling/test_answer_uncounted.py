"""Answers that do not count: of other questions and of practice; and whose each row is."""

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling.data.question import SeveralQuestionsError
from tests.scaling.answer_texts import read

PAIRS = [("A", "B"), ("B", "C"), ("A", "C")]


def table(column: str, cells: tuple[str, str], heads: str = "left,right,chosen,count") -> str:
    """Each pair for either cell, the left one chosen 3 times for the first, once for the other."""
    rows = [
        f"{cell},{a},{b},{a},{n}" for cell, n in zip(cells, (3, 1), strict=True) for a, b in PAIRS
    ]
    return "\n".join([f"{column},{heads}", *rows, ""])


@pytest.mark.parametrize("column", ["question", "Question ID", "設問"])
@pytest.mark.parametrize("repeats", [False, True])
def test_several_questions_are_never_pooled(tmp_path, column, repeats):
    text = table(column, ("deeper", "shinier"))
    with pytest.raises(SeveralQuestionsError, match="wanted: question='deeper' or another of"):
        read(tmp_path, text, repeats=repeats)
    with pytest.raises(nc.InputError, match="did you mean deeper"):
        read(tmp_path, text, question="Deeper")
    for question, count in (("deeper", 9), ("shinier", 3)):
        answers = read(tmp_path, text, question=question, repeats=repeats)
        assert (len(answers), dict(answers.uncounted)) == (count, {"question": 3})


def test_a_number_of_each_pair_is_no_question(tmp_path):
    text = "question,left,right,chosen\nQ1,A,B,A\nQ2,B,C,B\nQ1,B,A,A\n"
    assert len(read(tmp_path, text)) == 3
    with pytest.raises(nc.InputError, match="no column question"):
        read(tmp_path, "left,right,chosen\nA,B,A\n", question="deeper")


@pytest.mark.parametrize(
    ("column", "mark", "other", "reason"),
    [
        ("is_practice", "TRUE", "FALSE", "practice"),
        ("practice", "ja", "", "practice"),
        ("Trial Phase", "Practice trials", "main", "practice"),
        ("practice_trials.thisN", "0", "", "practice"),
        ("attention_check", "1", "0", "catch"),
        ("display", "catch", "trial", "catch"),
    ],
)
def test_marked_trials_do_not_count_where_a_person_has_others(
    tmp_path, column, mark, other, reason
):
    head, rows = (
        f"person,{column},left,right,chosen\n",
        [("A", "C", "C"), *[(*p, p[0]) for p in PAIRS]],
    )
    cells = [mark, other, other, other]
    within = "".join(
        f"{who},{cell},{','.join(row)}\n"
        for who in "mn"
        for cell, row in zip(cells, rows, strict=True)
    )
    answers = read(tmp_path, head + within)
    assert (len(answers), dict(answers.uncounted)) == (6, {reason: 2})
    assert np.all(answers.outcome == 1)
    between = "".join(
        f"{who},{cell},{','.join(row)}\n"
        for who, cell in (("m", mark), ("n", other))
        for row in rows[1:]
    )
    answers = read(tmp_path, head + between)
    assert (len(answers), dict(answers.uncounted)) == (6, {})


@pytest.mark.parametrize(
    ("heads", "rows", "named", "other"),
    [
        ("Email Address", "m@x,A,B|n@x,B,C|m@x,A,C", "Email Address", ""),
        ("Your name", "m,A,B|n,B,C|m,A,C", "Your name", ""),
        ("氏名", "m,A,B|n,B,C|m,A,C", "氏名", ""),
        ("id", "m,A,B|n,B,C|m,A,C", "id", ""),
        ("ResponseId,PROLIFIC_PID", "R1,p,A,B|R2,q,B,C|R3,p,A,C", "PROLIFIC_PID", "ResponseId"),
    ],
)
def test_one_person_in_several_rows_is_never_several_in_silence(
    tmp_path, heads, rows, named, other
):
    text = f"{heads},A vs B,B vs C\n" + rows.replace("|", "\n") + "\n"
    with pytest.raises(nc.InputError, match="rows 2 and 4, which would count as several people"):
        read(tmp_path, text)
    assert len(read(tmp_path, text, person=named, repeats=True).people) == 2
    assert len(read(tmp_path, text, person=other).people) == 3


def test_an_event_of_redcap_is_no_person(tmp_path):
    text = "record_id,redcap_event_name,A vs B,B vs C\n1,a,A,\n1,b,,B\n2,a,B,\n"
    assert read(tmp_path, text).people == ("1", "2")


@pytest.mark.parametrize(
    ("column", "mark", "other"),
    [
        ("trial_type", "practice", "main"),
        ("block", "Practice block 1", "Block 1"),
        ("condition", "attention check", "A"),
        ("task", "warm-up", "compare"),
        ("part", "Training", "2"),
        ("type", "attention", "pair"),
        ("section", "practice session", "main"),
    ],
)
def test_words_of_practice_in_other_columns_mark_trials_too(tmp_path, column, mark, other):
    rows = [f"{who},{cell},A,B,A" for who in "mn" for cell in (mark, other)]
    answers = read(tmp_path, f"person,{column},left,right,chosen\n" + "\n".join(rows))
    assert (len(answers), sum(answers.uncounted.values())) == (2, 2)


@pytest.mark.parametrize(
    ("column", "cells"),
    [
        ("trial_type", ("html-button-response", "image-keyboard-response")),
        ("condition", ("training", "control")),
        ("task", ("trainer", "catcher")),
    ],
)
def test_other_words_in_such_columns_are_groups(tmp_path, column, cells):
    rows = [f"m,{cells[0]},A,B,A", f"m,{cells[1]},B,C,B"]
    answers = read(tmp_path, f"person,{column},left,right,chosen\n" + "\n".join(rows))
    assert (len(answers), dict(answers.uncounted)) == (2, {})
    assert answers.groups[column].levels == tuple(sorted(cells))


@pytest.mark.parametrize(
    ("column", "cells"),
    [
        ("excluded", ("yes", "", "")),
        ("Excluded", ("TRUE", "FALSE", "FALSE")),
        ("exclude", ("1", "0", "0")),
        ("is_excluded", ("x", "NA", "NA")),
        ("exclusion_reason", ("too fast", "", "NA")),
        ("excluded", ("excluded", "included", "included")),
        ("invalid", ("ja", "nein", "nein")),
        ("valid", ("no", "yes", "yes")),
        ("is_valid", ("0.0", "1.0", "1.0")),
        ("include", ("FALSE", "TRUE", "TRUE")),
        ("除外", ("はい", "いいえ", "いいえ")),
    ],
)
def test_rows_marked_as_excluded_do_not_count(tmp_path, column, cells):
    rows = [
        f"{who},{cell},{a},{b},{a}" for who, cell, (a, b) in zip("mno", cells, PAIRS, strict=True)
    ]
    answers = read(tmp_path, f"person,{column},left,right,chosen\n" + "\n".join(rows))
    assert (answers.people, dict(answers.uncounted)) == (("n", "o"), {"marked": 1})
    wide = "\n".join(f"{who},{cell},A,B" for who, cell in zip("mno", cells, strict=True))
    answers = read(tmp_path, f"person,{column},A vs B,B vs C\n{wide}\n")
    assert (answers.people, dict(answers.uncounted)) == (("n", "o"), {"marked": 2})
    with pytest.raises(nc.InputError, match=r"left out: 1 marked as excluded"):
        read(tmp_path, f"person,{column},left,right,chosen\nm,{cells[0]},A,B,A\nn,,,,\n")


@pytest.mark.parametrize(
    ("column", "cells"),
    [
        ("excluded", ("yes", "no", "maybe")),
        ("exclude", ("2", "1", "0")),
        ("excluded", ("fast", "slow", "good")),
        ("valid", ("no", "yes", "")),
        ("include", ("no", "", "")),
        ("keep", ("no", "perhaps", "yes")),
    ],
)
def test_exclusions_that_are_not_clear_are_refused_by_column_and_values(tmp_path, column, cells):
    rows = [
        f"{who},{cell},{a},{b},{a}" for who, cell, (a, b) in zip("mno", cells, PAIRS, strict=True)
    ]
    with pytest.raises(nc.InputError) as refusal:
        read(tmp_path, f"person,{column},left,right,chosen\n" + "\n".join(rows))
    said = str(refusal.value)
    assert f"column {column} may say which rows are excluded" in said
    assert all(f'"{cell}"' in said for cell in cells if cell)

"""Lines of names as programs write them, and what stands above and below."""

import re

import pytest

import nacreous as nc
from tests.scaling.answer_texts import read, said


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
@pytest.mark.parametrize(
    ("mark", "titles"),
    [
        (",", "My study\n"),
        (";", "My study\nOf pearls, in 2024\n"),
        ("\t", "C:\\Data\\Pearls-1.edat3\n\n"),
        ("\t", "Pearls, spring 2024\n"),
        ("|", "A; B\n\nC, D\n"),
    ],
)
def test_titles_above_names_of_other_programs_are_left_out(tmp_path, mark, titles, encoding):
    names = mark.join(["Subject", "LeftStim", "RightStim", "Choice.RESP"])
    rows = "".join(mark.join(row) + "\n" for row in (("1", "A", "B", "A"), ("2", "B", "C", "C")))
    text = f"{titles}{names}\n{rows}".encode(encoding)
    options = {"left": "LeftStim", "right": "RightStim", "chosen": "Choice.RESP"}
    told = ", ".join(f"{role}={name!r}" for role, name in options.items())
    with pytest.raises(nc.InputError, match=f"name them by {re.escape(told)}"):
        read(tmp_path, text)
    assert said(read(tmp_path, text, **options)) == ["1:A>B", "2:C>B"]


@pytest.mark.parametrize(
    "text",
    [
        "pairs A B 1 812\npairs A D 1 813\npairs C B 2 814\n",
        "subj stimL stimR resp\n1 A B A\n1 A D A\n",
        "subj  stimL  stimR  resp\n   1  A      B      A\n  10  A      D      A\n",
        "subj stimL stimR resp rt\n1 A B A 0,812\n1 A D A 0,813\n",
        "My study\n\nsubj stimL stimR resp\n1 A B A\n1 A D A\n",
        "person left right chosen\n1 A B A\n",
    ],
)
def test_cells_that_spaces_part_are_refused_as_that(tmp_path, text):
    with pytest.raises(nc.InputError, match="txt: cells are separated by spaces; allowed: commas"):
        read(tmp_path, text, "a.txt")


@pytest.mark.parametrize(
    ("names", "told"),
    [
        ("left_or_right,key,resp", "left=NAME, right=NAME, chosen=NAME"),
        (
            "bild_left,bild_right,left_response",
            "left='bild_left', right='bild_right', chosen='left_response'",
        ),
        ("links,rechts,Antwort links", "left=NAME, right='rechts', chosen=NAME"),
        ("stim,foil,leftright_choice", "left=NAME, right=NAME, chosen=NAME"),
    ],
)
def test_a_line_that_names_columns_names_none_of_them_twice(tmp_path, names, told):
    with pytest.raises(nc.InputError, match=re.escape(f"name them by {told}")):
        read(tmp_path, f"{names}\nA,B,A\nC,B,C\n")


def test_a_mistyped_name_is_not_taken_for_a_column_that_has_a_role_already(tmp_path):
    with pytest.raises(nc.InputError, match=r"has no column lefft; .*name it by right=NAME"):
        read(tmp_path, "left,foil,chosen\nA,B,A\nC,B,C\n", right="lefft")


@pytest.mark.parametrize(
    ("names", "told"),
    [
        (["A or B?", "B or C?"], "A vs B"),
        (["A or B", "B or C"], "A vs B"),
        (["Which is better: A or B?", "Which is better: B or C?"], "Which is better: A vs B"),
        (["Which - A or B", "Which - B or C"], "Which: A vs B"),
        (["A oder B?", "B oder C?"], "A vs B"),
        (["AかB？", "BかC？"], "A vs B"),
        (["A / B", "B / C"], "A vs B"),
        (["Was glänzt mehr: A gegen B", "Was glänzt mehr: B gegen C"], "Was glänzt mehr: A vs B"),
        (["A contre B", "B contre C"], "A vs B"),
        (["A contra B?", "B contra C?"], "A vs B"),
        (["A contro B", "B contro C"], "A vs B"),
        (["A o B", "B o C"], "A vs B"),
        (["A対B", "B対C"], "A vs B"),
        (["A 対 B", "B 対 C"], "A vs B"),
        (["AｖｓB", "BｖｓC"], "A vs B"),
        (["A OR B", "B OR C"], "A vs B"),
    ],
)
def test_columns_of_pairs_in_other_words_are_told_with_vs(tmp_path, names, told):
    text = f"Timestamp,Email Address,How old or young?,Score,{','.join(names)}\n"
    text += "3/1/2026 9:30:00,p@x.org,31,0 / 6,A,C\n3/2/2026 9:30:00,q@x.org,32,0 / 6,B,\n"
    allowed = f'allowed with a column a pair: names such as "{told}"'
    with pytest.raises(nc.InputError) as refusal:
        read(tmp_path, text)
    assert f'has columns such as "{names[0]}"; {allowed}' in str(refusal.value)
    read(tmp_path, text.replace(names[0], told).replace(names[1], told.replace("B", "C")))


def test_columns_with_or_that_hold_neither_are_no_pairs(tmp_path):
    text = "Smoker or not,Where or when,links,rechts,Antwort\n1,2,A,B,A\n"
    with pytest.raises(nc.InputError, match="has no columns left, right and chosen; columns here"):
        read(tmp_path, text)


MONKEY = "Respondent ID,Collector ID,Start Date,"


@pytest.mark.parametrize(
    "lines",
    [
        f"{MONKEY}Which? A vs B,Which? B vs C,Age\n,,,Response,Response,Open-Ended Response\n",
        f"{MONKEY}Which? A vs B,Which? B vs C,Age\n,,,A vs B,B vs C,Response\n",
        f"{MONKEY}Which?,,Age\n,,,A vs B,B vs C,Response\n",
        f"{MONKEY}Which?,,Age\nRespondent ID,Collector ID,Start,A vs B,B vs C,Response\n",
        "respondent_id,collector_id,date_created,A vs B,B vs C,Age\n,,,Antwort,Antwort,Antwort\n",
        f"Of spring\n\n{MONKEY}A vs B,B vs C,Age\n,,,Response,Response,Response\n",
        f"{MONKEY}A vs B,B vs C,Age\n",
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
def test_the_second_line_of_names_of_surveymonkey_is_no_person(tmp_path, lines, encoding):
    text = f"{lines}118,4,03/01/2026 09:30:00 AM,A,C,31\n119,4,03/02/2026 09:30:00 AM,B,,32\n"
    answers = read(tmp_path, text.encode(encoding))
    assert said(answers) == ["118:A>B", "118:C>B", "119:B>A"]
    assert answers.groups["Age"].levels == ("31", "32")


def test_the_second_line_of_names_counts_in_the_numbers_of_rows(tmp_path):
    text = f"{MONKEY}Which?,\n,,,A vs B,B vs C\n118,4,x,A,C\n119,4,y,D,B\n"
    with pytest.raises(nc.InputError, match=r'row 4: .*"D"; allowed: "A" or "B"'):
        read(tmp_path, text)


@pytest.mark.parametrize("rows", ["A,B,A\nC,B,B\n", "mika,A,B,B\nyuki,C,D,D\n", "1,2,1\n3,4,3\n"])
def test_a_first_line_that_repeats_a_label_is_told_to_be_no_line_of_names(tmp_path, rows):
    path = tmp_path / "a.csv"
    path.write_text(rows)
    with pytest.raises(
        nc.InputError, match=r"row 1 .* an answer.*; allowed: a line of column names"
    ):
        nc.scaling.Answers.read(path)

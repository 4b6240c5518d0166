"""What a file of answers has to say differently: one line, with the argument to give."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import nacreous as nc
from nacreous import cli
from nacreous.commands.spoken import spoken
from nacreous.scaling import Answers, Comparisons

HEAD = "person,left,right,chosen\n"
PLAIN = HEAD + "p1,A,B,A\np1,B,C,C\n"
QUALTRICS = """\
ResponseId,Finished,Q1,Q2
Response ID,Finished,Which? A vs B,"Which?
B or C?"
"{""ImportId"":""_recordId""}","{""ImportId"":""finished""}","{""ImportId"":""QID1""}",\
"{""ImportId"":""QID2""}"
"""


def outcomes(folder: Path, content: str | bytes, **options: Any) -> list[str]:
    path = folder / "a.csv"
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    answers = Answers.read(path, **options)
    sides = (answers.stimuli[at] for at in (*answers.left, *answers.right))
    labels = list(sides)
    pairs = zip(labels[: len(answers)], labels[len(answers) :], answers.outcome, strict=True)
    return [f"{left}{'<=>'[outcome + 1]}{right}" for left, right, outcome in pairs]


def refused(folder: Path, content: str | bytes, **options: Any) -> str:
    """The one line that says why."""
    with pytest.raises(nc.InputError) as told:
        outcomes(folder, content, **options)
    (line,) = str(told.value).splitlines()
    return line.removeprefix(f"{folder}/a.csv: ")


@pytest.mark.parametrize(
    "content",
    [
        PLAIN.replace(",", "|"),
        "sep=|\n" + PLAIN.replace(",", "|"),
        PLAIN.encode("utf-16"),
        "subject,A vs B,B vs C\np1,left,right\n",
        'Response ID,Seed,Which? [A vs B],"Which? [B vs C]"\n1,7,A,C\n2,8,N/A,\n',
        HEAD + "p1,A,B,\"['A', 'A']\"\np1,B,C,['C']\n",
    ],
)
def test_a_file_that_says_all_is_read(tmp_path, content):
    assert outcomes(tmp_path, content) == ["A>B", "B<C"]


def test_japanese_of_mail_is_read_by_its_escapes(tmp_path):
    text = HEAD + "p1,光沢,巻き,巻き\n"
    assert outcomes(tmp_path, text.encode("iso2022_jp")) == ["光沢<巻き"]


@pytest.mark.parametrize(
    ("content", "options", "message"),
    [
        (PLAIN.replace(",", " "), {}, "cells are separated by spaces; allowed: commas, semicolons"),
        (
            "<!DOCTYPE html><html><body>Login</body></html>",
            {},
            "is a web page or XML; allowed: a t",
        ),
        ('[{"left":"A","right":"B","chosen":"A"}]', {}, "is JSON; allowed: a table as text"),
        (PLAIN, {"encoding": "utf-16"}, "is not UTF-16 text; allowed: UTF-16, as was said"),
    ],
)
def test_what_is_no_table_is_called_by_its_name(tmp_path, content, options, message):
    assert refused(tmp_path, content, **options).startswith(message)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (PLAIN + "# exported 2024\n", 'row 4: has 1 cell, "# exported 2024"; allowed: 4 (remove'),
        ("p,A,B,A\np,B,C,C\nq,C,A,A\np,A,B,A\n", 'row 1 seems to be an answer, for "p", "A", "B"'),
        ("p,A,B,C\np,A,C,B\nq,C,B,A\n", 'row 1 seems to be an answer, for "p", "A", "B" stand in'),
        ("who,A or B,B or C\np,A,B\n", 'has columns such as "A or B"; allowed with a column a p'),
        ("subject,A/B,B/C\np,A,B\n", 'has columns such as "A/B"; allowed with a column a pair'),
        ("'left','right','chosen'\n'A','B','A'\n", "row 1 has its names in single quotation mark"),
        (
            HEAD + '1,"A \\"big\\"",B,B\n',
            "line 2: a quotation mark stands behind a backslash; allow",
        ),
        (
            HEAD + '1,A,"say \\"a, b\\"",A\n',
            "line 2: a quotation mark stands behind a backslash; al",
        ),
        (
            HEAD + "(text),(text),(text),(s)\np,A,B,A\n",
            'row 2: "(text)" is paired with itself; allo',
        ),
        (
            HEAD + "p,string,string,string\np,A,B,A\n",
            'row 2: "string" is paired with itself; allowe',
        ),
        ("person,Which? [A vs B][1]\np,A\n", 'column "Which? [A vs B][1]" has brackets beside tho'),
        ("person,Q1 [A vs B] [Scale 1]\np,A\n", 'column "Q1 [A vs B] [Scale 1]" has brackets bes'),
        (HEAD + "p,A,B,-3\np,B,C,2\np,A,C,0\n", "chosen holds -3, 0 and 2, as grades do; allowed"),
        (HEAD + 'p,A,B,"1,5"\np,B,C,1\np,A,C,½\n', "chosen holds ½, 1 and 1,5, as grades do; al"),
        (HEAD + "p,A,B,50%\np,B,C,1\np,A,C,5%\n", "chosen holds 5%, 50% and 1, as grades do; al"),
        (
            HEAD + "p,A,B,0\np,B,C,2\n",
            "chosen holds 0 and 2, and either side may be meant; allowed",
        ),
    ],
)
def test_what_is_no_line_of_names_or_no_answer_is_said(tmp_path, content, message):
    assert refused(tmp_path, content).startswith(message)


def test_advice_names_what_is_in_the_file(tmp_path):
    line = refused(tmp_path, HEAD + "p,A,B,0\np,B,C,2\n")
    assert line.endswith("left_word='0', right_word='2'")
    line = refused(tmp_path, "person,Which? [A vs B][1]\np,A\n")
    assert line.endswith('such as "Which? [A vs B]" (rename)')
    line = refused(tmp_path, HEAD + "p,string,string,string\np,A,B,A\n")
    assert line.endswith("(remove the row, if it says the units or kinds of the columns)")
    assert refused(tmp_path, HEAD + "p,A,A,A\np,A,B,A\n").endswith("allowed: two stimuli")


def test_a_folder_at_the_end_of_a_cell_is_no_escape(tmp_path):
    assert outcomes(tmp_path, HEAD + '"C:\\a\\",A,B,A\n"C:\\b\\",B,"C",C\n') == ["A>B", "B<C"]


def test_a_line_of_a_wide_table_given_twice_is_one_fault(tmp_path):
    line = refused(tmp_path, "subject,A vs B,B vs C,A vs C\np1,A,C,A\np1,A,C,A\n")
    assert line.startswith("row 3: repeats row 2: the same person on the same pair")


@pytest.mark.parametrize(
    ("words", "arguments"),
    [
        (("links", "rechts"), "left_word='links', right_word='rechts'"),
        (("gauche", "droite"), "left_word='gauche', right_word='droite'"),
        (("FALSE", "TRUE"), "left_word='TRUE', right_word='FALSE' or the other way round"),
        (("yes", "yes"), "left_word='yes', right_word='no' or the other way round"),
        (("equal", "equal"), "tie='equal'"),
        (("=", "="), "tie='='"),
        (("同じ", "同じ"), "tie='同じ'"),
        (("x", "y"), "left_word=WORD, right_word=WORD, tie=WORD"),
    ],
)
def test_other_words_are_refused_once_with_the_arguments_that_say_them(tmp_path, words, arguments):
    rows = "".join(f"p{at},A,B,{word}\n" for at, word in enumerate(words * 9))
    line = refused(tmp_path, HEAD + rows)
    assert line.startswith(f'row 2: chosen {"holds" if len(set(words)) > 1 else "is"} "')
    assert line.endswith(
        f'; allowed: "A" or "B", left, right or tie, or {arguments} (18 such rows)'
    )


@pytest.mark.parametrize(
    ("column", "cell"),
    [
        ("time", "01.03.2024 10:00"),
        ("time", "3/1/2024 10:00 AM"),
        ("trial", "first"),
        ("response_ms", "timeout"),
        ("response_s", "[0.81, 0.9]"),
    ],
)
def test_a_column_that_may_be_missing_is_left_unused_where_it_cannot_be_read(
    tmp_path, column, cell
):
    content = f'left,right,chosen,{column}\nA,B,A,"{cell}"\nB,C,C,"{cell}"\n'
    line = refused(tmp_path, content)
    assert line.startswith(f'row 2: {column} is "{cell}"; allowed: a number')
    assert line.endswith(f"{column}='' to leave the column unused (2 such rows)")
    assert outcomes(tmp_path, content, **{column: ""}) == ["A>B", "B<C"]


def test_missing_columns_are_named_in_one_line_with_all_their_arguments(tmp_path):
    head = "stim_l,stim_r,trials.thisN,key_resp.keys,key_resp.rt,participant\n"
    content = f"{head}A,B,0,left,0.8,1\nB,C,1,right,0.9,1\n"
    line = refused(tmp_path, content)
    assert line.startswith('has no columns left, right and chosen; columns here: "stim_l", ')
    assert line.endswith("name them by left='stim_l', right='stim_r', chosen='key_resp.keys'")
    named = {"left": "stim_l", "right": "stim_r", "chosen": "key_resp.keys"}
    assert outcomes(tmp_path, content, **named) == ["A>B", "B<C"]
    assert refused(tmp_path, "a,b,c,d\n1,2,3,4\n").endswith("left=NAME, right=NAME, chosen=NAME")


def test_a_question_that_names_no_pair_is_not_dropped(tmp_path):
    line = refused(tmp_path, QUALTRICS + "R_1,1,A,B\nR_2,1,B,C\n")
    assert line.startswith('column Q2 ("Which? B or C?") holds "B" and names no pair')
    asked = QUALTRICS.replace("B or C?", "B vs C")
    assert outcomes(tmp_path, asked + "R_1,1,A,B\nR_2,1,B,C\n") == ["A>B", "B>C", "A<B", "B<C"]
    numbers = asked.replace("A vs B", "1 vs 2").replace("B vs C", "2 vs 3")
    assert outcomes(tmp_path, numbers + "R_1,1,1,2\n") == ["1>2", "2>3"]
    assert "column best holds" in refused(tmp_path, "subject,A vs B,best\n1,A,A\n")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"left_word": "x", "right_word": "x"}, "left_word='x' is given with right_word='x'; allo"),
        ({"left_word": "tie"}, "left_word='tie' is given with tie='tie'; allowed: d"),
        ({"left_word": "A"}, "left_word='A' is the label of a stimulus; allowed: another word"),
        ({"tie": "A"}, "tie='A' is the label of a stimulus; allowed: another word"),
        ({"left_word": "f"}, "left_word='f' is given; allowed: words in chosen, which holds \"A\""),
        ({"left_word": ""}, "left_word is empty; allowed: a word"),
        ({"left": ""}, "left is empty; allowed: a name"),
    ],
)
def test_words_without_effect_are_refused(tmp_path, words, message):
    line = refused(tmp_path, PLAIN, **words)
    assert line.startswith(message)


def test_a_table_of_answers_is_no_square_of_counts_and_the_other_way_round(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text(PLAIN)
    with pytest.raises(nc.InputError, match=r"^[^\n]*names of a table of answers.*Answers\.read$"):
        Comparisons.read_counts(path)
    square = ",A,B\nA,0,3\nB,1,0\n"
    assert refused(tmp_path, square).endswith("read this by Comparisons.read_counts")
    path.write_text(square.replace(",", ";").replace("3", "3,5"))
    with pytest.raises(nc.InputError, match=r'column 2 is "3,5"; allowed: a whole number, 0 or'):
        Comparisons.read_counts(path)


@pytest.mark.parametrize(
    ("python", "command"),
    [
        (
            "ties is True; allowed with method 'bias-reduced': False, each counts half",
            "--ties is given; allowed with --method bias-reduced: --no-ties, each counts half",
        ),
        (
            'group "g": few; allowed: 3 or more people, or kind="expected" or counts, which take '
            "answers as independent",
            'group "g": few; allowed: 3 or more people, or --column person= to take answers as '
            "independent",
        ),
        (
            """has no columns left; name them by left="it's", right='b'""",
            """has no columns left; name them by --column 'left=it'"'"'s' --column right=b""",
        ),
        (
            'label "x" is odd; name it by left="a\'b"',
            """label "x" is odd; name it by --column 'left=a'"'"'b'""",
        ),
    ],
)
def test_the_command_speaks_of_its_own_options(python, command):
    with pytest.raises(nc.InputError) as told, spoken("a.csv"):
        raise nc.InputError(python)
    assert str(told.value) == command


def test_what_is_no_file_is_called_by_its_name(tmp_path, capsys):
    path = tmp_path / "a.csv"
    path.write_text(PLAIN)
    for command, message in (
        ([""], "the file's name is empty; allowed: a file, or - for standard input"),
        (
            ["https://example.org/a.csv"],
            "https://example.org/a.csv: is an address; allowed: a file",
        ),
        ([str(path), "-o", ""], "the output is empty; allowed: a file that ends in .html, .csv"),
        ([str(path), "-o", str(tmp_path)], f"{tmp_path}: is a folder; allowed: a file in it"),
    ):
        assert cli.main(["scale", *command]) == 2
        assert capsys.readouterr().err.startswith(f"nacreous: {message}")


def test_a_line_break_in_a_path_breaks_no_message(tmp_path):
    for name in ("no\nsuch.csv", "no\nsuch", "."):
        with pytest.raises(nc.InputError, match=r"\A[^\n]*\Z"):
            Answers.read(tmp_path / name)
        with pytest.raises(nc.InputError, match=r"\A[^\n]*\Z"):
            Comparisons.read_counts(tmp_path / name)

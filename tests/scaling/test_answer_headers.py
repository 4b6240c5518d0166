"""Lines of names as programs write them, and what stands above and below."""

import re

import pytest

import nacreous as nc
from tests.scaling.test_answer_files import read, said


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

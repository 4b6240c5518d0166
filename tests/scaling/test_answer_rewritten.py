"""Labels that a program rewrote: rounded, in a wrong encoding, escaped, as a path of Windows."""

import pytest

import nacreous as nc
from nacreous.scaling import Answers


def refused(column: str, one: str, other: str) -> str:
    """What is said of two values in one column."""
    table = {"person": [*"pqr"], "left": [*"ABC"], "right": [*"BCA"], "chosen": [*"BCA"]}
    table[column] = [one, other, *table[column][2:]]
    with pytest.raises(nc.InputError) as told:
        Answers.of_table(table)
    (line,) = str(told.value).splitlines()
    return line.removeprefix("table: ")


@pytest.mark.parametrize("column", ["person", "left", "right"])
@pytest.mark.parametrize(
    ("cell", "digits", "shown"),
    [
        ("1.23457E+12", 13, 6),
        ("1,23457E+12", 13, 6),
        ("1E+11", 12, 1),
        ("1.2E+07", 8, 2),
        ("1.234568e+12", 13, 7),
        ("9.00719925474099e15", 16, 15),
    ],
)
def test_a_number_that_lost_digits_is_nobody_and_no_stimulus(column, cell, digits, shown):
    said = refused(column, cell, cell) if column == "person" else refused(column, cell, "D")
    many = " (2 such rows)" if column == "person" else ""
    assert said == (
        f'row 0: {column} is "{cell}", a number of {digits} digits that a spreadsheet rounded to '
        f"{shown}; allowed: all its digits (save the column as text){many}"
    )


@pytest.mark.parametrize("label", ["1e3", "1E+3", "1e+05", "1.5", "1E-12", "1.23456789E+8", "E+12"])
def test_a_number_with_all_its_digits_stays_a_label(label):
    answers = Answers.of_table({"left": [label], "right": ["B"], "chosen": [label]})
    assert set(answers.stimuli) == {label, "B"}


def test_a_label_that_is_given_may_look_rounded():
    table = {"left": ["1E+12"], "right": ["B"], "chosen": ["B"]}
    assert Answers.of_table(table, stimuli=["1E+12", "B"]).stimuli == ("1E+12", "B")


ENCODINGS = [
    *(("cp1252", "utf-8"), ("cp932", "utf-8"), ("mac_roman", "utf-8"), ("cp850", "utf-8")),
    ("cp1252", "cp932"),
]


@pytest.mark.parametrize("column", ["person", "left"])
@pytest.mark.parametrize(("read_as", "encoding"), ENCODINGS)
@pytest.mark.parametrize("label", ["weiß", "光沢", "café", "voilà"])
def test_a_label_read_in_a_wrong_encoding_is_no_second_one(column, read_as, encoding, label):
    try:
        wrong = label.encode(encoding).decode(read_as).strip()
    except UnicodeError:
        return  # one of the two lacks a letter
    if not wrong.isprintable():
        return  # which is refused by that
    for pair in ((label, wrong), (wrong, label)):
        assert refused(column, *pair) == (
            f'"{label}" and "{wrong}" are likely one label, the second read in a wrong encoding; '
            "allowed: one way of writing it"
        )


@pytest.mark.parametrize(
    ("label", "other", "how"),
    [
        ("weiß", "wei?", "label, the second with letters lost"),
        ("weiß", "wei\ufffd", "label, the second with letters lost"),
        ("weiß", "wei&szlig;", "label, the second as web pages escape it"),
        ("A & B", "A &amp; B", "label, the second as web pages escape it"),
        ("A 1.png", "A%201.png", "label, the second as web addresses escape it"),
        ("stim/A.png", "stim\\A.png", "file"),
        ("./A.png", "A.png", "file"),
        ("A.PNG", "A.png", "file"),
        ("a/B.jpeg", "a\\B.JPEG", "file"),
    ],
)
def test_a_label_with_what_programs_make_of_it_is_likely_one(label, other, how):
    said = f'"{label}" and "{other}" are likely one {how}; allowed: one way of writing it'
    assert refused("left", label, other) == said


@pytest.mark.parametrize(
    ("label", "other"),
    [
        ("weiß", "weiss"),
        ("a.png", "A.png"),
        ("St.A", "St.a"),
        ("A.png", "A.jpg"),
        ("x/A.png", "y/A.png"),
        ("é", "á"),
        ("weiß?", "wei??"),
        ("50%", "5%"),
        ("A+B", "A&B"),
        ("光沢", "色調"),
    ],
)
def test_labels_that_no_program_makes_of_each_other_stay_two(label, other):
    answers = Answers.of_table({"left": [label], "right": [other], "chosen": [other]})
    assert set(answers.stimuli) == {label, other}

"""Answers' files as they come from elsewhere: each read right, or refused in one line."""

from __future__ import annotations

import pytest

import nacreous as nc
from tests.scaling.answer_texts import HEAD, PLAIN, ROWS, TOLD, read, said

JAPANESE = PLAIN.replace("A", "光沢").replace("B", "巻き").replace("C", "テリ")


@pytest.mark.parametrize(
    "content",
    {
        "mark and blank line": "\ufeff\n" + PLAIN,
        "mark before a name in quotes": '\ufeff"person",left,right,chosen\n' + ROWS,
        "comma at the end of each line": PLAIN.replace("\n", ",\n"),
        "two commas, of data alone": HEAD + ROWS.replace("\n", ",,\n"),
        "comma at the end of the names alone": HEAD.replace("\n", ",,\n") + ROWS,
        "empty rows": HEAD + ",,,\n" + ROWS.replace("p2", ",,,\n , ,\t,\np2") + ",,,\n\n,,,\n",
        "sep line": "sep=;\r\n" + PLAIN.replace(",", ";").replace("\n", "\r\n"),
        "sep line in quotes, with commas": '"sep=,"\n' + PLAIN,
        "sep line after a mark": "\ufeffsep=\t\n" + PLAIN.replace(",", "\t"),
        "title": "Pearl study 2024,,,\n" + PLAIN,
        "titles and a blank line": "Pearl study\n2024-01-01\n\n" + PLAIN,
        "title with other separators": "Study; of pearls; 2024\n" + PLAIN,
        "separators within quotes": PLAIN.replace("chosen", 'chosen,"a;b;c;d;e;f"', 1)
        .replace("A\n", "A,x\n")
        .replace("C\n", "C,x\n"),
        "names in capitals": PLAIN.replace("left", "Left").replace("chosen", "CHOSEN"),
        "all in quotes": '"' + PLAIN.replace(",", '","').replace("\n", '"\n"')[:-1],
        "carriage returns": PLAIN.replace("\n", "\r"),
        "lines of Windows with blank ones": PLAIN.replace("\n", "\r\r\n"),
        "no end of the last line": PLAIN[:-1],
        "an index of pandas": ",person,left,right,chosen\n0,p1,A,B,A\n1,p1,B,C,C\n2,p2,C,A,A\n",
        "an index of R": '"",person,left,right,chosen\n1,p1,A,B,A\n2,p1,B,C,C\n3,p2,C,A,A\n',
        "names of rows of R, in tabs": (
            HEAD
            + "".join(
                f"{at},{line}" for at, line in zip((1, 3, 2), ROWS.splitlines(True), strict=True)
            )
        ).replace(",", "\t"),
        "names of rows of R, in blanks": '"person" "left" "right" "chosen"\n'
        '"1" "p1" "A" "B" "A"\n"2" "p1" "B" "C" "C"\n"7" "p2" "C" "A" "A"\n',
        "UTF-16": PLAIN.encode("utf-16"),
        "UTF-16, big end first": b"\xfe\xff" + PLAIN.encode("utf-16-be"),
        "UTF-16 of E-Prime": PLAIN.replace(",", "\t").encode("utf-16"),
        "UTF-16 without a mark": PLAIN.encode("utf-16-le"),
        "UTF-32": PLAIN.encode("utf-32"),
        "words": HEAD + "p1,A,B,Left\np1,B,C,RIGHT\np2,C,A,right\n",
        "letters": HEAD + "p1,A,B,L\np1,B,C,R\np2,C,A,r\n",
        "first and second": HEAD + "p1,A,B,1\np1,B,C,2\np2,C,A,2\n",
        "first and second of pandas": HEAD + "p1,A,B,1.0\np1,B,C,2.0\np2,C,A,2.0\n",
        "arrow keys": HEAD + "p1,A,B,ArrowLeft\np1,B,C,arrowright\np2,C,A,{RIGHTARROW}\n",
        "Japanese sides": HEAD + "p1,A,B,左\np1,B,C,右\np2,C,A,右\n",
        "lists of one": HEAD + 'p1,A,B,[\'left\']\np1,B,C,"[""C""]"\np2,C,A,[A]\n',
        "people by another name": PLAIN.replace("person", "subject_nr"),
        "a note over lines": PLAIN.replace("chosen", "chosen,note", 1)
        .replace("A\n", 'A,"one, two\nthree"\n')
        .replace("C\n", "C,\n"),
        "Ctrl-Z at the end": PLAIN + "\x1a",
        "a new page at the end": PLAIN + "\x0c\r\n",
        "long cells": PLAIN.replace("chosen", "chosen,note", 1)
        .replace("A\n", f"A,{'x' * 2_000_000}\n")
        .replace("C\n", "C,\n"),
    }.items(),
    ids=lambda case: case[0],
)
def test_a_file_of_spreadsheets_and_programs_is_read_right(tmp_path, content):
    answers = read(tmp_path, content[1])
    assert said(answers) == TOLD
    assert answers.stimuli == ("A", "B", "C")


@pytest.mark.parametrize("name", ["a.tsv", "a.txt", "A.TSV"])
def test_a_text_file_of_another_ending_is_read(tmp_path, name):
    assert said(read(tmp_path, PLAIN.replace(",", "\t"), name)) == TOLD
    assert said(read(tmp_path, PLAIN, name)) == TOLD


def test_japanese_is_read_in_the_encodings_of_japan(tmp_path):
    wanted = said(read(tmp_path, JAPANESE))
    assert wanted == ["p1:光沢>巻き", "p1:テリ>巻き", "p2:光沢>テリ"]
    assert said(read(tmp_path, JAPANESE.encode("cp932"))) == wanted
    assert said(read(tmp_path, JAPANESE.encode("utf-16"))) == wanted
    assert said(read(tmp_path, JAPANESE.encode("euc_jp"), encoding="euc-jp")) == wanted
    assert said(read(tmp_path, JAPANESE.encode("cp932"), encoding="Shift_JIS")) == wanted


@pytest.mark.parametrize("python", ["utf-32-le", "utf-32-be", "utf-16-le", "utf-16-be", "utf-32"])
@pytest.mark.parametrize("text", [JAPANESE, PLAIN, JAPANESE.replace("person", "評価者")])
def test_wide_text_is_read_with_a_mark_or_without(tmp_path, python, text):
    content = text.encode(python)
    found = [read(tmp_path, content), read(tmp_path, content, encoding=python[:6])]
    assert [said(one) for one in found] == [said(read(tmp_path, text))] * 2
    assert [one.encoding_guessed for one in found] == [None, None]


@pytest.mark.parametrize("python", ["utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_names_in_japanese_need_no_mark(tmp_path, python, separator):
    """All that is ASCII in the first line is what separates its names."""
    text = "左,右,選択\n巻き,光沢,巻き\n一番,光沢,光沢\n".replace(",", separator)
    named = {"left": "左", "right": "右", "chosen": "選択"}
    assert said(read(tmp_path, text.encode(python), **named)) == ["巻き>光沢", "光沢>一番"]


def test_a_guessed_encoding_is_told(tmp_path):
    guessed = read(tmp_path, JAPANESE.encode("cp932"))
    assert guessed.encoding_guessed == guessed.comparisons().encoding_guessed == "Shift-JIS"
    assert read(tmp_path, JAPANESE.encode("cp932"), encoding="sjis").encoding_guessed is None
    assert read(tmp_path, JAPANESE).encoding_guessed is None
    (tmp_path / "counts.csv").write_bytes("光沢,巻き\n0,3\n1,0\n".encode("cp932"))
    counts = nc.scaling.Comparisons.read_counts(tmp_path / "counts.csv")
    assert counts.encoding_guessed == "Shift-JIS"


@pytest.mark.parametrize(
    "labels",
    ["Hélène,Éclat,Terné", "A,Éclat,B", "Ångström,Ørsted,a", "São,maçã,brûlée", "às,maçã,brûlée"],
)
@pytest.mark.parametrize("python", ["mac_roman", "cp850", "cp437"])
def test_accents_that_make_kanji_within_latin_words_are_no_japanese(tmp_path, labels, python):
    one, two, three = labels.encode(python, "replace").decode(python).split(",")
    text = f"person;left;right;chosen\n{one};{two};{three};{two}\n"
    with pytest.raises(nc.InputError, match="is not UTF-8 text"):
        read(tmp_path, text.encode(python))
    assert len(read(tmp_path, text.encode(python), encoding="mac-roman")) == 1


@pytest.mark.parametrize(
    "labels", [("T字路", "Y字路"), ("あこやpearl", "白蝶pearl"), ("A級", "B級")]
)
def test_latin_letters_beside_japanese_are_japanese(tmp_path, labels):
    text = "left,right,chosen\n{0},{1},{1}\n光沢,{1},光沢\n".format(*labels)
    assert set(labels) < set(read(tmp_path, text.encode("cp932")).stimuli)


@pytest.mark.parametrize(
    ("labels", "python"),
    [
        (["Émail", "Nacré", "Doré"], "cp1252"),
        (["Pearl’s", "“two”", "a—b"], "cp1252"),
        (["été", "Régis", "éb"], "latin-1"),
        (["ﾃﾘ", "ﾏｷ", "ｲﾛ"], "cp932"),
        (["光", "沢", "光沢"], "cp932"),
        (["жемчуг", "блеск", "цвет"], "cp1251"),
        (["珍珠", "光泽", "颜色"], "gb18030"),
    ],
)
def test_an_encoding_that_cannot_be_told_is_asked_for(tmp_path, labels, python):
    """Half-width kana and two kanji alone may be Western text, and the other way round."""
    text = PLAIN
    for letter, label in zip("ABC", labels, strict=True):
        text = text.replace(letter, label)
    with pytest.raises(nc.InputError, match=r"line 2 is not UTF-8 .* such as encoding="):
        read(tmp_path, text.encode(python))
    name = {"cp1252": "windows-1252", "cp1251": "windows-1251", "cp932": "shift-jis"}
    answers = read(tmp_path, text.encode(python), encoding=name.get(python, python))
    assert set(answers.stimuli) == set(labels)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (PLAIN + HEAD + ROWS, "row 5 is the line of column names again"),
        ("x,y,z\n" + PLAIN, "row 2 holds the names of columns, and row 1 .*skip_rows=1"),
        ("Study\nlinks,right,chosen\nA,B\n", "skip rows above the names by skip_rows=N"),
        ("left,right;chosen\nA,B;A\n", "separated by commas or semicolons in .*line sep=,"),
        (HEAD + "p1,A,B\n", "row 2: has 3 cells; allowed: 4"),
        (HEAD + "p1,A,B,A,note\n", "row 2: has 5 cells; allowed: 4"),
        (HEAD + "1,p1,A,B,A\n1,p1,B,C,C\n", "row 2: has 5 cells; allowed: 4"),
        (HEAD + "\n\np1,A,B\n", "row 4: has 3 cells; allowed: 4"),
        (HEAD + 'p1,A,B,A\np1,"A,B,A\np2,B,C,C\n', "row 3: a quotation mark is not closed"),
        (HEAD + 'p1,A,B,"A\np2,B,C,C\n', "row 2: a quotation mark is not closed"),
        ('person,left,right,"chosen\n' + ROWS, "row 1: a quotation mark is not closed"),
        (HEAD + "p1,A,B,A\0\n", "line 2 holds a NUL character"),
        (HEAD + "p1,,B,B\n", "row 2: left is empty"),
        (HEAD + ROWS + "p1,,,A\n", "row 5: left is empty"),
        (HEAD + ",A,B,A\n", "row 2: person is empty"),
        ("left,left,right,chosen\nA,A,B,A\n", 'has more than one column "left"'),
        ("Left,LEFT,right,chosen\nA,A,B,A\n", "has no column left; did you mean"),
        (",left,right,chosen\nx,A,B,A\n", 'column 1 has no name, and row 2 holds "x" there'),
        (
            "subject,participant,left,right,chosen\n1,2,A,B,A\n1,3,A,B,A\n",
            "people may .* person='sub",
        ),
        (HEAD + "p1,A,B,\"['A', 'B']\"\n", "row 2: chosen is "),
        (HEAD + ",,,\n,,,\n", "has no rows"),
        ("PK\x03\x04" + PLAIN, "is a workbook; allowed: a table as text"),
        ("\n\n \n", "is empty"),
        (PLAIN.replace("chosen", "winner"), "has no column chosen; .*name it by chosen=NAME"),
        (f"{HEAD}p1,A,B,{'x' * 300}\n", "chosen is 300 characters long"),
    ],
    ids=range(25),
)
def test_what_cannot_be_read_is_refused_in_one_line(tmp_path, content, message):
    with pytest.raises(nc.InputError, match=message) as told:
        read(tmp_path, content)
    line, *others = str(told.value).splitlines()
    assert len(others) <= 1  # where two cells of a row are empty
    assert line.startswith(f"{tmp_path}/a.csv: ")
    assert len(line) < 500
    assert "Arrow" not in line
    assert "CSV parse" not in line


def test_rows_above_the_names_are_skipped_where_that_is_said(tmp_path):
    above = "lab,date,room\nOsaka,2024,3\n"
    assert said(read(tmp_path, above + PLAIN, skip_rows=2)) == TOLD
    with pytest.raises(nc.InputError, match=r"skip_rows is -1; allowed: a whole number, 0 to"):
        read(tmp_path, PLAIN, skip_rows=-1)
    with pytest.raises(nc.InputError, match="is empty below the first 50 rows"):
        read(tmp_path, PLAIN, skip_rows=50)
    with pytest.raises(nc.InputError, match="encoding is 'shift-jsi'; did you mean shift-jis"):
        read(tmp_path, PLAIN, encoding="shift-jsi")


def test_rows_are_numbered_as_spreadsheets_count(tmp_path):
    text = "Title\n\n" + PLAIN + "\n,,,\np3,A,B,X\n"
    with pytest.raises(nc.InputError, match='row 9: chosen is "X"'):
        read(tmp_path, text)

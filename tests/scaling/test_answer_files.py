"""Answers' files as they come from elsewhere: each read right, or refused in one line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import Answers, Comparisons
from nacreous.scaling.compare.attribute_table import AttributeTable

HEAD = "person,left,right,chosen\n"
ROWS = "p1,A,B,A\np1,B,C,C\np2,C,A,A\n"
PLAIN = HEAD + ROWS
JAPANESE = PLAIN.replace("A", "光沢").replace("B", "巻き").replace("C", "テリ")
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


def read(folder: Path, content: str | bytes, name: str = "a.csv", **options: Any) -> Answers:
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return Answers.read(path, **options)


def said(answers: Answers) -> list[str]:
    """Each answer as person:winner>loser, or person:left=right."""
    lines = []
    for row in range(len(answers)):
        left, right = answers.stimuli[answers.left[row]], answers.stimuli[answers.right[row]]
        who = "" if answers.person is None else answers.people[answers.person[row]] + ":"
        told = {1: f"{left}>{right}", -1: f"{right}>{left}", 0: f"{left}={right}"}
        lines.append(who + told[int(answers.outcome[row])])
    return lines


TOLD = ["p1:A>B", "p1:C>B", "p2:A>C"]
UNKNOWN = ["A>B", "C>B", "A>C"]


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


# --- programs


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


# --- numbers and times


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


# --- labels in one Unicode form


def test_labels_people_and_groups_are_compared_in_one_unicode_form(tmp_path):
    composed, apart = "\u304c", "\u304b\u3099"
    assert composed != apart
    text = "person,left,right,chosen,gruppe\n" + "".join(
        f"\u00e9{n},{a},b,{b},{a}\ne\u0301{n},b,{b},{a},{b}\n"
        for n, (a, b) in enumerate([(composed, apart), (apart, composed)])
    )
    answers = read(tmp_path, text)
    assert answers.stimuli == ("b", composed)
    assert answers.people == ("\u00e90", "\u00e91")
    assert answers.groups["gruppe"].levels == (composed,)
    assert read(tmp_path, text, stimuli=[apart, "b"]).stimuli == (composed, "b")
    assert Answers.of_pairs([(composed, "b"), ("b", apart)]).stimuli == ("b", composed)
    assert set(answers.split("gruppe")) == {composed}
    fit = nc.scaling.thurstone(answers, prior=1.0)
    assert fit.difference(apart, "b", kind="expected").value > 0
    assert AttributeTable.of({apart: {"x": 1}}).stimuli == (composed,)
    (tmp_path / "counts.csv").write_text(f"{apart},b\n0,1\n2,0\n")
    assert Comparisons.read_counts(tmp_path / "counts.csv").stimuli == (composed, "b")


def test_names_of_columns_are_compared_in_one_unicode_form(tmp_path):
    text = "links,rechts,gewählt\na,b,a\nb,a,b\n".replace("ä", "a\u0308")
    answers = read(tmp_path, text, left="links", right="rechts", chosen="gewählt")
    assert said(answers) == ["a>b", "b>a"]


@pytest.mark.parametrize(
    ("label", "escape"),
    [
        ("\x1b[31mA", r"\\u001b"),
        ("A\x07", r"\\u0007"),
        ("A\u200bB", r"\\u200b"),
        ("\u202eA", r"\\u202e"),
        ("A\x9b2J", r"\\u009b"),
        ("A\u2028B", r"\\u2028"),
        ("A\nB", r"\\u000a"),
        ("A\u3164", r"\\u3164"),
        ("A\u034f", r"\\u034f"),
        ("A\u2800", r"\\u2800"),
        ("A\uffff", r"\\uffff"),
        ("A\U0001fffe", r"\\U0001fffe"),
        ("A\U000e0041", r"\\U000e0041"),
        ("\u200c", r"\\u200c"),
        ("\ufe0f", r"\\ufe0f"),
    ],
)
def test_control_and_invisible_characters_are_no_part_of_a_label(tmp_path, label, escape):
    with pytest.raises(nc.InputError, match=f"left is .*; allowed: no {escape} in it") as told:
        read(tmp_path, HEAD + f'p1,"{label}",C,C\n')
    assert str(told.value).replace("\u200c", "").isprintable()  # which words of Persian hold
    with pytest.raises(nc.InputError, match=f"allowed: no {escape} in"):
        Answers.of_pairs([(label, "C"), ("C", label)])
    noted = read(tmp_path, HEAD.replace("\n", ",note\n") + f'p1,A,B,A,"{label}"\n')
    assert noted.groups["note"].levels[0].replace("\u200c", "").isprintable()


def test_words_of_any_script_are_labels(tmp_path):
    labels = ["לؤلؤ", "نیم\u200cفاصله", "👩\u200d🔬", "真珠", "葛\U000e0100", "❤\ufe0f", "x²", "x2"]
    labels += [f"🏴\U000e0067\U000e0062{tag}\U000e007f" for tag in ("\U000e0065", "\U000e0073")]
    text = HEAD + "".join(f"p{n},{label},b,{label}\n" for n, label in enumerate(labels))
    assert set(read(tmp_path, text).stimuli) == {"b", *labels}


ONE_NUMBER = [
    *(("1", "1.0"), ("0.5", "0.50"), ("0.5", ".5"), ("0.5", "0,5"), ("-1", "-1.0"), ("1", "+1")),
    *(("1000", "1e3"), ("1000", "1,000"), ("0", "-0.0"), ("1e-2", ".01"), ("-1", "\u22121.0")),
    *(("1000", "1 000"), ("1000", "1'000"), ("1000.5", "1.000,5"), ("0.5", "½"), ("1.75", "1¾")),
    *(("1000", "1\u202f000"), ("1000000", "1.000.000")),
    *(("0.5", "50%"), ("0,5", "50 %"), ("1", "100%"), ("0.125", "12.5％"), ("0.005", "5‰")),
]
ALIKE = [
    *(("a b", "a\u00a0b"), ("ab", "a\u200db"), ("ab", "ab\ufe0f"), ("A1", "Ａ１"), ("1", "１")),
    *(("A", "\u0410"), ("A", "\u0391"), ("\u0410", "\u0391"), ("c", "\u0441"), ("ガ", "ｶﾞ")),
    *(("A-1", "A\u20111"), ("A-1", "A\u20131"), ("-1", "\u22121"), ("ﬁn", "fin")),
    *(("A's", "A\u2019s"), ("\u201ca", "\u201da"), ("\u30ed", "\u53e3"), ("\u30cb", "\u4e8c")),
    *(("\u30ab", "\u529b"), ("\u30bf", "\u5915"), ("\u30fc", "\u4e00"), ("\u3078", "\u30d8")),
    *(("A\u00d72", "Ax2"), ("1", "\u2460"), ("a\u00b7b", "a\u30fbb"), ("A/B", "A\u2215B")),
    *(("a~", "a\u223c"), ("a", "\u0251"), ("i", "\u0131"), ("1", "\u0661")),
]


@pytest.mark.parametrize(
    ("one", "other", "why"),
    [
        *((one, other, "are one number") for one, other in ONE_NUMBER),
        *((one, other, "look alike") for one, other in ALIKE),
    ],
)
def test_one_thing_written_in_two_ways_is_refused(tmp_path, one, other, why):
    """In files put together it would be two stimuli, or two people."""
    with pytest.raises(nc.InputError, match=f'".*" and ".*" {why}'):
        read(tmp_path, HEAD + f'p,"{one}",C,C\np,"{other}",C,C\n')
    with pytest.raises(nc.InputError, match=why):
        read(tmp_path, HEAD + f'"{one}",A,B,A\n"{other}",A,B,A\n')
    with pytest.raises(nc.InputError, match=why):
        Answers.of_pairs([(one, "C"), (other, "C")])


@pytest.mark.parametrize(
    "labels",
    [("1", "1,000"), ("1.25", "1,250"), ("a", "A"), ("1", "-1"), ("12" * 20, "12" * 20 + "1")],
)
def test_two_things_are_two_labels(tmp_path, labels):
    rows = "".join(f'p,"{label}",C,C\n' for label in labels)
    assert set(read(tmp_path, HEAD + rows).stimuli) == {"C", *labels}


def test_zeros_in_front_are_part_of_a_person(tmp_path):
    assert read(tmp_path, HEAD + "007,A,B,A\n7,A,B,A\n").people == ("007", "7")


# --- what is refused


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

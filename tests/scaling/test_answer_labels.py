"""Labels, people and names of columns, compared in one Unicode form."""

from __future__ import annotations

import pytest

import nacreous as nc
from nacreous.scaling import Answers, Comparisons
from nacreous.scaling.compare.attribute_table import AttributeTable
from tests.scaling.answer_texts import HEAD, read, said


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

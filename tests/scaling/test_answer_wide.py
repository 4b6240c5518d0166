"""Tables with a column a pair: each stimulus is one, or it is asked which is meant."""

from __future__ import annotations

from pathlib import Path

import pytest

import nacreous as nc
from nacreous.scaling import Answers

PAIRS = ("A vs B", "B vs C", "C vs A")


def outcomes(folder: Path, columns: list[str], *rows: str, **options) -> list[str]:
    path = folder / "a.csv"
    names = ",".join(f'"{name}"' for name in ["person", *columns])
    lines = [f"p{at},{row}\n" for at, row in enumerate(rows)]
    path.write_text(f"{names}\n{''.join(lines)}", "utf-8")
    return said(Answers.read(path, **options))


def said(answers: Answers) -> list[str]:
    names = answers.stimuli
    both = zip(answers.left, answers.right, answers.outcome, strict=True)
    return [f"{names[left]}{'<=>'[outcome + 1]}{names[right]}" for left, right, outcome in both]


def qualtrics(texts: list[str], *rows: str, more: str = "") -> str:
    ids = ",".join(f'"{{""ImportId"":""QID{at}""}}"' for at in range(len(texts) + 1 + bool(more)))
    names = ["ResponseId", *([more] if more else []), *(f"Q{at}" for at in range(len(texts)))]
    asked = ",".join(f'"{text}"' for text in ["Response ID", *([more] if more else []), *texts])
    return "\n".join([",".join(names), asked, ids, *rows, ""])


def refused(folder: Path, columns: list[str], *rows: str) -> str:
    with pytest.raises(nc.InputError) as told:
        outcomes(folder, columns, *rows)
    (line,) = str(told.value).splitlines()
    return line.removeprefix(f"{folder}/a.csv: ")


@pytest.mark.parametrize(
    "form",
    [
        "{pair}",
        "Which is better? {pair}",
        "Which is better? {pair}?",
        "Which is better: {pair}",
        "{pair}: which is better?",
        "どちらが良い？{pair}",
        "Which is better? - {pair}",
        "Which is better? ({pair})",
        "Which is better [{pair}]",
        "{n}. {pair}",
        "{n}) {pair}",
        "Q{n}: {pair}",
        "Q{n} {pair}",
        "Q{n}. Which is better? {pair}",
        "<p>Which is better</p> {pair}",
        "Which is <b>better</b>? <i>{pair}</i>",
    ],
)
@pytest.mark.parametrize("row", ["left,Right,RIGHT", "1,2,2", "A,C,A"])
def test_what_stands_beside_a_pair_is_no_part_of_a_label(tmp_path, form, row):
    columns = [form.format(pair=pair, n=at) for at, pair in enumerate(PAIRS, 1)]
    assert outcomes(tmp_path, columns, row) == ["A>B", "B<C", "C<A"]
    joined = [f"Q{at}_{pair.replace(' ', '_')}" for at, pair in enumerate(PAIRS, 1)]
    assert outcomes(tmp_path, joined, row) == ["A>B", "B<C", "C<A"]


def test_letters_set_by_tags_are_the_same_letters(tmp_path):
    columns = [f"<b>{a}</b> vs <span style='x'>{b}</span>" for a, b in ("AB", "BC", "CA")]
    assert outcomes(tmp_path, columns, "A,C,A") == ["A>B", "B<C", "C<A"]


@pytest.mark.parametrize(
    ("columns", "labels"),
    [
        ([f"Choose one. {pair}" for pair in PAIRS], ("A", "Choose one. A")),
        ([f"Which is better, {pair}" for pair in PAIRS], ("A", "Which is better, A")),
        ([f"Which is better - {pair}" for pair in PAIRS], ("A", "Which is better - A")),
        ([f"{pair} - which one?" for pair in PAIRS], ("B", "B - which one")),
        (["Better. A vs B", "Better. C vs D"], ("A", "Better. A")),
        (["A_vs_B_1", "C_vs_D_1"], ("B", "B_1")),
        (["A vs B", "B vs C", "A vs B.1"], ("B", "B.1")),
        (["A vs B", "A vs B (2)", "B vs C"], ("B", "B (2)")),
        (["A vs B", "B vs C (repeat)", "B vs C"], ("C", "C (repeat)")),
        (["A_vs_B_1", "B_vs_C_1", "C_vs_A_1"], ("B", "B_1")),
        (["A_vs_B", "A_vs_B_rt", "B_vs_C"], ("B", "B_rt")),
        (["1. A vs B", "B vs A", "C vs A"], ("A", "1. A")),
        (["1 vs 2", "1 vs 2.1"], ("2", "2.1")),
    ],
)
def test_a_label_that_may_be_another_one_is_asked_about(tmp_path, columns, labels):
    line = refused(tmp_path, columns, ",".join(["left", "right", "left"][: len(columns)]))
    assert f'may mean "{labels[0]}", or "{labels[1]}" as another stimulus; allowed: names' in line


@pytest.mark.parametrize(
    ("columns", "row"),
    [
        (["pearl vs pearl 2", "pearl 2 vs pearl 3", "pearl 3 vs pearl"], "left,left,right"),
        (["pearl vs pearl 2", "pearl vs shell"], "pearl 2,shell"),
        (["A vs A.1", "A.1 vs B", "B vs A"], "1,2,2"),
        (["0.5 vs 1", "1 vs 1.5", "0.5 vs 1.5"], "left,right,right"),
        (["real 1 vs fake 1", "real 2 vs fake 2"], "1,2"),
        (["ref vs A", "ref vs B", "ref vs C"], "1,2,2"),
        (["10:30 vs 11:00", "11:00 vs 12:15"], "1,2"),
    ],
)
def test_a_label_that_is_seen_to_be_one_is_kept(tmp_path, columns, row):
    sides = [name.split(" vs ") for name in columns]
    told = outcomes(tmp_path, columns, row)
    assert [line.replace("<", ">").split(">") for line in told] == sides


def test_a_table_asks_one_question(tmp_path):
    asked = ["deep: A vs B", "shiny: A vs B", "deep: B vs C"]
    line = refused(tmp_path, asked, "left,right,left")
    assert line.startswith('column "deep: A vs B" and column "shiny: A vs B" ask different quest')
    assert "allowed: one question a table (remove the other's columns)" in line
    for columns in (
        ["deep [A vs B]", "shiny [B vs C]"],
        ["deep: A vs B", "B vs C"],
        ["1: A vs B", "1: B vs C", "2: A vs B"],
    ):
        assert "ask different questions" in refused(tmp_path, columns, "1,2,1"[: len(columns) * 2])
    around = ["pearl: big vs shell: small", "pearl: big vs stone: old"]
    assert "has text before and behind" in refused(tmp_path, around, "1,2")


def test_a_name_with_several_pairs_is_not_skipped(tmp_path):
    for name in ("Pearl vs shell: which? A vs B", "A vs B vs C"):
        line = refused(tmp_path, [name, "B vs C"], "A,B")
        assert line.startswith(f'column "{name}" names more than one pair; allowed: one')


def test_a_pair_asked_twice_is_numbered_and_said(tmp_path):
    columns = ["Q1: A vs B", "Q2: B vs C", "Q3: A vs B"]
    assert "repeats row" in refused(tmp_path, columns, "1,2,2")
    assert outcomes(tmp_path, columns, "1,2,2", repeats=True) == ["A>B", "B<C", "A<B"]


@pytest.mark.parametrize("texts", ["Which? {}", "Which? - {}", "Which?\n{}", "Which? ({})"])
@pytest.mark.parametrize(
    "rows", [("left,Right,RIGHT",), ("A,C,A", "left,Right,right"), ("L,R,R",), ("A,C,A",)]
)
def test_qualtrics_may_say_sides_whichever_answers_come_first(tmp_path, texts, rows):
    """Left and right in the first answers are no names of columns."""
    path = tmp_path / "a.csv"
    lines = [f"R_{at},{row}" for at, row in enumerate(rows)]
    path.write_text(qualtrics([texts.format(pair) for pair in PAIRS], *lines))
    assert said(Answers.read(path)) == ["A>B", "B<C", "C<A"] * len(rows)


@pytest.mark.parametrize(
    ("column", "words"),
    [
        ("Status", ("IP Address", "Survey Preview")),
        ("Status", ("0", "1")),
        ("Status", ("IP Address", "Survey Test")),
        *(("Status", ("IP Address", word)) for word in ("Survey Preview Spam", "Imported Spam")),
        *(("Status", ("Offline", word)) for word in ("Offline Survey Preview", "Spam", "EX Spam")),
        *(("Status", (person, "8")) for person in ("4", "16", "32", "48", "132")),
        *(("Status", ("0", number)) for number in ("2", "9", "12", "17", "40", "256")),
        ("DistributionChannel", ("anonymous", "preview")),
    ],
)
def test_a_preview_is_nobodys_answer(tmp_path, column, words):
    path = tmp_path / "a.csv"
    rows = [f"R_1,{words[0]},A,B", f"R_2,{words[1]},B,C"]
    path.write_text(qualtrics(["Which? A vs B", "Which? B vs C"], *rows, more=column))
    with pytest.raises(nc.InputError, match=f'row 5: {column} is "{words[1]}", which is no per'):
        Answers.read(path)
    answers = Answers.read(path, skip_unanswered=True)
    assert (said(answers), answers.people) == (["A>B", "B>C"], ("R_1",))
    assert (answers.left_out, answers.unanswered) == (1, 1)


def test_what_either_column_says_of_previews_counts(tmp_path):
    path = tmp_path / "a.csv"
    rows = ["person,Status,DistributionChannel,left,right,chosen", "p,Spam,anonymous,A,B,A"]
    rows += ["q,IP Address,preview,A,B,A", "r,IP Address,anonymous,A,B,B", ""]
    path.write_text("\n".join(rows))
    assert Answers.read(path, skip_unanswered=True).people == ("r",)

"""Labels are compared in one Unicode form wherever a caller names them."""

from dataclasses import replace

import pytest

from nacreous.problem import InputError
from nacreous.scaling import (
    Answers,
    Plan,
    analyse,
    cluster_ratio,
    compare_groups,
    compare_ratios,
    fit_attributes,
    simulate,
    thurstone,
)

COMPOSED, APART = "caf\u00e9", "cafe\u0301"


def test_plans_take_either_form():
    plan = Plan({APART: 0.5, "b": 0.0}, people=8, pairs=[(COMPOSED, "b")])
    one, other = (plan.power(label, "b", studies=20) for label in (APART, COMPOSED))
    assert one == other


def test_bootstraps_take_either_form():
    samples = thurstone([(COMPOSED, "b")] * 6 + [("b", COMPOSED)] * 3).bootstrap(50)
    assert samples.difference(APART, "b") == samples.difference(COMPOSED, "b")


def test_two_forms_of_one_label_are_no_two_stimuli():
    with pytest.raises(InputError, match="again; allowed: each label once"):
        simulate({APART: 0.5, COMPOSED: 0.0}, people=3)


def test_clusters_take_either_form():
    answers = simulate({COMPOSED: 1.0, "b": 0.9, "c": -0.9, "d": -1.0}, people=20)
    one, other = (cluster_ratio(answers, [label, "b"], ["c", "d"]) for label in (APART, COMPOSED))
    assert one.first == other.first == (COMPOSED, "b")
    assert one.ratio == other.ratio
    both = {"x": answers, "y": answers}
    found = compare_ratios(both, [APART, "b"], ["c", "d"], same_people=False)
    assert found.first.first == (COMPOSED, "b")


def test_attributes_take_either_form():
    answers = simulate({"a": 1.0, COMPOSED: 0.3, "c": -0.4, "d": -1.0}, people=30)
    values = {"a": 1.0, APART: 0.2, "c": -0.3, "d": -1.0}
    rows = {label: {APART: value} for label, value in values.items()}
    fit = fit_attributes(answers, rows, [COMPOSED])
    assert fit.predict({COMPOSED: 0.5}).value == fit.predict({APART: 0.5}).value
    table = {APART: list(values), "lustre": list(values.values())}
    column = fit_attributes(answers, table, stimulus=COMPOSED)
    assert column.weights[0].value == fit.weights[0].value


def test_columns_and_words_take_either_form(tmp_path):
    path = tmp_path / "answers.csv"
    rows = f"{APART},right,chosen,eye\na,b,{APART},l\nb,a,right,{COMPOSED}\n"
    path.write_text(rows, encoding="utf-8")
    answers = Answers.read(path, left=COMPOSED, tie=COMPOSED)
    assert answers.outcome.tolist() == [0, -1]
    assert set(answers.split("eye")) == {"l", COMPOSED}


# --- characters that a terminal obeys

RED = "A\x1b[31m"
REFUSED = r"allowed: no \\u001b in it"


def test_control_characters_never_become_labels_however_they_enter():
    plain = simulate({"A": 0.5, "B": -0.5, "C": 0.0}, 20, seed=1)
    counts = plain.comparisons()
    people = tuple(f"\x1b[2J{one}" for one in plain.people)
    for enter in (
        lambda: simulate({RED: 0.5, "B": -0.5}, 3),
        lambda: Plan({RED: 1.0, "B": 0.0}).power(RED, "B", studies=20),
        lambda: replace(plain, stimuli=(RED, "B", "C")),
        lambda: replace(counts, stimuli=(RED, "B", "C")),
        lambda: replace(plain, people=people),
        lambda: compare_groups({RED: plain, "x": plain}, same_people=False),
        lambda: compare_ratios({RED: plain, "x": plain}, ["A"], ["B", "C"], same_people=False),
        lambda: fit_attributes(plain, {label: {RED: k} for k, label in enumerate("ABC")}),
        lambda: fit_attributes(plain, {"stimulus": list("ABC"), RED: [1.0, 2.0, 4.0]}),
    ):
        with pytest.raises(InputError, match=REFUSED) as problem:
            enter()
        assert "\x1b" not in str(problem.value)


def test_marks_that_would_turn_a_line_are_refused_too():
    with pytest.raises(InputError, match=r"allowed: no \\u202e in it"):
        simulate({"A\u202e": 0.5, "B": -0.5}, 3)


def test_emoji_and_joined_letters_stay_labels():
    labels = ("👩\u200d🔬", "می\u200cخواهم", "真珠")
    answers = simulate(dict(zip(labels, (0.5, 0.0, -0.5), strict=True)), 5)
    assert set(replace(answers, left_out=1).stimuli) == set(labels)


def test_two_forms_of_one_name_are_no_two_groups():
    answers = simulate({"a": 0.5, "b": 0.0, "c": -0.5}, people=10)
    groups = {COMPOSED: answers, APART: answers}
    with pytest.raises(InputError, match=r"groups has .* again; allowed: each name once"):
        compare_groups(groups, same_people=False)
    with pytest.raises(InputError, match=r"groups has .* again; allowed: each name once"):
        compare_ratios(groups, ["a"], ["b", "c"], same_people=False)


# --- glyphs


@pytest.mark.parametrize(
    ("question", "labels", "guessed", "japanese"),
    [
        ("どちらが真珠らしいですか", ["真珠", "直光", "骨核"], None, True),
        (None, ["真珠", "直光", "骨核"], "Shift-JIS", True),
        (None, ["真珠", "直光", "あこや"], None, True),
        (None, ["真珠", "直光", "骨核"], None, False),
        ("どちらが真珠らしいですか", ["真珠", "直光", "骨头"], None, False),
    ],
)
def test_kanji_beside_japanese_have_japanese_glyphs_on_an_english_page(
    question, labels, guessed, japanese
):
    answers = simulate(dict(zip(labels, (0.5, 0.0, -0.5), strict=True)), 20)
    answers = replace(answers, encoding_guessed=guessed)
    page = analyse(answers, bootstrap=0, question=question).text("report.html")
    assert ('<b class="name" lang="ja">真珠</b>' in page) == japanese


@pytest.mark.parametrize(
    ("label", "shown"),
    [
        ("A  B", r"A\u0020\u0020B"),
        ("A\u00a0B", r"A\u00a0B"),
        ("A\u3000B", r"A\u3000B"),
    ],
)
def test_labels_that_differ_in_their_blanks_are_shown_so(tmp_path, label, shown):
    place = tmp_path / "a.csv"
    place.write_text(f'left,right,chosen\n"{label}",C,C\nA B,C,C\n')
    with pytest.raises(InputError) as refusal:
        Answers.read(place)
    line = str(refusal.value)
    assert shown in line

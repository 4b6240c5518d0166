"""What a cell means: numbers are compared as numbers, ties are ties, times have their unit."""

from __future__ import annotations

from datetime import time, timedelta
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous import cli
from nacreous.scaling import Answers

BARE: dict[str, Any] = {"left": ["a", "b", "c"], "right": ["b", "c", "a"], "chosen": ["a"] * 3}
BARE["chosen"] = ["a", "c", "a"]
MS = np.array([812, 700, 900], "timedelta64[ms]")


def outcomes(left, right, chosen, **options) -> list[str]:
    table = {"left": left, "right": right, "chosen": chosen}
    answers = Answers.of_table(table, **options)
    names = answers.stimuli
    both = zip(answers.left, answers.right, answers.outcome, strict=True)
    return [f"{names[one]}{'<=>'[outcome + 1]}{names[other]}" for one, other, outcome in both]


@pytest.mark.parametrize(
    ("labels", "cells"), [(("1", "2"), ("1.0", "2.0")), (("1.0", "2.0"), ("1", "2"))]
)
def test_a_chosen_number_is_a_label_before_it_is_a_side(labels, cells):
    one, two = labels
    told = outcomes([two, one, two], [one, two, one], [cells[0], cells[0], cells[1]])
    assert told == [f"{two}<{one}", f"{one}>{two}", f"{two}>{one}"]


@pytest.mark.parametrize("labels", [("01", "02"), ("1.png", "2.png"), ("pearl 1", "pearl 2")])
def test_a_number_that_may_be_a_side_or_a_stimulus_is_asked_about(labels):
    one, two = labels
    rows = ([two, one], [one, two], ["1", "2"])
    with pytest.raises(nc.InputError, match=f'1 and 2, which may be sides or .* "{one}"'):
        outcomes(*rows)
    sided = outcomes(*rows, left_word="1", right_word="2")
    assert sided == [f"{two}>{one}", f"{one}<{two}"]
    assert len(outcomes([two, two], [one, "pearl 7"], ["2", "1"])) == 2  # 1 is no such stimulus


@pytest.mark.parametrize(
    ("cells", "said"),
    [
        (["-1", "1", "0"], "-1, 0 and 1, .* left_word='-1', right_word='1', tie='0'$"),
        (["-1.0", "1.0", "1.0"], "-1 and 1, .* left_word='-1', right_word='1'$"),
        (["1", "0", "0"], "0 and 1, .* left_word='1', right_word='0'$"),
        (["1", "2", "0"], "0, 1 and 2, .* left_word='1', right_word='2', tie='0'$"),
    ],
)
def test_codes_are_asked_about_by_the_values_that_are_there(cells, said):
    with pytest.raises(nc.InputError, match=f"chosen holds {said}"):
        outcomes(["A", "B", "C"], ["B", "C", "A"], cells)
    words = {"left_word": "-1", "right_word": "1", "tie": "0"}
    if "-1" in cells[0]:
        told = outcomes(["A", "B", "C"], ["B", "C", "A"], cells, **words)
        assert told == ["A>B", "B<C", "C=A" if cells[2] == "0" else "C<A"]


# --- ties in a column of their own


@pytest.mark.parametrize(
    ("name", "cells"),
    [("draw", ["0", "1"]), ("tie", [False, True]), ("Is tie", ["no", "yes"]), ("Draw", [None, 1])],
)
def test_a_draw_is_no_win(name, cells):
    table = {"winner": ["A", "B"], "loser": ["B", "C"], name: cells}
    answers = Answers.of_table(table)
    assert answers.outcome.tolist() == [1, 0]
    assert not answers.groups


def test_a_tie_that_chosen_does_not_know_is_refused():
    table = {"left": ["A", "B"], "right": ["B", "C"], "chosen": ["A", "tie"], "tie": [1, 1]}
    with pytest.raises(nc.InputError, match=r'row 0: tie says .*, and chosen is "A"; allowed'):
        Answers.of_table(table)
    assert Answers.of_table(table | {"tie": [0, 1]}).outcome.tolist() == [1, 0]
    with pytest.raises(nc.InputError, match=r'row 1: tie says that this is no tie, .* is "tie"'):
        Answers.of_table(table | {"tie": [0, 0]})


@pytest.mark.parametrize(
    ("yes", "no"),
    [
        *[("WAHR", "FALSCH"), ("VRAI", "FAUX"), ("VERDADERO", "FALSO"), ("Ja", "Nein")],
        *[
            ("oui", "non"),
            ("はい", "いいえ"),
            ("真", "偽"),
            ("ИСТИНА", "ЛОЖЬ"),
            ("DOĞRU", "YANLIŞ"),
        ],
        *[("T", "F"), ("on", "off"), ("x", ""), ("tie", ""), ("draw", "win"), ("1", "NA")],
        *[("1.0", "0.0"), ("ＴＲＵＥ", "ＦＡＬＳＥ"), ("Unentschieden", ""), ("-", "1")[::-1]],
    ],
)
def test_a_tie_is_none_in_the_words_of_any_spreadsheet(yes, no):
    cells = [yes, no, no, yes]
    won = {"winner": ["A", "A", "B", "B"], "loser": ["B", "B", "A", "A"], "tie": cells}
    answers = Answers.of_table(won)
    assert answers.outcome.tolist() == [0, 1, 1, 0]
    assert not answers.groups
    table = {"left": ["A", "B"], "right": ["B", "A"], "chosen": ["A", "A"], "tie": [yes, no]}
    with pytest.raises(nc.InputError, match=r'row 0: tie says that this is a tie, .* is "A"'):
        Answers.of_table(table)


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        ({"tie": ["2", "0"]}, 'column tie holds "2"; allowed: 1 and 0, yes and no or TRUE and'),
        ({"Draw": ["-1", "0"]}, 'column Draw holds "-1"; allowed'),
        ({"引き分け": ["?", ""]}, 'column 引き分け holds "\\?"; allowed'),
        ({"tie": ["1", "0"], "draw": ["3", "4"]}, "columns tie and draw may say which"),
        ({"result": ["win", "draw"]}, 'column result holds "draw", and may say which'),
        ({"tie": ["1", "0", ""]}, 'row 2: tie is empty, beside "1", "0"; allowed: one of them'),
    ],
)
def test_a_column_that_may_be_about_ties_is_no_group(columns, said):
    rows = len(next(iter(columns.values())))
    table = {"winner": ["A", "B", "C"][:rows], "loser": ["B", "C", "A"][:rows], **columns}
    with pytest.raises(nc.InputError, match=said):
        Answers.of_table(table)


def test_words_for_a_tie_are_words_in_any_letters_unless_a_stimulus_is_called_so():
    cells = ["Tie", "TIE", "Draw", "drawn", "引き分け"]
    told = outcomes(["A"] * 5, ["B"] * 5, cells, repeats=True)
    assert told == ["A=B"] * 5
    assert outcomes(["Draw"], ["B"], ["Draw"]) == ["Draw>B"]
    with pytest.raises(nc.InputError, match='chosen is "draw"; allowed'):
        outcomes(["Draw"], ["B"], ["draw"])


# --- times


@pytest.mark.parametrize("role", ["response_s", "response_ms"])
@pytest.mark.parametrize("unit", ["ms", "us", "ns"])
def test_a_duration_is_converted_by_its_own_unit(tmp_path, role, unit):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(BARE | {role: MS.astype(f"timedelta64[{unit}]")})
    frame.to_parquet(tmp_path / "a.parquet")
    frame.to_csv(tmp_path / "a.csv", index=False)
    for answers in (
        Answers.of_table(frame),
        Answers.of_table(BARE | {role: MS.astype(f"timedelta64[{unit}]")}),
        Answers.read(tmp_path / "a.parquet"),
        Answers.read(tmp_path / "a.csv"),
    ):
        assert answers.response_s == pytest.approx([0.812, 0.7, 0.9], rel=1e-12)


@pytest.mark.parametrize(
    "cells",
    [
        ["0 days 00:00:00.812", "NaT", "0 days 00:01:00"],
        ["00:00:00.812", "", "00:01:00"],
        ["PT0.812S", None, "PT1M"],
        [timedelta(milliseconds=812), None, timedelta(minutes=1)],
        [time(0, 0, 0, 812_000), None, time(0, 1)],
        ["0.812", ".", "60"],
    ],
)
def test_a_length_of_time_is_read_in_seconds(cells):
    found = Answers.of_table(BARE | {"response_s": cells}).response_s
    assert np.array_equal(found, [0.812, np.nan, 60], equal_nan=True)


def test_a_length_of_time_says_when_but_a_time_of_day_does_not():
    for cells in (MS, ["0 days 00:00:00.812", "0 days 00:00:00.700", "0 days 00:00:00.900"]):
        time_s = Answers.of_table(BARE | {"time": cells}).time
        assert time_s == pytest.approx([0.812, 0.7, 0.9], rel=1e-12)
    for role, cell in (("time", "00:00:01"), ("response_s", "00:30"), ("response_s", "-1 days")):
        with pytest.raises(nc.InputError, match=f'{role} is "{cell}"; allowed: a number'):
            Answers.of_table(BARE | {role: [cell] * 3})


@pytest.mark.parametrize("name", ["rt", "RT", "Response Time", "duration"])
def test_a_column_that_may_be_response_times_is_not_passed_over_in_silence(tmp_path, capsys, name):
    path = tmp_path / "a.csv"
    rows = ["a,b,a", "b,a,a", "a,b,b", "b,a,b"]
    path.write_text(f"left,right,chosen,{name}\n" + "".join(f"{row},812\n" for row in rows))
    assert cli.main(["scale", str(path), "-o", str(tmp_path / "a.csv.json")]) == 0
    told = "".join(capsys.readouterr())
    assert f"column {name} is not used as response times; allowed: --column " in told


# --- jsPsych's numbers


def jspsych(kinds, responses, labels=("a", "b", "c"), **options) -> list[str]:
    count = len(responses)
    table = {
        "trial_type": [f"{kind}-response" if kind else "survey-likert" for kind in kinds],
        "trial_index": list(range(count)),
        "time_elapsed": [1000 * at for at in range(count)],
        "response": responses,
        "left": [labels[0], labels[1]][:count],
        "right": [labels[1], labels[2]][:count],
    }
    answers = Answers.of_table(table, **options)
    names = answers.stimuli
    both = zip(answers.left, answers.right, answers.outcome, strict=True)
    return [f"{names[one]}{'<=>'[outcome + 1]}{names[other]}" for one, other, outcome in both]


@pytest.mark.parametrize(
    "kinds",
    [
        ["html-keyboard"] * 2,
        ["html-slider"] * 2,
        ["", ""],
        ["html-button", "html-keyboard"],
    ],
)
def test_only_buttons_of_jspsych_count_from_the_left(kinds):
    with pytest.raises(nc.InputError, match="response holds 0 and 1, and either side may be meant"):
        jspsych(kinds, ["0", "1"])
    assert jspsych(kinds, ["0", "1"], left_word="1", right_word="0") == ["a<b", "b>c"]
    assert jspsych(["html-button", "image-button"], ["0", "1"]) == ["a>b", "b<c"]


def test_a_third_button_of_jspsych_and_a_button_called_as_a_stimulus_are_asked_about():
    for responses in (["0", "2"], ["1", "2"]):
        with pytest.raises(nc.InputError, match=r"left_word='0', right_word='1', tie='2'$"):
            jspsych(["html-button"] * 2, responses)
    assert jspsych(["html-button"], ["0"], labels=("0", "3", "4")) == ["0>3"]
    with pytest.raises(nc.InputError, match=r"response is 1, which may be a button or the stim"):
        jspsych(["html-button"] * 2, ["0", "1"], labels=("0", "1", "2"))


def test_jspsych_6_has_buttons_and_keys_in_columns_of_their_own():
    table = {
        "trial_type": ["html-button-response"] * 2,
        "trial_index": [1, 2],
        "time_elapsed": [1, 2],
        **{"left": ["a", "b"], "right": ["b", "c"], "button_pressed": [0, 1]},
    }
    assert Answers.of_table(table).outcome.tolist() == [1, -1]
    keys = {"key_press": [37, 39], "trial_type": ["html-keyboard-response"] * 2}
    table = {name: cells for name, cells in (table | keys).items() if name != "button_pressed"}
    with pytest.raises(nc.InputError, match=r"key_press holds .* left_word='37', right_word='39'"):
        Answers.of_table(table)


# --- columns that may mean two things


@pytest.mark.parametrize("role", ["left", "chosen", "person", "time"])
def test_two_columns_for_one_role_are_asked_about(role):
    table = BARE | {"person": ["p", "q", "r"], "time": [1, 2, 3]}
    twin = table | {role.title(): table[role]}
    with pytest.raises(nc.InputError, match=f"has the columns {role} and {role.title()}; allowed"):
        Answers.of_table(twin)
    assert len(Answers.of_table(twin, **{role: role})) == 3

"""What answers cannot tell is said not to be told: ties alone, circles of coins, large spreads."""

from __future__ import annotations

import json

import numpy as np
import pytest

from nacreous.commands.scale_lines import told
from nacreous.problem import InputError
from nacreous.scaling import Answers, analyse, circular_triads, population, simulate, thurstone
from nacreous.scaling.figure import interval_plot, matrix_plot
from tests.scaling.test_shared import together

PAIRS = [("a", "b"), ("a", "c"), ("b", "c")]


def answered(*chosen: list[str]) -> Answers:
    """A person for each list of choices, of the pairs a-b, a-c and b-c."""
    rows = [
        (f"p{k}", *pair, one)
        for k, own in enumerate(chosen)
        for pair, one in zip(PAIRS, own, strict=True)
    ]
    person, left, right, choice = zip(*rows, strict=True)
    return Answers.of_table({"person": person, "left": left, "right": right, "chosen": choice})


def halves() -> Answers:
    """Six people hold a over b over c, six the reverse: every pair is even."""
    return answered(*[["a", "a", "b"]] * 6, *[["b", "c", "c"]] * 6)


def test_ties_alone_make_no_report_and_print_says_that_nobody_chose():
    ties = answered(*[["tie"] * 3] * 5)
    with pytest.raises(InputError, match=r"nobody chose anything: all answers are ties \(15 of 15"):
        analyse(ties, bootstrap=0)
    assert str(thurstone(ties)).startswith("nobody chose anything")


def test_ties_whose_width_is_not_told_are_said_to_count_half_and_no_fit_is_praised():
    analysis = analyse(answered(*[["tie"] * 3] * 9, ["a", "tie", "tie"]), bootstrap=0)
    page = analysis.text("report.html")
    assert analysis.ties_unfitted
    assert "In 97 of 100 answers two items were called equal" in page
    assert "One scale describes" not in page
    assert "Yes, as far as these answers" not in page
    assert "how wide they are cannot be told" in told(analysis, 0)
    assert "100件中97件の回答は「同じ」でした" in analysis.text("report.html", "ja")


def test_where_no_pair_has_a_majority_there_are_no_circles_to_count():
    triads = circular_triads(halves())
    assert (triads.tied, triads.zeta, triads.p_value) == (3, None, None)
    analysis = analyse(halves(), bootstrap=0)
    page = analysis.text("report.html")
    assert "No pair has a majority" in page
    assert "0.25" not in page.split("Consistency</h2>")[1].split("How it was done")[0]
    assert "多数がありません" in analysis.text("report.html", "ja")
    # Nor is "chosen equally often" taken for "equal".
    assert "Whether they differ all the same cannot be told" in page
    assert "1 degree of freedom" in page


def test_circles_of_tied_pairs_are_said_to_be_a_mean_over_coins():
    page = analyse(answered(*[["a", "a", "tie"]] * 4, ["b", "c", "tie"]), bootstrap=0).text(
        "x.html"
    )
    assert "1 pair had no majority" in page
    assert "of 1 set of three would be circles on average" in page
    assert "Of 1 sets" not in page


def test_chance_stays_pale_in_the_picture_of_misfits(tmp_path):
    noise = np.array([[np.nan, 1e-16], [-1e-16, np.nan]])
    path = tmp_path / "misfit.svg"
    matrix_plot(noise, ["a", "b"], path, kind="residuals")
    drawn = path.read_text()
    assert ">0.0<" in drawn
    assert "+0.0" not in drawn
    assert "+2.0" in drawn


def test_a_spread_beyond_what_answers_tell_is_given_as_a_lower_end():
    """Simulated with a standard deviation of 3 z: the most likely one is 8."""
    found = population(
        simulate([0.6, 0.2, 0.0, -0.3], 20, person_spread=3.0, seed=1), most=2, starts=4
    )
    assert found.kind == "spread"
    assert (found.spread, found.spread_high) == (None, None)
    assert 0.5 < found.spread_low <= 1.5


def test_a_spread_that_is_told_has_an_interval_around_it():
    found = population(
        simulate(np.linspace(0.8, -0.8, 7), 30, person_spread=0.6, seed=1), most=2, starts=4
    )
    assert found.spread_low < found.spread < found.spread_high
    assert found.spread_low < 0.6 < found.spread_high


def test_one_person_is_no_class():
    """Simulated: one of 20 people holds the exact reverse, a class to BIC alone."""
    values = np.array([1.0, 0.6, 0.2, 0.0, -0.3, -1.0])
    one_against_all = together(simulate(values, 19, seed=2), simulate(-values, 1, seed=3))
    found = population(one_against_all, most=3, starts=6)
    assert any(one.lone for one in found.candidates)
    assert all(len(one.people) > 1 for one in found.classes)


def test_distances_without_end_have_none_in_record_table_and_picture(tmp_path):
    answers = simulate([5.0, 0.5, 0.0, -5.0], people=30, seed=2)
    analysis = analyse(answers, bootstrap=0, prior=1.0)
    record = json.loads(analysis.text("x.json"))
    first, *_, last = record["stimuli"]
    assert record["endless"][0] == [first["stimulus"]]
    assert (first["high"], last["low"]) == (None, None)
    assert record["neighbours"][0]["high"] is None
    assert "inf" in analysis.text("x.csv").splitlines()[1]
    assert " or more" in analysis.text("x.html")
    fit, ends = analysis.fit, analysis.doubt.open_ends(analysis.fit.stimuli)
    plain, opened = tmp_path / "plain.svg", tmp_path / "open.svg"
    interval_plot(fit, plain, intervals=analysis.doubt.intervals)
    interval_plot(fit, opened, intervals=analysis.doubt.intervals, open_ends=ends)
    assert opened.read_text().count("stroke-dasharray") > plain.read_text().count("dasharray")

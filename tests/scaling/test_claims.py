"""A report claims no more than its answers tell: of people, of ties, of margins."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

import nacreous as nc
from nacreous.commands.scale_lines import told
from nacreous.problem import InputError
from nacreous.scaling import Answers, agreement, analyse, shared_scale, simulate, thurstone

LABELS = tuple("abcdef")
PAIRS = list(combinations(range(6), 2))
NONE_TOLD = "Whether each person judges by it, they cannot tell"


def rows(answers: list[tuple[int, int, int, int]]) -> Answers:
    """(person, first, second, outcome), outcome 1 for the first, -1 for the second, 0 for a tie."""
    person, left, right, outcome = np.array(answers).T
    people = tuple(f"p{number}" for number in range(int(person.max()) + 1))
    return Answers(LABELS, left, right, outcome.astype(np.int8), people, person)


def camps(people: int, each: int) -> Answers:
    """Every second person holds exactly the reverse; so many answers each."""
    random = np.random.default_rng(1)
    truth = np.linspace(1.6, -1.6, 6)
    found = []
    for person in range(people):
        for at in random.choice(len(PAIRS), each, replace=False):
            i, j = PAIRS[at]
            lead = (truth[i] - truth[j]) * (-1) ** person
            found.append((person, i, j, 1 if lead > random.normal() else -1))
    return rows(found)


# --- people


def test_one_answer_a_person_tells_nothing_of_people():
    answers = camps(200, 1)
    with pytest.raises(InputError, match="nobody answered two pairs"):
        shared_scale(answers)
    page = analyse(answers, bootstrap=0).text("report.html")
    assert NONE_TOLD in page
    assert "As far as these answers can tell, yes: people differ" not in page
    assert "One scale describes the answers" not in page


def test_two_answers_a_person_tell_hardly_anything_and_that_is_said():
    found = shared_scale(camps(60, 2))
    assert not found.tells
    assert "cannot tell" in found.verdict()
    analysis = analyse(camps(60, 2), bootstrap=0)
    page, japanese = analysis.text("report.html"), analysis.text("report.html", "ja")
    assert NONE_TOLD in page
    assert "each person gave too few" in page
    assert "一人あたりの回答が少なすぎます" in japanese
    assert "回答は一つの尺度でよく表せます" not in japanese


def test_what_is_called_detectable_is_found_in_most_studies():
    truth = np.linspace(0.8, -0.8, 7)
    spread = float(
        np.median([shared_scale(simulate(truth, 20, seed=k)).detectable for k in (1, 2, 3)])
    )
    assert 0.25 < spread < 0.5
    found = [
        shared_scale(simulate(truth, 20, person_spread=spread, seed=seed), 99).differ()
        for seed in range(60)
    ]
    assert 0.65 <= np.mean(found) <= 0.95


def test_people_who_could_differ_are_still_said_to_share_a_scale():
    analysis = analyse(simulate(np.linspace(0.8, -0.8, 6), 40, seed=1), bootstrap=0)
    page = analysis.text("report.html")
    assert "One scale describes the answers" in page
    assert "that would mostly have been found" in page


# --- agreement


def repeated(people: int, seed: int) -> Answers:
    """Strangers: each has a scale of their own, and keeps to it ten times."""
    random = np.random.default_rng(seed)
    own = random.normal(size=(people, 6)) * 3
    return rows(
        [
            (person, i, j, 1 if own[person, i] - own[person, j] > random.normal() else -1)
            for person in range(people)
            for i, j in PAIRS
            for _ in range(10)
        ]
    )


def test_nobody_agrees_with_themselves():
    with pytest.raises(InputError, match="two people"):
        agreement(repeated(1, 1))
    page = analyse(repeated(1, 1), bootstrap=0, prior=1.0).text("report.html")
    assert "agree more than by chance" not in page


def test_u_is_the_mean_product_of_answers_of_different_people():
    answers = repeated(3, 2)
    net = np.zeros((3, 15))
    for at, pair in enumerate(PAIRS):
        mine = (answers.left == pair[0]) & (answers.right == pair[1])
        net[:, at] = np.bincount(answers.person[mine], answers.outcome[mine], 3)
    between = sum(net[p] @ net[q] for p, q in combinations(range(3), 2))
    assert agreement(answers).u == pytest.approx(between / (3 * 15 * 100))


@pytest.mark.parametrize("people", [3, 8, 14])
def test_strangers_who_repeat_themselves_are_no_agreement(people):
    p_values = [agreement(repeated(people, seed)).p_value for seed in range(60)]
    assert np.mean(np.array(p_values) < 0.05) <= 0.13


def test_too_few_people_agree_by_chance_or_not_nobody_can_tell():
    answers = simulate([3.0, 1.0, -1.0, -3.0], 4, seed=1)
    found = agreement(answers)
    assert found.p_value == found.least_p_value == 1 / 8
    page = analyse(answers, bootstrap=0, prior=1.0).text("report.html")
    assert "too few people to tell" in page


def test_many_people_who_hardly_chose_are_not_called_too_few():
    """Of 20 people all but two answered with ties alone."""
    chosen = {(0, 0): 1, (0, 1): 1, (0, 5): -1, (1, 0): 1, (1, 1): -1, (1, 5): 1, (1, 6): -1}
    answers = rows(
        [(p, i, j, chosen.get((p, at), 0)) for p in range(20) for at, (i, j) in enumerate(PAIRS)]
    )
    analysis = analyse(answers, bootstrap=0, prior=1.0, ties=False)
    page = analysis.text("report.html")
    assert "too few people to tell" not in page
    assert "Their choices without ties, 6 in all, are too few to tell" in page
    assert "「同じ」以外の回答が6件しかないため" in analysis.text("report.html", "ja")


def test_people_of_one_scale_agree_and_are_found():
    assert agreement(simulate([1.0, 0.0, -1.0], 20, seed=1)).p_value < 0.01


# --- ties


def test_ties_are_named_and_not_called_choices():
    random = np.random.default_rng(1)
    answers = rows(
        [
            (person, i, j, random.choice([0, 0, 0, 1 if (i + person) % 3 else -1]))
            for person in range(12)
            for i, j in PAIRS
        ]
    )
    analysis = analyse(answers, bootstrap=0, ties=False)
    share = f"{100 * (answers.outcome == 0).mean():.0f}"
    page = analysis.text("report.html")
    assert f"Ties, {share} of 100 answers, are left out of this." in page
    assert " ties</td>" in page
    assert "Ties count as half a choice for each." in page
    assert f"「同じ」という回答（100件中{share}件）" in analysis.text("report.html", "ja")
    assert 0 < analysis.goodness.largest.ties < 1


@pytest.mark.parametrize("ties", [None, True, False])
def test_where_every_answer_is_a_tie_there_is_no_report(ties):
    answers = rows([(person, i, j, 0) for person in range(12) for i, j in PAIRS])
    with pytest.raises(InputError, match="nobody chose anything: all answers are ties"):
        analyse(answers, bootstrap=0, ties=ties)


# --- margins


def one_pair(first: int, second: int, ties: int) -> Answers:
    outcomes = [1] * first + [-1] * second + [0] * ties
    people = tuple(f"p{number}" for number in range(len(outcomes)))
    count = len(outcomes)
    zero = np.zeros(count, np.int64)
    return Answers(
        ("a", "b"), zero, zero + 1, np.array(outcomes, np.int8), people, np.arange(count)
    )


def test_samples_without_a_scale_of_their_own_make_no_margins():
    """11 of 20 chose a, 1 chose b: over a third of samples have nobody who chose b."""
    analysis = analyse(one_pair(11, 1, 8), bootstrap=100)
    doubt, (pair,) = analysis.doubt, analysis.neighbours
    assert doubt.without_maximum > 20
    assert doubt.by == "clusters"
    # Mean 0, so that each of two places has half of their difference: one source, one verdict.
    low, high = doubt.intervals[0]
    assert 2 * low == pytest.approx(pair.low)
    assert 2 * high == pytest.approx(pair.high)
    assert pair.apart == (pair.low > 0)
    assert "too many to draw intervals from" in told(analysis, 0.0)
    assert "stand in their place" in analysis.text("report.html")
    assert "モデルから求めた幅を示します" in analysis.text("report.html", "ja")


def test_answers_of_unknown_people_fall_back_to_the_model():
    counts = nc.scaling.Comparisons.of_counts([[0, 5], [1, 0]])
    doubt = analyse(counts, bootstrap=200).doubt
    assert doubt.without_maximum > 20
    assert doubt.by == "information"
    assert doubt.intervals == pytest.approx(thurstone(counts).intervals())


def test_people_who_all_answered_alike_tell_nothing_of_others_under_any_prior():
    truth = np.array([10.0, 6.0, 2.0, -2.0, -6.0, -10.0])
    answers = rows([(person, i, j, 1) for person in range(12) for i, j in PAIRS])
    assert (truth[answers.left] > truth[answers.right]).all()
    for prior in (1.0, "hierarchical"):
        with pytest.raises(InputError, match="all people answered alike"):
            thurstone(answers, prior=prior).covariance()
        analysis = analyse(answers, prior=prior, bootstrap=0)
        assert analysis.doubt.too_few
        assert analysis.doubt.by == "information"
        assert "these answers cannot tell how people differ" in analysis.text("report.html")


# --- sides


def sided(pull: float, exchanged: bool) -> Answers:
    """Simulated: 15 people, all pairs; the better one always left, or sides by coin."""
    random = np.random.default_rng(5)
    found = []
    for person in range(15):
        for i, j in PAIRS:
            left, right = (j, i) if exchanged and random.random() < 0.5 else (i, j)
            lead = 0.3 * (right - left) + pull
            found.append((person, left, right, 1 if lead > random.normal() else -1))
    return rows(found)


def test_a_side_that_decides_most_answers_is_said_before_the_scale_and_no_scale_is_praised():
    analysis = analyse(sided(1.9, exchanged=True), bootstrap=0)
    page, japanese = analysis.text("report.html"), analysis.text("report.html", "ja")
    assert analysis.goodness.describes
    assert '<ul class="short">\n<li>The side decided most of the answers' in page
    assert "One scale describes the answers" not in page
    assert "Yes, as far as these answers can tell. The scale" not in page
    assert "回答の大半は、対象ではなく左右の位置で決まっています" in japanese
    assert "回答は一つの尺度でよく表せます" not in japanese
    lines = told(analysis, 0).splitlines()
    assert lines[0].startswith("the side decided most answers")
    assert lines[-1].startswith("whether one scale describes these data cannot be told")


def test_stimuli_that_never_change_sides_are_no_finding_on_sides():
    analysis = analyse(sided(0.0, exchanged=False), bootstrap=0)
    page, japanese = analysis.text("report.html"), analysis.text("report.html", "ja")
    assert "the side itself drew choices" not in page
    assert "whether the side drew choices cannot be told" in page
    assert "位置そのものの影響かどうかはわかりません" in japanese
    assert "side" not in told(analysis, 0)


# --- people who agree


@pytest.mark.parametrize(
    "drawn_together", [{"method": "bias-reduced"}, {"prior": 1.0}, {"prior": "hierarchical"}]
)
def test_where_all_agree_no_margin_over_people_is_given_and_no_end_is_claimed(drawn_together):
    """Simulated: in 4.7 z, 30 people choose the first in 120 of 120 answers."""
    answers = simulate([5.0, 1.0, 0.5, 0.0, -5.0], people=30, seed=2)
    fit = thurstone(answers, **drawn_together)
    for refused in (fit.intervals, fit.covariance, lambda: fit.parameter_covariance("people")):
        with pytest.raises(InputError, match="how much farther apart these are cannot be told"):
            refused()
    assert "how much farther apart these are cannot be told" in str(fit)
    analysis = analyse(answers, bootstrap=0, **drawn_together)
    first = analysis.doubt.endless[0]
    assert (len(first), analysis.doubt.by) == (1, "information")
    assert analysis.doubt.intervals[analysis.order[0]].tolist() == pytest.approx(
        fit.intervals(kind="expected")[analysis.order[0]].tolist()
    )
    assert "cannot be told" in told(analysis, 0).splitlines()[-2]
    page = analysis.text("report.html")
    assert "there is no upper end" in page
    assert "no bar here promises to hold the true place" in page
    assert "the bar holds it" not in page
    assert "離れ方に上限はありません" in analysis.text("report.html", "ja")


def test_where_people_differ_a_prior_leaves_errors_over_people():
    fit = thurstone(simulate([0.5, 0.0, -0.5], people=30, seed=2), prior=1.0)
    assert fit.covariance() == pytest.approx(fit.covariance("people"))

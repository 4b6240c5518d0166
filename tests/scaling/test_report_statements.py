"""What a report says of the answers."""

from __future__ import annotations

import json
import re
from html import unescape

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling.report.chapters import fit, groups, neighbours, scale
from nacreous.scaling.report.picture import inline
from nacreous.scaling.report.translation import (
    LANGUAGES,
    Html,
    Words,
    language_of,
)
from tests.scaling.report_answers import survey


def undrawn(draw, name, alt, caption, wide_pt=0.0) -> Html:
    """In place of a picture, whose drawing takes most of a page's time, what stands below it."""
    return Html(f"<figure><figcaption>{caption}</figcaption></figure>\n")


def told(study, language="en") -> str:
    """The words of a page outside its pictures."""
    with pytest.MonkeyPatch.context() as patch:
        for chapter in (fit, groups, scale):
            patch.setattr(chapter, "picture", undrawn)
        text = study.text("a.html", language)
    assert "<svg" not in text
    return unescape(re.sub(r"<[^>]+>", "", text))


def test_words_are_those_of_a_page_with_its_pictures(answered):
    text = re.sub(r"<svg.*?</svg>", "", answered.text("a.html"), flags=re.S)
    assert told(answered) == unescape(re.sub(r"<[^>]+>", "", text))


def test_labels_that_are_read_from_right_to_left_stand_apart_from_the_words_around_them():
    """Unicode's bidirectional algorithm (UAX 9) would put a row of them in the other order."""
    scale = {"A": 0.0, "שלום": 1.0, "مرحبا": 0.5}
    data = nc.scaling.simulate(scale, 20, seed=1)
    study = nc.scaling.analyse(data, bootstrap=0, question="איזה טוב?")
    for language in ("en", "ja"):
        page = study.text("a.html", language)
        assert "unicode-bidi: isolate" in page
        for label in ("שלום", "مرحبا"):
            assert f'<b class="name" dir="auto">{label}</b>' in page
            for found in re.finditer(label, re.sub(r"<text\b.*?</text>", "", page)):
                assert found.string[: found.start()].endswith(('dir="auto">', "\u2068"))
        assert "<title>" in page
        assert "\u2068איזה טוב?\u2069" in page[: page.index("</title>")]
        assert '<b class="name">A</b>' in page


def test_the_papers_report_says_what_the_paper_found(paper):
    said = told(paper)
    for sentence in (
        "people point to 2 most of all, and to 7 least",
        "From first to last: 2, 4, 3, 1, 5, 6, 7.",
        "Too close to call, from one to the next: 4 – 3 – 1.",
        "The largest misfit is 1 against 3: 74 of 100 answers chose 1, and the scale expects 49.",
        "(1 over 3 over 4 over 1)",
        "ζ is 0.93",
        "u = 0.37",
        "G² = 104.05, 15 degrees of freedom, p < 0.001",
        "reconstructed from table 1",
    ):
        assert sentence in said
    japanese = told(paper, "ja")
    terms = "サーストンの一対比較法 ケースV,心理尺度値,最尤推定,信頼区間,一巡三角形"
    for word in (*terms.split(","), "一致性の係数 ζ", "一致係数 u", "復元"):
        assert word in japanese


def test_only_the_papers_report_is_marked_as_reconstructed(answered):
    assert "reconstructed" not in answered.text("a.html")
    assert "復元" not in answered.text("a.html", "ja")


@pytest.mark.parametrize("language", LANGUAGES)
def test_simulated_answers_are_said_to_be_so_first_and_people_s_are_not(answered, language):
    words = Words(language)
    found = nc.scaling.analyse(survey(), question="Which?", simulated=True, bootstrap=0)
    page = found.text("report.html", language)
    title = words("page.simulated", title=words("page.asked", question="Which?"))
    assert f"<title>{title}</title>" in page
    assert page.index(words("head.simulated")) < page.index("<main>")
    assert "--simulated" in page
    assert json.loads(found.text("scale.json"))["settings"]["simulated"] is True
    assert words("head.simulated") not in answered.text("report.html", language)


def test_neighbours_told_apart_are_those_whose_interval_is_beyond_chance(paper):
    for pair in paper.neighbours:
        assert pair.low < pair.difference < pair.high
        assert pair.apart == (pair.p_value < 0.05)
        if pair.apart:
            assert pair.low > 0


def test_equals_are_too_close_to_call_and_good_answers_fit():
    chance = np.random.default_rng(3)
    wins = chance.binomial(200, 0.5, (4, 4)).astype(float)
    counts = np.triu(wins, 1) + np.tril(200 - wins.T, -1)
    found = nc.scaling.analyse(counts, bootstrap=200)
    assert not any(pair.apart for pair in found.neighbours)
    said = told(found)
    assert "No two items differ by more than chance" in said
    assert "stray from the scale no more than chance would make them" in said


def test_all_pairs_are_told_with_one_correction_for_all(paper):
    by_holm = {frozenset((d.first, d.second)): d for d in paper.differences}
    assert len(by_holm) == len(paper.differences) == 21
    assert all(pair.difference >= 0 for pair in paper.differences)
    for pair in paper.neighbours:  # more pairs, no smaller p
        assert by_holm[frozenset((pair.first, pair.second))].p_value >= pair.p_value
    assert len(json.loads(paper.text("a.json"))["differences"]) == 21
    chapter = neighbours.chapter(paper, Words("en"))
    assert chapter.count("<tr>") == 1 + 6 + 1 + 21
    assert "Each item with all that are further down: 21 pairs" in chapter


def test_labels_carry_their_language_on_pages_in_any_language():
    assert Words("en").name("光沢") == '<b class="name" lang="ja">光沢</b>'
    assert Words("ja").name("あこや 1") == '<b class="name" lang="ja">あこや 1</b>'
    assert Words("ja").name("pearl 1") == '<b class="name">pearl 1</b>'
    drawn = inline(
        '<svg viewBox="0"><g><text x="1">光沢</text><text>a</text></g></svg>', "p", "", ""
    )
    assert '<text lang="ja" x="1">光沢</text><text>a</text>' in drawn


@pytest.mark.parametrize(
    ("labels", "tag"),
    [
        (["光沢", "巻", "真珠の色", "ﾃﾘ", "働", "〆"], "ja"),
        (["骨头", "门", "珍珠颜色", "马"], "zh-Hans"),
        (["說明", "內"], "zh-Hant"),
        (["진주"], "ko"),
        (["真珠", "珍珠", "門", "骨", "pearl", "жемчуг"], ""),
    ],
)
def test_glyphs_are_asked_for_only_where_a_label_tells_its_language(labels, tag):
    wanted = f' lang="{tag}"' if tag else ""
    assert [language_of(label) for label in labels] == [wanted] * len(labels)


def test_a_question_carries_its_language_and_the_title_is_text_alone():
    page = nc.scaling.analyse(survey(), question="どちらが<深い>?", bootstrap=0).text("x.html")
    assert '<h1>“<span lang="ja">どちらが&lt;深い&gt;?</span>”</h1>' in page
    assert "<title>“どちらが&lt;深い&gt;?”</title>" in page
    assert 'Asked “<span lang="ja">どちらが' in page


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("case", ["nobody disagrees", "one answer a pair", "counts"])
def test_without_resampling_nothing_warns(case):
    rows = {
        "nobody disagrees": ("abc", "bca", "aba" * 6),
        "one answer a pair": ("abc", "bca", "abc"),
    }
    if case == "counts":
        found = nc.scaling.analyse([[0, 30], [10, 0]], bootstrap=0, prior=1.0)
    else:
        left, right, chosen = rows[case]
        times = len(chosen) // 3
        table = {"left": [*left] * times, "right": [*right] * times, "chosen": [*chosen]}
        table["person"] = [str(k // 3) for k in range(len(chosen))]
        answers = nc.scaling.Answers.of_table(table)
        found = nc.scaling.analyse(answers, bootstrap=0, prior=1.0)
    assert (found.doubt.intervals[:, 0] < found.doubt.intervals[:, 1]).all()
    json.loads(found.text("a.json"))


def test_two_stimuli_make_a_report_without_a_test_of_fit():
    found = nc.scaling.analyse([[0, 30], [10, 0]], bootstrap=100)
    assert "cannot be tested" in told(found)
    assert "一つの尺度" in told(found, "ja")


def test_one_answer_a_pair_is_said_to_be_too_few_to_test_the_fit():
    table = {"left": [*"abca"], "right": [*"bcdd"], "chosen": [*"abcd"]}
    found = nc.scaling.analyse(nc.scaling.Answers.of_table(table), bootstrap=0)
    assert found.goodness.describes is None
    assert "too few answers a pair" in told(found)
    assert "G² =" not in told(found)


def test_people_are_resampled_where_they_are_known(answered):
    assert answered.doubt.by == "people"
    assert "drawing the 25 people anew" in told(answered)
    unknown = nc.scaling.analyse(survey().comparisons(), bootstrap=100)
    assert unknown.doubt.by == "answers"
    assert "the true margins are wider" in told(unknown)


HARD = {
    "one person": {"left": [*"aabbca"], "right": [*"bccaab"], "chosen": [*"acbaab"]},
    "a choice among ties": {
        "left": [*"abac"],
        "right": [*"bcca"],
        "chosen": ["tie", "tie", "a", "tie"],
    },
}


@pytest.mark.parametrize("case", HARD)
@pytest.mark.parametrize("language", LANGUAGES)
def test_hard_cases_make_a_report_without_nan(case, language):
    count = len(HARD[case]["left"])
    table = HARD[case] | {"person": ["x"] * count, "time": list(range(count))}
    found = nc.scaling.analyse(nc.scaling.Answers.of_table(table), bootstrap=100)
    said = told(found, language)
    for word in ("nan", "inf ", "None"):
        assert word not in said
    assert found.doubt.by in ("answers", "information")
    assert (found.doubt.intervals[:, 0] < found.doubt.intervals[:, 1]).all()
    json.loads(found.text("a.json"))


def test_a_prior_places_what_the_answers_alone_do_not():
    pairs = [("a", "b")] * 5 + [("b", "c")]
    with pytest.raises(nc.InputError, match="no scale holds"):
        nc.scaling.analyse(pairs)
    found = nc.scaling.analyse(pairs, prior=1.0, bootstrap=100)
    assert found.ranking == ["a", "b", "c"]
    assert "drawn together by a normal prior with spread 1" in told(found)
    assert "(Ford)" not in told(found)


def test_few_people_are_said_to_be_few():
    found = nc.scaling.analyse(survey(people=8), bootstrap=100)
    assert "Only 8 people took part" in told(found)


def test_rows_left_out_are_counted_and_told_with_the_reason():
    table = {"left": ["a", "b", "a", "", ""], "right": ["b", "a", "b", "", ""]}
    table["chosen"] = ["a", "a", "", "", "space"]
    table["left"] += ["a"] * 2
    table["right"] += ["b"] * 2
    table["chosen"] += ["b", "a"]
    answers = nc.scaling.Answers.of_table(table, repeats=True, skip_unanswered=True)
    study = nc.scaling.analyse(answers, bootstrap=0)
    page = told(study)
    assert "Left out of the table: 2 rows without a pair, such as instructions." in page
    assert "Left out of the table: 1 row without an answer." in page
    page = told(study, "ja")
    assert "対の書かれていない2行は除きました" in page
    assert "回答のない1行は除きました" in page
    left_out = json.loads(study.text("x.json"))["rows_left_out"]
    assert {why: rows for why, rows in left_out.items() if rows} == {"pair": 2, "answer": 1}
    assert "Left out" not in told(nc.scaling.analyse(survey(), bootstrap=0))


@pytest.mark.parametrize("language", ["en", "ja"])
def test_no_control_character_reaches_a_page(language):
    question = "Which\x1b[31m\u202e is\nbetter?\x85"
    page = nc.scaling.analyse(survey(), question=question, bootstrap=0).text("x.html", language)
    hidden = {c for c in page if not c.isprintable()} - {"\n", "\u202f"}
    assert hidden == set()
    assert "\\u001b[31m\\u202e is" in page


def test_groups_sides_repeats_and_times_are_told(answered):
    said = told(answered)
    for words in ("Groups by room", "<south>: 13 people", "The left one was chosen",
                  "Asked the same pair again", "Half of the answers came within",
                  "of the answers were ties", "half of the people have a coefficient"):  # fmt: skip
        assert words in said


def test_without_resampling_the_margins_are_the_models():
    found = nc.scaling.analyse(nc.scaling.paper(), bootstrap=0)
    assert found.doubt.by == "information"
    np.testing.assert_allclose(found.doubt.se, found.fit.se, rtol=1e-12)


def test_least_squares_gives_the_papers_row_means():
    shares = nc.scaling.paper_proportions()
    counts = nc.scaling.Comparisons.of_proportions(shares, 104)
    found = nc.scaling.analyse(counts, method="least-squares")
    printed = [0.278, 0.810, 0.324, 0.419, -0.308, -0.623, -0.900]
    np.testing.assert_allclose(found.fit.scale, printed, atol=0.001)
    assert "in standard deviations (z)" in told(found)


@pytest.mark.parametrize("unit", ["z", "d'", "JOD", "JND", "logit"])
def test_units_are_said_and_one_unit_is_what_it_is(unit):
    found = nc.scaling.analyse(nc.scaling.paper(), unit=unit, bootstrap=100)
    share = {"z": "84", "d'": "76", "JOD": "75", "JND": "75", "logit": "73"}[unit]
    assert f"At a distance of 1 it would be {share}." in told(found)
    assert f"scale value ({unit.replace(chr(39), '′')})" in found.text("a.html")

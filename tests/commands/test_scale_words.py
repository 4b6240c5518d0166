"""The trade's words in reports: those of the numbers that are known, and nothing where none are."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

import nacreous as nc
from nacreous.commands.scale_words import called_of
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.page import html
from nacreous.study.design import freeze
from nacreous.study.design.called import called_stimuli

NUMBERS = """stimulus,facet_spread_rad,diameter_mm,overtone.chroma,overtone.hue_deg,grooves,free
a,0.03,7.2,3,20,,x
b,0.12,7.2,1,200,,y
c,,7.2,5,,1,z
"""


@pytest.fixture(scope="module")
def found() -> Analysis:
    counts = nc.scaling.Comparisons.of_counts(
        [[0, 7, 9], [3, 0, 6], [1, 4, 0]], stimuli=["a", "b", "c"]
    )
    return nc.scaling.analyse(counts, bootstrap=0)


def words_of(place: Path, text: str = NUMBERS) -> dict[str, list[tuple[str, str]]]:
    table = place / "numbers.csv"
    table.write_text(text, encoding="utf-8")
    found = called_of(str(table), ["a", "b", "c"])
    return {label: [(one.factor[0], one.word[0]) for one in each] for label, each in found.items()}


def test_each_number_has_the_tables_word_and_too_few_numbers_have_none(tmp_path: Path) -> None:
    size = ("size", "7.0-7.5 mm")
    assert words_of(tmp_path) == {
        "a": [size, ("overtone", "rose"), ("luster", "Very good")],
        "b": [size, ("overtone", "none"), ("luster", "Fair")],
        "c": [size],
    }


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("a,0.03", "a,0.9", "row 2: luster has no word for facet_spread_rad 0.9"),
        ("a,0.03", "a,x", 'row 2: facet_spread_rad is "x"; allowed: a number'),
        ("b,0.12", "a,0.12", 'row 3: stimulus is "a"; allowed: a label, each once'),
        ("stimulus", "item", "stimulus"),
        (NUMBERS, "stimulus,free\na,x\n", "has no quantity of the trade's table"),
        (NUMBERS, "stimulus,diameter_mm\nd,8\n", 'none of its stimuli ("d") was compared'),
    ],
)
def test_a_table_of_numbers_that_cannot_be_used_is_refused(
    tmp_path: Path, old: str, new: str, said: str
) -> None:
    with pytest.raises(nc.InputError) as caught:
        words_of(tmp_path, NUMBERS.replace(old, new))
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("language", "differs", "shared"),
    [
        ("en", "luster Very good (", "All items: size 7.0-7.5 mm ("),
        ("ja", "テリ 上（", "すべての対象に共通：大きさ 7.0～7.5 mm（"),
    ],
)
def test_the_page_says_words_in_both_languages_with_source_and_none_without_numbers(
    found: Analysis, tmp_path: Path, language: str, differs: str, shared: str
) -> None:
    words_of(tmp_path)
    named = replace(found, called=called_of(str(tmp_path / "numbers.csv"), "abc"))
    page = html(named, language)
    for said in (differs, shared, "Very good", "テリ", "facet_spread_rad 0.025 to 0.05 rad", "GIA"):
        assert said in page
    table = page[page.index("<tbody>") : page.index("</tbody>")]
    assert "Very good" in table
    assert "7.0" not in table  # which all share
    assert json.loads(named.text("x.json"))["stimuli"][0]["words"][-1]["word"]["ja"] == "上"
    assert "docs/words.md" not in html(found, language)
    assert "words" not in json.loads(found.text("x.json"))["stimuli"][0]


def test_a_study_has_the_words_of_the_pearls_that_its_pictures_were_made_from(
    tmp_path: Path,
) -> None:
    (tmp_path / "study.toml").write_text(
        """purpose = "demo"
        questions = [{ id = "q", text = { en = "Which?", ja = "どちら？" } }]
        display = { size_px = 32, samples = 1 }
        [[stimuli]]
        label = "a"
        pearl = "akoya-rg"
        words = ["luster=Poor"]
        [[stimuli]]
        label = "b"
        pearl = "akoya-rg"
        overrides = ["blemishes.pits=3", "blemishes.area=0.06"]
        """,
        encoding="utf-8",
    )
    found = called_stimuli(freeze(tmp_path / "study.toml", tmp_path / "study"))
    assert [one.word[0] for one in found["a"]] == ["8.0-8.5 mm", "round", "Poor", "clean"]
    assert [one.word[1] for one in found["b"]] == ["8.0～8.5 mm", "ラウンド", "上", "中キズ"]
    assert called_of(str(tmp_path / "study"), ["a", "b"]) == found

"""Where a column tells people apart, that leads, and no scale is said to hold them all."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from nacreous.commands.scale_lines import told
from nacreous.scaling import analyse, simulate
from nacreous.scaling.data.column import Grouping
from tests.scaling.test_covariate import with_columns
from tests.scaling.test_shared import together

PRAISE = (
    "One scale describes the answers",
    "As far as these answers can tell, yes",
    "Yes, as far as these answers can tell",
    "回答は一つの尺度でよく表せます",
    "この回答から判断するかぎり",
)


def two_orders(each=15, column="age"):
    """Simulated: half of the people put the first two and the last two the other way round."""
    one, other = [0.8, 0.1, -0.1, -0.8], [0.1, 0.8, -0.8, -0.1]
    study = together(simulate(one, each, seed=4), simulate(other, each, seed=104))
    ages = [*range(20, 20 + each), *range(50, 50 + each)]
    return with_columns(study, **{column: ages})


@pytest.fixture(scope="module")
def by_age():
    analysis = analyse(two_orders(), bootstrap=0)
    assert not analysis.single_people_differ  # the test of persons alone misses it
    assert analysis.goodness.describes
    return analysis


@pytest.mark.parametrize(
    ("language", "first"),
    [("en", "The answers do not follow one scale: taken apart by "), ("ja", "回答は一つの尺度に")],
)
def test_a_column_by_which_people_judge_differently_leads_the_report(by_age, language, first):
    page = by_age.text("report.html", language)
    assert f'<ul class="short">\n<li>{first}' in page
    assert not [one for one in PRAISE if one in page]
    assert page.index('<section id="people">') < page.index('<section id="scale">')


def test_the_chapter_of_people_says_no_and_what_the_test_of_persons_found(by_age):
    page = by_age.text("report.html")
    said = re.sub("<[^>]*>", "", page[page.index('<section id="people">') :])
    assert "No. Taken apart by age, people’s answers differ by more than chance." in said
    assert "Person by person, the test finds no more than chance would make" in said


def test_command_print_and_record_say_it_too(by_age):
    first, *_, last = told(by_age, 0).splitlines()
    assert first.startswith('the answers do not follow one scale: taken apart by "age"')
    assert last.startswith("all answers together: ")
    assert str(by_age.fit).startswith('people who differ in "age" judge differently, p 0.0')
    assert json.loads(by_age.text("x.json"))["judged_differently_by"] == ["age"]


def test_groups_of_the_same_people_that_judge_differently_lead_and_people_are_not_blamed():
    """Simulated: 20 people judge under two lamps, and alike under each."""
    one, other = [0.8, 0.1, -0.1, -0.8], [0.1, 0.8, -0.8, -0.1]
    parts = [simulate(truth, 20, seed=seed) for truth, seed in ((one, 3), (other, 4))]
    study = together(*parts)
    lamp = np.repeat([0, 1], [len(part) for part in parts])
    study = replace(
        study,
        people=parts[0].people,
        person=study.person % 20,
        groups={"lamp": Grouping(("day", "night"), lamp)},
    )
    analysis = analyse(study, bootstrap=0, group="lamp")
    page = analysis.text("report.html")
    assert '<ul class="short">\n<li>The answers do not follow one scale: taken apart by ' in page
    assert "One scale describes the answers" not in page
    assert page.index('<section id="groups">') < page.index('<section id="scale">')
    assert analysis.people_apart_by == ()
    assert told(analysis, 0).startswith("the answers do not follow one scale")


def test_a_column_that_goes_with_nothing_leaves_the_praise():
    study = with_columns(simulate([0.8, 0.1, -0.1, -0.8], 30, seed=1), eye=["l", "r"] * 15)
    analysis = analyse(study, bootstrap=0, group="eye")
    assert analysis.apart_by == ()
    assert PRAISE[0] in analysis.text("report.html")
    assert str(analysis.fit).startswith("scale in ")

"""What a report cannot have it names; the rest of it stands."""

import json
from dataclasses import replace

import numpy as np
import pytest

import nacreous as nc
from nacreous.commands.scale_lines import told
from nacreous.scaling.data.answers import Grouping
from tests.scaling.report_answers import survey


def with_rooms(rooms):
    """Simulated answers of people each of whom is in the room named."""
    answers = survey(people=len(rooms))
    levels = tuple(sorted(set(rooms)))
    code = np.array([levels.index(rooms[int(label[1:])]) for label in answers.people])
    return replace(answers, groups={"room": Grouping(levels, code[answers.person])})


@pytest.fixture(scope="module")
def lone():
    answers = with_rooms([*["north", "south"] * 9, "attic"])
    return nc.scaling.analyse(answers, group="room", bootstrap=0)


def test_a_lone_person_in_a_group_is_named_and_the_other_groups_are_compared(lone):
    assert set(lone.groups.found.fits) == {"north", "south"}
    assert [(one.name, one.reason) for one in lone.groups.left_out] == [("attic", "few")]
    assert 'not compared, for they have no scale of their own: "attic"' in told(lone, 0)
    assert json.loads(lone.text("a.json"))["groups"]["not_compared"] == {"attic": "few"}
    for language, words in (("en", "Not compared"), ("ja", "比較から除いた群")):
        page = lone.text("a.html", language)
        assert words in page
        assert '<b class="name">attic</b>' in page


def test_the_lone_persons_answers_count_in_the_scale_of_all(lone):
    assert lone.comparisons.total == len(survey(people=19))


def test_a_group_whose_answers_give_no_scale_is_named_and_the_others_are_compared():
    answers = with_rooms([*["north", "south"] * 6, *["attic"] * 4])
    attic = answers.groups["room"].levels.index("attic")
    there = answers.groups["room"].code == attic
    agreeing = np.where(answers.left < answers.right, 1, -1)  # of four people who all agree
    found = nc.scaling.analyse(
        replace(answers, outcome=np.where(there, agreeing, answers.outcome).astype(np.int8)),
        group="room",
        bootstrap=0,
    )
    assert [(one.name, one.reason) for one in found.groups.left_out] == [("attic", "unplaced")]
    assert "do not hold every item in place" in found.text("a.html")


@pytest.mark.parametrize(
    "rooms", [["north"] * 9 + ["attic"], [str(at) for at in range(9)], ["north"] * 9]
)
def test_where_no_two_groups_can_be_compared_the_report_says_so(rooms):
    found = nc.scaling.analyse(with_rooms(rooms), group="room", bootstrap=0)
    assert found.groups.found is None
    assert "cannot be compared" in told(found, 0)
    for language, words in (("en", "The groups cannot be compared"), ("ja", "群を比較できません")):
        assert words in found.text("a.html", language)

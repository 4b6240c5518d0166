"""Flags of people, the scale so far and the report, against truths that were planted."""

from __future__ import annotations

import base64
import re
from collections import Counter
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.problem import InputError
from nacreous.study.design import Design
from nacreous.study.plan import drawn_groups, trials
from nacreous.study.results import people_flags, report, scale_so_far
from nacreous.study.running import Running
from nacreous.study.store import Store, answers_of
from nacreous.study.task.flag import RATE
from nacreous.study.task.pair.chance import at_least, circles_by_chance, one_sided
from nacreous.study.task.pair.pair import PAIR
from tests.support.gathering import by_scale, frozen_study, opened, table_of, take_part

SCALE = {"a": 1.2, "b": 0.6, "c": 0.0, "d": -0.6, "e": -1.2}
KEYS = {
    "pairs": {"repeats": 4},
    "catches": [{"expected": "a", "against": "e"}, {"expected": "b", "against": "e"}],
    "groups": [{"name": "real-pearl", "values": ["shown", "not-shown"]}],
}


class Clock:
    """The server's time, which a test moves."""

    def __init__(self) -> None:
        self.now = datetime(2026, 11, 25, 9, 0, tzinfo=UTC)

    def __call__(self) -> datetime:
        return self.now


@pytest.fixture(scope="module")
def frozen(tmp_path_factory):
    return frozen_study(tmp_path_factory.mktemp("made"), **KEYS)


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def running(frozen, tmp_path: Path, clock: Clock) -> Iterator[Running]:
    with Store.open(tmp_path / "answers.sqlite", clock=clock) as store:
        yield opened(store, frozen)


def honest(running: Running, people: int = 20, seed: int = 1, **more) -> list[int]:
    random = np.random.default_rng(seed)
    return [take_part(running, by_scale(SCALE, random), **more) for _ in range(people)]


def kinds(running: Running, number: int) -> dict[str, str]:
    return {flag.kind: flag.detail for flag in people_flags(running)[number]}


def test_someone_who_always_clicks_left_is_flagged_by_side_repeats_and_circles(running):
    honest(running)
    lefty = take_part(running, lambda _: "left")
    found = kinds(running, lefty)
    assert found["left"] == "14/14"
    assert found["repeats"] == "4/4"


def test_someone_who_always_clicks_right_is_told_from_left(running):
    righty = take_part(running, lambda _: "right")
    assert "right" in kinds(running, righty)
    assert "left" not in kinds(running, righty)


def test_catches_that_were_missed_are_counted(running):
    honest(running, 1)
    blind = take_part(
        running,
        lambda trial: (
            ("right" if trial.stimuli[0] in "ab" else "left") if trial.kind == "catch" else "left"
        ),
    )
    assert kinds(running, blind)["catches"] == "2/2"
    looking = take_part(
        running, lambda trial: "left" if trial.stimuli[0] < trial.stimuli[1] else "right"
    )
    assert "catches" not in kinds(running, looking)


def test_who_answers_faster_than_anyone_sees_is_flagged(running):
    fast = take_part(running, by_scale(SCALE, np.random.default_rng(2)), response_ms=150.0)
    slow = take_part(running, by_scale(SCALE, np.random.default_rng(3)), response_ms=450.0)
    assert kinds(running, fast)["fast"] == "14/14"
    assert "fast" not in kinds(running, slow)


def test_who_answers_before_the_page_lets_anyone_is_flagged(running):
    assert running.frozen.design.sitting.minimum_viewing_ms == 500
    sooner = take_part(running, by_scale(SCALE, np.random.default_rng(2)), response_ms=499.0)
    later = take_part(running, by_scale(SCALE, np.random.default_rng(3)), response_ms=500.0)
    assert kinds(running, sooner)["unwaited"] == "19/19"
    assert "unwaited" not in kinds(running, later)


def test_a_long_pause_is_flagged_and_a_short_one_is_not(running, clock):
    def slowly(seconds: float):
        choose = by_scale(SCALE, np.random.default_rng(4))

        def waiting(trial):
            clock.now += timedelta(seconds=seconds if trial.number == 7 else 2)
            return choose(trial)

        return waiting

    away = take_part(running, slowly(640))
    here = take_part(running, slowly(200))
    assert kinds(running, away)["pause"] == "640 s"
    assert "pause" not in kinds(running, here)


def test_what_the_page_noticed_is_counted(running):
    noticed = take_part(running, lambda _: "left", flags={"away": 2, "shrunk": 0, "x": True})
    found = kinds(running, noticed)
    assert found["answer-away"] == "19/19"
    assert not {"answer-shrunk", "answer-x"} & set(found)


def test_excluded_people_keep_their_flags_and_erased_ones_have_none(running):
    lefty, erased = (take_part(running, lambda _: "left") for _ in range(2))
    sessions = {one.number: one.id for one in running.store.sessions(running.study)}
    running.store.exclude(sessions[lefty], "always left", "lab")
    running.store.erase(sessions[erased], "lab")
    found = people_flags(running)
    assert "left" in {flag.kind for flag in found[lefty]}
    assert erased not in found


def rows_of(design: Design, truth, number: int, random: np.random.Generator, spread: float):
    """Answers as the store gives them, of somebody whose scale strays from the truth."""
    own = {label: value + spread * random.standard_normal() for label, value in truth.items()}
    choose = by_scale(own, random)
    return [
        {
            "number": number,
            "trial": trial.number,
            "question": trial.question,
            "left": trial.stimuli[0],
            "right": trial.stimuli[1],
            "kind": trial.kind,
            "chosen": choose(trial),
            "response_ms": 900.0,
            "simulated": True,
            "excluded": None,
        }
        for trial in trials(design, number)
        if trial.kind in ("pair", "repeat")
    ]


@pytest.mark.parametrize("spread", [0.0, 0.5])
def test_honest_people_are_flagged_no_more_often_than_the_rate_says(spread):
    design = Design.load("paper")
    fit = nc.scaling.thurstone(nc.scaling.paper())
    truth = dict(zip(fit.stimuli, fit.scale.tolist(), strict=True))
    counts: Counter[str] = Counter()
    studies, people = 12, 60
    for study in range(studies):
        random = np.random.default_rng([study, 7])
        rows = [
            row
            for number in range(people)
            for row in rows_of(design, truth, number, random, spread)
        ]
        for flags in PAIR.flags(design.asked, table_of(rows)).values():
            counts.update(flag.kind for flag in flags)
    total = studies * people
    # Beyond so many, the rate would be broken by more than chance (one of 1000 times).
    most = next(k for k in range(total) if at_least(k, [RATE] * total) < 0.001)
    assert set(counts) <= {"repeats", "left", "right", "circles"}
    assert counts["repeats"] < most
    assert counts["circles"] < most
    assert counts["left"] + counts["right"] < most


def test_chance_is_what_it_is_by_counting():
    assert at_least(0, [0.2, 0.3]) == pytest.approx(1)
    assert at_least(2, [0.2, 0.3]) == pytest.approx(0.06)
    assert one_sided(10, 10) == one_sided(0, 10) == pytest.approx(2 / 2**10)
    assert one_sided(5, 10) == 1
    # Kendall and Babington Smith 1940: coins make C(n, 3) / 4 circular triads on average.
    assert np.mean(circles_by_chance(np.full((7, 7), 0.5))) == pytest.approx(35 / 4, abs=0.2)
    sure = np.triu(np.ones((7, 7)), 1)
    assert circles_by_chance(sure).max() == 0


def test_the_scale_so_far_is_that_of_the_same_table(running):
    honest(running, 15)
    found = scale_so_far(running, "deeper")
    fit = nc.scaling.thurstone(answers_of(running.store, running.study, "deeper"))
    bounds = fit.intervals(0.95, kind="people")
    for placed in found.stimuli:
        at = fit.stimuli.index(placed.label)
        assert placed.value == pytest.approx(fit.scale[at], abs=1e-12)
        assert (placed.low, placed.high) == pytest.approx(tuple(bounds[at]), abs=1e-12)
    assert [one.value for one in found.stimuli] == sorted(fit.scale, reverse=True)
    assert (found.people, found.answers, found.unit, found.level) == (15, 15 * 14, "z", 0.95)
    assert found.text == {"en": "Which is deeper?", "ja": "どちらが深い?"}
    pictures = {stimulus.label: stimulus.sha256 for stimulus in running.frozen.stimuli}
    assert {one.label: one.picture for one in found.stimuli} == pictures


def test_simulated_answers_and_those_of_excluded_people_stay_apart(running):
    people = honest(running, 12)
    honest(running, 12, seed=9, simulated=True)
    before = scale_so_far(running, "deeper")
    assert scale_so_far(running, "deeper", simulated=True).people == before.people == 12
    sessions = {one.number: one.id for one in running.store.sessions(running.study)}
    running.store.exclude(sessions[people[0]], "left the room", "lab")
    assert scale_so_far(running, "deeper").people == 11
    assert scale_so_far(running, "deeper", simulated=True).people == 12


def test_too_few_and_unanimous_answers_are_told_plainly(running):
    with pytest.raises(InputError, match="no answers to 'deeper' count yet"):
        scale_so_far(running, "deeper")
    take_part(running, lambda trial: "left" if trial.stimuli[0] < trial.stimuli[1] else "right")
    with pytest.raises(InputError, match="no scale holds"):
        scale_so_far(running, "deeper")
    with pytest.raises(InputError, match="question is 'duller'; allowed: deeper"):
        scale_so_far(running, "duller")


def carried(page: str) -> str:
    """The answers that a page carries along."""
    found = re.search(
        r'download="answers.csv" href="data:text/csv;charset=utf-8;base64,([^"]+)', page
    )
    assert found
    return base64.b64decode(found[1]).decode()


@pytest.mark.parametrize(
    ("language", "titled", "said"),
    [
        ("en", "(simulated)", "No person gave"),
        ("ja", "（シミュレーション）", "人の回答ではありません"),
    ],
)
def test_a_report_of_simulated_answers_says_so_in_title_and_text(running, language, titled, said):
    honest(running, 12)
    honest(running, 12, seed=9, simulated=True)
    page = report(running, "deeper", language, simulated=True)
    title = page[page.index("<title>") : page.index("</title>")]
    assert titled in title
    assert said in page
    assert "simulated 12,a," in carried(page)
    assert "--simulated" in page
    plain = report(running, "deeper", language)
    assert titled not in plain
    assert said not in plain
    assert {"en": "Which is deeper?", "ja": "どちらが深い?"}[language] in plain


def test_a_report_compares_the_groups_where_each_has_a_scale(running):
    honest(running, 24)
    page = report(running, "deeper")
    assert '<section id="groups">' in page
    assert "real-pearl" in page
    assert report(running, "deeper", group="real-pearl") == page
    with pytest.raises(InputError, match="group is 'age'; allowed: real-pearl"):
        report(running, "deeper", group="age")


def test_a_report_names_the_group_that_has_no_scale_of_its_own(running):
    random = np.random.default_rng(5)
    consistent = lambda trial: "left" if trial.stimuli[0] < trial.stimuli[1] else "right"  # noqa: E731
    for number in range(12):
        shown = drawn_groups(running.frozen.design, number)["real-pearl"] == "shown"
        take_part(running, by_scale(SCALE, random) if shown else consistent)
    page = report(running, "deeper")
    assert "do not hold every item in place" in page.split('<section id="groups">')[1]

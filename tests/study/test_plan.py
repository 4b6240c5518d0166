"""Plans of trials: each pair once, no stimulus twice in a row, balance, and the same again."""

from __future__ import annotations

from collections import Counter
from itertools import permutations
from typing import Any

import numpy as np
import pytest

import nacreous as nc
from nacreous.study.design import Design
from nacreous.study.plan import Trial, drawn_groups, repetitions, trials

WORDS = {"en": "Which looks more like a pearl?", "ja": "どちらがより真珠らしく見えますか。"}
PEOPLE = range(24)


def study(count: int, questions: int = 1, **keys: Any) -> Design:
    """A study of so many stimuli and questions."""
    return Design(
        purpose="demo",
        stimuli=[{"label": f"s{k}", "pearl": "paper"} for k in range(count)],
        questions=[{"id": f"q{k}", "text": WORDS} for k in range(questions)],
        **keys,
    )


def pair_of(trial: Trial) -> frozenset[str]:
    return frozenset((trial.stimuli[0], trial.stimuli[1]))


def of_kind(shown: list[Trial], *kinds: str) -> list[Trial]:
    return [trial for trial in shown if trial.kind in kinds]


def lean(shown: list[Trial]) -> Counter[str]:
    """How much more often each stimulus is on the left than on the right."""
    found = Counter(trial.stimuli[0] for trial in shown)
    found.subtract(trial.stimuli[1] for trial in shown)
    return found


CATCHES = [{"expected": "s0", "against": f"s{k}"} for k in (3, 4, 5)]
DESIGNS = {
    "seven": study(7),
    "repeats": study(7, pairs={"repeats": 4}),
    "all repeated": study(7, pairs={"repeat_share": 1.0}),
    "catches": study(7, pairs={"repeats": 5}, catches=CATCHES),
    "three questions": study(7, 3, pairs={"repeats": 3}, catches=CATCHES),
    "two questions": study(8, 2),
    "incomplete": study(12, pairs={"kind": "incomplete", "number": 30, "repeats": 4}),
    "no training": study(9, sitting={"training": 0, "break_every": 0}),
    "long training": study(6, sitting={"training": 40}),
    "many": study(24, pairs={"repeats": 10}),
}
CASES = pytest.mark.parametrize("design", DESIGNS.values(), ids=DESIGNS.keys())


@CASES
def test_every_pair_comes_exactly_once_under_every_question(design: Design) -> None:
    count = len(design.labels)
    wanted = design.pairs.number or count * (count - 1) // 2
    for number in PEOPLE:
        shown = trials(design, number)
        for question in design.questions:
            pairs = [pair_of(t) for t in of_kind(shown, "pair") if t.question == question.id]
            assert len(pairs) == len(set(pairs)) == wanted
            assert all(len(pair) == 2 for pair in pairs)


@CASES
def test_no_stimulus_is_shown_twice_in_a_row(design: Design) -> None:
    for number in PEOPLE:
        assert repetitions(trials(design, number)) == 0


@pytest.mark.parametrize(("count", "least"), [(2, 0), (3, 2), (4, 2), (5, 0)])
def test_few_stimuli_repeat_no_more_than_they_must(count: int, least: int) -> None:
    # Of three stimuli any two pairs share one; of four, the six pairs are three couples that share
    # none, and between couples there are two steps.
    design = study(count, sitting={"training": 0})
    assert {repetitions(trials(design, number)) for number in PEOPLE} == {least}


@pytest.mark.parametrize("seed", range(12))
def test_small_studies_have_the_fewest_repetitions_there_can_be(seed: int) -> None:
    """Against all orders there are of seven trials."""
    random = np.random.default_rng(seed)
    number = int(random.integers(4, 6))
    design = study(
        5,
        pairs={"kind": "incomplete", "number": number, "repeats": 6 - number},
        catches=CATCHES[:1],
        sitting={"training": 0},
        seed=seed,
    )
    shown = trials(design, seed)
    assert len(shown) == 7
    assert repetitions(shown) == min(map(repetitions, permutations(shown)))


@CASES
def test_each_stimulus_is_on_the_left_as_often_as_on_the_right(design: Design) -> None:
    for number in PEOPLE:
        counted = of_kind(trials(design, number), "pair", "repeat")
        places = Counter(
            label for trial in counted for label in (trial.stimuli[0], trial.stimuli[1])
        )
        for label, more in lean(counted).items():
            assert abs(more) == places[label] % 2


@CASES
def test_a_repeat_is_a_pair_shown_before_with_the_sides_exchanged(design: Design) -> None:
    for number in PEOPLE:
        shown = trials(design, number)
        for question in design.questions:
            asked = [trial for trial in shown if trial.question == question.id]
            pairs, repeats = of_kind(asked, "pair"), of_kind(asked, "repeat")
            assert len(repeats) == design.pairs.repeated(len(pairs))
            place = {(trial.stimuli[1], trial.stimuli[0]): trial.number for trial in pairs}
            assert all(place[t.stimuli[0], t.stimuli[1]] + 1 < t.number for t in repeats)


@pytest.mark.parametrize("name", ["repeats", "catches", "many"])
def test_a_pair_and_its_repeat_are_apart(name: str) -> None:
    for number in PEOPLE:
        shown = trials(DESIGNS[name], number)
        place = {pair_of(trial): trial.number for trial in of_kind(shown, "pair")}
        assert all(t.number - place[pair_of(t)] >= 3 for t in of_kind(shown, "repeat"))


@CASES
def test_two_people_in_a_row_have_the_same_pairs_mirrored(design: Design) -> None:
    for number in range(0, 12, 2):
        one, other = trials(design, number), trials(design, number + 1)
        sides = {(t.question, t.stimuli[0], t.stimuli[1]) for t in of_kind(one, "pair")}
        assert sides == {(t.question, t.stimuli[1], t.stimuli[0]) for t in of_kind(other, "pair")}
        assert [t.question for t in one] == [t.question for t in other]


def test_over_all_people_every_pair_stands_either_way_equally_often() -> None:
    counted = [t for number in range(20) for t in of_kind(trials(study(7), number), "pair")]
    ways = Counter((trial.stimuli[0], trial.stimuli[1]) for trial in counted)
    assert len(ways) == 42
    assert set(ways.values()) == {10}


@CASES
def test_same_design_and_number_same_trials_others_differ(design: Design) -> None:
    made = [trials(design, number) for number in PEOPLE]
    assert made == [trials(design, number) for number in PEOPLE]
    assert len({tuple(shown) for shown in made}) == len(made)
    other = Design(**design.model_dump(exclude={"seed"}), seed=design.seed + 1)
    assert trials(other, 0) != made[0]


def test_an_incomplete_design_joins_all_stimuli_and_differs_between_people() -> None:
    design = study(9, pairs={"kind": "incomplete", "number": 8})
    chosen = [{pair_of(t) for t in of_kind(trials(design, n), "pair")} for n in range(0, 20, 2)]
    for pairs in chosen:
        joined = set(next(iter(pairs)))
        for _ in range(9):
            joined |= {label for pair in pairs if pair & joined for label in pair}
        assert len(joined) == 9
    assert len({frozenset(pairs) for pairs in chosen}) == len(chosen)


def test_catches_are_spread_evenly_and_by_turns_on_either_side() -> None:
    sides: Counter[str] = Counter()
    for number in PEOPLE:
        shown = [t for t in trials(DESIGNS["catches"], number) if t.kind != "training"]
        caught = [(place, t) for place, t in enumerate(shown) if t.kind == "catch"]
        assert sorted(tuple(sorted(pair_of(t))) for _, t in caught) == [
            ("s0", "s3"),
            ("s0", "s4"),
            ("s0", "s5"),
        ]
        third = len(shown) / 3
        for place, (at, trial) in enumerate(caught):
            assert abs(at - (place + 0.5) * third) < third
            sides["left" if trial.stimuli[0] == "s0" else "right"] += 1
    assert sides["left"] == sides["right"]


def test_a_catch_is_asked_under_its_own_question() -> None:
    catch = {"expected": "s0", "against": "s1", "question": "q1"}
    (found,) = of_kind(trials(study(7, 2, catches=[catch]), 3), "catch")
    assert found.question == "q1"


def test_training_comes_first_and_every_so_many_trials_there_is_a_break() -> None:
    design = study(7, sitting={"training": 5, "break_every": 8})
    shown = trials(design, 2)
    assert [t.number for t in shown] == list(range(26))
    assert [t.kind for t in shown[:6]] == ["training"] * 5 + ["pair"]
    assert [t.number for t in shown if t.break_before] == [13, 21]
    assert [t.block for t in shown] == [0] * 5 + [1] * 8 + [2] * 8 + [3] * 5


def test_questions_come_in_turn_each_after_a_break() -> None:
    design = study(5, 3, sitting={"training": 2, "break_every": 100})
    firsts: Counter[str] = Counter()
    for number in range(12):
        shown = trials(design, number)
        order = list(dict.fromkeys(t.question for t in shown))
        assert sorted(order) == ["q0", "q1", "q2"]
        assert [t.number for t in shown if t.break_before] == [12, 22]
        assert [t.block for t in shown] == [0] * 2 + [1] * 10 + [2] * 10 + [3] * 10
        firsts[order[0]] += 1
    assert set(firsts.values()) == {4}


def test_without_breaks_there_is_none_and_blocks_are_questions() -> None:
    shown = trials(study(5, 2, sitting={"training": 0, "break_every": 0}), 0)
    assert not any(trial.break_before for trial in shown)
    assert [trial.block for trial in shown] == [1] * 10 + [2] * 10


def test_groups_by_lot_are_balanced_at_any_number() -> None:
    groups = [
        {"name": "real-pearl", "values": ["shown", "not-shown"]},
        {"name": "light", "values": ["a", "b", "c"]},
        {"name": "sex", "values": ["f", "m"], "how": "recorded", "question": WORDS},
    ]
    design = study(7, groups=groups)
    drawn = [drawn_groups(design, number) for number in range(120)]
    assert drawn == [drawn_groups(design, number) for number in range(120)]
    assert all(set(values) == {"real-pearl", "light"} for values in drawn)
    counts: Counter[tuple[str, ...]] = Counter()
    for number, values in enumerate(drawn):
        counts[tuple(values.values())] += 1
        spread = max(counts.values()) - min(counts.values() if len(counts) == 6 else [0])
        assert spread <= 2
        if number % 12 == 11:
            assert set(counts.values()) == {(number + 1) // 6}
    even = Counter(tuple(values.values()) for values in drawn[::2])
    assert set(even.values()) == {10}
    assert drawn[:12] != drawn[12:24]


def test_a_study_without_lots_draws_none() -> None:
    assert drawn_groups(study(7), 5) == {}


@pytest.mark.parametrize("number", [-1, 1.5, True, "1", 10**7])
def test_a_number_that_cannot_be_is_refused(number: Any) -> None:
    for act in (trials, drawn_groups):
        with pytest.raises(nc.InputError, match=r"number is .*; allowed: a whole number, 0 to"):
            act(study(7), number)


# --- simulated observers, no data of people -------------------------------------------------------


def simulated(people: int, seed: int) -> tuple[Any, Any]:
    """The scale of table 1, and the one that so many simulated observers drawn from it give back.

    They go through the paper's study; each is called "simulated 0" and so on.
    """
    design = Design.load("paper")
    truth = nc.scaling.thurstone(nc.scaling.paper())
    value = dict(zip(truth.stimuli, truth.scale.tolist(), strict=True))
    random = np.random.default_rng(seed)
    rows: dict[str, list[str]] = {"person": [], "left": [], "right": [], "chosen": []}
    for number in range(people):
        for trial in of_kind(trials(design, number), "pair"):
            felt = value[trial.stimuli[0]] - value[trial.stimuli[1]] + random.standard_normal()
            rows["person"].append(f"simulated {number}")
            rows["left"].append(trial.stimuli[0])
            rows["right"].append(trial.stimuli[1])
            rows["chosen"].append("left" if felt > 0 else "right")
    counts = nc.scaling.comparisons_of(nc.scaling.Answers.of_table(rows))
    assert counts.total == people * 21
    return truth, nc.scaling.thurstone(counts)


def order_of(scale: Any) -> list[str]:
    return [scale.stimuli[at] for at in np.argsort(-scale.scale)]


def test_104_simulated_observers_give_back_table_1_as_far_as_104_can() -> None:
    # Crops 4, 3 and 1 lie within 0.09 of each other, where a difference has a standard error of
    # 0.07: one study of 104 puts all seven in order about every second time. Of the values, 95 in
    # 100 lie in their 95 % intervals; 70 of them, seven at a time together, tell that to 0.07.
    inside = []
    for seed in range(10):
        truth, found = simulated(104, seed)
        order = order_of(found)
        assert (order[0], set(order[1:4]), order[4:]) == ("2", {"1", "3", "4"}, ["5", "6", "7"])
        inside += (np.abs(found.scale - truth.scale) < 1.96 * found.se).tolist()
    assert np.mean(inside) > 0.88


def test_forty_such_studies_give_back_the_order_of_table_1() -> None:
    truth, found = simulated(40 * 104, 1)
    assert order_of(found) == order_of(truth) == ["2", "4", "3", "1", "5", "6", "7"]
    assert np.abs((found.scale - truth.scale) / found.se).max() < 3.5


def test_half_of_104_observers_see_a_real_pearl_first() -> None:
    design = Design.load("paper")
    drawn = Counter(drawn_groups(design, number)["real-pearl"] for number in range(104))
    assert drawn == {"shown": 52, "not-shown": 52}

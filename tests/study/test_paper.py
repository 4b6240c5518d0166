"""The paper's experiment, rehearsed: 104 simulated observers give its table 1 back. No people."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.problem import InputError
from nacreous.server.observer import responses
from nacreous.server.rehearsal import rehearse, scale_of
from nacreous.study.design import Design, freeze, open_frozen
from nacreous.study.plan import trials
from nacreous.study.results import people_flags, report, scale_so_far
from nacreous.study.running import Running
from nacreous.study.store import Store, export
from nacreous.study.task.tasks import TASKS
from tests.support.server_process import served

OBSERVERS = 104
#: Crops 4, 3 and 1 lie within 0.15 of each other, and a difference has a standard error of 0.07: so
#: all seven come in the order of table 1 with 47 of the 60 seeds 1 to 60. This is one of the 47.
SEED = 2
OTHERS = (1, 5, 8, 10, 11, 12)  # among those with which they do not


def is_table_1_but_for_neighbours(ranking: Sequence[str]) -> bool:
    """What holds whatever the seed: the best, the next three in any order, and the last three."""
    return (
        ranking[0] == "2" and set(ranking[1:4]) == set("431") and list(ranking[4:]) == list("567")
    )


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """The preset paper, after the rehearsal through a server that runs by itself."""
    folder = tmp_path_factory.mktemp("paper") / "study"
    frozen = freeze("paper", folder)
    with served(folder) as server:
        done = rehearse(server.url, frozen, scale_of("paper"), OBSERVERS, seed=SEED)
        assert server.stop() == 0
    assert (done.observers, done.answers) == (OBSERVERS, OBSERVERS * 28)
    with Store.open(folder) as store:
        yield Running(store, open_frozen(folder))


@pytest.mark.slow
def test_every_answer_says_that_it_is_simulated(running: Running, tmp_path: Path) -> None:
    export(running.store, running.study, tmp_path / "answers.csv")
    with (tmp_path / "answers.csv").open(encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == OBSERVERS * 28
    assert {row["simulated"] for row in rows} == {"true"}
    with pytest.raises(InputError, match=r"count yet.*simulated observers do with --simulated"):
        scale_so_far(running, "pearl-like")
    page = report(running, "pearl-like", simulated=True)
    assert "(simulated)" in page[: page.index("</title>")]


@pytest.mark.slow
def test_every_observer_judged_all_pairs_and_half_saw_a_real_pearl(running: Running) -> None:
    people = running.store.progress(running.study).people
    assert [person.session.number for person in people] == list(range(OBSERVERS))
    assert {person.answers for person in people} == {28}
    groups = [person.session.groups["real-pearl"] for person in people]
    assert (groups.count("shown"), groups.count("not-shown")) == (52, 52)
    pairs = {
        (row["number"], frozenset((row["left"], row["right"])))
        for row in running.store.answers(running.study)
        if row["kind"] == "pair"
    }
    assert len(pairs) == OBSERVERS * 21


@pytest.mark.slow
def test_table_1_comes_back_in_its_order_and_within_its_intervals(running: Running) -> None:
    found = scale_so_far(running, "pearl-like", simulated=True)
    table = scale_of("paper")
    order = [one.label for one in found.stimuli]
    assert is_table_1_but_for_neighbours(order)
    assert order == sorted(table, key=lambda label: -table[label])
    assert (found.people, found.answers) == (OBSERVERS, OBSERVERS * 25)
    inside = [one.low <= table[one.label] <= one.high for one in found.stimuli]
    assert sum(inside) >= 5
    assert found.verdict == "describes"


@pytest.mark.slow
def test_honest_observers_are_seldom_flagged(running: Running) -> None:
    flags = people_flags(running)
    assert sum(len(of) > 0 for of in flags.values()) <= 8  # 4 tests at 1 %, and more than chance


def rehearsed(design: Design, seed: int) -> nc.scaling.Scale:
    """The same observers' scale, without a server: what they choose hangs on numbers alone."""
    table: dict[str, list[str]] = {"left": [], "right": [], "chosen": [], "person": []}
    for number in range(OBSERVERS):
        plan = trials(design, number)
        asked = [trial.stimuli for trial in plan]
        values = scale_of("paper")
        for trial, one in zip(
            plan, responses(TASKS["pair"], asked, values, number, seed=seed, sigma=1.0), strict=True
        ):
            if trial.kind in ("pair", "repeat"):
                row = (*trial.stimuli, one.given, str(number))
                for column, value in zip(table.values(), row, strict=True):
                    column.append(value)
    return nc.scaling.thurstone(nc.scaling.Answers.of_table(table, repeats=True))


def test_any_seed_gives_the_order_but_for_neighbours_and_covers_as_often_as_it_says() -> None:
    design, table = Design.load("paper"), scale_of("paper")
    covered = []
    for seed in (SEED, *OTHERS):
        fit = rehearsed(design, seed)
        assert is_table_1_but_for_neighbours(fit.ranking)
        truth = np.array([table[label] for label in fit.stimuli])
        low, high = fit.intervals(0.95, kind="people").T
        inside = (low <= truth) & (truth <= high)
        assert inside.sum() >= 5
        covered += inside.tolist()
    assert np.mean(covered) >= 0.85  # 0.94 with the seeds 1 to 60


@pytest.mark.slow
def test_the_server_gives_what_numbers_alone_give(running: Running) -> None:
    found = scale_so_far(running, "pearl-like", simulated=True)
    fit = rehearsed(running.frozen.design, SEED)
    for one in found.stimuli:
        assert one.value == pytest.approx(fit.scale[fit.stimuli.index(one.label)], abs=1e-9)

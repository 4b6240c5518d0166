"""A store written before tasks had a room of their own opens, and tells the same to the byte."""

import json
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from nacreous.scaling import thurstone
from nacreous.study.design import open_frozen
from nacreous.study.design.sitting import Sitting
from nacreous.study.plan import drawn_groups, trials
from nacreous.study.results import people_flags
from nacreous.study.running import Running
from nacreous.study.running.plans import plain
from nacreous.study.store import Store, answers_of, backup, export, restore

OLD = Path(__file__).parents[1] / "golden" / "store"


@pytest.fixture
def told() -> dict[str, Any]:
    """What was told of it then."""
    read: dict[str, Any] = json.loads((OLD / "results.json").read_text(encoding="utf-8"))
    return read


@pytest.fixture
def running(tmp_path: Path) -> Iterator[Running]:
    with closing(sqlite3.connect(tmp_path / "answers.sqlite")) as database:
        database.executescript((OLD / "answers.sql").read_text(encoding="utf-8"))
    with Store.open(tmp_path / "answers.sqlite") as store:
        yield Running(store, open_frozen(OLD / "study"))


def test_its_export_is_the_same_to_the_byte(running: Running, tmp_path: Path) -> None:
    """But for the one column that every export has had since."""

    def before(path: Path) -> bytes:
        text = path.read_bytes()
        assert b',"beforehand"' in text
        return text.replace(b',"pairs_chosen_by"', b"").replace(b',"beforehand"', b"")

    export(running.store, running.study, tmp_path / "answers.csv")
    assert before(tmp_path / "answers.csv") == (OLD / "answers.csv").read_bytes()
    export(running.store, running.study, tmp_path / "psych-ds")
    data = min((tmp_path / "psych-ds" / "data").iterdir(), key=lambda path: len(path.name))
    assert before(data) == (OLD / "answers.csv").read_bytes()
    record = "dataset_description.json"
    made, then = (
        json.loads((folder / record).read_text(encoding="utf-8"))
        for folder in (tmp_path / "psych-ds", OLD)
    )
    made["variableMeasured"] = [
        one for one in made["variableMeasured"] if one["name"] != "pairs_chosen_by"
    ]
    assert made == then


def test_its_flags_are_the_same(running: Running, told: dict[str, Any]) -> None:
    flags = {
        str(number): [[flag.kind, flag.detail] for flag in found]
        for number, found in people_flags(running).items()
    }
    assert flags == told["flags"]


def test_its_scales_are_the_same(running: Running, told: dict[str, Any]) -> None:
    """With ties as halves, as then; margins and what is said of the fit have become other since."""
    for then, simulated in zip(told["scale"], (False, True), strict=True):
        answers = answers_of(running.store, running.study, "deeper", simulated=simulated)
        assert (len(answers), len(answers.people)) == (then["answers"], then["people"])
        scale = thurstone(answers, ties=False).scale
        # Another processor may round the last bits otherwise.
        assert scale == pytest.approx([one["value"] for one in then["stimuli"]], abs=1e-9)


def test_whoever_entered_goes_on_with_the_same_plan(running: Running, told: dict[str, Any]) -> None:
    for session in running.store.sessions(running.study):
        stored = told["plans"][str(session.number)] if session.erased_at is None else None
        assert running.store.plan(session.id) == stored
        assert plain(running.plan(session), running.task) == (stored or [])


def test_whoever_enters_now_gets_the_plan_that_they_would_have_got(
    running: Running, told: dict[str, Any]
) -> None:
    design = running.frozen.design
    for session in running.store.sessions(running.study):
        if session.erased_at is None:
            assert (
                plain(trials(design, session.number), running.task)
                == told["plans"][str(session.number)]
            )
            assert session.groups == drawn_groups(design, session.number)


def test_a_backup_of_it_restores_to_the_same_rows(running: Running, tmp_path: Path) -> None:
    backup(tmp_path / "answers.sqlite", tmp_path / "backup.sqlite")
    restore(tmp_path / "backup.sqlite", tmp_path / "again.sqlite")
    with Store.open(tmp_path / "again.sqlite") as again:
        assert again.answers(running.study) == running.store.answers(running.study)


def test_its_study_goes_on_without_the_time_to_adapt_that_came_later(running: Running) -> None:
    assert running.frozen.design.sitting.adaptation_s == 0
    assert Sitting().adaptation_s == 60

"""Names and values of a study survive its exports: no two share a column, and none is lost."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nacreous.problem import InputError
from nacreous.scaling import Answers
from nacreous.study.design import Design, Frozen, freezing
from nacreous.study.design.exported_names import check_exported_names
from nacreous.study.results import exported_answers, report
from nacreous.study.results.scale import counted
from nacreous.study.store import Store, export
from nacreous.study.store.codebook import group_column
from nacreous.study.task.counting import DATA
from tests.support.gathering import by_scale, frozen_study, opened, take_part

#: Columns that somebody removes from an export.
GONE = (("kind",), ("simulated",), ("kind", "simulated", "excluded"))
ASKED = {"en": "Which?", "ja": "どれ?"}
SCALE = {"a": 0.5, "b": 0.0, "c": -0.5, "NA": -0.2}


def group(name: str, *values: str) -> dict[str, Any]:
    return {"name": name, "how": "recorded", "question": ASKED, "values": list(values)}


def frozen_before(
    folder: Path, monkeypatch: pytest.MonkeyPatch, labels: Any, **keys: Any
) -> Frozen:
    """A study frozen when such names were not refused yet."""
    monkeypatch.setattr(freezing, "check_exported_names", lambda *_: None)
    return frozen_study(folder, labels, **keys)


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        (
            {"groups": [group("group_left", "p", "q")]},
            'groups.0.name is "group_left"; allowed: a n',
        ),
        ({"groups": [group("group_new", "p", "q")]}, 'groups.0.name is "group_new"; allowed: a n'),
        *(
            ({"groups": [group("k", word, "1")]}, f"programs read {word} as an empty cell")
            for word in ("na", "nan", "null", "none", "undefined", "nat")
        ),
        ({"groups": [group("k", "na", "null")]}, "programs read na and null as an empty cell"),
        ({"questions": [{"id": "na", "text": ASKED}]}, 'questions.0.id is "na", which programs'),
    ],
)
def test_a_name_or_value_that_an_export_could_not_tell_is_refused_before_anybody_answers(
    tmp_path: Path, keys: dict[str, Any], said: str
) -> None:
    with pytest.raises(InputError) as caught:
        frozen_study(tmp_path, "ab", **keys)
    (line,) = str(caught.value).splitlines()
    assert said in line
    assert not (tmp_path / "study").exists()


@pytest.mark.parametrize("label", ["NA", "nan", "N/A", "#N/A", "-"])
def test_a_label_that_programs_read_as_an_empty_cell_is_refused(label: str) -> None:
    stimuli = [{"label": one, "pearl": "paper"} for one in ("a", label)]
    questions = [{"id": "q", "text": ASKED}]
    design = Design(purpose="demo", questions=questions, stimuli=stimuli)
    with pytest.raises(InputError) as caught:
        check_exported_names(design, "my.toml")
    said = f'my.toml: stimuli.1.label is "{label}", which programs read as an empty cell'
    assert str(caught.value).startswith(said)


def test_none_beside_words_and_poles_are_values_like_others(tmp_path: Path) -> None:
    frozen = frozen_study(tmp_path, "+-", groups=[group("training", "none", "some")])
    assert frozen.design.labels == ("+", "-")


def test_no_two_groups_have_one_column() -> None:
    own = ["at", "what", "who", "detail"]  # of the log
    names = ["left", "person", "trials", "flags", "simulated", "sex", *own]
    names += [f"group_{name}" for name in names] + [f"group_group_{name}" for name in names]
    assert len({group_column(name).name for name in names}) == len(names)
    assert {group_column(name).name for name in own}.isdisjoint(own)


def test_a_label_of_a_frozen_study_is_no_empty_cell_in_its_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frozen = frozen_before(tmp_path, monkeypatch, ["a", "b", "NA"])
    random = np.random.default_rng(8)
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for _ in range(12):
            take_part(running, by_scale(SCALE, random))
        assert counted(running, "deeper", simulated=False).stimuli == ("a", "b", "NA")
        assert '<b class="name">NA</b>' in report(running, "deeper")


def test_two_groups_of_a_frozen_study_are_both_in_every_export_and_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    groups = [group("left", "x", "y"), group("group_left", "p", "q")]
    frozen = frozen_before(tmp_path, monkeypatch, "abc", groups=groups)
    random = np.random.default_rng(8)
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for number in range(12):
            recorded = {"left": "xy"[number % 2], "group_left": "pq"[number % 3 == 0]}
            take_part(running, by_scale(SCALE, random), recorded)
        for table in ("answers", "people"):
            export(store, running.study, tmp_path / "out.csv", table=table)
            rows = list(csv.DictReader((tmp_path / "out.csv").read_text("utf-8").splitlines()))
            assert {row["group_left"] for row in rows} == {"x", "y"}
            assert {row["group_group_left"] for row in rows} == {"p", "q"}
        export(store, running.study, tmp_path / "psych")
        told = json.loads((tmp_path / "psych" / "dataset_description.json").read_text())
        described = {one["name"]: one["description"] for one in told["variableMeasured"]}
        assert described["group_left"] == "The person's group: left."
        assert described["group_group_left"] == "The person's group: group_left."
        for name, people in (("left", "6 people"), ("group_left", "8 people")):
            page = report(running, "deeper", group=name).split('id="groups"')[1]
            assert people in page


def test_a_declared_value_of_a_frozen_study_is_no_empty_cell_in_its_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    frozen = frozen_before(tmp_path, monkeypatch, "abc", groups=[group("region", "na", "eu")])
    random = np.random.default_rng(8)
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for number in range(12):
            take_part(running, by_scale(SCALE, random), {"region": ("na", "eu")[number % 2]})
        answers = counted(running, "deeper", simulated=False)
        assert answers.groups["region"].levels == ("eu", "na")
        assert (answers.groups["region"].code >= 0).all()
        assert "Not compared" not in report(running, "deeper", group="region")
        export(store, running.study, tmp_path / "out.csv")
    # A file may have been saved anew by a program that writes na into an empty cell: that is said.
    assert exported_answers(tmp_path / "out.csv").groups["region"].nothing == ("na",)


def test_labels_that_are_words_for_sides_are_labels_in_store_export_and_report(
    tmp_path: Path,
) -> None:
    scale = {"left": 0.8, "right": 0.0, "tie": -0.8}
    frozen = frozen_study(tmp_path, scale, sitting={"ties": True})
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for _ in range(6):
            take_part(running, by_scale(scale, np.random.default_rng(8)))
        wins = dict.fromkeys(scale, 0)
        for row in store.answers(running.study):
            wins[row[row["chosen"]]] += row["kind"] in DATA
        answers = counted(running, "deeper", simulated=False)
        export(store, running.study, tmp_path / "out.csv")
        assert "<html" in report(running, "deeper")
    for found in (answers, exported_answers(tmp_path / "out.csv")):
        matrix = found.comparisons().matrix
        assert dict(zip(found.stimuli, matrix.sum(axis=1), strict=True)) == wins


def test_an_export_is_never_read_as_answers_that_all_count(tmp_path: Path) -> None:
    frozen = frozen_study(tmp_path, "abc")
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        take_part(running, by_scale(SCALE, np.random.default_rng(8)))
        export(store, running.study, tmp_path / "out.csv")
    rows = list(csv.DictReader((tmp_path / "out.csv").read_text("utf-8").splitlines()))
    table = {name: [row[name] for row in rows] for name in rows[0]}
    tables = [
        table,
        *({name: table[name] for name in table if name not in gone} for gone in GONE),
        {name.title(): column for name, column in table.items()},
    ]
    names = {"left": "Left", "right": "Right", "chosen": "Chosen"}
    for one, called in zip(tables, ({}, {}, {}, {}, names), strict=True):
        with pytest.raises(InputError, match=r"of a study's export, which says? that not every"):
            Answers.of_table(one, **called)
    counting = {name: table[name] for name in ("left", "right", "chosen", "person")}
    assert len(Answers.of_table(counting)) == len(rows)


def test_an_export_below_itself_is_refused(tmp_path: Path) -> None:
    frozen = frozen_study(tmp_path, "abc")
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        take_part(running, by_scale(SCALE, np.random.default_rng(8)))
        export(store, running.study, tmp_path / "out.csv")
    head, *rows = (tmp_path / "out.csv").read_text("utf-8").splitlines()
    (tmp_path / "twice.csv").write_text("\n".join([head, *rows, *rows]), "utf-8")
    said = f"row {len(rows) + 2}: sequence is 1, as in row 2; allowed: each once"
    with pytest.raises(InputError, match=said):
        exported_answers(tmp_path / "twice.csv")

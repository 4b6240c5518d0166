"""Labels of a study are compared in one Unicode form, from its file to its scale."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image as Pillow

from nacreous.problem import InputError
from nacreous.server.rehearsal import _by_picture, scale_of
from nacreous.study.design import Design, freeze, open_frozen
from nacreous.study.design.manifest import hash_of
from nacreous.study.plan import Trial
from nacreous.study.running.plans import trials_of
from nacreous.study.task.pair.reading import answers, chosen_of, pair_of
from nacreous.study.task.tasks import TASKS

COMPOSED, APART = "caf\u00e9", "cafe\u0301"
WORDS = {"en": "Which?", "ja": "どちらですか。"}
STUDY: dict[str, Any] = {
    "purpose": "demo",
    "questions": [{"id": "q", "text": WORDS}],
    "stimuli": [{"label": APART, "picture": "a.png"}, {"label": "b", "picture": "b.png"}],
    "catches": [{"expected": COMPOSED, "against": "b"}],
}


def design(**changes: Any) -> Design:
    return Design.check(copy.deepcopy({**STUDY, **changes}), "my.toml", Path())


@pytest.fixture
def frozen(tmp_path: Path) -> Path:
    for name, grey in (("a", 50), ("b", 200)):
        Pillow.fromarray(np.full((32, 32, 3), grey, np.uint8)).save(tmp_path / f"{name}.png")
    (tmp_path / "my.toml").write_text(design().to_toml(), encoding="utf-8")
    freeze(tmp_path / "my.toml", tmp_path / "study")
    return tmp_path / "study"


def test_a_study_file_may_write_a_label_in_either_form() -> None:
    made = design()
    assert made.labels == (COMPOSED, "b")
    assert made.catches[0].expected == COMPOSED


@pytest.mark.parametrize(
    ("label", "said"),
    [
        (COMPOSED, 'stimuli.1.label is "café", as stimuli.0.label'),
        (f" {APART} ", 'stimuli.1.label is "café", as stimuli.0.label'),
        (" ", 'stimuli.1.label is " "; allowed: one line of 1 to 120 characters'),
        ("a\x1b[31m", "stimuli.1.label is"),
        ("a\u202eb", "stimuli.1.label is"),
    ],
)
def test_labels_that_no_scale_could_hold_apart_are_refused(label: str, said: str) -> None:
    stimuli = [STUDY["stimuli"][0], {"label": label, "picture": "b.png"}]
    with pytest.raises(InputError) as caught:
        design(stimuli=stimuli, catches=[])
    assert said in str(caught.value)
    assert all(letter.isprintable() for letter in str(caught.value).replace("\n", ""))


@pytest.mark.parametrize(("one", "other"), [("1", "1.0"), ("a b", "a  b"), ("a b", "a\u00a0b")])
def test_labels_that_look_alike_are_refused_before_anybody_answers(one: str, other: str) -> None:
    stimuli = [{"label": label, "picture": "a.png"} for label in (one, other)]
    with pytest.raises(InputError, match="which looks like stimuli"):
        design(stimuli=stimuli, catches=[])


def test_japanese_prose_may_have_its_own_spaces() -> None:
    text = "\u3000これは調査です。\n\u3000任意です。"
    assert design(consent={"en": "Free.", "ja": text}).consent.ja == text


def test_a_study_that_was_frozen_in_the_other_form_opens_in_this_one(frozen: Path) -> None:
    manifest = json.loads((frozen / "study.json").read_text(encoding="utf-8"))
    manifest["stimuli"][0]["label"] = manifest["design"]["stimuli"][0]["label"] = APART
    manifest["design_hash"] = hash_of(manifest["design"])
    manifest.pop("study_hash")
    manifest["study_hash"] = hash_of(manifest)
    (frozen / "study.json").write_text(json.dumps(manifest), encoding="utf-8")
    found = open_frozen(frozen)
    assert [stimulus.label for stimulus in found.stimuli] == list(found.design.labels)
    assert found.path(APART) == found.path(COMPOSED)
    plan = [{"number": 0, "question": "q", "left": APART, "right": "b", "kind": "pair"}]
    [trial] = trials_of([{**plan[0], "block": 1, "break_before": False}], TASKS["pair"])
    assert trial == Trial(0, "q", (COMPOSED, "b"), "pair", 1, False)


def test_stored_answers_are_read_in_one_form() -> None:
    row: dict[str, Any] = {"left": APART, "right": "b", "chosen": "left", "response_ms": None}
    row |= {"person": "3", "trial": 1}
    assert (chosen_of(row), pair_of(row)) == (COMPOSED, {COMPOSED, "b"})  # type: ignore[arg-type]
    columns = {name: [value] for name, value in row.items()}
    assert answers(columns, {}).stimuli == ("b", COMPOSED)


def test_observers_scale_is_read_in_one_form(frozen: Path, tmp_path: Path) -> None:
    (tmp_path / "scale.csv").write_text(f"stimulus,scale\n {APART},1\nb,-1\n", encoding="utf-8")
    scale = scale_of(str(tmp_path / "scale.csv"))
    assert scale == {COMPOSED: 1.0, "b": -1.0}
    study = open_frozen(frozen)
    assert set(_by_picture(study, {APART: 1.0, "b": -1.0}).values()) == {1.0, -1.0}
    with pytest.raises(InputError, match='scale has no value for "b"; it has: "café"'):
        _by_picture(study, {APART: 1.0})

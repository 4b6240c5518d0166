"""Study files: every key refuses what it must, in words that name file, key and range."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest

import nacreous as nc
from nacreous.paper import crop
from nacreous.spec.key import Key, alternatives, every_key, sections_in
from nacreous.study.design import Design
from nacreous.study.design.multilingual import Words
from nacreous.study.design.stimulus import CROPS
from nacreous.study.plan import repetitions, trials

ROOT = Path(__file__).parent.parent.parent

WORDS = {"en": "Which looks more like a pearl?", "ja": "どちらがより真珠らしく見えますか。"}

#: A study that says everything that can be said.
WHOLE: dict[str, Any] = {
    "name": "whole",
    "consent": WORDS,
    "instructions": WORDS,
    "stimuli": [
        {"label": "r", "pearl": "akoya-r", "scene": "booth", "overrides": ["depth=0.8"]},
        {"label": "g", "pearl": "akoya-g"},
        {"label": "photograph", "picture": "photograph.png", "width_mm": 40.0},
        {"label": "crop", "pearl": "paper", "cut": "seven-crops"},
    ],
    "questions": [{"id": "pearl-like", "text": WORDS}, {"id": "deeper", "text": WORDS}],
    "pairs": {"kind": "incomplete", "number": 20, "repeats": 3},
    "catches": [{"expected": "r", "against": "crop 7", "question": "deeper"}],
    "groups": [
        {
            "name": "trade",
            "values": ["yes", "no"],
            "how": "recorded",
            "question": WORDS,
            "choices": [WORDS, WORDS],
            "notes": [{}, WORDS],
        },
        {"name": "real-pearl", "values": ["shown", "not-shown"], "notes": [WORDS, {}]},
    ],
    "sitting": {"ties": True},
    "screen": {"vision": ["contrast", "colour"], "if_vision": "refuse", "card": False},
    "entry": {"parameters": ["PROLIFIC_PID"]},
    "completion": {"code": "C1X9", "return_url": "https://platform.example/?cc={CODE}"},
}
KEYS = list(every_key(Design))
LEAVES = [key for key in KEYS if not sections_in(key.field.annotation)]
NUMBERS = [key for key in LEAVES if set(alternatives(key.field.annotation)) <= {int, float}]
TABLES = sorted({key.path.rpartition(".")[0] for key in KEYS})


def with_key(path: str, value: Any) -> dict[str, Any]:
    """The whole study with one key changed."""
    values = json.loads(json.dumps(WHOLE))  # no table stands in two places
    target: Any = values
    *steps, last = path.split(".")
    for step in steps:
        target = target[int(step)] if isinstance(target, list) else target.setdefault(step, {})
    target[last] = value
    return values


def problems(values: dict[str, Any]) -> list[str]:
    with pytest.raises(nc.InputError) as caught:
        Design.check(values, "my.toml", Path())
    lines = str(caught.value).splitlines()
    assert all(line.startswith("my.toml: ") for line in lines)
    return lines


def words_of(key: Key) -> str:
    extra = key.field.json_schema_extra
    assert isinstance(extra, dict)
    return str(extra["allowed"])


def test_the_whole_study_is_valid_and_written_out_is_itself() -> None:
    design = Design.check(copy.deepcopy(WHOLE), "my.toml", Path())
    assert Design.from_toml(design.to_toml()) == design
    assert design.labels == ("r", "g", "photograph", *(f"crop {k}" for k in range(1, 8)))


@pytest.mark.parametrize("key", KEYS, ids=lambda key: key.path)
def test_every_key_says_what_it_means(key: Key) -> None:
    assert key.field.description


@pytest.mark.parametrize("key", NUMBERS, ids=lambda key: key.path)
def test_every_number_refuses_what_is_outside_its_range(key: Key) -> None:
    marks = {type(mark).__name__: mark for mark in key.field.metadata}
    for value in (marks["Ge"].ge - 1, marks["Le"].le + 1, float("nan"), True, "3", [3]):
        (line,) = problems(with_key(key.path, value))
        assert line.startswith(f"my.toml: {key.path} is ")
        assert words_of(key) in line


@pytest.mark.parametrize("key", LEAVES, ids=lambda key: key.path)
def test_every_key_refuses_what_is_of_another_kind(key: Key) -> None:
    switch = set(alternatives(key.field.annotation)) == {bool}
    for value in ("yes" if switch else True, {"a": 1}, [[]]):
        (line, *_) = problems(with_key(key.path, value))
        assert line.startswith(f"my.toml: {key.path}")


@pytest.mark.parametrize("table", TABLES, ids=lambda table: table or "file")
def test_a_mistyped_key_is_offered_the_nearest(table: str) -> None:
    owner = next(key.owner for key in KEYS if key.path.rpartition(".")[0] == table)
    name = max(owner.model_fields, key=len)
    path = f"{table}.{name}x".removeprefix(".")
    (line, *_) = problems(with_key(path, 1))
    assert line == f"my.toml: {path} is not a key here; did you mean {name}?"


CONTRADICTIONS = {
    "stimuli.0.label is missing": {
        "stimuli": [{"pearl": "paper"}, {"label": "b", "pearl": "paper"}]
    },
    "stimuli.0.pearl is missing: give it, or give picture": {
        "stimuli": [{"label": "a"}, {"label": "b", "pearl": "paper"}]
    },
    "stimuli.1.picture cannot stand beside stimuli.1.pearl": {
        "stimuli": [
            {"label": "a", "pearl": "paper"},
            {"label": "b", "pearl": "paper", "picture": "b.png"},
        ]
    },
    "stimuli.0.scene cannot stand beside stimuli.0.picture": {
        "stimuli": [
            {"label": "a", "picture": "a.png", "scene": "booth"},
            {"label": "b", "pearl": "paper"},
        ]
    },
    'stimuli.1.label is "a", as stimuli.0.label': {
        "stimuli": [{"label": "a", "pearl": "paper"}, {"label": "a", "pearl": "paper"}]
    },
    "stimuli are 1 together; allowed: 2 to 64": {"stimuli": [{"label": "a", "pearl": "paper"}]},
    "stimuli are 70 together": {
        "stimuli": [{"label": f"{k}", "pearl": "paper", "cut": "seven-crops"} for k in range(10)]
    },
    'stimuli.0.pearl is "akoya-q"; allowed: a pearl preset or a path ending in .toml; did you': {
        "stimuli": [{"label": "a", "pearl": "akoya-q"}, {"label": "b", "pearl": "paper"}]
    },
    'questions.1.id is "q", as questions.0.id': {
        "questions": [{"id": "q", "text": WORDS}, {"id": "q", "text": WORDS}]
    },
    'questions.0.text.ja is missing while languages has "ja"': {
        "questions": [{"id": "q", "text": {"en": "Which?"}}]
    },
    "questions.0.text is missing; allowed: a table with en and ja": {"questions": [{"id": "q"}]},
    "questions is []": {"questions": []},
    'consent.en is " "; allowed: text': {"consent": {"en": " ", "ja": "同意"}},
    "consent.ja is missing": {"consent": {"en": "I agree."}},
    'languages are ["en", "en"]; allowed: each once': {"languages": ["en", "en"]},
    'pairs.number is missing while pairs.kind is "incomplete"': {"pairs": {"kind": "incomplete"}},
    'pairs.number is 5 while pairs.kind is "all"': {"pairs": {"number": 5}},
    'pairs.choice is "drawn" while pairs.kind is "all"': {"pairs": {"choice": "drawn"}},
    "pairs.number is 8; allowed: 9 to 45": {"pairs": {"kind": "incomplete", "number": 8}},
    "pairs.number is 46; allowed: 9 to 45": {"pairs": {"kind": "incomplete", "number": 46}},
    "pairs.repeats is 46; allowed: 0 to 45": {"pairs": {"repeats": 46}},
    "pairs.repeat_share cannot stand beside pairs.repeats": {
        "pairs": {"repeats": 2, "repeat_share": 0.1}
    },
    'catches.0.against is "gg", which is none of stimuli; did you mean "g"?': {
        "catches": [{"expected": "r", "against": "gg"}]
    },
    'catches.0.question is "deepr", which is none of questions; did you mean "deeper"?': {
        "catches": [{"expected": "r", "against": "g", "question": "deepr"}]
    },
    'catches.0.against is "r", as catches.0.expected': {
        "catches": [{"expected": "r", "against": "r"}]
    },
    'groups.0.values are ["a", "a"]; allowed: each once': {
        "groups": [{"name": "x", "values": ["a", "a"]}]
    },
    'groups.0.question is missing while groups.0.how is "recorded"': {
        "groups": [{"name": "x", "values": ["a", "b"], "how": "recorded"}]
    },
    'groups.0.question is given while groups.0.how is "randomised"': {
        "groups": [{"name": "x", "values": ["a", "b"], "question": WORDS}]
    },
    "groups.0.choices are 1; allowed: 2": {
        "groups": [
            {
                "name": "x",
                "values": ["a", "b"],
                "how": "recorded",
                "question": WORDS,
                "choices": [WORDS],
            }
        ]
    },
    "groups.0.notes are 1; allowed: 2, one for each value": {
        "groups": [{"name": "x", "values": ["a", "b"], "notes": [WORDS]}]
    },
    "groups.0.notes.1.ja is missing while languages has": {
        "groups": [{"name": "x", "values": ["a", "b"], "notes": [{}, {"en": "Take it."}]}]
    },
    'screen.if_no_card is "refuse" while screen.card is false; nobody would be asked': {
        "screen": {"card": False, "if_no_card": "refuse"}
    },
    "screen.vision has contrast while display.background_code is 59": {
        "screen": {"vision": ["contrast"]},
        "display": {"background_code": 59},
    },
    "screen.least_distance_mm is 900.0, not below screen.most_distance_mm": {
        "screen": {"least_distance_mm": 900, "most_distance_mm": 900}
    },
    'screen.if_no_distance is "refuse" while screen.distance is false': {
        "screen": {"distance": False, "if_no_distance": "refuse"}
    },
    'screen.if_not_full_screen is "refuse" while screen.full_screen is false': {
        "screen": {"full_screen": False, "if_not_full_screen": "refuse"}
    },
    'screen.if_levels is "refuse" while screen.levels is false': {
        "screen": {"levels": False, "if_levels": "refuse"}
    },
    'screen.if_vision is "refuse" while screen.vision is []': {"screen": {"if_vision": "refuse"}},
    'screen.vision are ["colour", "colour"]; allowed: each once': {
        "screen": {"vision": ["colour", "colour"]}
    },
    "screen.least_gamma is 2.8, not below screen.most_gamma": {"screen": {"least_gamma": 2.8}},
    'groups.1.name is "x", as groups.0.name': {
        "groups": [{"name": "x", "values": ["a", "b"]}, {"name": "x", "values": ["a", "b"]}]
    },
    "groups make 256 combinations by lot; allowed: at most 200": {
        "groups": [{"name": f"x{k}", "values": ["a", "b"]} for k in range(8)]
    },
    "display.samples is 15; allowed: a square number": {"display": {"samples": 15}},
}


@pytest.mark.parametrize("said", CONTRADICTIONS)
def test_keys_that_cannot_both_be_right_are_refused(said: str) -> None:
    values = {**copy.deepcopy(WHOLE), **CONTRADICTIONS[said]}
    if "stimuli" in CONTRADICTIONS[said]:  # nothing else names them
        values |= {"pairs": {}, "catches": []}
    if "questions" in CONTRADICTIONS[said]:
        values["catches"] = []
    assert any(line.startswith(f"my.toml: {said}") for line in problems(values))


@pytest.mark.parametrize("name", ["consent", "instructions", "stimuli", "questions"])
def test_what_a_study_must_have_is_named(name: str) -> None:
    values = copy.deepcopy(WHOLE)
    del values[name]
    (line,) = problems(values)
    assert line.startswith(f"my.toml: {name} is missing; allowed: ")


def test_a_demonstration_brings_its_own_consent_and_instructions() -> None:
    values = copy.deepcopy(WHOLE) | {"purpose": "demo"}
    del values["consent"], values["instructions"]
    design = Design.check(values, "my.toml", Path())
    assert "demonstration" in design.consent.in_language("en")
    assert "デモ" in design.consent.in_language("ja")


def test_one_language_needs_no_words_in_the_other() -> None:
    values = copy.deepcopy(WHOLE) | {"languages": ["ja"], "consent": {"ja": "同意"}}
    assert Design.check(values, "my.toml", Path()).consent.en is None


def test_a_pearl_file_is_no_study() -> None:
    with pytest.raises(nc.InputError, match="is a pearl file; wanted: a study file"):
        Design.check({"depth": 0.5}, "my.toml", Path())


def test_figure_2_has_as_many_crops_as_a_stimulus_promises() -> None:
    assert crop.COUNT == CROPS


def test_the_page_names_every_key_with_its_default_and_range() -> None:
    page = (ROOT / "docs" / "study.md").read_text(encoding="utf-8")
    for key in KEYS:
        extra, name = key.field.json_schema_extra, key.path.rpartition(".")[2]
        if not isinstance(extra, dict) or key.owner is Words:
            continue
        if key.field.is_required():
            written = "required"
        else:
            default = key.field.default
            written = "–" if default is None else f"`{json.dumps(default)}`"
        assert f"| `{name}` | {written} | {extra['allowed']} | " in page


def test_the_study_of_the_page_is_valid() -> None:
    page = (ROOT / "docs" / "study.md").read_text(encoding="utf-8")
    sample = page.partition("```toml\n")[2].partition("```")[0]
    design = Design.from_toml(sample)
    assert design.labels == ("R", "RG", "G", "RG, dull", "thin")
    assert repetitions(trials(design, 0)) == 0

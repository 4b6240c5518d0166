"""Study files and frozen studies: every bad key is refused, every change is seen."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image as Pillow

import nacreous as nc
from nacreous import cli
from nacreous.paper import crop
from nacreous.spec import Pearl, Scene
from nacreous.spec.key import Key, alternatives, every_key, sections_in
from nacreous.study.design import Design, freeze, open_frozen
from nacreous.study.design.manifest import hash_of
from nacreous.study.design.stimulus import CROPS
from nacreous.study.design.words import Words
from nacreous.study.plan import repetitions, trials

ROOT = Path(__file__).parent.parent

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
        },
        {"name": "real-pearl", "values": ["shown", "not-shown"]},
    ],
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
    for value in (True, {"a": 1}, [[]]):
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


# --- freezing -----------------------------------------------------------------------------------

SMALL = """
purpose = "demo"
questions = [{ id = "deeper", text = { en = "Which is deeper?", ja = "どちらが深いですか。" } }]

[[stimuli]]
label = "own"
pearl = "own.toml"
overrides = ["depth=0.9", "camera.elevation_deg=20"]

[[stimuli]]
label = "photograph"
picture = "photograph.png"
width_mm = 33.0

[[stimuli]]
label = "crop"
pearl = "paper"
cut = "seven-crops"

[display]
size_px = 96
samples = 1
"""


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a small study and what it names; commands run elsewhere."""
    place = tmp_path / "desk"
    place.mkdir()
    (place / "small.toml").write_text(SMALL, encoding="utf-8")
    (place / "own.toml").write_text('name = "own"\nmodel = "illuminant"\ngrain = 0.0\n')
    pixels = np.random.default_rng(1).integers(0, 256, (20, 30, 3), np.uint8)
    Pillow.fromarray(pixels).save(place / "photograph.png")
    monkeypatch.chdir(tmp_path)
    return place


def files_of(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def test_same_file_same_bytes_wherever_it_runs(desk: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    freeze("desk/small.toml", "one")
    monkeypatch.chdir(desk)
    freeze("small.toml", "two")
    assert files_of(desk.parent / "one") == files_of(desk / "two")
    assert str(desk) not in (desk / "two" / "study.json").read_text(encoding="utf-8")


def test_the_manifest_keeps_its_contract(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    manifest = json.loads(Path("out/study.json").read_text(encoding="utf-8"))
    assert manifest["nacreous_study"] == 1
    assert manifest["design_hash"] == hash_of(manifest["design"]) == frozen.design_hash
    assert manifest["design"]["sitting"]["break_every"] == 30
    assert manifest["design"]["stimuli"][0]["pearl"] == "own.toml"
    labels = ["own", "photograph", *(f"crop {number}" for number in range(1, 8))]
    assert [stimulus["label"] for stimulus in manifest["stimuli"]] == labels
    for stimulus in manifest["stimuli"]:
        path = Path("out") / stimulus["file"]
        assert path.name == f"{stimulus['sha256']}.png"
        with Pillow.open(path) as picture:
            assert picture.size == (stimulus["width_px"], stimulus["height_px"])
    assert [stimulus.width_mm for stimulus in frozen.stimuli[:3]] == [60.0, 33.0, 60.0]
    assert len(files_of(Path("out"))) == 1 + len({stimulus.sha256 for stimulus in frozen.stimuli})


def test_a_stimulus_is_made_again_from_its_recipe(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    recipe = frozen.stimuli[0].recipe
    assert recipe is not None
    pearl, scene = Pearl.from_toml(recipe["pearl"]), Scene.from_toml(recipe["scene"])
    assert (pearl.name, pearl.depth, scene.camera.elevation_deg) == ("own", 0.9, 20.0)
    settings = recipe["settings"]
    codes, _ = nc.render(pearl, scene, settings["size"], settings["samples"]).develop()
    assert np.array_equal(codes, np.asarray(Pillow.open(frozen.path("own"))))


def test_a_picture_that_is_brought_keeps_its_pixels(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    assert frozen.stimuli[1].recipe is None
    before, after = Pillow.open(desk / "photograph.png"), Pillow.open(frozen.path("photograph"))
    assert np.array_equal(np.asarray(before), np.asarray(after))


def test_no_stimulus_tells_a_participant_what_it_is(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    for stimulus in frozen.stimuli:
        assert nc.file.read_png_text(frozen.path(stimulus.label)) == {}


def test_a_frozen_study_opens_as_it_was_made(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    assert open_frozen("out") == frozen
    assert frozen.design.labels == tuple(stimulus.label for stimulus in frozen.stimuli)


@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace('"label": "own"', '"label": "one"'),
        lambda text: text.replace("Which is deeper?", "Which is worse?"),
        lambda text: text.replace('"width_mm": 33.0', '"width_mm": 34.0'),
        lambda text: text.replace('"study_hash": "', '"study_hash": "0'),
        lambda text: text.replace('"study_hash"', '"study_mash"'),
        lambda text: text.replace('"stimuli"', '"stimulus"'),
    ],
)
def test_a_changed_manifest_is_noticed(desk: Path, change: Callable[[str], str]) -> None:
    freeze(desk / "small.toml", "out")
    record = Path("out/study.json")
    text = record.read_text(encoding="utf-8")
    assert change(text) != text
    record.write_text(change(text), encoding="utf-8")
    with pytest.raises(nc.InputError) as caught:
        open_frozen("out")
    assert str(caught.value).endswith(
        "study.json: has been changed since it was frozen; wanted: as it was made"
    )


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"made_by": "somebody"}', "\xff"])
def test_what_is_no_manifest_is_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "study.json").write_text(text, encoding="latin-1")
    with pytest.raises(nc.InputError, match="is no manifest; wanted: one that"):
        open_frozen(tmp_path)


def test_a_manifest_of_another_version_is_refused(desk: Path) -> None:
    freeze(desk / "small.toml", "out")
    record = Path("out/study.json")
    text = record.read_text(encoding="utf-8")
    record.write_text(text.replace('"nacreous_study": 1', '"nacreous_study": 2'), encoding="utf-8")
    with pytest.raises(nc.InputError, match="nacreous_study is 2; allowed: 1"):
        open_frozen("out")


def test_a_changed_or_missing_stimulus_is_noticed(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    path = frozen.path("photograph")
    path.write_bytes(path.read_bytes() + b"\0")
    with pytest.raises(nc.InputError, match='the picture of "photograph" has been changed'):
        open_frozen("out")
    path.unlink()
    with pytest.raises(nc.InputError, match="cannot be read"):
        open_frozen("out")


def test_a_study_is_never_frozen_over_another_nor_among_other_files(desk: Path) -> None:
    freeze(desk / "small.toml", "out")
    before = files_of(Path("out"))
    with pytest.raises(nc.InputError, match="holds a study that is frozen already"):
        freeze(desk / "small.toml", "out")
    assert files_of(Path("out")) == before
    with pytest.raises(nc.InputError, match="wanted: an empty folder"):
        freeze(desk / "small.toml", desk)
    Path("empty").mkdir()
    freeze(desk / "small.toml", "empty")
    assert files_of(Path("empty")) == before


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"own.toml"', '"none.toml"', "stimuli.0: "),
        ("depth=0.9", "depht=0.9", "stimuli.0: overrides: depht is not a key here; did you mean"),
        ("depth=0.9", "depth=9", "stimuli.0: overrides: depth is 9; allowed: 0 to 1"),
        ('"photograph.png"', '"none.png"', "stimuli.1: "),
        ('"photograph.png"', '"huge.png"', "stimuli.1: picture has 4097 x 2 pixels; allowed: up"),
        ("size_px = 96", "size_px = 32", "stimuli.2: radius is"),
        ('pearl = "paper"', 'pearl = "paper"\nscene = "two-tier"', "stimuli.2: scene has rows"),
    ],
)
def test_what_a_study_names_and_cannot_be_used_leaves_nothing(
    desk: Path, old: str, new: str, said: str
) -> None:
    Pillow.new("RGB", (4097, 2)).save(desk / "huge.png")
    assert old in SMALL
    (desk / "bad.toml").write_text(SMALL.replace(old, new), encoding="utf-8")
    with pytest.raises(nc.InputError) as caught:
        freeze("desk/bad.toml", "out")
    (line,) = str(caught.value).splitlines()
    assert line.startswith(f"desk/bad.toml: {said}")
    assert not Path("out").exists()
    assert list(Path().glob(".nacreous-*")) == []


def test_crops_of_a_rendered_file_are_those_of_the_pearl(desk: Path) -> None:
    nc.render("paper", "paper", 96, 1).save(desk / "rendered.png")
    text = SMALL.replace(
        'label = "crop"\npearl = "paper"', 'label = "crop"\npicture = "rendered.png"'
    )
    (desk / "cut.toml").write_text(text, encoding="utf-8")
    rendered, read = freeze(desk / "small.toml", "a"), freeze(desk / "cut.toml", "b")
    assert [s.sha256 for s in rendered.stimuli] == [s.sha256 for s in read.stimuli]


# --- the command --------------------------------------------------------------------------------


def test_the_command_freezes_and_says_what_a_participant_sees(desk: Path, capsys: Any) -> None:
    assert cli.main(["study", "new", "desk/small.toml", "-o", "out"]) == 0
    line = capsys.readouterr().out
    assert line.startswith("out: study study, 9 stimuli, 39 trials a participant, ")
    assert open_frozen("out").study_hash[:12] in line


def test_the_command_says_where_three_stimuli_must_repeat(desk: Path, capsys: Any) -> None:
    text = SMALL.replace('cut = "seven-crops"', "")
    (desk / "three.toml").write_text(text, encoding="utf-8")
    assert cli.main(["study", "new", "desk/three.toml", "-o", "out"]) == 0
    assert "a stimulus is shown twice in a row 5 times" in capsys.readouterr().out


def test_an_adaptive_study_is_refused_for_now_and_not_frozen(desk: Path, capsys: Any) -> None:
    text = SMALL + '\n[pairs]\nkind = "adaptive"\nnumber = 20\n'
    (desk / "adaptive.toml").write_text(text, encoding="utf-8")
    assert cli.main(["study", "new", "desk/adaptive.toml", "-o", "out"]) == 2
    assert 'pairs.kind is "adaptive", for which there is no plan yet' in capsys.readouterr().err
    assert not Path("out").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [(["study"], "ACTION"), (["study", "nwe"], "nwe"), (["study", "new", "papre"], "paper")],
)
def test_bad_arguments_end_with_code_2(capsys: Any, arguments: list[str], said: str) -> None:
    assert cli.main(arguments) == 2
    assert said in capsys.readouterr().err

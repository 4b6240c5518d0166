"""Frozen studies: all of a folder or nothing, the same bytes again, and every change is seen."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image as Pillow

import nacreous as nc
from nacreous import cli
from nacreous.spec import Pearl, Scene
from nacreous.study.design import freeze, open_frozen
from nacreous.study.design.manifest import hash_of
from nacreous.study.design.outside import files_outside

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


_OVERRIDES = 'overrides = ["depth=0.9", "camera.elevation_deg=20"]'


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


def test_words_of_the_trade_are_frozen_with_the_numbers_that_they_set(desk: Path) -> None:
    given = 'overrides = ["shininess=0.4"]\nwords = ["luster=fair", "size=7.0-7.5"]'
    (desk / "small.toml").write_text(SMALL.replace(_OVERRIDES, given), encoding="utf-8")
    recipe = freeze(desk / "small.toml", "out").stimuli[0].recipe
    assert recipe is not None
    assert recipe["words"] == {
        "luster=fair": {"surface.facet_spread_rad": 0.116},
        "size=7.0-7.5": {"diameter_mm": 7.25},
    }
    pearl = Pearl.from_toml(recipe["pearl"])
    assert (pearl.surface.facet_spread_rad, pearl.shininess, pearl.diameter_mm) == (
        0.116,
        0.4,
        7.25,
    )


def test_a_picture_that_is_brought_keeps_its_pixels(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    assert frozen.stimuli[1].recipe is None
    before, after = Pillow.open(desk / "photograph.png"), Pillow.open(frozen.path("photograph"))
    assert np.array_equal(np.asarray(before), np.asarray(after))


def test_no_stimulus_tells_a_participant_what_it_is(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    for stimulus in frozen.stimuli:
        text = nc.file.read_png_text(frozen.path(stimulus.label))
        assert text == {"width_mm": str(stimulus.width_mm)}


def test_a_frozen_study_opens_as_it_was_made(desk: Path) -> None:
    frozen = freeze(desk / "small.toml", "out")
    assert open_frozen("out") == frozen
    assert frozen.design.labels == tuple(stimulus.label for stimulus in frozen.stimuli)


def test_one_picture_in_two_widths_is_two_stimuli(desk: Path) -> None:
    twice = SMALL.replace(
        'label = "photograph"',
        'label = "larger"\npicture = "photograph.png"\n'
        'width_mm = 66\n\n[[stimuli]]\nlabel = "photograph"',
    )
    (desk / "twice.toml").write_text(twice, encoding="utf-8")
    frozen = freeze(desk / "twice.toml", "twice")
    larger, smaller = frozen.stimuli[1:3]
    assert (larger.width_mm, smaller.width_mm) == (66.0, 33.0)
    assert larger.sha256 != smaller.sha256
    with Pillow.open(frozen.path("larger")) as one, Pillow.open(frozen.path("photograph")) as two:
        assert one.tobytes() == two.tobytes()


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


def test_a_manifest_with_a_key_twice_is_refused(desk: Path) -> None:
    """The last one is as it was made; another program may keep the first."""
    freeze(desk / "small.toml", "out")
    record = Path("out/study.json")
    text = record.read_text(encoding="utf-8").replace("{", '{"made_by": "me",', 1)
    record.write_text(text, encoding="utf-8")
    with pytest.raises(nc.InputError, match=r'study\.json: "made_by" is given twice; allowed: on'):
        open_frozen("out")


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


def test_a_frozen_folder_holds_its_files_and_no_links_or_paths_to_others(
    desk: Path, tmp_path: Path
) -> None:
    folder = desk / "out"
    frozen = freeze(desk / "small.toml", folder)
    [first, *_] = frozen.stimuli
    elsewhere = tmp_path / "elsewhere"
    for name in (first.file, "stimuli", "study.json"):
        (folder / name).rename(elsewhere)
        (folder / name).symlink_to(elsewhere)
        with pytest.raises(nc.InputError, match=f"is a link to {elsewhere}; wanted: as"):
            open_frozen(folder)
        (folder / name).unlink()
        elsewhere.rename(folder / name)
    assert open_frozen(folder).study_hash == frozen.study_hash
    manifest = json.loads((folder / "study.json").read_text(encoding="utf-8"))
    (tmp_path / "out.png").write_bytes((folder / first.file).read_bytes())
    for path in ("../../out.png", str(tmp_path / "out.png"), f"stimuli/../{first.file}", 7):
        manifest["stimuli"][0]["file"] = path
        del manifest["study_hash"]
        manifest["study_hash"] = hash_of(manifest)
        (folder / "study.json").write_text(json.dumps(manifest), encoding="utf-8")
        with pytest.raises(nc.InputError, match=r'file of "own" is .*; allowed: stimuli/ and its'):
            open_frozen(folder)


def test_a_pipe_in_a_frozen_folder_is_refused_and_nobody_waits_for_it(desk: Path) -> None:
    folder = desk / "out"
    frozen = freeze(desk / "small.toml", folder)
    for name in (frozen.stimuli[0].file, "study.json"):
        (folder / name).unlink()
        os.mkfifo(folder / name)
        with pytest.raises(nc.InputError, match=f"{name}: is no ordinary file; wanted: as"):
            open_frozen(folder)
    with pytest.raises(nc.InputError, match="holds a study that is frozen already"):
        freeze(desk / "small.toml", folder)


@pytest.mark.parametrize("named", ["photograph.png", "own.toml"])
def test_a_pipe_that_a_study_names_is_refused_and_nobody_waits_for_it(
    desk: Path, named: str
) -> None:
    (desk / named).unlink()
    os.mkfifo(desk / named)
    with pytest.raises(nc.InputError, match=r"ordinary file|regular file"):
        freeze(desk / "small.toml", "out")


def test_files_from_outside_a_studys_folder_are_stated(desk: Path, tmp_path: Path) -> None:
    assert files_outside(desk / "small.toml") == []
    (desk / "photograph.png").rename(tmp_path / "holiday.png")
    (desk / "photograph.png").symlink_to(tmp_path / "holiday.png")
    (desk / "own.toml").rename(tmp_path / "own.toml")
    text = (desk / "small.toml").read_text(encoding="utf-8").replace("own.toml", "../own.toml")
    (desk / "small.toml").write_text(text, encoding="utf-8")
    found = [str(tmp_path / "holiday.png"), str(tmp_path / "own.toml")]
    assert files_outside(desk / "small.toml") == found


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
        (
            _OVERRIDES,
            'words = ["luster=Fare"]',
            'stimuli.0: words "luster=Fare": luster is "Fare"; did',
        ),
        (
            _OVERRIDES,
            'words = ["nacre-akoya=thin", "nacre-tahitian=thin"]',
            'stimuli.0: words "nacre-tahitian=thin": sets body.nacre_mm, as "nacre-akoya=thin"',
        ),
        ('"photograph.png"', '"none.png"\nwords = ["luster=Fair"]', "stimuli.1.words cannot"),
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


def test_an_adaptive_study_is_frozen_and_its_first_participant_told(
    desk: Path, capsys: Any
) -> None:
    text = SMALL + '\n[pairs]\nkind = "adaptive"\nnumber = 20\n'
    (desk / "adaptive.toml").write_text(text, encoding="utf-8")
    assert cli.main(["study", "new", "desk/adaptive.toml", "-o", "out"]) == 0
    assert "9 stimuli, 23 trials a participant" in capsys.readouterr().out
    assert open_frozen("out").design.pairs.kind == "adaptive"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [(["study"], "ACTION"), (["study", "nwe"], "nwe"), (["study", "new", "papre"], "paper")],
)
def test_bad_arguments_end_with_code_2(capsys: Any, arguments: list[str], said: str) -> None:
    assert cli.main(arguments) == 2
    assert said in capsys.readouterr().err

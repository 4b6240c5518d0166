"""Pearl and scene files: every key refuses what it must, in words that name file, key and range."""

from __future__ import annotations

import datetime as dt
import doctest
import json
import math
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_args

import pytest

import nacreous as nc
from nacreous.problem import InputError
from nacreous.spec import (
    Body,
    Film,
    Growth,
    Inside,
    Interference,
    Lamp,
    Layers,
    Pearl,
    Row,
    Scene,
    Surface,
    Uniaxial,
    Window,
    json_schema,
    load,
    medium,
    override,
    preset,
)
from nacreous.spec.body import Pigment
from nacreous.spec.key import Key, alternatives, every_key, sections_in
from nacreous.spec.model import only_with
from nacreous.study.design import Design

ROOT = Path(__file__).parent.parent.parent


def kinds_of(key: Key) -> tuple[Any, ...]:
    return alternatives(key.field.annotation)


FILES = (Pearl, Scene)
LISTED = {"lamps": Lamp, "rows": Row, "windows": Window}
KEYS = [(model, key) for model in FILES for key in every_key(model)]
LEAVES = [(model, key) for model, key in KEYS if not all(map(sections_in, kinds_of(key)))]
NUMBERS = [
    (model, key) for model, key in LEAVES if set(alternatives(key.field.annotation)) <= {int, float}
]
MEDIA = [case for case in LEAVES if sections_in(case[1].field.annotation)]
MODELS = {"transport": "illuminant", "illuminant": "transport"}


def name_of(case: Any) -> str:
    return f"{case[0].__name__}-{case[1].owner.__name__}.{case[1].path}"


def problems(act: Callable[[], Any]) -> list[str]:
    with pytest.raises(InputError) as caught:
        act()
    lines = str(caught.value).splitlines()
    assert lines
    for line in lines:
        for jargon in ("pydantic", "http", "Input should", "validation", "type=", "Traceback"):
            assert jargon not in line
    return lines


def file_with(model: type, key: Key, value: Any) -> dict[str, Any]:
    """The smallest file that holds the key; lamps, windows and listed layers need company."""
    values: dict[str, Any] = {}
    target = values
    *steps, last = key.path.split(".")
    for step in steps:
        target = target.setdefault(step, {}) if step != "0" else target
    if key.owner is Layers:
        target["thickness_nm"] = [400.0]
    if key.owner is Lamp and last != "position_mm":
        target |= {"azimuth_deg": 0.0, "elevation_deg": 0.0}
    if key.owner is Uniaxial:
        target |= {"n_o": 1.6, "n_e": 1.5}
    if key.path == "body.nacre_mm":
        values["diameter_mm"] = 30.0
    if home(key):
        values["model"] = home(key)
    if key.owner is Window and last not in ("position_mm", "facing", "below_mm"):
        target |= {"azimuth_deg": 0.0, "elevation_deg": 0.0}
    if last == "facing":
        target["position_mm"] = [0.0, 0.0, 99.0]
    if last == "below_mm":
        values["table"] = {"kind": "none"}
    target[last] = value
    for name, owner in LISTED.items():
        if name in values and key.owner is owner:
            values[name] = [values[name]]
    return values


def home(key: Key) -> str:
    """The model that the key or its section belongs to; "" where both have it."""
    fields = Pearl.model_fields
    section = fields.get(key.path.partition(".")[0]) if key.owner is not Pearl else None
    return only_with(key.field) or (only_with(section) if section else "")


def refusal(model: type, key: Key, value: Any) -> str:
    (line,) = problems(lambda: model.check(file_with(model, key, value), "my.toml", Path()))
    assert line.startswith(f"my.toml: {key.path}")
    assert " is " in line
    return line


def bounds(key: Key) -> tuple[float, float, list[float]]:
    """Lowest and highest bound, and the bounds that are themselves outside."""
    marks = {type(mark).__name__: mark for mark in key.field.metadata}
    low = marks["Ge"].ge if "Ge" in marks else marks["Gt"].gt
    high = marks["Le"].le if "Le" in marks else marks["Lt"].lt
    outside = [low] if "Gt" in marks else []
    return low, high, outside + ([high] if "Lt" in marks else [])


# --- the error table, complete because it walks every key ---------------------------------------


@pytest.mark.parametrize("case", LEAVES, ids=name_of)
@pytest.mark.parametrize("value", [True, {"a": 1}, [[]], dt.datetime(2026, 1, 1)])
def test_every_key_refuses_a_value_of_the_wrong_type(case: Any, value: Any) -> None:
    model, key = case
    if case in MEDIA and isinstance(value, dict):
        assert len(problems(lambda: model.check(file_with(model, key, value), "", Path()))) == 3
        return  # a table is of the right type here; the next test says what it holds
    line = refusal(model, key, value)
    assert key.field.json_schema_extra["allowed"] in line


@pytest.mark.parametrize("case", MEDIA, ids=name_of)
def test_a_medium_by_direction_says_which_of_its_indices_is_wrong(case: Any) -> None:
    model, key = case
    for value, words in (
        ({"n_o": 1.6}, ["n_e is missing; allowed: above 0 to 10"]),
        ({"n_o": -1, "n_e": True}, ["n_o is -1; allowed: above 0 to 10", "n_e is true; wanted"]),
        ({"n_o": 1.6, "n_e": 1.5, "ne": 1.5}, ["ne is not a key here; did you mean n_e?"]),
    ):
        values = file_with(model, key, value)
        lines = problems(lambda values=values: model.check(values, "my.toml", Path()))
        assert len(lines) == len(words)
        for line, word in zip(lines, words, strict=True):
            assert line.startswith(f"my.toml: {key.path}.{word}")


@pytest.mark.parametrize("case", MEDIA, ids=name_of)
def test_an_index_says_its_range(case: Any) -> None:
    for value in (0, -1.5, 10.5, math.nan, [1.5, -0.1], [1.5, 11], [1.5], [1.5, 0, 0]):
        line = refusal(*case, value)
        assert "; allowed: a number n above 0 to 10, [n, k] with k from 0 to 10" in line


@pytest.mark.parametrize(
    ("values", "line"),
    [
        ({"nacre": {"aragonite": "aragonit"}}, '"aragonit"; allowed: a number n above 0'),
        ({"nacre": {"aragonite": "aragonit"}}, 'did you mean "aragonite"?'),
        ({"nacre": {"protein": "chitine"}}, 'did you mean "chitin"?'),
        ({"body": {"pigment": "golden"}}, 'did you mean "gold"?'),
        ({"body": {"pigment": "blacklip"}}, 'did you mean "black-lip"?'),
        ({"surface": {"facets": "torrance"}}, 'did you mean "torrance-sparrow"?'),
        ({"model": "transprt"}, 'did you mean "transport"?'),
        ({"model": "paper"}, 'model is "paper"; allowed: "transport" or "illuminant"'),
    ],
)
def test_a_mistyped_name_is_offered_the_nearest(values: dict[str, Any], line: str) -> None:
    (said,) = problems(lambda: Pearl.check(values, "my.toml", Path()))
    assert line in said


def test_names_of_media_and_pigments_are_those_of_the_compiled_rooms() -> None:
    assert medium.NAMES == nc.medium.NAMES
    assert get_args(Pigment) == nc.body.PIGMENTS


# --- keys of one model ----------------------------------------------------------------------------


@pytest.mark.parametrize("case", [case for case in LEAVES if home(case[1])], ids=name_of)
def test_a_key_of_the_other_model_is_refused(case: Any) -> None:
    model, key = case
    default = key.field.default
    bound = bounds(key) if case in NUMBERS else None
    value = default if default is not None else bound[1] if bound else None
    values = file_with(model, key, value)
    assert model.check(dict(values), "my.toml", Path()).model == home(key)
    values["model"] = MODELS[home(key)]
    assert problems(lambda: model.check(values, "my.toml", Path())) == [
        f'my.toml: {key.path} is given while model is "{MODELS[home(key)]}"; '
        f'allowed: only with model = "{home(key)}"'
    ]


def test_transport_is_the_model_of_a_file_that_names_none() -> None:
    assert Pearl().model == "transport"
    (line,) = problems(lambda: Pearl.check({"body_colour": "#ffffff"}, "my.toml", Path()))
    assert line == (
        'my.toml: body_colour is given while model is "transport"; '
        'allowed: only with model = "illuminant"'
    )


def test_an_empty_table_of_the_other_model_is_refused_by_its_name() -> None:
    (line,) = problems(lambda: Pearl.from_toml("[interference]\n", "my.toml"))
    assert line.startswith('my.toml: interference is given while model is "transport"; ')
    (line,) = problems(lambda: Pearl(model="illuminant", film=Film()))
    assert line.startswith('Pearl: film is given while model is "illuminant"; ')


def test_every_key_of_the_other_model_has_its_line() -> None:
    text = 'body_colour = "#ffffff"\n[interference]\nmixing = 0.5\nthreshold = 0.1\n'
    lines = problems(lambda: Pearl.from_toml(text, "my.toml"))
    assert [line.split()[1] for line in lines] == [
        "body_colour",
        "interference.threshold",
        "interference.mixing",
    ]
    overrides = [("model", "illuminant")]
    lines = problems(lambda: Pearl.load("akoya-rg", overrides))
    assert [line.split(" is ")[0] for line in lines] == [
        "preset akoya-rg: film.outer_um",
        "preset akoya-rg: body.pigment",
        "preset akoya-rg: body.nacre_mm",
        "preset akoya-rg: nacre.aragonite",
    ]


@pytest.mark.parametrize(
    ("model", "nacre", "allowed"),
    [
        ("transport", {"protein": [1.43, 0.01]}, "k = 0; what absorbs is body.pigment"),
        ("illuminant", {"aragonite": [1.53, 1e-9]}, "k = 0; what absorbs is body.pigment"),
        ("illuminant", {"aragonite": "aragonite"}, "an index that is the same in all directions"),
        ("illuminant", {"protein": {"n_o": 1.5, "n_e": 1.5}}, "an index that is the same in all"),
    ],
)
def test_a_model_refuses_media_that_it_does_not_know(
    model: str, nacre: dict[str, Any], allowed: str
) -> None:
    values = {"model": model, "nacre": nacre}
    (line,) = problems(lambda: Pearl.check(values, "my.toml", Path()))
    assert line.startswith(f"my.toml: nacre.{next(iter(nacre))} is ")
    assert f'while model is "{model}"; allowed: {allowed}' in line


def test_both_models_take_the_media_that_they_know() -> None:
    for model in MODELS:
        for index in (1.5, [1.5, 0.0], "aragonite-isotropic-1.53", "silk-fibroin"):
            assert Pearl(model=model, nacre={"aragonite": index, "protein": index})
    assert Pearl(nacre={"aragonite": {"n_o": 1.683, "n_e": 1.53}}).nacre.aragonite_medium == (
        1.683,
        1.53,
    )
    assert Pearl(nacre={"aragonite": "aragonite"}).nacre.aragonite_medium == "aragonite"
    assert Pearl(nacre={"protein": [1.43, 0]}).nacre.protein_medium == 1.43


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
@pytest.mark.parametrize("value", ["20", math.nan, math.inf, -math.inf])
def test_every_number_refuses_text_and_what_is_not_finite(case: Any, value: Any) -> None:
    line = refusal(*case, value)
    assert line.startswith(f"my.toml: {case[1].path} is {json.dumps(value)}"[:-9]) or "inf" in line
    assert line.endswith(f"allowed: {case[1].field.json_schema_extra['allowed']}")


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
def test_every_number_refuses_what_lies_outside_its_range(case: Any) -> None:
    model, key = case
    low, high, outside = bounds(key)
    step = 1 if int in alternatives(key.field.annotation) else 1e-3
    for value in (low - step, high + step, *outside):
        line = refusal(model, key, value)
        assert line == (
            f"my.toml: {key.path} is {value}; allowed: {key.field.json_schema_extra['allowed']}"
        )


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
def test_the_message_states_the_very_bounds_that_are_enforced(case: Any) -> None:
    low, high, _ = bounds(case[1])
    words = case[1].field.json_schema_extra["allowed"].split()
    stated = [word for word in words if word.lstrip("-").replace(".", "").isdigit()]
    assert [type(low)(stated[0]), type(high)(stated[1])] == [low, high]


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
def test_every_number_accepts_its_bounds(case: Any) -> None:
    model, key = case
    low, high, outside = bounds(key)
    for value in {low, high} - set(outside):
        values = file_with(model, key, value)
        if key.path.startswith("nacre.thickness_"):  # far from the noise, which another test checks
            values["nacre"]["thickness_noise_nm"] = min(value, 10)
        assert model.check(values, "my.toml", Path())


TEXTS = [case for case in LEAVES if case not in NUMBERS]


@pytest.mark.parametrize("case", TEXTS, ids=name_of)
@pytest.mark.parametrize("value", ["", "nonsense\n", "#12345g", "02-30", "99999K", "-1"])
def test_every_text_key_refuses_nonsense(case: Any, value: str) -> None:
    model, key = case
    if key.path in ("name", "rows.0.label") and value not in ("", "nonsense\n"):
        assert model.check(file_with(model, key, value), "my.toml", Path())
        return
    line = refusal(model, key, value)
    assert f"is {json.dumps(value)}; " in line
    assert f"allowed: {key.field.json_schema_extra['allowed']}" in line


@pytest.mark.parametrize("case", KEYS, ids=name_of)
def test_every_key_says_its_meaning_range_and_source(case: Any) -> None:
    field = case[1].field
    assert field.description
    if not sections_in(field.annotation):
        assert "Allowed: " in field.description
        assert "Source: " in field.description
        assert field.default is not None or "Left out: " in field.description


@pytest.mark.parametrize("case", [c for c in KEYS if c not in LEAVES], ids=name_of)
def test_every_table_refuses_a_number_in_its_place(case: Any) -> None:
    assert "wanted: a " in refusal(*case, 5)


@pytest.mark.parametrize("case", KEYS, ids=name_of)
def test_a_misspelt_key_is_told_its_right_name(case: Any) -> None:
    model, key = case
    wrong = f"{key.path}x"
    values = file_with(model, key._replace(path=wrong), 1)
    lines = problems(lambda: model.check(values, "my.toml", Path()))
    right = key.path.rpartition(".")[2]
    assert f"my.toml: {wrong} is not a key here; did you mean {right}?" in lines


# --- keys that contradict one another -----------------------------------------------------------


@pytest.mark.parametrize(
    ("model", "values", "both"),
    [
        (Pearl, {"nacre": {"thickness_nm": [400.0], "seed": 2}}, "nacre.seed nacre.thickness_nm"),
        (
            Pearl,
            {"nacre": {"thickness_noise_nm": 400}},
            "nacre.thickness_noise_nm nacre.thickness_winter_nm",
        ),
        (Pearl, {"nacre": {"harvest": "2026-12-15"}}, "nacre.harvest nacre.seeding"),
        (
            Pearl,
            {"nacre": {"seeding": "2026-04-15", "harvest": "2026-04-15"}},
            "nacre.harvest nacre.seeding",
        ),
        (
            Pearl,
            {"nacre": {"seeding": "2000-01-01", "harvest": "2020-01-02"}},
            "nacre.harvest nacre.seeding",
        ),
        (
            Pearl,
            {"nacre": {"layers_winter": 0, "layers_summer": 0, "layers_noise": 0}},
            "nacre.layers_summer layers_winter layers_noise",
        ),
        (Pearl, {"body": {"nacre_mm": 4.1}}, "body.nacre_mm diameter_mm 4.1 mm"),
        (
            Pearl,
            {"texture": {"low_per_mm": 3.0, "high_per_mm": 3.0}},
            "texture.low_per_mm texture.high_per_mm",
        ),
        (Scene, {"lamps": [{}]}, "lamps.0.azimuth_deg lamps.0.elevation_deg position_mm"),
        (Scene, {"lamps": [{"azimuth_deg": 3.0}]}, "lamps.0.elevation_deg lamps.0.azimuth_deg"),
        (
            Scene,
            {"lamps": [{"azimuth_deg": 3.0, "position_mm": [0.0, 0.0, 99.0]}]},
            "lamps.0.azimuth_deg lamps.0.position_mm",
        ),
        (Scene, {"lamps": [{"position_mm": [0.0, 12.0, 16.0]}]}, "lamps.0.position_mm 20 mm"),
        (Scene, {"sky": {"kind": "panorama"}}, "sky.path sky.kind"),
        (Scene, {"sky": {"path": "a.hdr"}}, "sky.path sky.kind"),
        (Scene, {"lamps": [{"azimuth_deg": 0, "elevation_deg": 0}] * 257}, "lamps 0 to 256"),
        (Pearl, {"nacre": {"thickness_nm": []}}, "nacre.thickness_nm 1 to 5000"),
        (Pearl, {"nacre": {"thickness_nm": [400.0] * 5001}}, "nacre.thickness_nm 1 to 5000"),
    ],
)
def test_keys_that_disagree_are_both_named(model: Any, values: Any, both: str) -> None:
    (line,) = problems(lambda: model.check(values, "my.toml", Path()))
    assert line.startswith("my.toml: ")
    for word in both.split():
        assert word in line


def test_all_problems_of_a_file_come_at_once() -> None:
    values = {
        "model": "illuminant",
        "diameter_mm": -1,
        "deph": 1,
        "nacre": {"seed": 1.5, "protein_nm": True},
        "surface": {"mirror_weight": 2},
    }
    lines = problems(lambda: Pearl.check(values, "my.toml", Path()))
    named = ["diameter_mm", "nacre.protein_nm", "nacre.seed", "surface.mirror_weight", "deph"]
    assert [line.split()[1] for line in lines] == named


def test_thousands_of_bad_numbers_are_not_thousands_of_lines() -> None:
    lines = problems(lambda: Layers(thickness_nm=[-1.0] * 5000))
    assert len(lines) == 21
    assert lines[0].startswith("Layers: thickness_nm.0 is -1")
    assert lines[-1] == "... and 4980 more problems"


@pytest.mark.parametrize("act", [lambda: Pearl(depth=2), lambda: Pearl(nacre={"seed": -1})])
def test_python_gets_the_same_plain_words_as_a_file(act: Any) -> None:
    assert problems(act)[0].startswith("Pearl: ")


# --- files that are not what they should be -----------------------------------------------------


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "empty"),
        (b"# only a comment\n", "empty"),
        (b"name = \n", "line 1, column 8: not TOML"),
        (b"[nacre]\nseed = 1\nseed = 2\n", "line 3"),
        (b"name = 'never closed", "line 1, column 21"),
        (b"\x89PNG\r\n\x1a\n\0\0", "binary"),
        (b"name = 'a'\n# \xff\n", "line 2: is not UTF-8"),
        (b"a = " + b"[" * 5000, "nested too deeply"),
        (b"[nacre]\nseed = " + b"9" * 5000, "too long"),
        (b"# " + b"a" * 1_000_000, "1000000 bytes"),
        (b"nam = 'a'\n", "nam is not a key here; did you mean name?"),
    ],
)
def test_a_bad_file_is_refused_in_one_line(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    (line,) = problems(lambda: Pearl.load(path))
    assert line.startswith(f"{path}: ")
    assert words in line


def test_a_folder_a_missing_file_and_a_device_are_refused(tmp_path: Path) -> None:
    folder = tmp_path / "folder.toml"
    folder.mkdir()
    assert problems(lambda: Pearl.load(folder)) == [f"{folder}: is a folder; wanted: a TOML file"]
    missing = tmp_path / "none.toml"
    assert problems(lambda: Pearl.load(missing)) == [f"{missing}: there is no such file"]
    assert "not a regular file" in problems(lambda: Pearl.load("/dev/zero"))[0]
    assert problems(lambda: Pearl.load("a\0b.toml"))


def test_a_windows_file_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    path = tmp_path / "windows.toml"
    path.write_bytes(b'\xef\xbb\xbfname = "w"\r\ndepth = 1\r\n')
    assert Pearl.load(path).depth == 1.0


def test_a_scene_given_as_a_pearl_is_called_a_scene(tmp_path: Path) -> None:
    path = tmp_path / "s.toml"
    path.write_text('name = "s"\n[camera]\nexposure = 2.0\n')
    assert problems(lambda: Pearl.load(path)) == [f"{path}: is a scene file; wanted: a pearl file"]
    assert "is a scene preset" in problems(lambda: Pearl.load("booth"))[0]
    assert isinstance(load(path), Scene)
    path.write_text('name = "s"\n')
    assert "neither a pearl nor a scene" in problems(lambda: load(path))[0]


# --- presets, paths and overrides ---------------------------------------------------------------


def test_a_folder_does_not_hide_the_preset_of_its_name(tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "paper").mkdir()
    assert Pearl.load("paper") == Pearl(name="paper", model="illuminant")


def test_an_existing_file_wins_over_the_preset_of_its_name(
    tmp_path: Path, monkeypatch: Any
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "paper").write_text("depth = 0.1\n")
    assert Pearl.load("paper").depth == 0.1


def test_a_mistyped_preset_is_offered_the_nearest() -> None:
    (line,) = problems(lambda: Pearl.load("akoya-rh"))
    assert "did you mean akoya-r" in line
    (line,) = problems(lambda: Growth(preset="akoia"))
    assert 'did you mean "akoya"?' in line


@pytest.mark.parametrize("kind", list(preset.FOLDERS))
def test_every_preset_is_valid_and_says_what_it_is(kind: str) -> None:
    model: Any = {"pearl": Pearl, "scene": Scene, "nacre": Growth, "study": Design}[kind]
    for name in preset.names(kind):
        made = model(preset=name) if kind == "nacre" else model.load(name)
        if kind != "study":  # whose name is a title that participants read
            assert name == (made.preset if kind == "nacre" else made.name)
        assert preset.text(kind, name).startswith("# ")
        assert 20 <= len(preset.summary(kind, name)) <= 100


def test_the_preset_paper_is_the_default_of_every_key() -> None:
    assert preset.values("nacre", "paper") == {
        key: value for key, value in Growth().model_dump().items() if key not in ("preset", "seed")
    }
    assert Pearl.load("paper") == Pearl(name="paper", model="illuminant")


def test_akoya_is_akoya_rg() -> None:
    assert preset.values("nacre", "akoya") == preset.values("nacre", "akoya-rg")


@pytest.mark.parametrize(
    ("name", "mean_nm"), [("akoya-r", 330), ("akoya-rg", 360), ("akoya-g", 440)]
)
def test_akoya_families_have_the_reported_tablets_in_the_outer_10_um(
    name: str, mean_nm: float
) -> None:
    nacre = Growth(preset=name)
    peak = (nacre.peak_date - nacre.seeding_date).days
    depth_nm = layers = total_nm = squares = 0.0
    for day in reversed(range(nacre.days)):  # expected growth, from the surface inward
        bell = math.exp(-((day - peak) ** 2) / (2 * nacre.season_days**2))
        count = nacre.layers_winter + (nacre.layers_summer - nacre.layers_winter) * bell
        rise_nm = nacre.thickness_summer_nm - nacre.thickness_winter_nm
        thickness_nm = nacre.thickness_winter_nm + rise_nm * bell
        layers += count
        total_nm += count * thickness_nm
        squares += count * thickness_nm**2
        depth_nm += count * (thickness_nm + nacre.protein_nm)
        if depth_nm >= 10_000:
            break
    mean = total_nm / layers
    spread = math.sqrt(squares / layers - mean**2 + nacre.thickness_noise_nm**2 / 3)
    assert mean == pytest.approx(mean_nm, abs=1.5)
    assert 10 <= spread <= 20


def test_the_paper_scene_has_its_lamp_at_45_degrees_to_the_line_of_sight() -> None:
    scene = Scene.load("paper")
    (lamp,) = scene.lamps

    def direction(azimuth_deg: float, elevation_deg: float) -> tuple[float, float, float]:
        a, e = math.radians(azimuth_deg), math.radians(elevation_deg)
        return math.sin(a) * math.cos(e), math.sin(e), math.cos(a) * math.cos(e)

    assert lamp.azimuth_deg is not None
    assert lamp.elevation_deg is not None
    cosine = sum(
        a * b
        for a, b in zip(
            direction(lamp.azimuth_deg, lamp.elevation_deg),
            direction(scene.camera.azimuth_deg, scene.camera.elevation_deg),
            strict=True,
        )
    )
    assert math.degrees(math.acos(cosine)) == pytest.approx(45, abs=0.01)
    assert (scene.table.kind, lamp.spectrum) == ("checker", "E")


def test_given_keys_win_over_the_nacre_preset() -> None:
    nacre = Growth(preset="akoya-g", thickness_summer_nm=500.0)
    assert nacre.thickness_summer_nm == 500.0
    assert nacre.thickness_winter_nm == Growth(preset="akoya-g").thickness_winter_nm


def test_paths_of_a_file_are_relative_to_it_and_paths_of_overrides_are_not(tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(
        'lamps = [{azimuth_deg = 1, elevation_deg = 1, spectrum = "led.csv"},'
        ' {azimuth_deg = 1, elevation_deg = 1, spectrum = "A"}]\n'
        '[sky]\nkind = "panorama"\npath = "room.HDR"\n'
    )
    scene = Scene.load(tmp_path / "s.toml", [("lamps.1.spectrum", "mine.csv")])
    assert [lamp.spectrum for lamp in scene.lamps] == [str(tmp_path / "led.csv"), "mine.csv"]
    assert scene.sky.path == str(tmp_path / "room.HDR")
    (tmp_path / "p.toml").write_text('texture.source = "shell.jpg"\n')
    assert Pearl.load(tmp_path / "p.toml").texture.source == str(tmp_path / "shell.jpg")


@pytest.mark.parametrize(
    ("key", "value", "line"),
    [
        ("nacre.seed", "-1", "--set: nacre.seed is -1; allowed: 0 to 9223372036854775807"),
        ("nacre.sed", "1", "--set: nacre.sed is not a key here; did you mean seed?"),
        ("depth", "deep", '--set: depth is "deep"; wanted: a number; allowed: 0 to 1'),
        ("depth", "nan", "--set: depth is nan; allowed: 0 to 1"),
        ("depth", "1\ngrain = 0", "--set: depth is "),
        ("depth.x", "1", '--set "depth.x": depth is not a table'),
        ("nacre..seed", "1", '--set "nacre..seed": a part of the key is empty'),
        ("nacre.", "1", '--set "nacre.": a part of the key is empty'),
    ],
)
def test_a_bad_override_is_named_as_such(key: str, value: str, line: str) -> None:
    assert problems(lambda: Pearl.load("paper", [(key, value)]))[0].startswith(line)


@pytest.mark.parametrize("place", ["1", "-1", "x", "99999999999999999999"])
def test_an_override_reaches_only_lamps_that_are_there(place: str) -> None:
    (line,) = problems(lambda: Scene.load("paper", [(f"lamps.{place}.intensity", "2")]))
    assert line.endswith("lamps is a list; allowed: lamps.0 to lamps.0")


def test_a_setting_without_a_value_is_refused() -> None:
    assert problems(lambda: override.parse("depth"))
    assert problems(lambda: override.parse("=3"))
    assert override.parse("name = a=b ") == ("name", "a=b")


# --- dates --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("seeding", "harvest", "days"),
    [
        ("04-15", "12-15", 244),
        ("12-15", "04-15", 121),
        ("04-15", "04-15", 365),
        ("2023-12-31", "2024-12-31", 366),
        ("2000-01-01", "2020-01-01", 7305),
    ],
)
def test_days_from_seeding_to_harvest(seeding: str, harvest: str, days: int) -> None:
    assert Growth(seeding=seeding, harvest=harvest).days == days


def test_a_date_without_quotes_means_the_same() -> None:
    text = "[nacre]\nseeding = 2024-02-29\nharvest = 2024-12-15\n"
    assert Pearl.from_toml(text).nacre == Growth(seeding="2024-02-29", harvest="2024-12-15")


# --- writing, schema, reference -----------------------------------------------------------------


@pytest.mark.parametrize(
    "spec",
    [
        *(Pearl.load(name) for name in preset.names("pearl")),
        *(Scene.load(name) for name in preset.names("scene")),
        Pearl(name='quo"te\\ 真珠', nacre=Layers(thickness_nm=[1e-7, 1e5], aragonite=[1.68, 0.0])),
        Pearl(
            name="all of transport",
            film=Film(outer_um=20, columns=8, column_spread_nm=12),
            body=Body(pigment="gold", nacre_mm=0.5, nucleus="#ffffff"),
            inside=Inside(spread=0.1),
            surface=Surface(facets="ggx", facet_spread_rad=0.1),
            nacre=Growth(aragonite=Uniaxial(n_o=1.683, n_e=1.53), protein="chitin"),
        ),
        Pearl(
            name="all of illuminant",
            model="illuminant",
            body_colour="#102030",
            interference=Interference(mixing=0.2),
            surface=Surface(mirror_weight=0.5, layer_reflectance=0.0, falloff_mm=3.0),
        ),
        Scene(lamps=[{"position_mm": [0, 0, -99.5]}], walls={}),
        Scene(),
    ],
    ids=lambda spec: spec.name,
)
def test_what_is_written_reads_back_as_the_same(spec: Any) -> None:
    text = spec.to_toml()
    assert type(spec).from_toml(text) == spec
    assert type(spec).model_validate_json(spec.model_dump_json()) == spec
    assert hash(spec) == hash(type(spec).from_toml(text))


@pytest.mark.parametrize("model", FILES)
def test_the_schema_states_every_key_with_description_range_and_default(model: Any) -> None:
    schema = json_schema(model)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    stated = {model.__name__: schema, **schema["$defs"]}
    for key in every_key(model):
        section = stated[key.owner.__name__]
        assert section["additionalProperties"] is False
        assert ">>>" not in section["description"]
        entry = section["properties"][key.path.rpartition(".")[2]]
        assert entry["description"] == key.field.description
        if (model, key) in NUMBERS:
            low, high, _ = bounds(key)
            assert entry.get("minimum", entry.get("exclusiveMinimum")) == low
            assert entry.get("maximum", entry.get("exclusiveMaximum")) == high
            default = None if key.field.is_required() else key.field.default
            assert entry.get("default") == default
    assert "null" not in json.dumps(schema)


def test_the_reference_page_names_every_key_with_its_default_and_range() -> None:
    page = (ROOT / "docs" / "files.md").read_text(encoding="utf-8")
    for _, key in LEAVES:
        name, default = key.path.rpartition(".")[2], key.field.default
        if key.field.is_required():
            written = "required"
        else:
            written = "–" if default is None else f"`{json.dumps(default)}`"
        allowed = key.field.json_schema_extra["allowed"]
        assert f"| `{name}` | {written} | {allowed} | " in page
    for _, key in KEYS:
        assert f"`{key.path.rpartition('.')[2]}`" in page or f"[{key.path}]" in page


def test_the_toml_of_the_reference_page_is_a_pearl() -> None:
    page = (ROOT / "docs" / "files.md").read_text(encoding="utf-8")
    sample = page.partition("```toml\n")[2].partition("```")[0]
    assert Pearl.from_toml(sample) == Pearl(
        name="my first pearl", depth=0.8, nacre={"preset": "akoya-rg", "seed": 7}
    )
    assert tomllib.loads(sample)["depth"] == 0.8


def test_the_python_of_the_reference_page_runs() -> None:
    done = doctest.testfile(str(ROOT / "docs" / "files.md"), module_relative=False)
    assert (done.failed, done.attempted) == (0, 4)


@pytest.mark.parametrize(
    "value",
    [10**400, -(10**5000), 1e308, "\udc80", "\u202e", "a" * 10_000],
    ids=["400 digits", "5000 digits", "1e308", "surrogate", "right to left", "long"],
)
def test_monstrous_values_are_refused_in_one_short_line(value: Any) -> None:
    for values in ({"depth": value}, {"nacre": {"seed": value}}, {"body": {"nucleus": value}}):
        (line,) = problems(lambda values=values: Pearl.check(dict(values), "my.toml", Path()))
        assert len(line) < 250
        assert line.isprintable()


def test_reading_files_needs_neither_numpy_nor_the_compiled_rooms() -> None:
    code = (
        "import sys, nacreous.spec; "
        "sys.exit(any(name in sys.modules for name in ('numpy', 'nacreous._core')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0

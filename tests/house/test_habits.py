"""What who works in Python expects of any library's objects and modules."""

import copy
import importlib
import sys

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling import Answers, paper, thurstone
from nacreous.scaling.report.analysis import analyse
from nacreous.scaling.report.settings import Settings
from nacreous.spec import Lamp, Scene, Texture

MODULES = (
    "body",
    "colour",
    "file",
    "iridescence",
    "measure",
    "medium",
    "nacre",
    "optics",
    "paper",
    "scaling",
    "spec",
    "strand",
    "study",
    "texture",
    "trade",
    "turn",
)


@pytest.mark.parametrize("name", MODULES)
def test_a_module_is_reached_from_the_package_and_lists_its_public_names_alone(name: str) -> None:
    module = getattr(nc, name)
    assert module is importlib.import_module(f"nacreous.{name}")
    assert sorted(module.__dir__()) == sorted(module.__all__)
    for offered in module.__all__:
        getattr(module, offered)


def test_parts_of_a_study_are_reached_without_another_import() -> None:
    assert nc.study.design.freezing.__name__ == "nacreous.study.design.freezing"


@pytest.mark.parametrize("name", ["design", "plan", "results", "running", "store"])
def test_a_part_of_a_study_lists_its_public_names_alone(name: str) -> None:
    part = getattr(nc.study, name)
    assert dir(part) == sorted(part.__all__)


def test_a_section_shows_the_keys_that_differ_from_their_defaults() -> None:
    assert repr(nc.Pearl()) == str(nc.Pearl()) == "Pearl()"
    pearl = nc.Pearl(depth=0.7, texture=Texture(seed=3))
    assert repr(pearl) == "Pearl(depth=0.7, texture=Texture(seed=3))"
    assert len(repr(nc.Pearl.load("paper"))) < 200


def test_a_section_offers_its_keys_and_what_it_does() -> None:
    offered = dir(nc.Pearl())
    assert {"depth", "nacre", "replace", "load"} <= {*offered}
    assert not {"parse_raw", "construct", "model_fields", "__dict__"} & {*offered}


def test_a_changed_section_is_checked_like_a_new_one() -> None:
    pearl = nc.Pearl(shininess=0.2)
    assert pearl.replace(depth=0.7) == nc.Pearl(shininess=0.2, depth=0.7)
    for wrong in ({"depth": 7}, {"depht": 0.7}, {"depth": "0.7"}):
        with pytest.raises(nc.InputError, match=r"Pearl: dep.* is"):
            pearl.replace(**wrong)
    with pytest.raises(nc.InputError, match="allowed: replace"):
        pearl.model_copy(update={"depth": 7})
    with pytest.raises(nc.InputError, match=r"copy\(update\) checks nothing; allowed: replace"):
        pearl.copy(update={"depth": 7})
    assert pearl.model_copy(deep=True) == pearl
    if sys.version_info >= (3, 13):
        assert copy.replace(pearl, depth=0.7) == pearl.replace(depth=0.7)
        with pytest.raises(nc.InputError, match="Pearl: depth is 7"):
            copy.replace(pearl, depth=7)


def test_a_section_that_is_written_to_says_how_to_make_another() -> None:
    pearl, scene = nc.Pearl(), Scene(lamps=[Lamp(position_mm=(0, 2, 300))])
    for section, name in (
        *((pearl, "depth"), (pearl, "depht"), (pearl.nacre, "protein_nm"), (scene, "lamps")),
        *((scene.camera, "glare"), (scene.lamps[0], "intensity"), (pearl, "model_config")),
    ):
        kind = type(section).__name__
        with pytest.raises(nc.InputError, match=rf"{kind}\.{name} cannot be set; allowed: replace"):
            setattr(section, name, 7)
        with pytest.raises(
            nc.InputError, match=rf"{kind}\.{name} cannot be deleted; allowed: a new"
        ):
            delattr(section, name)
    assert pearl == nc.Pearl()


def test_a_key_that_only_its_model_has_survives_a_change_of_another() -> None:
    pearl = nc.Pearl.load("paper")  # of the illuminant model
    assert pearl.replace(depth=0.9).replace(depth=pearl.depth) == pearl


def test_numpys_numbers_are_numbers_wherever_one_is_wanted() -> None:
    assert Texture(seed=np.int64(5)) == Texture(seed=5)
    assert nc.Pearl(depth=np.float64(0.25)) == nc.Pearl(depth=0.25)
    assert Lamp(position_mm=np.array([0.0, 2.0, 300.0])) == Lamp(position_mm=(0, 2, 300))
    assert Scene(lamps=[{"position_mm": np.array([0.0, 2.0, 300.0])}]).lamps[0].position_mm[1] == 2
    assert nc.grow(seed=np.int32(3)) == nc.grow(seed=3)
    assert nc.render("paper", size=np.int64(8), samples=np.int8(1)).linear.shape == (8, 8, 3)
    scale = thurstone(paper())
    assert scale.bootstrap(np.int64(10), seed=np.uint8(2)) == scale.bootstrap(10, seed=2)
    assert nc.render("paper", size=np.array(8), samples=1).linear.shape == (8, 8, 3)
    assert nc.grow(seed=np.array(3)) == nc.grow(seed=3)
    assert scale.bootstrap(np.array(10), seed=np.array(2)) == scale.bootstrap(10, seed=2)
    stack = nc.LayerStack([400.0], np.array(20.0), np.array(1.53))
    assert stack == nc.LayerStack([400.0], 20.0, 1.53)
    for wrong in (5.0, np.float64(5.0), np.array(5.0), np.array(True), np.array([2])):
        with pytest.raises(nc.InputError, match=r"seed is .*; (wanted|allowed): a whole number"):
            nc.grow(seed=wrong)
        with pytest.raises(nc.InputError, match=r"seed is .*; allowed: a whole number"):
            scale.bootstrap(10, seed=wrong)
    for wrong in (np.float64(5.5), np.float64("nan"), np.bool_(True), np.array([1, 2])):
        with pytest.raises(nc.InputError, match="Texture: seed is"):
            Texture(seed=wrong)


def test_a_picture_is_an_array_where_numpy_wants_one() -> None:
    image = nc.render("paper", size=8, samples=1)
    assert repr(image) == "Image(8 x 8, paper)"
    assert (np.asarray(image) == image.linear).all()
    assert np.asarray(image, float).dtype == float
    changed = np.array(image)
    changed[0, 0] = 7  # a copy; the picture never changes
    assert np.asarray(image)[0, 0, 0] != 7
    assert repr(nc.Image(image.linear, image.layers)) == "Image(8 x 8)"


def test_a_scale_is_a_table_in_pandas_and_in_notebooks() -> None:
    scale = thurstone(paper())
    frame = scale.to_frame()
    assert list(frame.columns) == ["value", "se", "low", "high"]
    assert tuple(frame.index) == scale.stimuli
    assert frame.attrs == {"unit": "z"}
    assert (frame[["low", "high"]].to_numpy() == scale.intervals()).all()
    shown = scale._repr_html_()
    assert shown.index("<th>2</th>") < shown.index("<th>7</th>"), "from the most preferred on"


def test_a_scale_without_errors_is_a_table_without_them() -> None:
    rows = [("a", "b", "a"), ("b", "c", "b"), ("c", "a", "c")] * 4
    table = {
        "left": [left for left, _, _ in rows],
        "right": [right for _, right, _ in rows],
        "chosen": [chosen for _, _, chosen in rows],
        "person": ["p1", "p2"] * 6,  # too few people for errors over people
    }
    scale = thurstone(Answers.of_table(table, repeats=True), prior=1.0)
    assert scale.to_frame()["se"].isna().all()
    assert "nan" not in scale._repr_html_()


def test_an_analysis_is_told_by_how_much_was_analysed() -> None:
    found = analyse(nc.scaling.paper(), Settings(bootstrap=0))
    assert repr(found) == "Analysis(2184 answers, 7 stimuli)"

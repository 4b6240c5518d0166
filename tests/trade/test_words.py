"""The trade's words: one table, whole, without holes, true to the renderer and to its page."""

from __future__ import annotations

import itertools
import json
import math

import numpy as np
import pytest

import nacreous as nc
from nacreous import _core, body, cli, colour
from nacreous.spec import Pearl
from nacreous.spec.key import every_key
from nacreous.trade import (
    dimensions_of,
    factors,
    overrides_of,
    range_of,
    stated_shape,
    word_of,
    words,
)
from tests.trade import words_page
from tests.trade.lamp_image import measured

RANGES = [(word, one) for factor in factors() for word in factor.words for one in word.ranges]
GRADES = ["Excellent", "Very good", "Good", "Fair", "Poor"]


def test_every_key_that_a_word_sets_is_one_of_a_pearl_and_takes_the_value() -> None:
    keys = {key.path for key in every_key(Pearl)}
    for word, one in RANGES:
        assert math.isnan(one.sets) == (not one.key)
        if one.key:
            assert one.key in keys
            assert one.holds(one.sets), word
            Pearl.load("tahitian", [(one.key, f"{one.sets:g}")])


def test_every_word_has_two_languages_a_source_and_bounds_in_order() -> None:
    for word, one in RANGES:
        assert word.en
        assert word.ja
        assert one.lower < one.upper
        assert "(ours)" in one.source or len(one.source) > 10
    for factor in factors():
        assert len({word.en for word in factor.words}) == len(factor.words)
        assert len({word.ja for word in factor.words}) == len(factor.words)


@pytest.mark.parametrize("factor", factors(), ids=lambda factor: factor.name)
def test_no_value_between_the_ends_is_without_a_word(factor) -> None:
    spans = []
    for name in factor.quantities:
        ranges = [r for word in factor.words for r in word.ranges if r.quantity == name]
        ends = {min(r.lower for r in ranges), *(r.upper for r in ranges if r.upper < math.inf)}
        low = 0.0 if name in ("grooves", "hue_deg", "chroma") else min(ends)
        top = 359.0 if name == "hue_deg" else max(ends)
        spans.append([name, sorted({low, top, *np.linspace(low, top, 7), *(ends - {low})})])
    told = (
        [{name: value} for name, span in spans for value in span]
        if factor.is_told_by_each
        else [
            dict(zip(factor.quantities, values, strict=True))
            for values in itertools.product(*(span for _, span in spans))
        ]
    )
    for given in told:
        given = {name: value % 360 if name == "hue_deg" else value for name, value in given.items()}
        assert word_of(factor.name, given).factor == factor.name


@pytest.mark.parametrize("factor", ["luster", "matching"])
def test_the_five_grades_follow_each_other_without_overlap(factor: str) -> None:
    assert [word.en for word in words(factor)] == GRADES
    for one, next_one in itertools.pairwise(words(factor)):
        assert one.ranges[0].upper == next_one.ranges[0].lower


def test_luster_by_knob_by_facets_and_by_half_width_is_the_same_word() -> None:
    for word in words("luster"):
        spread, half_width, shininess = (
            range_of("luster", word.en, name)
            for name in ("facet_spread_rad", "half_width_deg", "shininess")
        )
        assert half_width.lower == pytest.approx(134.9 * spread.lower, abs=0.06)
        for knob, facets in ((shininess.sets, spread.sets), (shininess.lower, spread.upper)):
            pearl = Pearl(shininess=knob).model_dump_json()
            found = _core.resolved_keys(pearl)["surface.facet_spread_rad"]
            assert found == pytest.approx(min(facets, 0.25), rel=0.01)


@pytest.mark.parametrize("spread_rad", [0.05, 0.09])
def test_a_lamps_image_is_as_wide_and_as_clear_as_the_bounds_say(spread_rad: float) -> None:
    at_bound = {one.ranges[0].lower: one for one in words("luster")}[spread_rad]
    sharp, clear = measured(spread_rad, 1.0), measured(spread_rad, 6.0)
    half_width_deg = range_of("luster", at_bound.en, "half_width_deg").lower
    contrast = range_of("luster", at_bound.en, "image_contrast").upper
    assert sharp.half_width_deg == pytest.approx(half_width_deg, rel=0.08)
    assert clear.contrast == pytest.approx(contrast, rel=0.05)


@pytest.mark.parametrize("word", words("shape"), ids=lambda word: word.en)
def test_the_pearl_that_a_shapes_word_makes_measures_inside_its_own_bounds(word) -> None:
    for seed, diameter_mm in ((1, 8.0), (2, 12.0), (3, 3.0), (4, 30.0)):
        given = [("shape.seed", str(seed)), ("diameter_mm", str(diameter_mm))]
        pearl = Pearl.load("south-sea-white", [*overrides_of(f"shape={word.en}"), *given])
        found = dimensions_of(pearl)
        assert word.holds(found), found
        assert stated_shape(pearl).word == word


def test_a_shapes_word_undoes_another() -> None:
    for word in words("shape"):
        both = overrides_of("shape=circled") + overrides_of(f"shape={word.en}")
        assert stated_shape(Pearl.load("tahitian", both)).word == word


def test_a_range_that_leaves_nothing_out_tells_no_word() -> None:
    with pytest.raises(nc.InputError, match="told by pits; wanted: blemished_percent or area"):
        word_of("surface", {"pits": 3})


def test_our_pigments_have_the_names_of_their_colours() -> None:
    named = {"white": "white", "cream": "cream", "pink": "pink", "gold": "golden"}
    for pigment, word in {**named, "dyed-blue": "blue", "black-lip": "grey"}.items():
        xyz = colour.xyz_from_spectrum(body.reflectance(pigment), "D65")
        lightness, a, b = colour.lab_from_xyz(xyz).tolist()
        hue_deg = math.degrees(math.atan2(b, a)) % 360
        told = {"lightness": lightness, "chroma": math.hypot(a, b), "hue_deg": hue_deg}
        assert word_of("bodycolour", told).en == word


def test_published_bounds_are_those_of_their_sources() -> None:
    def shape(variation_percent: float) -> str:
        values = {"diameter_variation_percent": variation_percent, "asymmetry_percent": 1}
        others = {"grooves": 0, "height_over_width": 1.0, "taper_percent": 0}
        return word_of("shape", {**values, **others}).en

    assert [shape(percent) for percent in (1.9, 2, 4.9, 5)] == [
        *("round", "near-round", "near-round", "oval")
    ]
    assert [word_of("nacre-akoya", mm).en for mm in (0.29, 0.3, 0.4)] == ["thin", "medium", "thick"]
    assert word_of("size", 7.49).en == "7.0-7.5 mm"
    assert word_of("size", 30).en == "29.5-30.0 mm"


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("luster=Excelent", '"Excelent"; did you mean Excellent'),
        ("lustre=Good", '"lustre" is no factor; did you mean luster'),
        ("overtone=rose", "overtone sets no key of a pearl file; allowed: size, shape"),
        ("luster", "wanted: factor=word, such as luster=Excellent"),
        ("size=77", r"allowed: 1.0-1.5 mm, 1.5-2.0 mm, \.\.\., 29.5-30.0 mm"),
    ],
)
def test_a_word_that_is_none_is_told_with_its_place(setting: str, said: str) -> None:
    with pytest.raises(nc.InputError, match=f'^--word "{setting}": .*{said}'):
        overrides_of(setting)


@pytest.mark.parametrize("value", [float("nan"), -1, 31, "big"])
def test_a_value_that_no_word_holds_is_refused(value: object) -> None:
    with pytest.raises(
        nc.InputError, match=r"size has no word|diameter_mm is 'big'; allowed: a nu"
    ):
        word_of("size", value)


def test_a_shape_wants_all_that_tells_shapes_apart() -> None:
    with pytest.raises(nc.InputError, match="told by grooves; wanted: grooves, diameter_variation"):
        word_of("shape", 0)
    with pytest.raises(nc.InputError, match="told by gloss; wanted: facet_spread_rad or half_wid"):
        word_of("luster", {"gloss": 0.7})


def test_the_page_shows_the_table() -> None:
    wanted = f"\n{words_page.table()}\n"
    assert words_page.shown() == wanted, "python -m tests.trade.words_page writes it anew"


def test_the_command_prints_all_words_in_both_languages(capsys) -> None:
    for options in (["words"], ["words", "--language", "ja"], ["words", "luster"]):
        assert cli.main(options) == 0
    shown = capsys.readouterr().out
    assert "Very good" in shown
    assert "厚巻き" in shown
    assert cli.main(["words", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert [one["factor"] for one in record] == [factor.name for factor in factors()]
    assert record[0]["words"][0]["ranges"][0]["key"] == "diameter_mm"
    assert cli.main(["words", "nacre"]) == 2
    assert "did you mean nacre-" in capsys.readouterr().err


def test_a_word_makes_the_picture_that_its_numbers_make(tmp_path) -> None:
    small = ["--size", "16", "--samples", "1"]
    said, set_ = str(tmp_path / "said.exr"), str(tmp_path / "set.exr")
    both = ["--set", "surface.facet_spread_rad=0.116", "--set", "shininess=0.253"]
    assert cli.main(["render", "akoya-rg", *small, "--word", "luster=fair", "-o", said]) == 0
    assert cli.main(["render", "akoya-rg", *small, *both, "-o", set_]) == 0
    assert (tmp_path / "said.exr").read_bytes() == (tmp_path / "set.exr").read_bytes()
    assert cli.main(["render", "paper", "--word", "luster=fairr", "-o", said]) == 2

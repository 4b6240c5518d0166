"""Grade cards: words are the table's for the numbers, in two languages, on pages that are whole."""

from __future__ import annotations

import io
import json
import re
from pathlib import Path
from string import Formatter

import numpy as np
import pytest

import nacreous as nc
from nacreous import cli, figure
from nacreous.card import CULTURES, Card, graded, html, make, record, save
from nacreous.card.card import SCENE
from nacreous.card.translation import Texts, texts
from nacreous.measure import Measures
from nacreous.spec import Pearl
from nacreous.trade import word_of


@pytest.fixture(scope="module")
def cards() -> list[Card]:
    return make(["akoya-rg", "paper"], culture="akoya", size=128, samples=1)


def test_every_word_is_the_tables_for_the_numbers_beside_it(cards: list[Card]) -> None:
    for card in cards:
        for factor in card.factors:
            if factor.word is None:
                assert factor.note, factor.name
                continue
            numbers = {one.quantity: one.value for one in factor.figures}
            assert factor.word.holds(numbers), factor.name
            assert {one.quantity for one in factor.word.ranges} & set(numbers), factor.name
            assert factor.word in nc.trade.words(factor.word.factor)


def test_a_number_of_the_file_names_its_key_and_a_measured_one_has_none(cards: list[Card]) -> None:
    for one in (one for card in cards for factor in card.factors for one in factor.figures):
        assert bool(one.key) == (one.origin == "file")


def _factor(pearl: Pearl, name: str, found: Measures | None = None, culture: str | None = None):
    return next(one for one in graded(pearl, found, culture) if one.name == name)


def test_luster_is_by_the_facets_where_the_file_says_them_and_by_the_knob_where_not() -> None:
    for knob in (0.1, 0.3, 0.5, 0.7, 0.9):
        found = _factor(Pearl(shininess=knob), "luster")
        assert (found.word, found.figures[0].key) == (
            word_of("luster", {"shininess": knob}),
            "shininess",
        )
    found = _factor(Pearl(surface={"facet_spread_rad": 0.12}), "luster")
    assert (found.word.en, found.figures[0].key) == ("Fair", "surface.facet_spread_rad")


@pytest.mark.parametrize("culture", CULTURES)
def test_nacre_has_a_word_only_where_the_kind_of_pearl_is_said(culture: str) -> None:
    pearl = Pearl(body={"nacre_mm": 0.9})
    assert _factor(pearl, "nacre").word is None
    assert _factor(pearl, "nacre").figures[0].value == 0.9
    assert _factor(pearl, "nacre", culture=culture).word == word_of(f"nacre-{culture}", 0.9)


def test_blemishes_count_by_the_files_area_and_without_one_by_the_picture() -> None:
    assert _factor(Pearl(), "surface").word.en == "clean"
    stated = Pearl(blemishes={"pits": 3, "area": 0.06})
    assert _factor(stated, "surface").word.en == "moderately spotted"
    assert _factor(Pearl(blemishes={"area": 0.06}), "surface").word.en == "clean"  # of none
    assert _factor(Pearl(blemishes={"pits": 3}), "surface").note == "unmeasured"


def test_the_shape_is_the_files_and_the_outline_stands_beside_it(cards: list[Card]) -> None:
    assert _factor(Pearl(), "shape").word.en == "round"
    drop = _factor(Pearl(shape={"length": 1.35, "taper": 0.6}), "shape")
    assert drop.word.en == "drop"
    assert {one.key for one in drop.figures} == {"shape"}
    for card, key in zip(cards, ("shape", "model"), strict=False):
        shape = next(one for one in card.factors if one.name == "shape")
        assert shape.word.en == "round"
        assert [one.origin for one in shape.figures] == ["file", "picture"]
        assert shape.figures[0].key == key


def test_of_the_illuminant_model_is_told_what_can_be_told(cards: list[Card]) -> None:
    factors = {factor.name: factor for factor in cards[1].factors}
    assert [name for name, one in factors.items() if one.word is None] == ["surface", "matching"]
    assert factors["bodycolour"].figures[0].key == "body_colour"


def test_a_picture_too_small_to_measure_leaves_words_out_and_says_so() -> None:
    (card,) = make(["akoya-rg"], size=8, samples=1)
    unmeasured = [one.name for one in card.factors if one.note == "unmeasured"]
    assert unmeasured == ["overtone"]
    assert texts("en")["note.as_overtone"] in html([card])


def _places(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def test_both_languages_have_the_same_keys_and_places() -> None:
    english, japanese = texts("en"), texts("ja")
    assert list(english) == list(japanese)
    for key, text in english.items():
        assert _places(text) == _places(japanese[key]), key


def _without_spans(page: str) -> str:
    return re.sub("</?span>", "", page)


def test_sources_on_a_japanese_page_are_japanese(cards: list[Card]) -> None:
    page = html(cards, "ja")
    assert "(当方)" in page
    assert "(ours)" not in page
    assert "(ours)" in html(cards, "en")


@pytest.mark.parametrize("language", ["en", "ja"])
def test_a_page_says_what_it_is_and_how_it_is_made_again(cards, language: str) -> None:
    page = html(cards, language, "out.html")
    assert texts(language)["not_graded"] in page
    assert "nacreous card akoya-rg paper --scene booth --type akoya" in _without_spans(page)
    assert page.count("data:image/png;base64,") == 2
    assert 'class="batch"' in page
    assert not re.search(r'(src|href)="(?!data:|#)', page)  # it asks for nothing
    luster = next(one for one in cards[0].factors if one.name == "luster")
    assert f"{luster.word.text(language)}</td>" in page


def test_a_name_of_the_pearl_is_text_on_the_page() -> None:
    (card,) = make([Pearl(name="<b>&")], size=8, samples=1)
    assert "<b>&" not in html([card])
    assert texts("en")["no_command"] in html([card])


@pytest.mark.parametrize("ending", [".html", ".png"])
def test_the_same_call_gives_the_same_bytes(cards, tmp_path: Path, ending: str) -> None:
    pages = []
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        place = tmp_path / folder / f"card{ending}"
        save(place, cards)
        pages.append(place.read_bytes())
    assert pages[0] == pages[1]


def test_the_record_has_both_languages_and_every_number(cards: list[Card]) -> None:
    held = json.loads(record(cards))
    size = held["cards"][0]["factors"][0]
    assert size["word"] == {"en": "8.0-8.5 mm", "ja": "8.0～8.5 mm"}
    assert size["numbers"][0]["from"] == "file"
    assert Pearl.from_toml(held["cards"][0]["file"]) == cards[0].pearl


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["akoya-rg", "--language", "fr"], "--language is 'fr'; allowed: en, ja"),
        (["akoya-rg", "--type", "akoja"], "--type is 'akoja'; did you mean akoya?"),
        (["akoya-rgg"], "is neither a file nor a pearl preset; did you mean akoya-rg?"),
        (["akoya-rg", "-o", "card.pdf"], "card.pdf: the ending is .pdf; allowed: .html, .png"),
        (["akoya-rg", "--json", "card.txt"], "card.txt: the ending is .txt; allowed: .json"),
        (["akoya-rg"] * 49, "the number of pearls is 49; allowed: a whole number, 1 to 48"),
    ],
)
def test_what_cannot_be_is_said_in_one_line_and_nothing_is_written(
    tmp_path, monkeypatch, capsys, words: list[str], message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["card", *words, "--size", "8"]) == 2
    assert message in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_another_language_is_refused_in_python_too(cards, tmp_path) -> None:
    with pytest.raises(nc.InputError, match="language is 'fr'; allowed: en, ja"):
        save(tmp_path / "card.html", cards, "fr")
    assert list(tmp_path.iterdir()) == []


def test_a_page_never_takes_the_place_of_the_pearls_file(tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pearl.toml").write_text("depth = 0.5")
    (tmp_path / "card.html").symlink_to("pearl.toml")
    assert cli.main(["card", "pearl.toml", "--size", "8"]) == 2
    assert "is the same file as the input pearl.toml" in capsys.readouterr().err
    assert (tmp_path / "pearl.toml").read_text() == "depth = 0.5"


def test_a_picture_in_japanese_without_a_font_is_refused_with_the_line_that_installs_one(
    cards, tmp_path, monkeypatch
) -> None:
    monkeypatch.setattr(figure, "japanese_fonts", list)
    with pytest.raises(nc.InputError, match="sudo apt install fonts-noto-cjk"):
        save(tmp_path / "card.png", cards, "ja")
    assert list(tmp_path.iterdir()) == []


def test_a_page_that_fails_half_way_leaves_the_old_one(cards, tmp_path, monkeypatch) -> None:
    place = tmp_path / "card.html"
    place.write_text("old")

    def fail(*_: object) -> str:
        raise RuntimeError

    monkeypatch.setattr("nacreous.card.page.html", fail)
    with pytest.raises(RuntimeError):
        save(place, cards)
    assert [one.read_text() for one in tmp_path.iterdir()] == ["old"]


def test_no_card_is_no_page(tmp_path) -> None:
    for path in ("none.html", "none.png"):
        with pytest.raises(nc.InputError, match="there is no card"):
            save(tmp_path / path, [])
    assert not list(tmp_path.iterdir())


def test_a_scene_is_read_from_standard_input_once(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b'name = "given"\n')))
    assert cli.main(["card", "akoya-rg", "--scene", "-", "--size", "64", "-o", "c.html"]) == 0
    assert "given" in (tmp_path / "c.html").read_text(encoding="utf-8")


def test_the_record_and_the_card_have_the_command_that_makes_them_again() -> None:
    how = {"size": 32, "samples": 1, "words": ["luster=Fair"], "overrides": ["depth=0.3"]}
    (card,) = make(["akoya-rg"], **how)
    assert (card.pearl.shininess, card.pearl.depth) == (0.253, 0.3)
    wanted = "--scene booth --word luster=Fair --set depth=0.3 --language ja"
    assert wanted in json.loads(record([card], "c.html", "ja"))["command"]
    assert wanted in _without_spans(html([card], "ja", "c.html"))
    with pytest.raises(nc.InputError, match="given with a model"):
        make([Pearl()], **how)


def test_the_default_scene_adds_no_hue_to_a_grey_pearl() -> None:
    for colour in ("#777777", "#ababab"):
        lab = nc.colour.lab_from_xyz(nc.colour.xyz_from_rgb(nc.colour.linear_from_hex(colour)))
        assert np.hypot(lab[1], lab[2]) < 0.1
    scene = nc.Scene.load(SCENE)
    assert {window.spectrum for window in scene.windows} == {"D65"}
    assert {scene.table.colour, scene.walls.colour, scene.sky.horizon} == {"#777777", "#ababab"}


def test_what_is_not_round_has_width_and_length_and_numbers_have_digits_that_mean_something() -> (
    None
):
    drop = graded(Pearl(diameter_mm=12.0, shape={"length": 1.45, "taper": 0.6}), None)
    shown = [Texts("en").number(one) for factor in drop[:2] for one in factor.figures]
    assert "width x length 12.00 x 17.40 mm" in shown
    assert "departure from a figure of revolution 0.0 %" in shown
    for factor in graded(Pearl(), None):
        assert "length_mm" not in [one.quantity for one in factor.figures]


def test_the_reason_that_a_picture_gives_is_told_in_both_languages() -> None:
    why = "no pearl: no round outline stands out (an edge in 12 % of all directions; wanted: 40 %)"
    overtone = next(one for one in graded(Pearl(), why) if one.name == "overtone")
    assert Texts("en").note(overtone) == f"Not told: {why}."
    assert "全方向の12 %" in Texts("ja").note(overtone)


def test_a_picture_of_letters_that_no_font_has_is_refused_and_a_page_is_not(tmp_path) -> None:
    (card,) = make([Pearl(name="\ua98f")], size=8, samples=1)
    save(tmp_path / "card.html", [card])
    with pytest.raises(nc.InputError, match="no font here has \ua98f of the pearl's file"):
        save(tmp_path / "card.png", [card])
    assert [one.name for one in tmp_path.iterdir()] == ["card.html"]

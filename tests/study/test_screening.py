"""A screen check: what is measured is described, nothing that came is lost, and rules decide."""

from typing import Any

import pytest
from pydantic import ValidationError

from nacreous.study.design.screen import Screen
from nacreous.study.running.screen_check import ScreenCheck
from nacreous.study.running.screening import flags_of, is_refused

GOOD = {
    "window": {"width_px": 1600, "height_px": 900, "device_pixel_ratio": 2},
    "full_screen": True,
    "card": {"px_per_mm": 4.2},
    "distance_mm": 620,
    "distance_by": "blind-spot",
    "gamma": 2.2,
    "darkest_step": 5,
    "gamut": "srgb",
}


def test_a_good_screen_has_no_flag() -> None:
    plates = {"contrast": {"right": 7, "of": 8}, "colour": {"right": 6, "of": 8}}
    screen = Screen(vision=("contrast", "colour"))
    assert flags_of(screen, ScreenCheck(**GOOD, vision=plates)) == ()


@pytest.mark.parametrize(
    ("change", "flags"),
    [
        ({"window": None}, ["small-window"]),
        ({"window": {"width_px": 1600, "height_px": 639.5}}, ["small-window"]),
        ({"full_screen": False}, ["not-full-screen"]),
        ({"full_screen": None}, ["not-full-screen"]),
        ({"card": None}, ["no-card"]),
        ({"distance_mm": None, "distance_by": "none"}, ["no-distance"]),
        ({"distance_mm": 199.9}, ["distance"]),
        ({"distance_mm": 2000.1, "distance_by": "typed"}, ["distance"]),
        ({"gamma": None}, ["no-levels"]),
        ({"gamma": 1.5, "darkest_step": 17}, ["gamma", "darkest-step"]),
        ({"gamma": 2.81, "darkest_step": None}, ["no-levels", "gamma"]),
        ({"gamut": "less"}, ["small-gamut"]),
        ({"vision": None}, ["colour-vision"]),
        ({"vision": {}}, ["colour-vision"]),
        ({"vision": {"colour": {"right": 5, "of": 8}}}, ["colour-vision"]),
        ({"vision": {"colour": {"right": 0, "of": 0}}}, ["colour-vision"]),
    ],
)
def test_what_falls_short_is_flagged(change: dict[str, Any], flags: list[str]) -> None:
    check = ScreenCheck(**{**GOOD, "vision": {"colour": {"right": 6, "of": 8}}, **change})
    assert list(flags_of(Screen(vision=("colour",)), check)) == flags


def test_what_is_not_asked_for_is_not_missed() -> None:
    screen = Screen(full_screen=False, card=False, distance=False, levels=False)
    assert flags_of(screen, ScreenCheck(window=GOOD["window"])) == ()


@pytest.mark.parametrize(
    "change",
    [
        {"window": 3},
        {"window": {"width_px": "1600", "height_px": 900}},
        {"card": {"px_per_mm": float("nan")}},
        {"card": {"px_per_mm": 0}},
        {"card": [4.2]},
        {"distance_mm": -1},
        {"distance_tries_mm": [600, -1]},
        {"distance_by": "guess"},
        {"gamma": True},
        {"darkest_step": 256},
        {"darkest_step": 10**400},
        {"full_screen": "yes"},
        {"vision": {"contrast": 8}},
        {"later": float},
    ],
)
def test_what_no_screen_has_is_refused(change: dict[str, Any]) -> None:
    with pytest.raises(ValidationError):
        ScreenCheck(**{**GOOD, **change})


def test_what_the_pages_can_find_is_taken_at_its_extremes() -> None:
    for gamma in (0.66, 11.44):  # at either end of the slider, codes 90 and 240
        assert ScreenCheck(gamma=gamma).gamma == gamma
    for step in (2, 255):
        assert ScreenCheck(darkest_step=step).darkest_step == step
    for distance_mm in (100, 3000, 22_000):  # typed at either end; a wall of 8000 px
        assert ScreenCheck(distance_tries_mm=[distance_mm]).distance_tries_mm == [distance_mm]
    for ratio in (0.25, 20):  # a browser's zoom of 25 %, and of 500 % on a telephone
        window = {"width_px": 0, "height_px": 0, "device_pixel_ratio": ratio}
        assert ScreenCheck(window=window).window.device_pixel_ratio == ratio


def test_keys_of_other_versions_are_kept_as_they_came() -> None:
    sent = {
        "window": {"width_px": 1600.0, "height_px": 900.0, "turned": True},
        "ambient_lux": [120, None, {"by": "camera"}],
    }
    assert ScreenCheck.model_validate(sent).model_dump(exclude_unset=True) == sent


@pytest.mark.parametrize(
    ("rule", "flags"),
    [
        ("if_smaller", ["small-window"]),
        ("if_not_full_screen", ["not-full-screen"]),
        ("if_no_card", ["no-card"]),
        ("if_no_distance", ["no-distance", "distance"]),
        ("if_small_gamut", ["small-gamut"]),
        ("if_levels", ["no-levels", "gamma", "darkest-step"]),
        ("if_vision", ["contrast-vision", "colour-vision"]),
    ],
)
def test_a_rule_refuses_its_own_flags_and_no_others(rule: str, flags: list[str]) -> None:
    every = ["small-window", "no-card", "no-levels", "gamma", "darkest-step", "contrast-vision"]
    every += ["colour-vision", "not-full-screen", "no-distance", "distance", "small-gamut"]
    every += ["of a newer version"]
    screen = Screen(vision=("contrast", "colour"), **{rule: "refuse"})
    assert [flag for flag in every if is_refused(screen, [flag])] == flags

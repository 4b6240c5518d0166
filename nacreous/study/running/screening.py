"""What a screen check amounts to: its flags, and whether the study refuses such a screen."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Literal

from nacreous.study.design.screen import Screen
from nacreous.study.running.screen_check import Plates, ScreenCheck, Vision, Window

__all__ = ["ScreenFlag", "flags_of", "is_refused"]

ScreenFlag = Literal[
    "small-window",
    "not-full-screen",
    "no-card",
    "no-distance",
    "distance",
    "no-levels",
    "gamma",
    "darkest-step",
    "small-gamut",
    "contrast-vision",
    "colour-vision",
]

#: The rule that decides what a flag means; a store may hold flags of other versions.
_RULES: Mapping[str, str] = {
    "small-window": "if_smaller",
    "not-full-screen": "if_not_full_screen",
    "no-card": "if_no_card",
    "no-distance": "if_no_distance",
    "distance": "if_no_distance",
    "no-levels": "if_levels",
    "gamma": "if_levels",
    "darkest-step": "if_levels",
    "small-gamut": "if_small_gamut",
    "contrast-vision": "if_vision",
    "colour-vision": "if_vision",
}


def flags_of(screen: Screen, check: ScreenCheck) -> tuple[ScreenFlag, ...]:
    """What falls short in a screen check, in words that answers are exported with.

    What was asked for and is not there falls short too.

    >>> check = ScreenCheck(window={"width_px": 800, "height_px": 900}, full_screen=True)
    >>> flags_of(Screen(levels=False, distance=False), check)
    ('small-window', 'no-card')
    """
    return tuple(_flags(screen, check))


def is_refused(screen: Screen, flags: Collection[str]) -> bool:
    """Whether the study's rules let nobody go on with such a screen.

    >>> is_refused(Screen(if_no_card="refuse"), ["no-card"])
    True
    """
    return any(getattr(screen, _RULES[flag]) == "refuse" for flag in flags if flag in _RULES)


def _flags(screen: Screen, check: ScreenCheck) -> Iterator[ScreenFlag]:
    window = check.window
    if window is None or not _large_enough(window, screen):
        yield "small-window"
    if screen.full_screen and not check.full_screen:
        yield "not-full-screen"
    if screen.card and check.card is None:
        yield "no-card"
    if screen.distance:
        yield from _distance(screen, check.distance_mm)
    if screen.levels:
        yield from _levels(screen, check)
    if check.gamut == "less":
        yield "small-gamut"
    vision = check.vision or Vision()
    if "contrast" in screen.vision and not _passes(vision.contrast, screen):
        yield "contrast-vision"
    if "colour" in screen.vision and not _passes(vision.colour, screen):
        yield "colour-vision"


def _large_enough(window: Window, screen: Screen) -> bool:
    wide = window.width_px >= screen.least_width_px
    return wide and window.height_px >= screen.least_height_px


def _distance(screen: Screen, found_mm: float | None) -> Iterator[ScreenFlag]:
    if found_mm is None:
        yield "no-distance"
    elif not screen.least_distance_mm <= found_mm <= screen.most_distance_mm:
        yield "distance"


def _levels(screen: Screen, check: ScreenCheck) -> Iterator[ScreenFlag]:
    gamma, step = check.gamma, check.darkest_step
    if gamma is None or step is None:
        yield "no-levels"
    if gamma is not None and not screen.least_gamma <= gamma <= screen.most_gamma:
        yield "gamma"
    if step is not None and step > screen.darkest_step:
        yield "darkest-step"


def _passes(plates: Plates | None, screen: Screen) -> bool:
    if plates is None or plates.of == 0:
        return False
    return plates.right >= screen.least_right * plates.of

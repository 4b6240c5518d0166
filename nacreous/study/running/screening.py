"""What a screen check amounts to: its flags, and whether the study refuses such a screen."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

from nacreous.problem import InputError
from nacreous.study.design.screen import Screen

__all__ = ["flags_of", "is_refused"]

#: The rule that decides what a flag means.
_RULES = {
    "small-window": "if_smaller",
    "not-full-screen": "if_not_full_screen",
    "no-card": "if_no_card",
    "no-distance": "if_no_distance",
    "no-levels": "if_levels",
    "gamma": "if_levels",
    "darkest-step": "if_levels",
    "small-gamut": "if_small_gamut",
    "contrast-vision": "if_vision",
    "colour-vision": "if_vision",
}


def flags_of(screen: Screen, content: Mapping[str, Any]) -> tuple[str, ...]:
    """What falls short in a screen check, in words that answers are exported with.

    What was asked for and is not there falls short too. Raises `InputError` for a number that is
    none.

    >>> window = {"width_px": 800, "height_px": 900}
    >>> flags_of(Screen(levels=False, distance=False), {"window": window, "full_screen": True})
    ('small-window', 'no-card')
    """
    return tuple(_flags(screen, content))


def is_refused(screen: Screen, flags: Collection[str]) -> bool:
    """Whether the study's rules let nobody go on with such a screen.

    >>> is_refused(Screen(if_no_card="refuse"), ["no-card"])
    True
    """
    return any(getattr(screen, _RULES[flag]) == "refuse" for flag in flags if flag in _RULES)


def _flags(screen: Screen, content: Mapping[str, Any]) -> Iterator[str]:
    width, height = (_number(content, "window", name) for name in ("width_px", "height_px"))
    if (width or 0) < screen.least_width_px or (height or 0) < screen.least_height_px:
        yield "small-window"
    if screen.full_screen and content.get("full_screen") is not True:
        yield "not-full-screen"
    if screen.card and _number(content, "card", "px_per_mm") is None:
        yield "no-card"
    if screen.distance and _number(content, "distance_mm") is None:
        yield "no-distance"
    if screen.levels:
        yield from _levels(screen, content)
    if content.get("gamut") == "less":
        yield "small-gamut"
    for test in screen.vision:
        right, of = (_number(content, "vision", test, name) for name in ("right", "of"))
        if not of or (right or 0) < screen.least_right * of:
            yield f"{test}-vision"


def _levels(screen: Screen, content: Mapping[str, Any]) -> Iterator[str]:
    gamma, step = _number(content, "gamma"), _number(content, "darkest_step")
    if gamma is None or step is None:
        yield "no-levels"
    if gamma is not None and not screen.least_gamma <= gamma <= screen.most_gamma:
        yield "gamma"
    if step is not None and step > screen.darkest_step:
        yield "darkest-step"


def _number(content: Any, *path: str) -> float | None:
    """A number of the check by its keys; None where it or a table above it is not given."""
    value = content
    for name in path:
        if value is None:
            return None
        if not isinstance(value, Mapping):
            raise InputError(f"screen.{'.'.join(path)}: {ascii(value)[:40]} stands in its place")
        value = value.get(name)
    if value is None:
        return None
    good = isinstance(value, int | float) and not isinstance(value, bool)
    if not good or not 0 <= value <= 1e6:
        said = ascii(value)[:40]
        raise InputError(f"screen.{'.'.join(path)} is {said}; allowed: a number, 0 to 1000000")
    return float(value)

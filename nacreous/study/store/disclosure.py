"""What of that which a participant's browser sent goes into every export.

A browser may send what it likes, and somebody may write a name or a telephone number into it: only
keys that our pages have go, with numbers, truth values and our own words. The rest goes where what
may identify a person is asked for.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, TypeAlias

from nacreous.study.store.watch import NOTICED

__all__ = ["SCREEN_CHECK", "browser_family", "plain_check", "plain_flags"]

#: The words that a value may be beside a number.
Words: TypeAlias = frozenset[str]
_NUMBER: Words = frozenset()
#: No count and no measurement is larger; telephone numbers are.
_MOST = 1e6
_AREA = {"width_px": _NUMBER, "height_px": _NUMBER}
_PLATES = {"right": _NUMBER, "of": _NUMBER}

#: The keys of a screen check, each with its table's keys or its words.
SCREEN_CHECK: Mapping[str, Words | Mapping[str, Any]] = {
    "window": {**_AREA, "device_pixel_ratio": _NUMBER},
    "full_screen": _NUMBER,
    "screen": {**_AREA, "colour_depth": _NUMBER},
    "card": {"px_per_mm": _NUMBER},
    "picture_width_mm": _NUMBER,
    "distance_mm": _NUMBER,
    "distance_by": frozenset(("blind-spot", "typed", "none")),
    "distance_tries_mm": _NUMBER,
    "gamma": _NUMBER,
    "darkest_step": _NUMBER,
    "gamut": frozenset(("less", "srgb", "p3", "rec2020")),
    "hdr": _NUMBER,
    "vision": {"contrast": _PLATES, "colour": _PLATES},
    "simulated": _NUMBER,
    "flags": frozenset(
        (
            *("small-window", "not-full-screen", "no-card", "no-distance", "distance"),
            *("no-levels", "gamma", "darkest-step", "small-gamut"),
            *("contrast-vision", "colour-vision"),
        )
    ),
}
#: Those of which a value is several.
_LISTS = ("distance_tries_mm", "flags")
#: Of what a trial was marked with; Watch counts the same.
_FLAGS: Mapping[str, Words] = dict.fromkeys(NOTICED, _NUMBER)
#: The browsers that our pages tell apart.
_FAMILIES = (
    *("Edge", "Opera", "Samsung Internet", "Firefox", "Chromium", "Safari"),
    *("another browser", "simulated"),
)


def plain_check(check: Mapping[str, Any]) -> dict[str, Any]:
    """A screen check, with `at`, when it came by our own clock.

    >>> plain_check({"at": "2026-03-01", "gamma": 2.2, "gamut": "my name", "phone": 5551234})
    {'at': '2026-03-01', 'gamma': 2.2}
    """
    return {"at": check["at"], **_plain(check, SCREEN_CHECK)}


def plain_flags(flags: str) -> str:
    """What was noticed while an answer was given, from JSON to JSON.

    >>> plain_flags('{"away":2,"note":"my name"}')
    '{"away":2}'
    """
    if flags == "{}":  # as nearly all are
        return flags
    return json.dumps(_plain(json.loads(flags), _FLAGS), sort_keys=True, separators=(",", ":"))


def browser_family(agent: str) -> str | None:
    """A browser's family, without its version, if it is one that our pages tell apart.

    >>> browser_family("Samsung Internet 25"), browser_family("Kokichi 3"), browser_family("")
    ('Samsung Internet', None, None)
    """
    for family in _FAMILIES:
        if agent == family or agent.startswith(f"{family} "):
            return family
    return None


def _plain(given: Mapping[str, Any], allowed: Mapping[str, Any]) -> dict[str, Any]:
    kept: dict[str, Any] = {}
    for key, words in allowed.items():
        value = given.get(key)
        if isinstance(words, Mapping):
            if isinstance(value, Mapping):
                kept[key] = _plain(value, words)
        elif isinstance(value, list) and key in _LISTS:
            kept[key] = [part for part in value if _is_plain(part, words)]
        elif value is not None and _is_plain(value, words):
            kept[key] = value
    return kept


def _is_plain(value: Any, words: Words) -> bool:
    if isinstance(value, str):
        return value in words
    return isinstance(value, int | float) and abs(value) <= _MOST

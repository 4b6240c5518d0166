"""The [screen] of a study: what is asked of a participant's screen and eyes, and what follows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section

Rule = Literal["flag", "refuse"]
Vision = Literal["contrast", "colour"]

#: What a flag of a screen check hangs on: the keys that say whether it refuses.
RULES = (
    *("if_smaller", "if_not_full_screen", "if_no_card", "if_no_distance", "if_levels"),
    *("if_small_gamut", "if_vision"),
)


def _rule(when: str) -> Any:
    return key(
        "flag",
        f"{when}: keep the answers with a mark, or do not begin.",
        allowed='"flag" or "refuse"',
        source="**(ours)**",
    )


def _check(what: str) -> Any:
    return key(True, what, allowed="true or false", source="**(ours)**")


class Screen(Section):
    """What is asked of a participant's screen, and what follows where it falls short."""

    least_width_px: int = quantity(
        1024,
        "The least width of the window, in the browser's pixels.",
        least=200,
        most=10_000,
        source="**(ours)**",
    )
    least_height_px: int = quantity(
        640,
        "The least height of the window, in the browser's pixels.",
        least=200,
        most=10_000,
        source="**(ours)**",
    )
    if_smaller: Rule = _rule("Where the window is smaller")
    full_screen: bool = _check("Whether the pages fill the screen.")
    if_not_full_screen: Rule = _rule("Where they do not fill it")
    card: bool = _check("Whether the screen is measured with a bank card, so that sizes are in mm.")
    if_no_card: Rule = _rule("Where the size of a millimetre is not known")
    distance: bool = _check(
        "Whether the viewing distance is asked for: by the blind spot, or typed in."
    )
    least_distance_mm: float = quantity(
        200.0,
        "The least viewing distance that passes.",
        least=50,
        most=10_000,
        unit="mm",
        source="**(ours)**; nearer than this few adults see sharply (Duane 1922)",
    )
    most_distance_mm: float = quantity(
        2000.0,
        "The greatest viewing distance that passes.",
        least=50,
        most=10_000,
        unit="mm",
        source="**(ours)**; farther away nobody reaches keys or mouse",
    )
    if_no_distance: Rule = _rule("Where the viewing distance is not known or does not pass")
    levels: bool = _check("Whether gamma and the darkest step that can be seen are found by eye.")
    least_gamma: float = quantity(
        1.6, "The least gamma that passes.", least=0.5, most=5, source="**(ours)**"
    )
    most_gamma: float = quantity(
        2.8, "The greatest gamma that passes.", least=0.5, most=5, source="**(ours)**"
    )
    darkest_step: int = quantity(
        16,
        "The greatest first step above black that passes, of 255.",
        least=1,
        most=255,
        source="**(ours)**",
    )
    if_levels: Rule = _rule("Where gamma or the darkest step does not pass, or was not found")
    if_small_gamut: Rule = _rule("Where the browser says that the screen shows less than sRGB")
    vision: tuple[Vision, ...] = key(
        (),
        "Which tests of the eyes are made, on plates of ours; no diagnosis.",
        allowed='"contrast", "colour" or both, each once',
        source="**(ours)**",
        strict=False,
        max_length=2,
    )
    least_right: float = quantity(
        0.75, "The share of plates read right that passes.", least=0, most=1, source="**(ours)**"
    )
    if_vision: Rule = _rule("Where fewer plates are read right, or none were shown")

    @property
    def refuses(self) -> bool:
        """Whether there is a screen with which nobody may begin.

        >>> Screen().refuses, Screen(if_levels="refuse").refuses
        (False, True)
        """
        return any(getattr(self, name) == "refuse" for name in RULES)

    def contradictions(self) -> Iterator[Contradiction]:
        """A test made twice, a range that is none, and rules that nothing could break."""
        if len(set(self.vision)) < len(self.vision):
            yield Contradiction("vision", f"are {shown(self.vision)}; allowed: each once")
        if self.least_gamma >= self.most_gamma:
            verdict = f"is {shown(self.least_gamma)}, not below {{other}}; allowed: less"
            yield Contradiction("least_gamma", verdict, "most_gamma")
        if self.least_distance_mm >= self.most_distance_mm:
            verdict = f"is {shown(self.least_distance_mm)}, not below {{other}}; allowed: less"
            yield Contradiction("least_distance_mm", verdict, "most_distance_mm")
        for rule, check in (
            ("if_not_full_screen", "full_screen"),
            ("if_no_card", "card"),
            ("if_no_distance", "distance"),
            ("if_levels", "levels"),
            ("if_vision", "vision"),
        ):
            if getattr(self, rule) == "refuse" and not getattr(self, check):
                said = shown(getattr(self, check))
                verdict = f'is "refuse" while {{other}} is {said}; nobody would be asked'
                yield Contradiction(rule, verdict, check)

"""The card's texts in one language."""

from __future__ import annotations

import json
import math
import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous import toml_text
from nacreous.number import said
from nacreous.problem import InputError

if TYPE_CHECKING:
    from nacreous.card.factor import Factor, Figure
    from nacreous.trade.word import Language

__all__ = ["LANGUAGES", "Texts", "texts"]

LANGUAGES: tuple[Language, ...] = ("en", "ja")
#: Digits behind the point, finer than the bounds of words and than anybody grades **(ours)**.
_DIGITS = {
    "diameter_mm": 2,
    "length_mm": 2,
    "diameter_variation_percent": 1,
    "outline_variation_percent": 1,
    "height_over_width": 2,
    "taper_percent": 1,
    "asymmetry_percent": 1,
    "grooves": 0,
    "lightness": 1,
    "chroma": 1,
    "hue_deg": 0,
    "hue_range_deg": 0,
    "orient": 2,
    "facet_spread_rad": 3,
    "shininess": 3,
    "image_width_deg": 1,
    "blemished_percent": 1,
    "nacre_mm": 2,
}


class Texts:
    """All texts of one language, by their keys in en.toml or ja.toml.

    >>> Texts("ja")("factor.luster"), Texts("en")("factor.luster")
    ('テリ', 'Luster')
    """

    def __init__(self, language: str) -> None:
        """Raises `InputError` for another language."""
        if language not in LANGUAGES:
            raise InputError(f"language is {said(language)}; allowed: {', '.join(LANGUAGES)}")
        self.language: Language = "ja" if language == "ja" else "en"

    def __call__(self, key: str, /, **values: object) -> str:
        """The text of a key, with the values in their places."""
        return texts(self.language)[key].format(**values)

    def name(self, factor: Factor) -> str:
        """What a factor is called."""
        return self(f"factor.{factor.name}")

    def word(self, factor: Factor) -> str:
        """The factor's word, or a dash."""
        return "–" if factor.word is None else factor.word.text(self.language)

    def note(self, factor: Factor) -> str:
        """Why something is left out, or how it was had; "" where nothing is to be said."""
        if factor.reason:
            return self("because", reason=self.reason(factor.reason))
        return self(f"note.{factor.note}") if factor.note else ""

    def reason(self, reason: str) -> str:
        """Why the picture lets something not be measured; in English where it has no Japanese.

        >>> Texts("ja").reason("the pearl is too small")
        '真珠が小さすぎます'
        """
        if self.language == "ja":
            for pattern, text in reasons():
                if found := re.search(pattern, reason):
                    return text.format(*found.groups())
        return reason

    def value(self, figure: Figure) -> str:
        """A number's digits: to the first digit of its error, or as many as its quantity has."""
        digits = _DIGITS[figure.quantity]
        if figure.error:
            digits = min(max(-math.floor(math.log10(figure.error)), 0), 4)
        shown = _rounded(figure.value, digits)
        if figure.error is not None:
            shown += f" ± {_rounded(figure.error, digits)}"
        return shown if figure.across is None else f"{_rounded(figure.across, digits)} x {shown}"

    def number(self, figure: Figure) -> str:
        """A number with its name, unit and standard error: "diameter 8.00 mm"."""
        shown = self.value(figure)
        name, unit = self(f"quantity.{figure.quantity}"), self(f"unit.{figure.unit}")
        return self("number", name=name, value=shown, unit=unit).rstrip()

    def origin(self, figure: Figure) -> str:
        """Where a number is from."""
        return self(f"origin.{figure.origin}", key=figure.key)

    def bounds(self, factor: Factor) -> str:
        """What the word stands for, of the quantities that the card has: "0.025 to 0.05 rad"."""
        here = {figure.quantity for figure in factor.figures}
        ranges = () if factor.word is None else factor.word.ranges
        return "; ".join(
            self(
                "bounds" if one.upper < float("inf") else "bounds_open",
                name=self(f"quantity.{one.quantity}"),
                lower=f"{one.lower:g}",
                upper=f"{one.upper:g}",
                unit=self(f"unit.{one.unit}"),
            ).rstrip()
            for one in ranges
            if one.quantity in here
        )


def _rounded(value: float, digits: int) -> str:
    """So many digits behind the point, and no -0."""
    return f"{round(value, digits) + 0.0:.{digits}f}"


@cache
def reasons() -> list[tuple[str, str]]:
    """Patterns of what `nacreous.measure` says, and their Japanese; the viewer reads them too."""
    content = Path(__file__).with_name("reasons.json").read_text(encoding="utf-8")
    return [(one["pattern"], one["ja"]) for one in json.loads(content)]


@cache
def texts(language: str) -> dict[str, str]:
    """The texts of a language by dotted key."""
    content = Path(__file__).with_name(f"{language}.toml").read_text(encoding="utf-8")
    return dict(toml_text.flat(toml_text.loads(content)))

"""The card's texts in one language."""

from __future__ import annotations

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
        return self(f"note.{factor.note}") if factor.note else ""

    def number(self, figure: Figure) -> str:
        """A number with its name, unit and standard error: "diameter 8 mm"."""
        shown = f"{figure.value:.3g}"
        if figure.error is not None:
            shown += f" ± {figure.error:.1g}"
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


@cache
def texts(language: str) -> dict[str, str]:
    """The texts of a language by dotted key."""
    content = Path(__file__).with_name(f"{language}.toml").read_text(encoding="utf-8")
    return dict(toml_text.flat(toml_text.loads(content)))

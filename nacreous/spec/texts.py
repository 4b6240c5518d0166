"""The texts that keys may hold: names, colours, lights and file endings."""

from __future__ import annotations

from typing import Annotated
from unicodedata import normalize

from pydantic import AfterValidator, Field

from nacreous.printable import printable
from nacreous.spec.key import FilePath


def ending(*suffixes: str) -> str:
    """A pattern for paths with one of these endings, in small or capital letters.

    >>> ending(".hdr")
    '.+[.]([hH][dD][rR])'
    """
    either = [
        "".join(f"[{letter}{letter.upper()}]" for letter in suffix[1:]) for suffix in suffixes
    ]
    return f".+[.]({'|'.join(either)})"


def _one_line(text: str) -> str:
    """In Unicode's form NFC, in which names are compared."""
    text = normalize("NFC", text.strip(" \u3000"))
    if not text or printable(text) != text:
        raise ValueError("blank, or not printable")
    return text


Name = Annotated[str, Field(min_length=1, max_length=120), AfterValidator(_one_line)]
NAME = "one line of 1 to 120 characters"

Word = Annotated[str, Field(pattern="^[a-z0-9][a-z0-9_-]{0,39}$")]
WORD = "1 to 40 of a to z, 0 to 9, - and _, the first a letter or digit"

Colour = Annotated[str, Field(pattern="^#[0-9a-fA-F]{6}$")]
COLOUR = '"#rrggbb", six hexadecimal digits of sRGB'

_ILLUMINANTS = "A|C|D50|D55|D65|D75|E|FL?([1-9]|1[0-2])|LED-(B[1-5]|BH1|RGB1|V[12])"
_NAMES = (
    '"A", "C", "D50", "D55", "D65", "D75", "E", "FL1" to "FL12", "LED-B1" to "LED-B5", "LED-BH1", '
    '"LED-RGB1", "LED-V1", "LED-V2"'
)
_KELVIN = "[0-9]{4,5}K"
_TEMPERATURE = "a colour temperature from 1000K to 25000K"


def _temperature(text: str) -> str:
    kelvin = text.removesuffix("K")
    if text.endswith("K") and kelvin.isdecimal() and not 1000 <= int(kelvin) <= 25000:
        raise ValueError("outside the daylight and black-body formulas")
    return text


#: The light of a lamp: a standard illuminant, a colour temperature, or a measured spectrum.
Spectrum = Annotated[
    str,
    Field(pattern=f"^({_ILLUMINANTS}|{_KELVIN}|{ending('.csv')})$"),
    AfterValidator(_temperature),
    FilePath((".csv",)),
]
SPECTRUM = f"{_NAMES}, {_TEMPERATURE}, or a path ending in .csv"
SPECTRUM_EXAMPLES = ["A", "D50", "D65", "E", "FL11", "LED-B3"]

#: What is shown as white: the light's own white, an illuminant or a colour temperature.
White = Annotated[
    str, Field(pattern=f"^(auto|{_ILLUMINANTS}|{_KELVIN})$"), AfterValidator(_temperature)
]
WHITE = f'"auto", {_NAMES}, or {_TEMPERATURE}'
WHITE_EXAMPLES = ["auto", *SPECTRUM_EXAMPLES]

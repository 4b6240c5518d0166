"""Labels that look alike or are one number, which in files put together would be two things."""

from __future__ import annotations

import re
from collections.abc import Iterable
from unicodedata import decomposition, normalize

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.data.hidden import visible

#: Letters of Cyrillic and Greek that are drawn as a Latin one (a part of the table of Unicode
#: Technical Standard 39), and dashes that are drawn as a hyphen.
_DRAWN_AS = str.maketrans(
    "АВЕЅІЈКМНОРСТУХЅаеѕіјорсухһԁԛԝ" + "ΑΒΕΖΗΙΚΜΝΟΡΤΥΧοϲϳ",
    "ABESIJKMHOPCTYXSaesijopcyxhdqw" + "ABEZHIKMNOPTYXocj",
) | dict.fromkeys(map(ord, "\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u2043\ufe58\ufe63"), "-")
#: Kinds of Unicode's compatibility forms that differ in width or cut alone; ² and ① are not 2.
_FORMS = ("<wide>", "<narrow>", "<font>", "<noBreak>", "<compat>")
#: Whole or decimal, without zeros in front: 007 is a person's code.
_NUMBER = re.compile(
    r"([+-]?)(0|[1-9][0-9]*|(?=[.,][0-9]))(?:[.,]([0-9]*))?(?:[eE]([+-]?[0-9]{1,3}))?"
)
_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2}(,[0-9]{3})+(\.[0-9]*)?")


def check_alike(labels: Iterable[str], place: str) -> None:
    """Refuse labels that look alike or are one number: in pooled files one thing would be two."""
    seen: dict[str, str] = {}
    for label in labels:
        other = seen.setdefault(shape_of(label), label)
        if other != label:
            differ = "look alike" if _drawn(other) == _drawn(label) else "are one number"
            raise InputError(
                f"{place}: {quoted(other)} and {quoted(label)} {differ}; allowed: one way of "
                "writing it"
            )


def shape_of(label: str) -> str:
    """What labels that look alike, or are one number, have in common.

    >>> shape_of("crop  2") == shape_of("crop 2"), shape_of("0.50") == shape_of(".5")
    (True, True)
    """
    drawn = _drawn(label)
    return _number(drawn) or drawn


def _drawn(label: str) -> str:
    """What a label looks like: letters of one width and one script where they are drawn alike."""
    text = visible(label)
    if text.isascii():
        return text
    plain = "".join(
        normalize("NFKC", letter) if decomposition(letter).startswith(_FORMS) else letter
        for letter in text
    )
    return " ".join(normalize("NFC", plain).translate(_DRAWN_AS).split())


def _number(drawn: str) -> str | None:
    """A number as a whole one and a power of ten, however it is written; None of other labels."""
    if _THOUSANDS.fullmatch(drawn):
        drawn = drawn.replace(",", "")
    found = _NUMBER.fullmatch(drawn)
    if not found:
        return None
    fraction = found[3] or ""
    digits = (found[2] + fraction).lstrip("0")
    whole = digits.rstrip("0")
    if not whole:
        return "0"
    power = int(found[4] or 0) - len(fraction) + len(digits) - len(whole)
    return f"{found[1].strip('+')}{whole}e{power}"

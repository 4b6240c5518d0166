"""Labels that look alike or are one number, which in files put together would be two things."""

from __future__ import annotations

import re
from collections.abc import Iterable
from unicodedata import decimal, decomposition, normalize, numeric

from nacreous.problem import InputError
from nacreous.scaling.data.fault import quoted_exactly
from nacreous.scaling.data.hidden import visible
from nacreous.scaling.data.rewriting import check_rewritten

#: Letters of Cyrillic and Greek, and some others, that are drawn as a Latin one, kana that are
#: drawn as a kanji or as the other kana, and marks that are drawn as one on every keyboard (a part
#: of the table of Unicode Technical Standard 39).
_DRAWN_AS = str.maketrans(
    "АВЕЅІЈКМНОРСТУХЅаеѕіјорсухһԁԛԝ" + "ΑΒΕΖΗΙΚΜΝΟΡΤΥΧοϲϳ",
    "ABESIJKMHOPCTYXSaesijopcyxhdqw" + "ABEZHIKMNOPTYXocj",
) | dict.fromkeys(map(ord, "\u2010\u2011\u2012\u2013\u2014\u2015\u2212\u2043\ufe58\ufe63"), "-")
_DRAWN_AS |= str.maketrans("ɑı×✕✖∕⁄⧸∼∽〜～", "aixxx///~~~~")
_DRAWN_AS |= str.maketrans("ロニカタエトハチムヘベペリー一", "口二力夕工卜八千厶へべぺり--")
_DRAWN_AS |= dict.fromkeys(map(ord, "‘’‚‛′ʹʻʼ`´＇"), "'") | dict.fromkeys(map(ord, "“”„‟″«»"), '"')
_DRAWN_AS |= dict.fromkeys(map(ord, "･·•‧∙⋅ꞏ・"), "·")
#: Kinds of Unicode's compatibility forms that differ in width, cut or a ring; ² is not 2.
_FORMS = ("<wide>", "<narrow>", "<font>", "<noBreak>", "<compat>", "<circle>")
#: Whole or decimal, without zeros in front: 007 is a person's code.
_NUMBER = re.compile(
    r"([+-]?)(0|[1-9][0-9]*|(?=[.,][0-9]))(?:[.,]([0-9]*))?(?:[eE]([+-]?[0-9]{1,3}))?"
)
#: Thousands parted by commas, blanks or apostrophes, and by points where a decimal comma follows.
_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2}([,' ])[0-9]{3}(\1[0-9]{3})*(\.[0-9]*)?")
_POINTS = re.compile(r"[+-]?[1-9][0-9]{0,2}((\.[0-9]{3})+,[0-9]+|(\.[0-9]{3}){2,})")
#: By which power of ten a mark behind a number divides it.
_SHARES = {"%": 2, "‰": 3}
#: One character that is a number between 0 and 1, alone or behind a whole one.
_FRACTION = re.compile("([0-9]*) ?([¼½¾⅐-⅞↉])")


def check_alike(labels: Iterable[str], place: str) -> None:
    """Refuse labels that look alike, are one number or are likely one label rewritten.

    In pooled files one thing would be two.
    """
    labels = list(labels)
    seen: dict[str, str] = {}
    for label in labels:
        other = seen.setdefault(shape_of(label), label)
        if other != label:
            differ = "look alike" if _drawn(other) == _drawn(label) else "are one number"
            raise InputError(
                f"{place}: {quoted_exactly(other)} and {quoted_exactly(label)} {differ}; "
                "allowed: one way of writing it"
            )
    check_rewritten(labels, place)


def shape_of(label: str) -> str:
    """What labels that look alike, or are one number, have in common.

    >>> shape_of("crop  2") == shape_of("crop 2"), shape_of("0.50") == shape_of(".5")
    (True, True)
    """
    drawn = _drawn(label)
    return _number(drawn) or drawn


def number_of(label: str) -> str | None:
    """What all ways of writing a number have in common; None of a label that is none.

    >>> number_of("1.0") == number_of("1"), number_of("50%") == number_of("0.5"), number_of("01")
    (True, True, None)
    """
    return _number(_drawn(label))


def _drawn(label: str) -> str:
    """What a label looks like: letters of one width and one script where they are drawn alike."""
    text = visible(label)
    if text.isascii():
        return text.replace("`", "'")
    plain = "".join(map(_plain, text))
    return " ".join(normalize("NFC", plain).translate(_DRAWN_AS).split())


def _plain(letter: str) -> str:
    """A letter in its plain form; digits of every script as 0 to 9."""
    if decomposition(letter).startswith(_FORMS):
        return normalize("NFKC", letter)
    return str(decimal(letter, letter))


def _number(drawn: str) -> str | None:
    """A number as a whole one and a power of ten, however it is written; None of other labels.

    Spreadsheets show 0.5 as 50%.
    """
    share = _SHARES.get(drawn[-1:], 0)
    found = _NUMBER.fullmatch(_ungrouped(drawn[:-1].rstrip() if share else drawn))
    if not found:
        return None
    fraction = found[3] or ""
    digits = (found[2] + fraction).lstrip("0")
    whole = digits.rstrip("0")
    if not whole:
        return "0"
    power = int(found[4] or 0) - share - len(fraction) + len(digits) - len(whole)
    return f"{found[1].strip('+')}{whole}e{power}"


def _ungrouped(drawn: str) -> str:
    """A number without what parts its thousands, its decimal mark a point."""
    if _THOUSANDS.fullmatch(drawn):
        return re.sub("[,' ]", "", drawn)
    if _POINTS.fullmatch(drawn):
        return drawn.replace(".", "").replace(",", ".")
    part = _FRACTION.fullmatch(drawn)
    return str(int(part[1] or 0) + numeric(part[2])) if part else drawn

"""What the first column of a medium's table is called, and its unit."""

from __future__ import annotations

import re
from unicodedata import normalize

from nacreous.number import said
from nacreous.problem import InputError

_WORDS = (
    r"wl|wvl|wave|wave[ _-]?lengths?|(?:lambda|lam|\u03bb)(?:[ _]?0)?|wellenl(?:\u00e4|ae)ngen?"
    r"|longueurs? d['\u2019]onde|longitud(?:es)? de onda|lunghezz[ae] d['\u2019]onda|\u6ce2\u9577"
)
_UM = r"um|\u03bcm|microns?|micro-?met(?:er|re)s?|mikrometer"
_NM = r"nm|nano-?met(?:er|re)s?"
#: `wl`, `Wavelength (nm)`, `lambda_um`, `Wavelength/nm`, `nm`, and nothing around it: 1/nm is none.
_NAME = re.compile(
    rf"(?P<word>(?:vacuum[ _])?(?:{_WORDS}))?[\s_,/:\-]*(?:in\s)?\s*"
    rf"(?P<open>[(\[])?\s*(?:(?P<um>{_UM})|(?P<nm>{_NM}))?\s*(?(open)[)\]])"
)


def is_wavelength(name: str) -> bool:
    """Whether a column of this name is a wavelength in um or nm.

    >>> is_wavelength("Wavelength (nm)"), is_wavelength("wavenumber"), is_wavelength("1/nm")
    (True, False, False)
    """
    return _found(name) is not None


def nm_per_unit(name: str) -> float:
    """The unit that a column's name says, um where it says none; other quantities are refused.

    >>> nm_per_unit("wl"), nm_per_unit("lambda [nm]")
    (1000.0, 1.0)
    """
    found = _found(name)
    if found is None:
        raise InputError(
            f"the first column is {said(name)}; allowed: a wavelength in um or nm, called 'wl' "
            "(um), 'nm', 'um', 'Wavelength (nm)', 'lambda [um]' or the like"
        )
    return 1.0 if found["nm"] else 1e3


def stated_unit(name: str) -> float | None:
    """The same where the name says a unit, with or without a word before it; else None.

    >>> stated_unit("[nm]"), stated_unit("wl")
    (1.0, None)
    """
    found = _found(name)
    return nm_per_unit(name) if found and (found["nm"] or found["um"]) else None


def _found(name: str) -> re.Match[str] | None:
    found = _NAME.fullmatch(normalize("NFKC", name).strip().casefold())
    return found if found and (found["word"] or found["um"] or found["nm"]) else None

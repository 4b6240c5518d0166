"""What the columns of a medium's table behind the first are called: n or k."""

from __future__ import annotations

import re
from unicodedata import normalize

_N = (
    r"(?:absolute )?refractive ind(?:ex|ices)|ind(?:ex|ices) of refraction|brechungsindex|brechzahl"
    r"|indice de réfraction|índice de refracción|indice di rifrazione|屈折率"
)
_K = (
    r"extinction coefficients?|absorption index|extinktionskoeffizient"
    r"|coefficient d['\u2019]extinction|coeficiente de extinción"
    r"|coefficiente di estinzione|消衰係数"
)
#: `n`, `Refractive index`, `Refractive index n`, `Refractive index (n)`, `n (refractive index)`.
_NAMES = {
    letter: re.compile(
        rf"{letter}|(?:{words})(?:[ ,_]*[(\[]?{letter}[)\]]?)?"
        rf"|{letter}[ ,_]*[(\[]?(?:{words})[)\]]?"
    )
    for letter, words in (("n", _N), ("k", _K))
}


def column_of(name: str) -> str | None:
    """Which of "n" and "k" a column is, or None of what is called otherwise.

    >>> column_of("Refractive index n"), column_of("Extinction coefficient, k"), column_of("m")
    ('n', 'k', None)
    """
    plain = " ".join(normalize("NFKC", name).casefold().replace("_", " ").split())
    return next((letter for letter, names in _NAMES.items() if names.fullmatch(plain)), None)

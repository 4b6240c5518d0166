"""How thin nacre may be, by which micrometres given for nanometres are known.

Optics allows films of any thickness, but a stack in micrometres is thinner than its atoms: it would
show no colour, and nobody would know why.
"""

from __future__ import annotations

from collections.abc import Iterable

__all__ = ["thin_layers", "thin_protein"]

#: Thinner than this no stack of nacre is throughout: two cells of aragonite along c, 0.574 nm each
#: (de Villiers 1971). Single layers may be, as the last day's is.
THINNEST_NM = 1.0
#: Thinner than this is no sheet of protein but none, 0: an atom.
THINNEST_PROTEIN_NM = 0.1


def thin_layers(thickness_nm: Iterable[float]) -> str | None:
    """What is wrong with aragonite layers of which each is thinner than two of its cells.

    >>> thin_layers([0.38, 0.41])
    'is at most 0.41; allowed: a layer of 1 nm or more (is it in um?)'
    """
    thickest = max(thickness_nm, default=THINNEST_NM)
    if thickest >= THINNEST_NM or not thickest > 0:  # what is not above 0 is told as that
        return None
    return f"is at most {thickest:g}; allowed: a layer of {THINNEST_NM:g} nm or more (is it in um?)"


def thin_protein(protein_nm: float) -> str | None:
    """What is wrong with a pearl's protein layers that are thinner than an atom.

    >>> thin_protein(0.02), thin_protein(0.0)
    ('is 0.02; allowed: 0, or 0.1 nm or more (is it in um?)', None)
    """
    if not 0 < protein_nm < THINNEST_PROTEIN_NM:
        return None
    return f"is {protein_nm:g}; allowed: 0, or {THINNEST_PROTEIN_NM:g} nm or more (is it in um?)"

"""How light becomes the codes of a file, bits, space and gamut: what may be asked, checked once."""

from numbers import Integral
from typing import Literal

from nacreous.number import said
from nacreous.problem import InputError

__all__ = ["check_bits", "check_unchanged", "check_words"]


def check_words(space: str, gamut: str) -> None:
    """Asked of OpenEXR too, which needs neither."""
    for name, word, allowed in (
        ("RGB space", space, ("srgb", "display-p3")),
        ("gamut", gamut, ("clip", "soft")),
    ):
        if word not in allowed:
            raise InputError(f'{name} is "{word}"; allowed: {", ".join(allowed)}')


def check_unchanged(bits: int, space: str, gamut: str) -> None:
    """OpenEXR holds light as it is, which nothing of PNG's changes."""
    for name, given, own in (("bits", bits, 8), ("space", space, "srgb"), ("gamut", gamut, "soft")):
        if given != own:
            raise InputError(f"{name} is {said(given)}; allowed with .exr: as it is by default")


def check_bits(bits: int) -> Literal[8, 16]:
    """8 or 16 bits a channel, of NumPy's numbers too."""
    if not isinstance(bits, Integral) or isinstance(bits, bool) or bits not in (8, 16):
        raise InputError(f"bits is {said(bits)}; allowed: 8, 16")
    return 16 if bits == 16 else 8

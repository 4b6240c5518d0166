"""Text from outside as it may be shown in a terminal or on a page."""

from unicodedata import category

__all__ = ["by_number", "printable", "printable_lines"]

#: Zero-width, but a part of words in Persian and of joined emoji.
_JOINERS = "\u200c\u200d"


def printable(text: str) -> str:
    r"""The text with control, invisible and unassigned characters as \\u and their number.

    They could move a terminal's cursor, colour it, or turn the direction of what follows. Spaces of
    any width stay: Japanese has one of its own.

    >>> print(printable("pearl\x1b[31m"))
    pearl\u001b[31m
    """
    if text.isprintable():
        return text
    return "".join(c if _shows(c) else by_number(c) for c in text)


def by_number(letter: str) -> str:
    r"""A character as Python writes it by its number: of four digits, or of eight.

    >>> print(by_number("\x1b"), by_number("\U000e0041"))
    \u001b \U000e0041
    """
    code = ord(letter)
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def _shows(letter: str) -> bool:
    return letter.isprintable() or letter in _JOINERS or category(letter) == "Zs"


def printable_lines(text: str) -> str:
    r"""The same of a text of several lines, whose ends stay.

    >>> print(printable_lines("one\x07\ntwo"))
    one\u0007
    two
    """
    return "\n".join(printable(line) for line in text.split("\n"))

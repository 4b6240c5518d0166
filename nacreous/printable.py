"""Text from outside as it may be shown in a terminal or on a page."""

__all__ = ["printable"]

#: Zero-width, but a part of words in Persian and of joined emoji.
_JOINERS = "\u200c\u200d"


def printable(text: str) -> str:
    r"""The text with control, invisible and unassigned characters as \\u and their number.

    They could move a terminal's cursor, colour it, or turn the direction of what follows.

    >>> print(printable("pearl\x1b[31m"))
    pearl\u001b[31m
    """
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() or c in _JOINERS else f"\\u{ord(c):04x}" for c in text)

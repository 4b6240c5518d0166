"""Characters in a label that nobody can see."""

from __future__ import annotations

import re
from unicodedata import category

from nacreous.printable import by_number

#: Unicode's categories of control and format characters, and separators of lines and paragraphs.
_HIDDEN = ("Cc", "Cf", "Zl", "Zp")
#: What shows nothing and is in none of these: joiners and fillers of letters, vowels of Khmer that
#: nobody writes, an empty pattern of Braille (Unicode's Default_Ignorable_Code_Point and U+2800).
_FILLERS = "\u034f\u115f\u1160\u17b4\u17b5\u2800\u3164\uffa0"
#: Zero-width, but a part of words in Persian, Mongolian and of emoji, and of kanji in names.
_JOINERS = "\u200c\u200d"
_SELECTORS = "\u180b-\u180d\u180f\ufe00-\ufe0f\U000e0100-\U000e01ef"
#: Letters of the flags of Scotland and the like, behind a black one.
_FLAG = re.compile("\U0001f3f4[\U000e0020-\U000e007f]+")
_ZERO_WIDTH = re.compile(f"[{_JOINERS}{_SELECTORS}]")
#: Code points that are no characters, now or ever: the last two of each plane, and 32 of Arabic's.
_NONCHARACTERS = r"\x{FDD0}-\x{FDEF}" + "".join(
    rf"\x{{{plane:X}FFFE}}\x{{{plane:X}FFFF}}" for plane in range(17)
).replace(r"\x{0FFF", r"\x{FFF")

#: A pattern (RE2) of whatever may be hidden: `hidden_in` looks closer.
MAYBE_HIDDEN = rf"[\p{{Cc}}\p{{Cf}}\p{{Zl}}\p{{Zp}}{_FILLERS}{_SELECTORS}{_NONCHARACTERS}]"


def hidden_in(label: str) -> str | None:
    r"""The first character that cannot be seen, as \\u and its number; None where all can.

    Joiners and selectors are allowed behind something that is seen, and tags in emoji of flags.

    >>> print(hidden_in("pearl\u200b"))
    \u200b
    """
    text = _FLAG.sub("\U0001f3f4", label)
    bare = not visible(text)
    hidden = next((c for c in text if _is_hidden(c) or (bare and _ZERO_WIDTH.match(c))), None)
    return None if hidden is None else by_number(hidden)


def visible(label: str) -> str:
    """The label without joiners and selectors, and with single spaces."""
    return " ".join(_ZERO_WIDTH.sub("", label).split())


def _is_hidden(letter: str) -> bool:
    if _ZERO_WIDTH.match(letter):
        return False
    code = ord(letter)
    no_character = code & 0xFFFE == 0xFFFE or 0xFDD0 <= code <= 0xFDEF
    return category(letter) in _HIDDEN or letter in _FILLERS or no_character
